"""The loader's end of the protocol, in Python: the twin of the firmware's core.

No I/O and no clock of its own: bytes and the time go in, bytes come out. A `Board` is the chip.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from dataclasses import astuple, dataclass, replace
from typing import Protocol
from zlib import adler32, crc32

from loader_twin.intake import Intake
from loader_twin.parsing import Held, Limits, Refusal
from loader_twin.timing import ON_TIME
from nscc.chips.target import Target
from nscc_runtime.device import messages, packets
from nscc_runtime.device.messages import (
    DATA,
    FRAME,
    LOAD,
    Capability,
    Channel,
    LoaderFault,
    LoaderState,
    plane_bytes,
)
from nscc_runtime.device.packets import MOST_DATA, REPLY, VERSION, Packet, PacketKind
from nscc_runtime.device.tasks import LONGEST_US

MOST_OUT = 8192
"""Bytes that may wait to be sent; a reply that finds no room is not sent: the host asks again."""
MOST_READS = 8
_KEPT = 1 << 17
_SMALLEST_CHUNK = 16
_ZEROS = bytes(32)


def packed_info(info: messages.Info) -> bytes:
    """The body of a description: its fixed part, then its texts, each after its length."""
    *fixed, name, firmware = astuple(info)
    texts = (name.encode()[:60], firmware.encode()[:60])
    return info.layout.pack(*fixed) + b"".join(bytes([len(text)]) + text for text in texts)


def declared(body: bytes) -> messages.Declare:
    """The entries of a DECLARE. Raises ValueError for another length."""
    size, layout = messages.Declare.layout.size, messages.ObjectEntry.layout
    first, count = messages._fields(messages.Declare.layout, body[:size])
    if len(body) != size + count * layout.size:
        raise ValueError(f"{count} entries in {len(body)} bytes")
    entries = (messages.ObjectEntry(*fields) for fields in layout.iter_unpack(body[size:]))
    return messages.Declare(first, tuple(entries))


class Board(Protocol):
    """The chip below a loader."""

    def expose(self, held: Held, channels: int) -> None:
        """Begin to expose a frame of a checked program."""

    def exposed(self) -> bytes | None:
        """The frame's channels once it is exposed, None before.

        Raises RuntimeError where it cannot be exposed.
        """


@dataclass
class Frame:
    """The last capture: `data` is None until it is exposed, and gone before `released`."""

    number: int
    channels: int
    started_us: int
    data: bytes | None = None
    sums: tuple[int, int] = (0, 0)
    released: int = 0
    fault: Refusal | None = None


class Loader:
    """A loader for one target. `receive` and `poll` are all there is to it."""

    def __init__(self, target: Target, board: Board, firmware: str, *, window: int = 16384) -> None:
        self.target = target
        self.board = board
        self.firmware = firmware
        self.window = window
        self.limits = Limits(words=target.store_words)
        self.intake = Intake(target, self.limits)
        self.announce()

    def announce(self) -> None:
        """Start, or start again: everything is forgotten, and the host is told so."""
        self.intake.forget()
        self.frame: Frame | None = None
        self._loading: tuple[int, bytes] = 0, b""
        self.exposing = False
        self.session = self.boot = 0
        self.packets = 0
        self._unpacker = packets.Unpacker()
        self._out = bytearray(Packet(PacketKind.BOOTED, 0, 0).wire())
        self._reads: deque[tuple[int, messages.ReadRequest]] = deque()
        self._now_us = self._started_us = 0

    def receive(self, data: bytes, now_us: int) -> None:
        """Take bytes from the line and act on the packets that they complete."""
        self._now_us = now_us
        self._started_us = self._started_us or now_us
        for packet in self._unpacker.feed(data):
            self.packets += 1
            self._handle(packet)

    def poll(self, now_us: int, room: int) -> bytes:
        """Go on with what is being done; at most about `room` bytes to send."""
        self._now_us = now_us
        self._watch_exposure()
        while self._reads and len(self._out) < room and self._has_room:
            self._send_piece()
        out = bytes(self._out[:room])
        del self._out[:room]
        return out

    @property
    def busy(self) -> bool:
        """Whether `poll` has something to do without new bytes."""
        return bool(self._out or self._reads or self.exposing)

    def watched(self) -> list[int]:
        """File descriptors that announce something to do: none."""
        return []

    def _handle(self, packet: Packet) -> None:
        handlers: dict[int, Callable[[Packet], bytes | None]] = {
            PacketKind.HELLO: self._hello,
            PacketKind.STATUS: self._status,
            PacketKind.BEGIN: self._begin,
            PacketKind.DECLARE: self._declare,
            PacketKind.DATA: self._data,
            PacketKind.FINISH: self._finish,
            PacketKind.CAPTURE: self._capture,
            PacketKind.CAPTURE_WITH: self._capture_with,
            PacketKind.LOAD: self._load,
            PacketKind.READ: self._read,
            PacketKind.CANCEL: self._cancel,
        }
        try:
            if packet.kind != PacketKind.HELLO and packet.session != (self.session or None):
                raise Refusal(LoaderFault.NO_SESSION)
            if packet.kind not in handlers:
                raise Refusal(LoaderFault.UNKNOWN)
            try:
                reply = handlers[packet.kind](packet)
            except ValueError:
                raise Refusal(LoaderFault.MALFORMED) from None
        except Refusal as refusal:
            failure = messages.LoaderFailure(
                packet.kind, refusal.fault, refusal.detail & 0xFFFFFFFF
            )
            self._send(Packet(PacketKind.ERROR, packet.sequence, packet.session, failure.pack()))
            return
        if reply is not None:
            self._send(Packet(packet.kind | REPLY, packet.sequence, packet.session, reply))

    def _send(self, packet: Packet) -> None:
        if self._has_room:
            self._out += packet.wire()

    @property
    def _has_room(self) -> bool:
        return len(self._out) + packets.LONGEST_WIRE + 2 <= MOST_OUT

    def _hello(self, packet: Packet) -> bytes:
        hello = messages.Hello.unpack(packet.body)
        if not packet.session:
            raise Refusal(LoaderFault.MALFORMED)
        if not hello.first <= VERSION <= hello.last:
            raise Refusal(LoaderFault.VERSION, VERSION)
        self.session = packet.session
        self.boot = self.boot or packet.session
        self._reads.clear()
        program = None if self.intake.refusal else self.intake.program
        begin = program.begin if program else None
        info = messages.Info(
            version=VERSION,
            state=self._shown_state,
            most_data=MOST_DATA,
            window=self.window,
            boot=self.boot,
            capabilities=Capability.EXACT
            | Capability.GAIN
            | Capability.LOOKS
            | Capability.PICTURES
            | Capability.REPORTS
            | Capability.HOST_VALUES,
            most_words=self.limits.words,
            most_kernels=self.limits.kernels,
            most_rows=self.limits.rows,
            most_runs=self.limits.runs,
            most_frame=self.limits.frame_bytes,
            hold=self._hold,
            longest_ms=LONGEST_US // 1000,
            rows=self.target.rows,
            cols=self.target.cols,
            target=self.intake.digest,
            program=begin.program if begin else _ZEROS,
            label=begin.label if begin else _ZEROS,
            target_name=self.target.name,
            firmware=self.firmware,
        )
        return packed_info(info)

    @property
    def _shown_state(self) -> LoaderState:
        return LoaderState.EXPOSING if self.exposing else self.intake.state

    def _status(self, packet: Packet) -> bytes:
        _need_length(packet.body, 0)
        return messages.Status(
            self._shown_state,
            self.boot,
            self._now_us - self._started_us,
            self.intake.program.position if self.intake.program else 0,
            self.packets & 0xFFFFFFFF,
            self._unpacker.damaged & 0xFFFFFFFF,
        ).pack()

    def _progress(self) -> bytes:
        program = self.intake.program
        if program is None:
            return messages.UploadProgress(self._shown_state, 0, 0, 0).pack()
        declared, failures = len(program.entries), min(program.failures, 255)
        return messages.UploadProgress(
            self._shown_state, failures, declared, program.position
        ).pack()

    def _begin(self, packet: Packet) -> bytes:
        if self.intake.begin(messages.Begin.unpack(packet.body), self.exposing):
            self.frame = None
            self._loading = 0, b""
            self._reads.clear()
        return self._progress()

    def _declare(self, packet: Packet) -> bytes:
        self.intake.declare(declared(packet.body))
        return self._progress()

    def _data(self, packet: Packet) -> bytes:
        self.intake.data(packet.body)
        return self._progress()

    def _finish(self, packet: Packet) -> bytes:
        _need_length(packet.body, 32)
        self.intake.finish(packet.body)
        return self._progress()

    def _capture_with(self, packet: Packet) -> bytes:
        size = messages.CaptureRequest.layout.size
        return self._capture(replace(packet, body=packet.body[:size]), packet.body[size:])

    def _capture(self, packet: Packet, data: bytes | None = None) -> bytes:
        capture = messages.CaptureRequest.unpack(packet.body)
        program = self.intake.announced()
        if self.intake.state != LoaderState.READY:
            raise Refusal(LoaderFault.NO_PROGRAM)
        held = program.held
        if data is not None and len(data) != 4 * len(held.params):
            raise Refusal(LoaderFault.MALFORMED, len(held.params))
        frame = self.frame
        if frame is None or frame.number != capture.number:
            if self.exposing:
                raise Refusal(LoaderFault.BUSY)
            channels = capture.channels
            length = program.held.frame_bytes(channels, self.target)
            if not length or channels >= 2 * Channel.REPORTS:
                raise Refusal(LoaderFault.MALFORMED, channels)
            if length > self.limits.frame_bytes:
                raise Refusal(LoaderFault.TOO_LARGE, length)
            if data is not None:
                held.set_params(data)
            held.keep_schedule(self.target)
            self._reads.clear()
            self._loading = 0, b""
            frame = self.frame = Frame(capture.number, channels, self._now_us)
            self.exposing = True
            if program.held.too_late:
                frame.fault = Refusal(LoaderFault.LATE, program.held.kept.late)
            else:
                self.board.expose(program.held, channels)
                program.held.is_first = False
        if frame.fault is not None and not self.exposing:
            raise frame.fault
        return self._captured(frame, program.held)

    def _load(self, packet: Packet) -> bytes:
        head, data = packet.body[: LOAD.size], packet.body[LOAD.size :]
        if not data or len(data) > MOST_DATA:
            raise Refusal(LoaderFault.MALFORMED)
        if self.intake.refusal or self.intake.state != LoaderState.READY:
            raise Refusal(LoaderFault.NO_PROGRAM)
        if self.exposing:
            raise Refusal(LoaderFault.BUSY)
        register, position = LOAD.unpack(head)
        if position == 0:
            self.frame, self._loading = None, (register, b"")
            self._reads.clear()
        loading, loaded = self._loading
        if (register, position) == (loading, len(loaded)):
            size = plane_bytes(self.target.rows * self.target.cols)
            if len(loaded) + len(data) > size:
                raise Refusal(LoaderFault.PLANE, register)
            self._loading = register, loaded + data
            if len(loaded) + len(data) == size:
                try:
                    self.intake.announced().held.load(register, loaded + data, self.target)
                except Refusal:
                    self._loading = 0, b""
                    raise
        loading, loaded = self._loading
        return DATA.pack(len(loaded) if register == loading else 0)

    def _captured(self, frame: Frame, held: Held) -> bytes:
        readouts, length = len(held.readouts or ()), held.frame_bytes(frame.channels, self.target)
        readout_ms = int(min(self.target.readout_us, LONGEST_US)) // 1000 + 1
        whole = frame.data is not None and self._made(frame) == length
        crc, adler = frame.sums if whole else (0, 0)
        kept = ON_TIME if self.exposing else held.kept
        return messages.CaptureReply(
            number=frame.number,
            ready=frame.data is not None,
            channels=frame.channels,
            readouts=readouts,
            estimate_ms=held.frame_us // 1000 + readouts * readout_ms + 1,
            length=length,
            released=frame.released,
            started_us=frame.started_us,
            lasted_us=kept.lasted_us,
            readout_us=0,
            late=kept.late,
            latest_us=kept.latest_us,
            complete=whole,
            crc32=crc,
            adler32=adler,
        ).pack()

    @property
    def _hold(self) -> int:
        """How many bytes of a frame are kept behind those that the host has."""
        return (_KEPT // self.target.rows - 1) * self.target.rows

    def _made(self, frame: Frame) -> int:
        """How many bytes of a frame a chip would have made by now, column by column."""
        if frame.data is None:
            return 0
        columns = -(-(frame.released + self._hold) // self.target.rows)
        return min(columns * self.target.rows, len(frame.data))

    def _watch_exposure(self) -> None:
        if not self.exposing:
            return
        frame = self.frame
        assert frame is not None
        if frame.fault is None:
            try:
                data = self.board.exposed()
                if data is not None:
                    held = self.intake.announced().held
                    frame.data = held.with_reports(data, frame.channels, self.target)
            except RuntimeError:
                frame.fault = Refusal(LoaderFault.HARDWARE)
            if frame.data is not None:
                frame.sums = crc32(frame.data), adler32(frame.data)
        self.exposing = frame.data is None and frame.fault is None

    def _read(self, packet: Packet) -> None:
        read = messages.ReadRequest.unpack(packet.body)
        frame = self.frame
        if frame is None or frame.data is None or frame.number != read.number:
            raise Refusal(LoaderFault.NO_FRAME)
        inside = read.length > 0 and read.offset + read.length <= len(frame.data)
        known = read.confirmed <= min(self._made(frame), read.offset)
        if not inside or not known or not _SMALLEST_CHUNK <= read.chunk <= MOST_DATA:
            raise Refusal(LoaderFault.MALFORMED)
        released = max(read.confirmed, frame.released)
        if read.offset < released:
            raise Refusal(LoaderFault.NO_FRAME, released)
        if read.offset + read.length - released > self._hold:
            raise Refusal(LoaderFault.TOO_LARGE, released)
        if len(self._reads) == MOST_READS:
            raise Refusal(LoaderFault.BUSY)
        frame.released = released
        self._reads.append((packet.sequence, read))

    def _send_piece(self) -> None:
        sequence, read = self._reads.popleft()
        frame = self.frame
        if frame is None or frame.data is None or read.offset < frame.released:
            return
        size = min(read.chunk, read.length)
        data = frame.data[read.offset : read.offset + size]
        body = FRAME.pack(read.number, read.offset) + data
        self._send(Packet(PacketKind.READ | REPLY, sequence, self.session, body))
        if size < read.length:
            rest = replace(read, offset=read.offset + size, length=read.length - size)
            self._reads.appendleft((sequence, rest))

    def _cancel(self, packet: Packet) -> bytes:
        """Back to where a new program or a new frame can begin; what was uploaded stays."""
        _need_length(packet.body, 0)
        self._reads.clear()
        self.frame, self.exposing = None, False
        if self.intake.state == LoaderState.REFUSED:
            self.intake.forget()
        return self._progress()


def _need_length(body: bytes, length: int) -> None:
    if len(body) != length:
        raise Refusal(LoaderFault.MALFORMED)
