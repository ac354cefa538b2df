"""A stand-in behind a pseudo-terminal: a loader, a faulty cable, and a port to open."""

from __future__ import annotations

import errno
import os
import select
import tty
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from time import monotonic, sleep
from typing import Protocol

from nscc_runtime.device.faults import Accidents, LineFaults, Spoiler

_MOST_READ = 4096
_ROOM = 4096
_NOBODY_S = 0.01
_BUSY_S = 0.002
_PAUSE_S = 0.0002
_IDLE_S = 0.25
_BOOT_S = 0.1
_LET_GO_S = 2.0
"""Time for a host to close a port that vanished, in seconds."""
_MOST_TRIES = 64


class Loaded(Protocol):
    """A loader: the firmware's core, on this machine or on an emulated one."""

    @property
    def busy(self) -> bool:
        """Whether `poll` has work without new bytes."""

    def receive(self, data: bytes, now_us: int) -> None:
        """Receive bytes from the line."""

    def poll(self, now_us: int, room: int) -> bytes:
        """Return at most `room` bytes for the line."""

    def announce(self) -> None:
        """Restart the loader."""

    def watched(self) -> list[int]:
        """Return the file descriptors whose input gives `poll` work."""


class Terminal:
    """A pseudo-terminal whose name stays the same after a lost connection, if the system allows."""

    def __init__(self, name: str | None = None) -> None:
        self.name = ""
        spare_masters = []
        try:
            for _ in range(_MOST_TRIES):
                master, slave = os.openpty()
                self.name = os.ttyname(slave)
                tty.setraw(slave)
                os.close(slave)
                if name in (None, self.name):
                    break
                spare_masters.append(master)
            else:
                master = spare_masters.pop()
        finally:
            # The lowest free number is assigned first: close the terminals that were in the way.
            for spare in spare_masters:
                os.close(spare)
        os.set_blocking(master, False)
        self.fd = master
        self.opened = False

    def read(self) -> bytes | None:
        """Return the bytes written by the other side; None while the port is not open."""
        try:
            data = os.read(self.fd, _MOST_READ)
        except BlockingIOError:
            return b""
        except OSError as error:
            if error.errno != errno.EIO:
                raise
            return None
        self.opened = True
        return data

    def write(self, data: bytes) -> int:
        """Write bytes and return how many were accepted."""
        try:
            return os.write(self.fd, data)
        except BlockingIOError:
            return 0

    def hung_up(self) -> bool:
        """Return whether the port is not open."""
        poller = select.poll()
        poller.register(self.fd, select.POLLIN)
        return any(happened & select.POLLHUP for _, happened in poller.poll(0))

    def close(self) -> None:
        with suppress(OSError):
            os.close(self.fd)


class StandInServer:
    """Transfers bytes between a terminal and a loader, with `faults` of the line. `moved` is called
    with the new name of the port if the name changes."""

    def __init__(
        self, loader: Loaded, faults: LineFaults, moved: Callable[[str], None] = lambda _: None
    ) -> None:
        self.loader, self.faults, self.moved = loader, faults, moved
        self.terminal = Terminal()
        self._accidents = Accidents(faults)
        self._up, self._down = Spoiler(faults, 1), Spoiler(faults, 2)
        self._arriving: deque[tuple[float, bytes]] = deque()
        self._leaving: deque[tuple[float, bytes]] = deque()
        self._boots_until = 0.0
        self._connected = False
        self._until: float | None = None

    def serve(self, *, once: bool = False, seconds: float | None = None) -> None:
        """Serve for `seconds` (None: forever); with `once`, only until the first host has left."""
        self._until = None if seconds is None else monotonic() + seconds
        while not self._over():
            if self.terminal.hung_up():
                # Bytes are lost while the port is not open, as on any line.
                self._leaving.clear()
                if self._connected and once:
                    return
                self._turn(None)
                sleep(_NOBODY_S)
            else:
                self._connected = True
                self._turn(self.terminal.read())
                self._wait()

    def _over(self) -> bool:
        return self._until is not None and monotonic() >= self._until

    def _now_us(self) -> int:
        return int(monotonic() * 1e6)

    def _turn(self, data: bytes | None) -> None:
        now = monotonic()
        if data:
            self._arriving.append((now + self.faults.delay_s, self._up.spoiled(data)))
            self._accident(len(data))
        while self._arriving and self._arriving[0][0] <= now:
            _, piece = self._arriving.popleft()
            if now >= self._boots_until:
                self.loader.receive(piece, self._now_us())
        # Only bytes that are due occupy the buffer.
        late = sum(len(piece) for due, piece in self._leaving if due <= now)
        if now >= self._boots_until and late < _ROOM:
            out = self.loader.poll(self._now_us(), _ROOM)
            if out:
                self._leaving.append((now + self.faults.delay_s, self._down.spoiled(out)))
                self._accident(len(out))
        while self._leaving and self._leaving[0][0] <= now:
            due, piece = self._leaving.popleft()
            written = self.terminal.write(piece)
            if written < len(piece):
                self._leaving.appendleft((due, piece[written:]))
                break

    def _accident(self, count: int) -> None:
        for accident in self._accidents.passed(count):
            self._arriving.clear()
            if accident == "disconnect":
                self._leaving.clear()
                self._disconnect()
            else:
                self.loader.announce()
                self._boots_until = monotonic() + _BOOT_S

    def _disconnect(self) -> None:
        """Remove the port, and open it again after the outage, with its old name if possible."""
        name = self.terminal.name
        # While the other side is open, the number is not reused.
        reserved = os.open(name, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
        self.terminal.close()
        back = monotonic() + self.faults.outage_s
        while monotonic() < back and not self._over():
            sleep(_BUSY_S)
        os.close(reserved)
        self.terminal = Terminal(name)
        while self.terminal.name != name and monotonic() < back + _LET_GO_S:
            self.terminal.close()
            sleep(_BUSY_S)
            self.terminal = Terminal(name)
        self._connected = False
        if self.terminal.name != name:
            self.moved(self.terminal.name)

    def _wait(self) -> None:
        """Wait until a byte arrives, or other work is due."""
        now = monotonic()
        readers = [self.terminal.fd, *self.loader.watched()]
        if self._leaving and self._leaving[0][0] <= now:
            select.select(readers, [self.terminal.fd], [], _IDLE_S)
            return
        due = [queue[0][0] for queue in (self._arriving, self._leaving) if queue]
        waits = [_IDLE_S, *(max(time - now, 0.0) for time in due)]
        if self.loader.busy or self._boots_until > now:
            waits.append(_PAUSE_S if self.loader.busy else _BUSY_S)
        select.select(readers, [], [], min(waits))
