"""Tasks of a host: upload a program, expose a frame, fetch it."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from zlib import adler32, crc32

import numpy as np

from nscc_runtime.device import messages
from nscc_runtime.device.host import (
    LONGEST_WAIT_S,
    Host,
    Implausible,
    RequestRefused,
    Task,
    checked,
    raise_failure,
)
from nscc_runtime.device.messages import (
    DATA,
    FRAME,
    CaptureReply,
    LoaderFailure,
    LoaderFault,
    LoaderState,
    UploadProgress,
    frame_bytes,
)
from nscc_runtime.device.objects import Upload
from nscc_runtime.device.packets import OVERHEAD, REPLY, Packet, PacketKind

LONGEST_US = 1_200_000_000
"""Longest time from the first to the last word of a frame, in microseconds."""
CHUNK = 64
"""Bytes of a frame are sent in multiples of this number, except at the end of the frame."""
_BESIDE_S = 10.0
"""Time beside exposure and readout that any frame may take, in seconds."""


@dataclass(eq=False)
class FrameRequest:
    """A frame to be exposed, with a unique `number`.

    `channels`: bits of `Channel`. `program`: None if only the device knows it; `pixels` is then the
    number of pixels of the frame. `received`: its bytes so far, None before the loader's first
    reply. `values`: those of the program's parameters, in their order."""

    number: int
    channels: int
    program: Upload | None = None
    pixels: int = 0
    received: FrameBytes | None = None
    values: tuple[int, ...] = ()

    def bytes(self, readouts: int) -> int:
        """Return the expected number of bytes of the frame if the loader reports this number of
        `readouts`; 0 if the program has another number."""
        program = self.program
        if program is None:
            return frame_bytes(self.channels, self.pixels, readouts, 0)
        matches = readouts == program.readouts
        return matches * frame_bytes(
            self.channels, program.pixels, readouts, program.states, program.report_bytes
        )

    def exposure_s(self, captured: CaptureReply) -> float:
        """Return the shorter of two estimates of the exposure time in seconds: the loader's, in its
        reply `captured`, and the host's if it knows the program."""
        own_ms = captured.estimate_ms if self.program is None else self.program.frame_ms
        return min(own_ms, captured.estimate_ms) / 1000

    @property
    def longest_s(self) -> float:
        """Longest time in seconds that a loader may take: twice the host's estimate, plus overhead.
        For an unknown program it is twice the limit of all loaders."""
        program = self.program
        if program is None:
            return 2e-6 * LONGEST_US
        return 2e-3 * (program.frame_ms + program.readout_ms) + _BESIDE_S


class FrameBytes:
    """The received bytes of a frame. `origin` identifies the exposure: the loader's start
    (`Info.boot`) and its clock when the exposure began.

    They are kept when the line is lost, because a loader discards bytes that the host has
    confirmed. `missing` has a byte for each chunk of `CHUNK` bytes, 1 until it has arrived, and
    `missing_count` counts the ones."""

    def __init__(self, length: int, origin: tuple[int, int]) -> None:
        """Begin with all chunks of the frame's `length` bytes missing. `origin` is the loader's
        start and its clock when the exposure began."""
        self.origin = origin
        self.data = bytearray(length)
        self.missing = bytearray(b"\1" * -(-length // CHUNK))
        self.missing_count = len(self.missing)

    @property
    def confirmed(self) -> int:
        """The offset before which all bytes have been received."""
        first = self.missing.find(1)
        return len(self.data) if first < 0 else first * CHUNK

    def store(self, offset: int, data: bytes) -> bool:
        """Store bytes of complete chunks at `offset`, a multiple of `CHUNK`; only the frame's last
        chunk may be shorter. Return whether any of them were missing before; if none was, change
        nothing."""
        first, last = offset // CHUNK, -(-(offset + len(data)) // CHUNK)
        fresh = self.missing.count(1, first, last)
        if fresh:
            self.data[offset : offset + len(data)] = data
            self.missing[first:last] = bytes(last - first)
            self.missing_count -= fresh
        return bool(fresh)


_SMALLEST_WINDOW = 2 * (CHUNK + 64)
"""Two of the smallest packets, so that one is on its way while the other is answered."""
_MOST_DIGEST_FAILURES = 8
"""Number of objects with a wrong digest after which an upload fails."""
_GROW_AFTER = 8
"""Number of packets without a loss after which packets become larger."""
_READ_AHEAD = 6
_READ_CHUNKS = 8
"""Most pending requests for bytes of a frame, and most packets of each."""
_POLL_S = 0.02
_LONGEST_POLL_S = 0.25
"""First and longest interval between questions whether a frame is ready."""
_LONGEST_SILENCE_S = 5.0
"""Longest time without a question while a frame is exposed, so that a restart is noticed."""
_BUSY_WAIT_S = 0.1
_FIRST_WINDOW = 2048
"""Initial number of bytes in flight: grows without losses, is halved after a loss."""

Watch = Callable[[int], None]
"""A function that is called with the number of bytes transferred so far."""


@dataclass(frozen=True)
class FetchedFrame:
    """A received frame: the loader's reply, and its bytes with verified checksums."""

    captured: CaptureReply
    data: bytes


def upload(host: Host, program: Upload, watch: Watch = lambda _: None) -> Task[bool]:
    """Upload a program, and continue an upload that a lost link interrupted. Return whether the
    loader already had the program.

    `watch` receives the number of bytes acknowledged. Raises the exceptions of `Host.ask`:
    RequestRefused if the loader does not take the program."""
    progress = yield from _begun(host, program.begin)
    already_held = progress.state != LoaderState.RECEIVING
    while progress.declared < len(program.objects) and progress.state == LoaderState.RECEIVING:
        objects = program.objects[progress.declared : progress.declared + messages.MOST_ENTRIES]
        declare = messages.Declare(progress.declared, tuple(object_.entry for object_ in objects))
        reply = yield from host.ask(PacketKind.DECLARE, declare.pack())
        progress = checked(UploadProgress.unpack, reply)
        host.moved()
    if progress.state == LoaderState.RECEIVING:
        yield from _Sender(host, program.stream, progress, watch).run()
    yield from host.ask(PacketKind.FINISH, program.digest)
    host.moved()
    return already_held


def forget(host: Host, program: Upload) -> Task[None]:
    """Make the loader forget its program, by uploading one without objects for the target of
    `program`. Raises the exceptions of `Host.ask`."""
    zeros = bytes(32)
    yield from _begun(host, messages.Begin(program.target, zeros, zeros, 0, 0))


def load(host: Host, register: int, plane: bytes) -> Task[None]:
    """Load the bytes of a `plane` into the digital register number `register` of the program that
    the loader has. Raises the exceptions of `Host.ask`."""
    assert host.info is not None
    sent, most = 0, host.info.most_data
    while sent < len(plane):
        body = messages.LOAD.pack(register, sent) + plane[sent : sent + most]
        reply = yield from _idle(host, PacketKind.LOAD, body)
        position = checked(messages.loaded_bytes, reply)
        if position > sent:
            host.moved()
        host.check_patience()
        # The loader says from where on it needs bytes, also after a packet that it dropped.
        sent = position


def _begun(host: Host, begin: messages.Begin) -> Task[UploadProgress]:
    """Announce a program by `begin`, and return how much of it the loader has. An exposure that
    runs is stopped first. Raises the exceptions of `Host.ask`."""
    reply = yield from _idle(host, PacketKind.BEGIN, begin.pack())
    host.moved()
    return checked(UploadProgress.unpack, reply)


def _idle(
    host: Host, kind: PacketKind, body: bytes, extra_s: float = 0.0, stop: bool = True
) -> Task[Packet]:
    """Send a request with this `body` and return its reply. While the loader is busy, the request
    is sent again, and with `stop` its exposure is stopped. `extra_s`: as in `Host.ask`, whose other
    exceptions are raised."""
    while True:
        try:
            return (yield from host.ask(kind, body, extra_s=extra_s))
        except RequestRefused as refused:
            if refused.fault != LoaderFault.BUSY:
                raise
            if stop:
                yield from host.cancel()
            yield from pause(host, _BUSY_WAIT_S)


def pause(host: Host, seconds: float) -> Task[None]:
    """Let `host` wait for a time in seconds, during which packets are ignored. Raises Silent or
    Stalled after too long a wait."""
    until = host.now + seconds
    while host.now < until:
        yield until
    host.check_patience(seconds)


class _Chunk:
    """The bytes per packet: halved after a loss, doubled after some packets without a loss."""

    def __init__(self, most: int) -> None:
        """Begin with the largest allowed chunk: `most` bytes, rounded down to a multiple of
        `CHUNK`, at least one."""
        self.most = self.size = max(CHUNK, most // CHUNK * CHUNK)
        self._good = 0

    def record_arrival(self) -> None:
        """Note that a chunk arrived: after `_GROW_AFTER` without a loss, chunks become twice as
        large, at most the largest allowed."""
        self._good += 1
        if self._good >= _GROW_AFTER and self.size < self.most:
            self.size, self._good = min(2 * self.size, self.most), 0

    def record_loss(self) -> None:
        """Note that a chunk was lost: chunks become half as large, at least `CHUNK` bytes."""
        self.size, self._good = max(self.size // 2, CHUNK), 0


class _Sender:
    """Sends a stream with many packets in flight; goes back after a loss, to keep the order."""

    def __init__(self, host: Host, stream: bytes, progress: UploadProgress, watch: Watch) -> None:
        """Begin to send `stream` at the position that the loader reports in `progress`. `watch`
        receives the number of bytes acknowledged.

        `sent` has for each packet in flight its sequence number, its position in the stream, its
        bytes on the wire, and the time when it was sent. `given_up` has these times of packets that
        count as lost, by sequence number."""
        assert host.info is not None
        self.host, self.stream, self.watch = host, stream, watch
        self.most = max(host.info.window, _SMALLEST_WINDOW)
        self.window = min(self.most, _FIRST_WINDOW)
        self.chunk = _Chunk(min(host.info.most_data, self.window // 2))
        self.acknowledged = self.next = progress.position
        self.failures = progress.failures
        self.sent: deque[tuple[int, int, int, float]] = deque()
        self.given_up: dict[int, float] = {}
        self.flying = 0
        self.wait = host.wait_s

    def run(self) -> Task[None]:
        """Send the stream until the loader has acknowledged all of it.

        After a timeout everything not acknowledged is sent again. Raises RequestRefused for an
        error of the loader, Silent or Stalled after too long a wait."""
        host = self.host
        while self.acknowledged < len(self.stream):
            self._fill()
            until = self.sent[0][3] + self.wait
            packet = yield until
            if packet is None:
                if host.now >= until:
                    self.wait = min(2 * self.wait, max(LONGEST_WAIT_S, host.wait_s))
                    self._back_to(self.acknowledged)
                continue
            if packet.kind == PacketKind.ERROR and self._ours(packet.sequence):
                raise_failure(packet)
            if packet.kind == PacketKind.DATA | REPLY:
                self._acknowledge(packet.sequence, checked(UploadProgress.unpack, packet))

    def _ours(self, sequence: int) -> bool:
        """Return whether a reply with this `sequence` number belongs to a packet in flight."""
        return any(number == sequence for number, *_ in self.sent)

    def _fill(self) -> None:
        """Send packets as long as the bytes in flight fit into the window; one packet is always
        sent."""
        while self.next < len(self.stream):
            data = self.stream[self.next : self.next + self.chunk.size]
            # The bytes on the wire: stuffing adds at most 2 and one in 128, and zero bytes stand
            # around.
            cost = len(data) + OVERHEAD + DATA.size + 2 + len(data) // 128 + 2
            if self.flying and self.flying + cost > self.window:
                return
            sequence = self.host.send(PacketKind.DATA, DATA.pack(self.next) + data)
            self.sent.append((sequence, self.next, cost, self.host.now))
            self.flying += cost
            self.next += len(data)

    def _back_to(self, position: int) -> None:
        """Send again from `position` in the stream: halve the window and the packets, and forget
        what is in flight.

        Raises Silent or Stalled after too long a wait."""
        self.host.check_patience()
        self.host.resent += len(self.sent)
        self.chunk.record_loss()
        self.window = max(self.window // 2, _SMALLEST_WINDOW)
        self.given_up = {number: since for number, _, _, since in self.sent}
        self.sent.clear()
        self.flying = 0
        self.acknowledged = self.next = position

    def _acknowledge(self, sequence: int, progress: UploadProgress) -> None:
        """Use the reply to the packet `sequence`, which has the loader's `progress`: advance, or
        send again from where the loader is.

        A reply measures the round trip and enlarges the window. A late one shows that the line is
        slower than estimated. Raises RequestRefused if digests of objects fail too often."""
        if not self._ours(sequence):
            late_since = self.given_up.pop(sequence, None)
            if late_since is not None:  # the line is slower than estimated
                self.host.timed(self.host.now - late_since)
                self.wait = max(self.wait, self.host.wait_s)
                if progress.failures == self.failures and progress.position > self.acknowledged:
                    self._advance(progress.position)
            return
        while True:
            number, position, cost, since = self.sent.popleft()
            self.flying -= cost
            if number == sequence:
                break
        if progress.failures != self.failures:
            self.failures = progress.failures
            if self.failures >= _MOST_DIGEST_FAILURES:
                raise RequestRefused(
                    LoaderFailure(PacketKind.DATA, LoaderFault.DIGEST, progress.position)
                )
            self._back_to(progress.position)
        # The loader did not take this packet: an earlier one was lost.
        elif progress.position <= position:
            self._back_to(progress.position)
        else:
            self.host.timed(self.host.now - since)
            self.wait = self.host.wait_s
            self.chunk.record_arrival()
            # One more packet in flight per acknowledgement: twice as many after a round trip.
            self.window = min(self.window + cost, self.most)
            self._advance(progress.position)

    def _advance(self, position: int) -> None:
        """Record that the loader has everything before `position` of the stream, and report the
        progress."""
        self.acknowledged = max(self.acknowledged, position)
        # The loader may be ahead of retransmissions, but never behind its acknowledgement.
        behind = self.next < self.acknowledged or not self.sent
        self.next = self.acknowledged if behind else self.next
        self.host.moved()
        self.watch(self.acknowledged)


def capture(host: Host, request: FrameRequest) -> Task[FetchedFrame]:
    """Expose the frame of `request` and fetch it. A frame that exists already is not exposed again,
    and its bytes that were received before a lost link are kept.

    Raises RequestRefused if the checksums do not match, Implausible for a frame of another size,
    and the exceptions of `Host.ask`."""
    captured = yield from _captured(host, request)
    assert host.info is not None
    origin = host.info.boot, captured.started_us
    if request.received is None or request.received.origin != origin:
        request.received = FrameBytes(captured.length, origin)
    yield from _Fetcher(host, request.number, request.received).run()
    captured = yield from _captured(host, request)
    data = bytes(request.received.data)
    sums = captured.crc32, captured.adler32
    if not captured.complete or sums != (crc32(data), adler32(data)):
        raise RequestRefused(LoaderFailure(PacketKind.READ, LoaderFault.DIGEST, 0))
    return FetchedFrame(captured, data)


def _captured(host: Host, request: FrameRequest) -> Task[CaptureReply]:
    """Expose the requested frame and return the loader's reply about it, asking again while it is
    being exposed.

    Raises RequestRefused for errors and for replies about another frame, Implausible for a frame of
    another size, and Silent or Stalled after too long a wait."""
    body = messages.CaptureRequest(request.number, request.channels).pack()
    body += np.array(request.values, "<i4").tobytes()
    kind = PacketKind.CAPTURE_WITH if request.values else PacketKind.CAPTURE
    poll, extra, silent = _POLL_S, 0.0, False
    while True:
        reply = yield from _idle(host, kind, body, extra, stop=False)
        captured = checked(CaptureReply.unpack, reply)
        if captured.number != request.number or captured.channels != request.channels:
            raise RequestRefused(LoaderFailure(kind, LoaderFault.MALFORMED, 0))
        if captured.length != request.bytes(captured.readouts) or not captured.length:
            raise Implausible(captured)
        if captured.ready:
            host.moved()
            return captured
        extra = min(2 * captured.estimate_ms / 1000, request.longest_s)
        host.check_patience(extra)
        if not silent:
            # Do not disturb the loader while words run.
            silent = True
            yield from pause(host, min(request.exposure_s(captured), _LONGEST_SILENCE_S))
        yield from pause(host, poll)
        poll = min(2 * poll, _LONGEST_POLL_S)


@dataclass(frozen=True)
class _Range:
    """A pending request for bytes `start` to `stop` (excluded) of the frame, sent at the time
    `since`.

    `alone`: whether no other request was pending, so that its first packet measures the reply
    time."""

    start: int
    stop: int
    since: float
    alone: bool


class _Fetcher:
    """Requests ranges of a frame, several at a time, and again after losses.

    A loader serves requests in order: a packet of one request means that earlier requests are
    complete or lost. It keeps only a limited number of bytes behind those confirmed by the host."""

    def __init__(self, host: Host, number: int, frame_bytes: FrameBytes) -> None:
        """Begin to fetch frame `number` into `frame_bytes`, with no request sent.

        `asked` has the pending requests and `given_up` those that count as lost, by sequence
        number. `heard` is the time of the last piece of the frame."""
        assert host.info is not None
        self.host, self.number, self.frame_bytes = host, number, frame_bytes
        self.hold = max(host.info.hold, CHUNK)
        self.chunk = _Chunk(min(host.info.most_data, self.hold // 2))
        self.asked: dict[int, _Range] = {}
        self.given_up: dict[int, _Range] = {}
        self.heard = host.now
        self.wait = host.wait_s

    def run(self) -> Task[None]:
        """Request the missing chunks of the frame until none is missing.

        Requests without an answer are sent again. Raises RequestRefused for errors other than
        "busy", Silent or Stalled after too long a wait."""
        host = self.host
        while self.frame_bytes.missing_count:
            self._ask()
            until = (
                max(self.heard, min(pending.since for pending in self.asked.values())) + self.wait
            )
            packet = yield until
            if packet is None:
                if host.now >= until:
                    host.check_patience()
                    self.given_up.clear()
                    self._lose(list(self.asked))
                    self.wait = min(2 * self.wait, max(LONGEST_WAIT_S, host.wait_s))
                continue
            if packet.kind == PacketKind.ERROR and packet.sequence in self.asked:
                if checked(LoaderFailure.unpack, packet).fault != LoaderFault.BUSY:
                    raise_failure(packet)
            elif packet.kind == PacketKind.READ | REPLY and len(packet.body) > FRAME.size:
                number, offset = FRAME.unpack_from(packet.body)
                if number == self.number:
                    self._take(packet.sequence, offset, packet.body[FRAME.size :])
        host.moved()

    def _ask(self) -> None:
        """Request the next missing chunks, several requests ahead, as far as the loader holds the
        frame."""
        # New requests are sent several at a time, when half of them are answered.
        if len(self.asked) > _READ_AHEAD // 2:
            return
        frame_bytes, confirmed = self.frame_bytes, self.frame_bytes.confirmed
        pending = bytearray(frame_bytes.missing)
        for pending_range in self.asked.values():
            first, last = pending_range.start // CHUNK, -(-pending_range.stop // CHUNK)
            pending[first:last] = bytes(last - first)
        most = min(_READ_CHUNKS * self.chunk.size, max(self.hold // 4, CHUNK))
        room = (confirmed + self.hold) // CHUNK
        end = 0
        while len(self.asked) < _READ_AHEAD:
            begin = pending.find(1, end)
            if begin < 0 or begin >= room:
                return
            end = pending.find(0, begin)
            end = len(pending) if end < 0 else end
            end = min(end, room, begin + most // CHUNK)
            start, stop = begin * CHUNK, min(end * CHUNK, len(frame_bytes.data))
            read = messages.ReadRequest(
                self.number, start, stop - start, confirmed, self.chunk.size
            )
            request = _Range(start, stop, self.host.now, alone=not self.asked)
            self.asked[self.host.send(PacketKind.READ, read.pack())] = request

    def _lose(self, sequences: list[int]) -> None:
        """Give up the requests with these `sequences`, so that their chunks are requested again in
        smaller packets. Counts them in `host.resent`."""
        for sequence in sequences:
            self.given_up[sequence] = self.asked.pop(sequence)
            self.host.resent += 1
        if sequences:
            self.chunk.record_loss()

    def _take(self, sequence: int, offset: int, data: bytes) -> None:
        """Store a received piece of the frame, `data` from `offset` on, and use it to measure the
        line. It answers the request `sequence`.

        Pieces that do not match chunks are ignored. Requests sent before the answered one count as
        lost."""
        end = offset + len(data)
        length = len(self.frame_bytes.data)
        chunk_aligned = end % CHUNK == 0 or end == length
        if offset % CHUNK or end > length or not chunk_aligned:
            return
        if self.frame_bytes.store(offset, data):
            self.chunk.record_arrival()
            self.host.moved()
        request = self.asked.get(sequence) or self.given_up.get(sequence)
        if request is None:
            return
        self.heard = self.host.now
        if request.alone and offset == request.start:
            self.host.timed(self.host.now - request.since)
        self.wait = self.host.wait_s
        if sequence not in self.asked:
            return
        # Older requests: numbers wrap at 2^16.
        self._lose([n for n in self.asked if 0 < (sequence - n & 0xFFFF) < 0x8000])
        if end >= request.stop:
            del self.asked[sequence]
