"""The bodies of requests and replies, as values. Integers are little endian.

Each `unpack` raises ValueError for an invalid body. The checksum has been verified before, so an
invalid body comes from another version of the protocol, or an attacker."""

from __future__ import annotations

import json
from dataclasses import asdict, astuple
from enum import IntEnum, IntFlag
from struct import Struct, error
from typing import Any, Self

from nscc.record import Record


class LoaderState(IntEnum):
    """The state of a loader: without a program, receiving one, having all of its bytes, ready to
    expose, exposing, or having refused a program."""

    EMPTY = 0
    RECEIVING = 1
    COMPLETE = 2
    READY = 3
    EXPOSING = 4
    REFUSED = 5


class LoaderFault(IntEnum):
    """The reason why a loader refused a request.

    A detail goes with it (`LoaderFailure`). DIGEST: data do not match their checksum. LATE:
    launches (starts of kernels) were later than the program allows. NO_SESSION: the request has
    another session's number. A kernel is a list of words."""

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
    PARAM = 18


class Capability(IntFlag):
    """Optional features of a loader."""

    EXACT = 1
    """Sends exposures in float64 in addition to the converter codes."""
    GAIN = 2
    """Multiplies a register by a gain other than 1 before conversion."""
    LOOKS = 4
    """Sets IN between kernels, and sends digital registers with the frame."""
    PICTURES = 8
    """Runs words that reach neighbours, and converts signed values."""
    REPORTS = 16
    """Sends where the bits of a plane are 1 instead of the plane."""
    HOST_VALUES = 32
    """Sets levels of IN and numbers of launches to parameters, loads planes between frames, and
    keeps analog registers from frame to frame."""


class Channel(IntFlag):
    """The content of a frame: CODES, a byte per pixel; EXPOSURE, a float64 per pixel in electrons;
    STATES, one bit per pixel for each digital register that the program names; REPORTS, where the
    bits of other digital registers are 1."""

    CODES = 1
    EXPOSURE = 2
    STATES = 4
    REPORTS = 8


def frame_bytes(
    channels: int, pixels: int, readouts: int, states: int, report_bytes: int = 0
) -> int:
    """Return the number of bytes of a frame in these `channels`, bits of `Channel`: CODES and
    EXPOSURE of `readouts` registers of `pixels` each, `states` planes in STATES, and `report_bytes`
    in REPORTS."""
    bytes_per_pixel = (1 if channels & Channel.CODES else 0) + (
        8 if channels & Channel.EXPOSURE else 0
    )
    planes = states if channels & Channel.STATES else 0
    reports = report_bytes if channels & Channel.REPORTS else 0
    return readouts * bytes_per_pixel * pixels + planes * plane_bytes(pixels) + reports


def plane_bytes(pixels: int) -> int:
    """Return the number of bytes of a plane of one bit for each of `pixels`; the last byte may be
    filled up."""
    return (pixels + 7) // 8


class _Body(Record):
    """A body of fixed layout (`layout`), whose fields are those of the record, in order."""

    layout = Struct("")  # not a field: only annotated attributes are

    def pack(self) -> bytes:
        """Return the bytes of the fields."""
        return self.layout.pack(*astuple(self))

    @classmethod
    def unpack(cls, body: bytes) -> Self:
        """Return the value of a body. Raises ValueError for a body of another length."""
        return cls(*_fields(cls.layout, body))


def _fields(layout: Struct, body: bytes) -> tuple[Any, ...]:
    """Return the values in `layout` that `body` contains; raise ValueError if its length is not
    that of the layout."""
    try:
        return layout.unpack(body)
    except error as wrong:
        raise ValueError(f"a body of {len(body)} bytes, not {layout.size}") from wrong


class Hello(_Body):
    """The first and last version of the protocol that a host supports."""

    first: int
    last: int
    layout = Struct("<BBxx")


class Info(_Body):
    """The description of a loader.

    `version`: of the protocol. `state`: see `LoaderState`. `most_data`: bytes of data in one
    packet. `window`: number of unacknowledged bytes on the wire. `boot`: identifies its current
    run; another number means that all uploads are lost. `capabilities`: bits of `Capability`.
    `most_..`, `longest_ms`: limits of words, kernels, rows of the schedule, runs of equal slots,
    bytes of all channels of a frame, and milliseconds from first to last word. `hold`: number of
    bytes of a frame that stay available after the host has confirmed them. `rows`, `cols`: size of
    the array. `target`, `program`: their digests; `label`: chosen by the host of the program. The
    last two are zeros without a program. A kernel is a list of words."""

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

    @classmethod
    def unpack(cls, body: bytes) -> Self:
        """Read the description of a loader from a body: fixed fields, then two texts (names of
        target and firmware), each after a byte with its length.

        Characters that a terminal could interpret are replaced. Raises ValueError if the body is
        cut short; bytes after the texts are ignored."""
        fixed = _fields(cls.layout, body[: cls.layout.size])
        texts, offset = [], cls.layout.size
        for _ in range(2):
            if offset >= len(body) or offset + 1 + body[offset] > len(body):
                raise ValueError("a text is cut short")
            text = body[offset + 1 : offset + 1 + body[offset]].decode("utf-8", "replace")
            # Texts are printed, and terminals interpret control characters.
            shown = (c if c.isprintable() else "\N{REPLACEMENT CHARACTER}" for c in text)
            texts.append("".join(shown))
            offset += 1 + body[offset]
        return cls(*fixed, *texts)


class Begin(_Body):
    """The announcement of a program: digests of its target table and of the program, a label chosen
    by the host (nscc: SHA-256 of the container file), total bytes and number of objects. A
    container is a compiled program."""

    target: bytes
    program: bytes
    label: bytes
    length: int
    objects: int
    layout = Struct("<32s32s32sIHxx")


class ObjectEntry(_Body):
    """The announcement of an object: its kind (`ObjectKind`), the register of a plane (0 for other
    kinds), number of bytes, SHA-256."""

    kind: int
    register: int
    length: int
    sha256: bytes
    layout = Struct("<BBI32s")


class Declare(_Body):
    """Consecutive entries of a program, from entry number `first` on, counted from 0."""

    first: int
    entries: tuple[ObjectEntry, ...]
    layout = Struct("<HH")

    def pack(self) -> bytes:
        """Return the bytes of the head and of all entries."""
        head = self.layout.pack(self.first, len(self.entries))
        return head + b"".join(entry.pack() for entry in self.entries)


MOST_ENTRIES = 26
"""Largest number of entries of one DECLARE packet."""


class UploadProgress(_Body):
    """The progress of an upload.

    `state`: see `LoaderState`. `failures`: number of objects dropped because of a wrong digest.
    `declared`: number of announced objects. `position`: number of bytes received of all objects in
    order."""

    state: int
    failures: int
    declared: int
    position: int
    layout = Struct("<BBHI")


class CaptureRequest(_Body):
    """A request to expose a frame, unless the frame `number` exists or is being exposed.
    `channels`: bits of `Channel`.

    In CAPTURE_WITH the values of all parameters follow, as i32."""

    number: int
    channels: int
    layout = Struct("<QBxxx")


class CaptureReply(_Body):
    """The state of a capture.

    `number`, `channels`: those of the request. `ready`: whether its frame can be read, 0 or 1.
    `readouts`: number of registers. `estimate_ms`: time of exposure and readout. `length`: number
    of bytes of the frame. `released`: bytes before this offset are no longer available.
    `started_us`: the loader's clock at the start. `lasted_us`: time from first to last word.
    `readout_us`: time of readout so far. `late`: number of launches (starts of kernels) that
    exceeded the program's tolerance, the latest by `latest_us`. `crc32`, `adler32`: checksums of
    all bytes, 0 until the loader has all of them (`complete` is 1). A kernel is a list of words."""

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


class ReadRequest(_Body):
    """A request for `length` bytes of the frame `number` from `offset` on, at most `chunk` bytes
    per packet. The host has all bytes before `confirmed`."""

    number: int
    offset: int
    length: int
    confirmed: int
    chunk: int
    layout = Struct("<QIIIHxx")


class Status(_Body):
    """The state of a loader.

    `state`: see `LoaderState`. `boot`: number of its current run. `uptime_us`: microseconds since
    its start. `position`: bytes received of an upload. `packets`, `damaged`: packets received and
    dropped since its start."""

    state: int
    boot: int
    uptime_us: int
    position: int
    packets: int
    damaged: int
    layout = Struct("<BxxxIQIII")


class LoaderFailure(_Body):
    """The failure of a request. `request`: kind of its packet. `fault`: see `LoaderFault`; a newer
    loader may send others. `detail` depends on the fault, for example the number of a word."""

    request: int
    fault: int
    detail: int
    layout = Struct("<BBxxI")


LOAD = Struct("<B3xI")
"""Head of LOAD: the register of a plane, and the position of the bytes that follow."""
DATA = Struct("<I")
"""Body of DATA: the position of the bytes that follow. Body of the reply to LOAD: how many bytes of
the plane the loader has."""


def loaded_bytes(body: bytes) -> int:
    """Return how many bytes of a plane the loader has, from `body`, that of its reply to LOAD.
    Raises ValueError for a body of another length."""
    (position,) = _fields(DATA, body)
    return int(position)


FRAME = Struct("<QI")
"""Body of the reply to READ: number of the capture and offset of the bytes that follow."""


def name_of(kinds: type[IntEnum], number: int) -> str:
    """Return the name of the member of `kinds` that is `number`; the number as text if there is
    none, as in messages of a newer loader."""
    return kinds(number).name if number in set(kinds) else str(number)


def info_text(info: Info, status: Status) -> str:
    """Return the description `info` of a loader and its `status` as text, one property per line,
    with a newline at the end."""
    state = name_of(LoaderState, info.state).lower()
    holds = f"program {info.label.hex()}" if any(info.program) else "no program"
    return "\n".join(
        [
            f"loader     {info.firmware}, protocol {info.version}",
            f"target     {info.target_name}, {info.rows} x {info.cols} pixels, "
            f"table {info.target.hex()[:16]}",
            f"holds      {holds} ({state})",
            f"room       {info.most_words} words, {info.most_kernels} kernels, "
            f"{info.most_rows} rows of schedule, {info.most_frame} bytes of frame",
            f"line       {info.window} bytes ahead, {info.most_data} a packet; "
            f"{status.packets} packets received, {status.damaged} damaged",
            f"up         {status.uptime_us / 1e6:.1f} s",
            "",
        ]
    )


def info_json(info: Info, status: Status) -> str:
    """Return the description `info` of a loader and its `status` as JSON: the fields of `info`,
    with digests in hexadecimal, and those of `status` under that key."""
    values = {**asdict(info), "status": asdict(status)}
    for name in ("target", "program", "label"):
        values[name] = values[name].hex()
    return json.dumps(values, indent=2) + "\n"
