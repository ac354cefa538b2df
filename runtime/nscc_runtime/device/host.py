"""The host's end of the protocol: no I/O and no clock of its own.

A `Host` runs one task at a time, a generator that sends packets and waits for replies. Whoever
drives it hands in bytes (`receive`), asks for bytes (`poll`) and says what time it is. Every wait
has an end: a task finishes, or it raises one of this module's exceptions.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
from dataclasses import dataclass
from typing import TypeVar

from nscc_runtime.device.messages import (
    CaptureReply,
    Hello,
    Info,
    LoaderFailure,
    LoaderFault,
    Status,
)
from nscc_runtime.device.packets import REPLY, VERSION, Packet, PacketKind, Unpacker

Result = TypeVar("Result")
Task = Generator[float, "Packet | None", Result]
"""Yields until when it waits at most; gets a packet, or None when that time has come."""

FIRST_WAIT_S = 0.25
LONGEST_WAIT_S = 0.5
"""Between two tries: short beside the two seconds in which a lost link is to be taken up again."""
_SHORTEST_WAIT_S = 0.05
_MOST_RESTARTS = 40
_MOST_TAKEN = 4
"""Sessions that may be lost, while the loader runs on, before somebody else must have them."""
_STALL_FACTOR = 6


@dataclass(eq=False)
class Silent(Exception):
    """Nothing was heard for as long as the host is willing to wait; `ever` whether before."""

    ever: bool
    noise: int


class Stalled(Exception):
    """The loader answers, and nothing gets done."""


class Implausible(Exception):
    """A loader says of a frame what no frame of the program can be."""

    def __init__(self, captured: CaptureReply) -> None:
        super().__init__()
        self.captured = captured


class Contested(Exception):
    """Another host begins conversations with the loader."""


@dataclass(eq=False)
class RequestRefused(Exception):
    """The loader said why it will not do what it was asked."""

    failure: LoaderFailure

    @property
    def fault(self) -> int:
        """The fault's number; `messages.Fault` names those that this version knows."""
        return self.failure.fault


class SessionLost(Exception):
    """The loader has started anew, or the line was away: say hello and go on from there."""


class SessionTaken(SessionLost):
    """The loader says that it has another session, or none."""


class Host:
    """One end of a line. `new_session` returns numbers in 1 .. 2^32 - 1, another one each time.

    `patience_s` is how long silence may last, `line_s` how long a window of bytes takes on the
    line.
    """

    def __init__(
        self, new_session: Callable[[], int], *, patience_s: float = 10.0, line_s: float = 0.06
    ) -> None:
        self.patience_s = patience_s
        self.info: Info | None = None
        self.now = 0.0
        self.resent = 0
        self._new_session = new_session
        self._session = 0
        self._sequence = 0
        self._unpacker = Unpacker()
        self._out = bytearray()
        self._line_s = line_s
        self._round_s: float | None = None
        self._spread_s = 0.0
        self._heard = 0.0
        self._moved = 0.0
        self._ever_heard = False
        self._task: Generator[float, Packet | None, object] | None = None
        self.deadline = 0.0
        """When `poll` must be called if nothing arrives before."""
        self.result: object = None

    def start(self, task: Generator[float, Packet | None, object], now: float) -> None:
        """Begin a task. What the one before left unsent is forgotten."""
        self.now = self._heard = self._moved = now
        self._out.clear()
        self.result = None
        self._task = task
        self._step(None)

    @property
    def running(self) -> bool:
        """Whether the task still has something to do."""
        return self._task is not None

    def receive(self, data: bytes, now: float) -> None:
        """Take bytes from the line; may raise what the task raises."""
        self.now = now
        for packet in self._unpacker.feed(data):
            self._heard = now
            self._ever_heard = True
            if self._task is None:
                continue
            if packet.kind == PacketKind.BOOTED:
                if self.info is not None:
                    self._step(None, SessionLost())
            elif packet.session == self._session:
                self._step(packet)

    def poll(self, now: float) -> bytes:
        """Go on where a wait has ended; the bytes to send now."""
        self.now = now
        if self._task is not None and now >= self.deadline:
            self._step(None)
        out = bytes(self._out)
        self._out.clear()
        return out

    def line_restored(self, now: float) -> None:
        """The line was away and is there again."""
        self.now = self._heard = now
        self._unpacker = Unpacker()
        self._out.clear()
        if self._task is not None:
            self._step(None, SessionLost())

    def _step(self, packet: Packet | None, thrown: Exception | None = None) -> None:
        assert self._task is not None
        try:
            self.deadline = self._task.throw(thrown) if thrown else self._task.send(packet)
        except StopIteration as done:
            self._task = None
            self.result = done.value
        except BaseException:
            self._task = None
            raise

    def send(self, kind: PacketKind, body: bytes = b"") -> int:
        """Send a request; its sequence number."""
        self._sequence = self._sequence + 1 & 0xFFFF
        self._out += Packet(kind, self._sequence, self._session, body).wire()
        return self._sequence

    def moved(self) -> None:
        """Something got done: a task calls this so that it is not taken for stalled."""
        self._moved = self.now

    def check_patience(self, extra_s: float = 0.0) -> None:
        """Raise Silent or Stalled where it has taken too long; `extra_s` is expected silence."""
        if self.now - self._heard > self.patience_s + extra_s:
            raise Silent(self._ever_heard, self._unpacker.damaged)
        if self.now - self._moved > _STALL_FACTOR * self.patience_s + extra_s:
            raise Stalled

    def timed(self, seconds: float) -> None:
        """A reply came after so long: what to expect of the next one (Jacobson's estimate)."""
        if self._round_s is None:
            self._round_s, self._spread_s = seconds, seconds / 2
        else:
            self._spread_s += (abs(seconds - self._round_s) - self._spread_s) / 4
            self._round_s += (seconds - self._round_s) / 8

    @property
    def wait_s(self) -> float:
        """How long to wait for a reply before asking again."""
        if self._round_s is None:
            return FIRST_WAIT_S + self._line_s
        return max(self._round_s + 4 * self._spread_s, _SHORTEST_WAIT_S) + self._line_s

    def ask(self, kind: PacketKind, body: bytes = b"", *, extra_s: float = 0.0) -> Task[Packet]:
        """Send a request until it is answered; raises Refused, SessionLost, Silent or Stalled."""
        sent: dict[int, float] = {}
        wait = self.wait_s
        while True:
            sequence = self.send(kind, body)
            sent[sequence] = self.now
            self.resent += len(sent) > 1
            until = self.now + wait
            while self.now < until:
                packet = yield until
                if packet is None or packet.sequence not in sent:
                    continue
                if packet.kind == PacketKind.ERROR:
                    raise_failure(packet)
                if packet.kind == kind | REPLY:
                    self.timed(self.now - sent[packet.sequence])
                    return packet
            self.check_patience(extra_s)
            wait = min(2 * wait, max(LONGEST_WAIT_S, self.wait_s))

    def hello(self) -> Task[Info]:
        """Begin a conversation; what the loader says of itself."""
        self._session = self._new_session()
        self.info = None
        reply = yield from self.ask(PacketKind.HELLO, Hello(VERSION, VERSION).pack())
        self.info = checked(Info.unpack, reply)
        return self.info

    def status(self) -> Task[Status]:
        """The loader's state and counters."""
        reply = yield from self.ask(PacketKind.STATUS)
        return checked(Status.unpack, reply)

    def cancel(self) -> Task[None]:
        """Stop what the loader is doing, so that anything can begin."""
        yield from self.ask(PacketKind.CANCEL)

    def lasting(self, work: Callable[[], Task[Result]]) -> Task[Result]:
        """Say hello and do `work`, again and again until it is done: each time it goes on from
        what the loader has. Raises Stalled where the loader keeps starting anew, Contested where it
        does not and yet has the sessions of another host."""
        lost_sessions, boot = 0, None
        for _ in range(_MOST_RESTARTS):
            try:
                if self.info is None:
                    info = yield from self.hello()
                    lost_sessions = lost_sessions if info.boot == boot else 0
                    boot = info.boot
                return (yield from work())
            except SessionTaken:
                self.info = None
                lost_sessions += 1
                if lost_sessions == _MOST_TAKEN:
                    raise Contested from None
            except SessionLost:
                self.info = None
        raise Stalled


def raise_failure(packet: Packet) -> None:
    """Raise what an ERROR packet says: SessionLost or Refused."""
    failure = checked(LoaderFailure.unpack, packet)
    if failure.fault == LoaderFault.NO_SESSION:
        raise SessionTaken
    raise RequestRefused(failure)


def checked(unpack: Callable[[bytes], Result], packet: Packet) -> Result:
    """The body of a reply; one that is none is refused as a fault of the loader."""
    try:
        return unpack(packet.body)
    except ValueError:
        raise RequestRefused(
            LoaderFailure(packet.kind, LoaderFault.MALFORMED, len(packet.body))
        ) from None
