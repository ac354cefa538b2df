"""The host's side of the protocol, without I/O and without a clock.

A `Host` runs one task at a time, a generator that sends packets and waits for replies. The caller
passes received bytes (`receive`), fetches bytes to send (`poll`), and passes the time. Every wait
is bounded: a task finishes, or raises an exception of this module."""

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
"""A generator that yields deadlines, and receives a packet, or None at the deadline."""

FIRST_WAIT_S = 0.25
"""Wait for a reply before the time of replies is known, beside the time on the line."""
LONGEST_WAIT_S = 0.5
"""Longest interval between retries, short compared with two seconds for resuming a link."""
_SHORTEST_WAIT_S = 0.05
_MOST_RESTARTS = 40
"""Number of sessions of one task after which Stalled is raised."""
_MOST_TAKEN = 4
"""Number of sessions lost to other hosts after which Contested is raised."""
_STALL_FACTOR = 6
"""Patiences without progress after which a task that still gets replies counts as stalled."""
_SHOWN_BYTES = 24
"""Number of bytes of noise that a message shows."""


@dataclass(eq=False)
class Silent(Exception):
    """No reply arrived in time. `ever`: whether one came before. `noise`: the first bytes that
    arrived and are not packets."""

    ever: bool
    noise: bytes


class Stalled(Exception):
    """The loader replies, but the task makes no progress."""


@dataclass(eq=False)
class Implausible(Exception):
    """A loader's reply about a frame contradicts the program."""

    captured: CaptureReply


class Contested(Exception):
    """Another host starts sessions with the loader."""


@dataclass(eq=False)
class RequestRefused(Exception):
    """The loader refused a request, with a reason."""

    failure: LoaderFailure

    @property
    def fault(self) -> int:
        """Number of the fault; `messages.LoaderFault` names the faults of this version."""
        return self.failure.fault


class SessionLost(Exception):
    """The loader restarted, or the line was interrupted: the host must say hello and resume."""


class SessionTaken(SessionLost):
    """The loader does not know this session: it restarted, or another host began a session."""


class Host:
    """The host's end of a line.

    `new_session` returns a different number in 1 .. 2^32 - 1 each time. `patience_s`: longest
    silence. `line_s`: the time in seconds that a full window of bytes takes on the line. `info`:
    the loader's description, None without a session. `resent`: number of repeated packets."""

    def __init__(
        self, new_session: Callable[[], int], *, patience_s: float = 10.0, line_s: float = 0.06
    ) -> None:
        """Begin without a session, a task or an estimate of the time of replies.

        `new_session` returns a new number for a session. `patience_s` is the longest silence of the
        loader, `line_s` the time of a full window of bytes on the line, both in seconds."""
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
        self._first_bytes = b""
        self._task: Generator[float, Packet | None, object] | None = None
        self.deadline = 0.0
        """When `poll` must be called if nothing arrives before."""
        self.result: object = None

    def start(self, task: Generator[float, Packet | None, object], now: float) -> None:
        """Start a task at the time `now` (s, of any clock that `receive` and `poll` use too) up to
        its first wait. Unsent bytes and the rest of the previous task are discarded. Raises the
        exceptions of the task."""
        self.now = self._heard = self._moved = now
        self._out.clear()
        self.result = None
        self._task = task
        self._step(None)

    @property
    def running(self) -> bool:
        """Whether a task is running."""
        return self._task is not None

    def receive(self, data: bytes, now: float) -> None:
        """Process bytes that arrived from the line at the time `now` (s): each valid packet of this
        session resumes the task. Other bytes are ignored; that the loader restarted raises
        SessionLost in the task.

        Raises the exceptions of the task."""
        self.now = now
        self._first_bytes = (self._first_bytes + data)[:_SHOWN_BYTES]
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
        """Resume the task if its wait has expired at the time `now` (s), and return the bytes to
        send, which may be none. Raises the exceptions of the task."""
        self.now = now
        if self._task is not None and now >= self.deadline:
            self._step(None)
        out = bytes(self._out)
        self._out.clear()
        return out

    def line_restored(self, now: float) -> None:
        """Tell the task that the line was lost and is available again at the time `now` (s):
        SessionLost is raised in it. Bytes of the lost line are discarded."""
        self.now = self._heard = now
        self._unpacker = Unpacker()
        self._out.clear()
        if self._task is not None:
            self._step(None, SessionLost())

    def _step(self, packet: Packet | None, thrown: Exception | None = None) -> None:
        """Resume the task up to its next wait, with the packet that it waits for, None at its
        deadline, or the exception `thrown`.

        Stores the task's result or its next deadline; an exception of the task ends it and is
        raised."""
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
        """Send a request with this `body` at the next `poll`, and return its sequence number, 0 to
        65535."""
        self._sequence = self._sequence + 1 & 0xFFFF
        self._out += Packet(kind, self._sequence, self._session, body).wire()
        return self._sequence

    def moved(self) -> None:
        """Record progress of the task, so that it does not count as stalled."""
        self._moved = self.now

    def check_patience(self, extra_s: float = 0.0) -> None:
        """Raise Silent if nothing arrived for `patience_s`, or Stalled if the task made no progress
        for six times as long. `extra_s` is expected silence, which both may last longer."""
        if self.now - self._heard > self.patience_s + extra_s:
            raise Silent(self._ever_heard, self._first_bytes)
        if self.now - self._moved > _STALL_FACTOR * self.patience_s + extra_s:
            raise Stalled

    def timed(self, seconds: float) -> None:
        """Update the estimate of the reply time by a reply that took `seconds` (Jacobson's
        algorithm)."""
        if self._round_s is None:
            self._round_s, self._spread_s = seconds, seconds / 2
        else:
            self._spread_s += (abs(seconds - self._round_s) - self._spread_s) / 4
            self._round_s += (seconds - self._round_s) / 8

    @property
    def wait_s(self) -> float:
        """Seconds to wait for a reply before the request is repeated: the estimated time of a reply
        with its spread, and the time of a full window on the line."""
        if self._round_s is None:
            return FIRST_WAIT_S + self._line_s
        return max(self._round_s + 4 * self._spread_s, _SHORTEST_WAIT_S) + self._line_s

    def ask(self, kind: PacketKind, body: bytes = b"", *, extra_s: float = 0.0) -> Task[Packet]:
        """Send a request with this `body`, again after each wait without a reply, and return its
        reply. `extra_s`: how long the loader may be silent beyond the patience.

        Raises RequestRefused, SessionLost, Silent or Stalled."""
        sent: dict[int, float] = {}
        wait = self.wait_s
        while True:
            sequence = self.send(kind, body)
            sent[sequence] = self.now
            self.resent += len(sent) > 1
            until = self.now + wait
            while self.now < until:
                # A reply to any of the repetitions counts.
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
        """Start a session and return the loader's description, which is also stored in `info`.
        Raises like `ask`."""
        self._session = self._new_session()
        self.info = None
        reply = yield from self.ask(PacketKind.HELLO, Hello(VERSION, VERSION).pack())
        self.info = checked(Info.unpack, reply)
        return self.info

    def status(self) -> Task[Status]:
        """Return the loader's state and counters. Raises like `ask`."""
        reply = yield from self.ask(PacketKind.STATUS)
        return checked(Status.unpack, reply)

    def cancel(self) -> Task[None]:
        """Stop the loader's current activity. Raises like `ask`."""
        yield from self.ask(PacketKind.CANCEL)

    def lasting(self, work: Callable[[], Task[Result]]) -> Task[Result]:
        """Say hello if there is no session, do the task `work` and return its result. After a lost
        session, start `work` again, which continues from the loader's state.

        Raises Stalled if the session is lost 40 times, Contested if other hosts take the sessions
        of a loader that does not restart, and the other exceptions of `work`."""
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
    """Raise the exception of an ERROR packet: SessionTaken if the loader does not know the session,
    else RequestRefused."""
    failure = checked(LoaderFailure.unpack, packet)
    if failure.fault == LoaderFault.NO_SESSION:
        raise SessionTaken
    raise RequestRefused(failure)


def checked(unpack: Callable[[bytes], Result], packet: Packet) -> Result:
    """Return the body of a reply as the value that `unpack` makes of it. Raises RequestRefused
    for an invalid body."""
    try:
        return unpack(packet.body)
    except ValueError:
        raise RequestRefused(
            LoaderFailure(packet.kind, LoaderFault.MALFORMED, len(packet.body))
        ) from None
