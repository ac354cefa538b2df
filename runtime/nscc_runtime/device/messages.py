"""What packets say: the bodies of requests and replies, as values. Integers are little endian.

Each `unpack` raises ValueError for a body that is none; the checksum has been checked before, so
that only another version of the protocol, or an enemy, sends such a body.
"""

from __future__ import annotations

from dataclasses import astuple, dataclass
from enum import IntEnum, IntFlag
from struct import Struct, error
from typing import Any, ClassVar, Self


class LoaderState(IntEnum):
    """What a loader is doing."""

    EMPTY = 0
    RECEIVING = 1
    COMPLETE = 2
    READY = 3
    EXPOSING = 4
    REFUSED = 5


class LoaderFault(IntEnum):
    """Why a loader did not do what it was asked."""

    NO_SESSION = 1
    VERSION = 2
    MALFORMED = 3
    WRONG_STATE = 4
    TARGET = 5
    TOO_LARGE = 6
    DIGEST = 7
    WORD = 8
    SCHEDULE = 9
    PLANE = 10
    READOUT = 11
    NO_PROGRAM = 12
    HARDWARE = 13
    NO_FRAME = 14
    UNKNOWN = 15
    BUSY = 16
    LATE = 17


class Capability(IntFlag):
    """What a loader can do beyond the least."""

    EXACT = 1
    """Hand out exposures in float64 beside the converter's codes."""
    GAIN = 2
    """Multiply a register by a gain other than 1 before it is converted."""
    LOOKS = 4
    """Set IN between kernels, and send digital registers with the frame."""


class Channel(IntFlag):
    """What a frame holds: CODES, a byte a pixel; EXPOSURE, a float64 a pixel in electrons; STATES,
    the planes of the digital registers that the program names, a bit a pixel."""

    CODES = 1
    EXPOSURE = 2
    STATES = 4


def frame_bytes(channels: int, pixels: int, readouts: int, states: int) -> int:
    """Bytes of a frame: of all readouts in these channels, and of so many planes of states."""
    bytes_per_pixel = (1 if channels & Channel.CODES else 0) + (
        8 if channels & Channel.EXPOSURE else 0
    )
    planes = states if channels & Channel.STATES else 0
    return readouts * bytes_per_pixel * pixels + planes * plane_bytes(pixels)


def plane_bytes(pixels: int) -> int:
    """Bytes of one bit a pixel."""
    return (pixels + 7) // 8


class _Body:
    """A body of fixed layout, whose fields are the dataclass's in their order."""

    layout: ClassVar[Struct]

    def pack(self) -> bytes:
        """The body's bytes."""
        return self.layout.pack(*astuple(self))  # type: ignore[call-overload]

    @classmethod
    def unpack(cls, body: bytes) -> Self:
        """The value of a body; ValueError where it has another length."""
        return cls(*_fields(cls.layout, body))


def _fields(layout: Struct, body: bytes) -> tuple[Any, ...]:
    try:
        return layout.unpack(body)
    except error as wrong:
        raise ValueError(f"a body of {len(body)} bytes, not {layout.size}") from wrong


@dataclass(frozen=True)
class Hello(_Body):
    """The first and last version of the protocol that a host speaks."""

    first: int
    last: int
    layout = Struct("<BBxx")


@dataclass(frozen=True)
class Info(_Body):
    """What a loader is, what it holds and how much it takes.

    `boot` names the life of the loader since it started: another number means that everything
    uploaded is gone. `window` is how many bytes on the wire may await their acknowledgement.
    The limits are numbers of words, kernels, rows of the schedule, runs of equal slots, bytes of
    all channels of a frame, and milliseconds from its first word to its last. `hold` is how many
    bytes of a frame are kept behind those that the host says it has. `program` and `label` are
    zeros while there is no program.
    """

    version: int
    state: int
    most_data: int
    window: int
    boot: int
    capabilities: int
    most_words: int
    most_kernels: int
    most_rows: int
    most_runs: int
    most_frame: int
    hold: int
    longest_ms: int
    rows: int
    cols: int
    target: bytes
    program: bytes
    label: bytes
    target_name: str
    firmware: str
    layout = Struct("<BBHIIIIIIIIIIHH32s32s32s")

    def pack(self) -> bytes:
        """The body's bytes; its texts follow, each behind its length."""
        *fixed, name, firmware = astuple(self)
        texts = (name.encode()[:60], firmware.encode()[:60])
        return self.layout.pack(*fixed) + b"".join(bytes([len(text)]) + text for text in texts)

    @classmethod
    def unpack(cls, body: bytes) -> Self:
        """The value of a body; ValueError where it is none."""
        fixed = _fields(cls.layout, body[: cls.layout.size])
        texts, at = [], cls.layout.size
        for _ in range(2):
            if at >= len(body) or at + 1 + body[at] > len(body):
                raise ValueError("a text is cut short")
            text = body[at + 1 : at + 1 + body[at]].decode("utf-8", "replace")
            # It goes to terminals, which obey what is not printed.
            shown = (c if c.isprintable() else "\N{REPLACEMENT CHARACTER}" for c in text)
            texts.append("".join(shown))
            at += 1 + body[at]
        return cls(*fixed, *texts)


@dataclass(frozen=True)
class Begin(_Body):
    """A program is announced: digests of its target table and of itself, a label of the host's
    choice (nscc: SHA-256 of the container file), bytes and number of its objects."""

    target: bytes
    program: bytes
    label: bytes
    length: int
    objects: int
    layout = Struct("<32s32s32sIHxx")


@dataclass(frozen=True)
class ObjectEntry(_Body):
    """An object: what it is, the register of a plane, bytes, SHA-256 of them."""

    kind: int
    register: int
    length: int
    sha256: bytes
    layout = Struct("<BBI32s")


@dataclass(frozen=True)
class Declare(_Body):
    """Some of a program's entries, from number `first` on."""

    first: int
    entries: tuple[ObjectEntry, ...]
    layout = Struct("<HH")

    def pack(self) -> bytes:
        """The body's bytes."""
        head = self.layout.pack(self.first, len(self.entries))
        return head + b"".join(entry.pack() for entry in self.entries)

    @classmethod
    def unpack(cls, body: bytes) -> Self:
        """The value of a body; ValueError where it is none."""
        first, count = _fields(cls.layout, body[: cls.layout.size])
        packed = body[cls.layout.size :]
        if len(packed) != count * ObjectEntry.layout.size:
            raise ValueError(f"{count} entries in {len(body)} bytes")
        return cls(
            first,
            tuple(
                ObjectEntry(*entry_fields)
                for entry_fields in ObjectEntry.layout.iter_unpack(packed)
            ),
        )


MOST_ENTRIES = 26
"""Most entries of one DECLARE: they fit a packet."""


@dataclass(frozen=True)
class UploadProgress(_Body):
    """How far an upload is: entries declared, bytes received of all objects in their order,
    and how often an object's digest did not fit, so that its bytes were dropped."""

    state: int
    failures: int
    declared: int
    position: int
    layout = Struct("<BBHI")


@dataclass(frozen=True)
class CaptureRequest(_Body):
    """Expose a frame, unless it is the one of this number that is there or being exposed."""

    number: int
    channels: int
    layout = Struct("<QBxxx")


@dataclass(frozen=True)
class CaptureReply(_Body):
    """What became of a capture.

    `ready`: whether its frame can be read; `estimate_ms` is how long exposure and readout take, and
    `started_us` the loader's clock when it began. The bytes before `released` are gone. The frame
    took `lasted_us` from its first word to its last, and `readout_us` to read out so far; `late`
    launches came later than the program allows a launch to, the latest one by `latest_us`. The
    sums are those of all `length` bytes, 0 until the loader has made them all (`complete`).
    """

    number: int
    ready: int
    channels: int
    readouts: int
    estimate_ms: int
    length: int
    released: int
    started_us: int
    lasted_us: int
    readout_us: int
    late: int
    latest_us: int
    complete: int
    crc32: int
    adler32: int
    layout = Struct("<QBBHIIIQIIIIIII")


@dataclass(frozen=True)
class ReadRequest(_Body):
    """Send `length` bytes of a frame from `offset`, at most `chunk` of them a packet.

    The host has all bytes before `confirmed`.
    """

    number: int
    offset: int
    length: int
    confirmed: int
    chunk: int
    layout = Struct("<QIIIHxx")


@dataclass(frozen=True)
class Status(_Body):
    """A loader's state and counters since it started."""

    state: int
    boot: int
    uptime_us: int
    position: int
    packets: int
    damaged: int
    layout = Struct("<BxxxIQIII")


@dataclass(frozen=True)
class LoaderFailure(_Body):
    """A request was not carried out; `detail` depends on the fault (the number of a word, ..)."""

    request: int
    fault: int
    detail: int
    layout = Struct("<BBxxI")


DATA = Struct("<I")
"""Body of DATA: the position of the bytes that follow."""
FRAME = Struct("<QI")
"""Body of the reply to READ: number of the capture and offset of the bytes that follow."""
