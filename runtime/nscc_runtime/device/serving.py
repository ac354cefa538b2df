"""A stand-in behind a pseudo-terminal: a loader, a faulty cable, and a port to open."""

from __future__ import annotations

import errno
import os
import re
import select
import tty
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from math import log
from random import Random
from time import monotonic, sleep

from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.diagnostics.suggest import meant
from nscc.mappings import NamedValues
from nscc_runtime.device.firmware import RunningFirmware

_TIME = re.compile(r"(\d+(?:\.\d+)?)(us|ms|s)")
_UNITS = {"us": 1e-6, "ms": 1e-3, "s": 1.0}
_LONGEST_S = 3600.0
"""Longest delay or outage, in seconds."""
EXAMPLE = "corrupt=1e-4,drop=1e-5,delay=50ms,disconnect=after:20000,reboot=after:40000"


@dataclass(frozen=True)
class LineFaults:
    """Simulated faults of a line.

    `corrupt`, `drop`: rates per byte, 0 to 1. `delay_s`: delay in each direction.
    `disconnect_after`: number of bytes, in both directions together, after which the line is
    interrupted for `outage_s`. `reboot_after`: number of such bytes after which the loader reboots.
    Both happen once; None for never. `seed`: of the random faults."""

    corrupt: float = 0.0
    drop: float = 0.0
    delay_s: float = 0.0
    disconnect_after: int | None = None
    reboot_after: int | None = None
    outage_s: float = 0.3
    seed: int = 0

    def __str__(self) -> str:
        """Return the faults as `--fault` takes them, times in seconds."""
        terms = [f"corrupt={self.corrupt:g}", f"drop={self.drop:g}", f"delay={self.delay_s:g}s"]
        for name, after in (("disconnect", self.disconnect_after), ("reboot", self.reboot_after)):
            if after is not None:
                terms.append(f"{name}=after:{after}")
        return ",".join([*terms, f"outage={self.outage_s:g}s", f"seed={self.seed}"])


# The field of `LineFaults` for each name of `--fault`.
NAMES = {
    "corrupt": "corrupt",
    "drop": "drop",
    "delay": "delay_s",
    "disconnect": "disconnect_after",
    "reboot": "reboot_after",
    "outage": "outage_s",
    "seed": "seed",
}


def parse_faults(text: str) -> LineFaults:
    """Return the faults of a line from a `text` such as EXAMPLE: NAME=VALUE, separated by commas,
    each name at most once; others keep their defaults. Raises Rejected (NS0769, status 2) for other
    texts."""
    values: NamedValues = {}
    for item in text.split(","):
        name, _, value = (piece.strip() for piece in item.partition("="))
        if name not in NAMES:
            raise _invalid_faults(f"unknown fault '{name[:40]}'", *meant(name, NAMES))
        if NAMES[name] in values:
            raise _invalid_faults(f"'{name}' is given twice")
        values[NAMES[name]] = _value(name, value)
    return LineFaults(**values)


def _value(name: str, text: str) -> float | int:
    """Return the value of the fault `name` that `text` gives: a rate per byte from 0 to 1, a time
    such as 50ms in seconds, `after:` with a number of bytes, or the whole number of a seed.

    Raises Rejected (NS0769) for other texts."""
    shown = f"{name}={text[:40]}"
    if name in ("corrupt", "drop"):
        with suppress(ValueError):
            if 0 <= float(text) <= 1:
                return float(text)
        raise _invalid_faults(f"'{shown}' is not a rate per byte from 0 to 1")
    if name in ("delay", "outage"):
        match = _TIME.fullmatch(text)
        seconds = float(match[1]) * _UNITS[match[2]] if match else _LONGEST_S + 1
        if seconds > _LONGEST_S:
            raise _invalid_faults(f"'{shown}' is not a time such as 50ms, at most {_LONGEST_S:g} s")
        return seconds
    digits = text if name == "seed" else text.removeprefix("after:")
    counted = name == "seed" or text.startswith("after:")
    if not counted or not digits.isascii() or not digits.isdigit() or len(digits) > 12:
        raise _invalid_faults(
            f"'{shown}' should be {name}={'1' if name == 'seed' else 'after:BYTES'}"
        )
    return int(digits)


def _invalid_faults(problem: str, *helps: str) -> Rejected:
    """Return the error (NS0769) that `--fault` has this `problem`; without `helps`, the help is
    EXAMPLE."""
    return rejected(
        "NS0769",
        f"--fault: {problem}",
        notes=(f"--fault takes a comma-separated list of: {', '.join(NAMES)}",),
        helps=helps or (f"for instance --fault {EXAMPLE}",),
    )


class Spoiler:
    """Corrupts and drops bytes at the rates of `faults`; the seed determines the sequence."""

    def __init__(self, faults: LineFaults, seed: int) -> None:
        """Draw when the first faults occur. `seed` distinguishes the two directions of the line;
        the random sequence follows from it and from `faults.seed`."""
        self._random = Random(f"{faults.seed} {seed}")
        self._faults = faults
        self._to_corrupt = self._gap(faults.corrupt)
        self._to_drop = self._gap(faults.drop)

    def _gap(self, rate: float) -> int:
        """Return the random number of undamaged bytes before the next fault, if each byte is
        damaged with the probability `rate`. At rate 0 it is more than will ever pass."""
        if rate <= 0:
            return 1 << 62
        if rate >= 1:
            return 0
        # The inverse of the distribution: the next n bytes pass with probability (1 - rate)^n.
        return int(log(1 - self._random.random()) / log(1 - rate))

    def spoiled(self, data: bytes) -> bytes:
        """Return what arrives of `data` at the other end of the line, with some bytes changed and
        some missing."""
        if self._to_corrupt >= len(data) and self._to_drop >= len(data):
            self._to_corrupt -= len(data)
            self._to_drop -= len(data)
            return data
        out = bytearray()
        for byte in data:
            value = byte
            if self._to_corrupt == 0:
                value ^= self._random.randrange(1, 256)
                # Plus 1, because the byte itself is counted below.
                self._to_corrupt = self._gap(self._faults.corrupt) + 1
            if self._to_drop == 0:
                self._to_drop = self._gap(self._faults.drop) + 1
            else:
                out.append(value)
            self._to_corrupt -= 1
            self._to_drop -= 1
        return bytes(out)


class Accidents:
    """Decides, by the number of transferred bytes, when the line breaks or the loader reboots."""

    def __init__(self, faults: LineFaults) -> None:
        """Plan the accidents that `faults` describe: after how many bytes the line breaks, and
        after how many the loader restarts."""
        after = {"disconnect": faults.disconnect_after, "reboot": faults.reboot_after}
        self._to_come = {name: count for name, count in after.items() if count is not None}
        self._passed = 0

    def passed(self, count: int) -> list[str]:
        """Return the accidents ("disconnect", "reboot") that fall due with `count` more bytes; each
        is returned once."""
        self._passed += count
        due = [name for name, after in self._to_come.items() if self._passed >= after]
        for name in due:
            del self._to_come[name]
        return due


_MOST_READ = 4096
_ROOM = 4096
"""Number of bytes of the loader that wait for the terminal before no more are taken."""
_NOBODY_S = 0.01
_BUSY_S = 0.002
_PAUSE_S = 0.0002
_IDLE_S = 0.25
"""Longest pauses in seconds: without a host, in an outage, with a busy loader, and else."""
_BOOT_S = 0.1
"""Time of a reboot, in seconds."""
_LET_GO_S = 2.0
"""Time for a host to close a port that vanished, in seconds."""
_MOST_TRIES = 64
"""Number of terminals that are opened to get one of the wanted name."""


class Terminal:
    """A pseudo-terminal whose name stays the same after a lost connection, if the system allows."""

    def __init__(self, name: str | None = None) -> None:
        """Open a pseudo-terminal, if possible with this `name`, so that a device seems to return to
        its port. If the name cannot be had, or is None, it has another one (attribute `name`)."""
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

    def read(self) -> bytes | None:
        """Return the bytes written by the other side, b"" if there are none; None while the port is
        not open."""
        try:
            return os.read(self.fd, _MOST_READ)
        except BlockingIOError:
            return b""
        except OSError as error:
            if error.errno != errno.EIO:
                raise
            return None

    def write(self, data: bytes) -> int:
        """Write `data` and return how many of its bytes, from the start, were accepted: 0 if the
        terminal is full."""
        try:
            return os.write(self.fd, data)
        except BlockingIOError:
            return 0

    def hung_up(self) -> bool:
        """Return whether no host has the port open."""
        poller = select.poll()
        poller.register(self.fd, select.POLLIN)
        return any(happened & select.POLLHUP for _, happened in poller.poll(0))

    def close(self) -> None:
        """Close the terminal."""
        with suppress(OSError):
            os.close(self.fd)


class StandInServer:
    """Transfers bytes between a terminal and a loader, with `faults` of the line."""

    def __init__(
        self,
        loader: RunningFirmware,
        faults: LineFaults,
        moved: Callable[[str], None] = lambda _: None,
    ) -> None:
        """Open a terminal in front of `loader`. `moved` is called with the new name of the port if
        it changes after an outage."""
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
        """Serve hosts for `seconds` (None: forever); with `once`, only until the first host has
        left. Raises RuntimeError if the loader's process ends."""
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
        """Return whether the time of the server has passed."""
        return self._until is not None and monotonic() >= self._until

    def _turn(self, data: bytes | None) -> None:
        """Pass on the bytes that are due in both directions. `data` are bytes from the host, None
        or empty for none.

        Bytes are delayed and damaged as `faults` says. A rebooting loader receives and sends
        nothing."""
        now = monotonic()
        now_us = int(now * 1e6)
        if data:
            self._arriving.append((now + self.faults.delay_s, self._up.spoiled(data)))
            self._accident(len(data))
        while self._arriving and self._arriving[0][0] <= now:
            _, piece = self._arriving.popleft()
            if now >= self._boots_until:
                self.loader.receive(piece, now_us)
        # Only bytes that are due occupy the buffer.
        late = sum(len(piece) for due, piece in self._leaving if due <= now)
        if now >= self._boots_until and late < _ROOM:
            out = self.loader.poll(now_us, _ROOM)
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
        """Count `count` bytes on the line; disconnect or reboot where the faults say so. Delayed
        bytes to the loader are lost then."""
        for accident in self._accidents.passed(count):
            self._arriving.clear()
            if accident == "disconnect":
                self._leaving.clear()
                self._disconnect()
            else:
                self.loader.announce()
                self._boots_until = monotonic() + _BOOT_S

    def _disconnect(self) -> None:
        """Remove the port, and open it again after the outage, with its old name if that becomes
        free within `_LET_GO_S`; otherwise `moved` is called with the new name."""
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
        """Wait until a byte arrives or can be written, or delayed bytes or other work are due, at
        most `_IDLE_S` seconds."""
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
