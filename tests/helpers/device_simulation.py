"""Both ends of a line on a virtual clock: hours of a bad cable in a second, the same each time.

Time moves from event to event. A byte takes ten bits of the line; what is sent while the line is
away, or while the loader starts anew, is lost.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Generator
from dataclasses import dataclass

from nscc_runtime.device.firmware import RunningFirmware
from nscc_runtime.device.host import Host
from nscc_runtime.device.packets import Packet
from nscc_runtime.device.serving import Accidents, LineFaults, Spoiler

_PIECE = 256
_BOOT_S = 0.1
_TICK_S = 1e-3
_BITS_A_BYTE = 10


class Hung(Exception):
    """A task did not end in the time that it may take."""


@dataclass
class _Way:
    """One direction: the pieces under way, and when the line is free for the next."""

    spoiler: Spoiler
    free_at: float = 0.0
    bytes: int = 0
    busy_s: float = 0.0

    def __post_init__(self) -> None:
        self.pieces: deque[tuple[float, bytes]] = deque()


class Simulation:
    """A host and a loader with `faults` between them. `now` is the virtual time in seconds."""

    def __init__(
        self,
        host: Host,
        loader: RunningFirmware,
        faults: LineFaults | None = None,
        *,
        baud: float = 3e6,
    ) -> None:
        self.host, self.loader = host, loader
        self.faults = faults or LineFaults()
        self.now = 0.0
        self.events: list[tuple[float, str]] = []
        self._byte_s = _BITS_A_BYTE / baud
        self._accidents = Accidents(self.faults)
        self.up = _Way(Spoiler(self.faults, 1))
        self.down = _Way(Spoiler(self.faults, 2))
        self._away_until: float | None = None
        self._boots_until = 0.0

    def run(self, task: Generator[float, Packet | None, object], limit_s: float = 600.0) -> object:
        """Run a task to its end; its result. Raises what it raises, or Hung after `limit_s`."""
        end = self.now + limit_s
        self.host.start(task, self.now)
        while self.host.running:
            if self.now > end:
                raise Hung(f"after {limit_s} s, with {self.faults}")
            self._talk()
            if self.host.running:
                self.now = max(self.now, self._next())
                self._deliver()
        return self.host.result

    def _talk(self) -> None:
        if self._away_until is None:
            self._send(self.up, self.host.poll(self.now))
        if self.now >= self._boots_until and self.now >= self.down.free_at:
            self._send(self.down, self.loader.poll(self._now_us, _PIECE))

    @property
    def _now_us(self) -> int:
        return int(self.now * 1e6) + 1

    def _next(self) -> float:
        """When something happens next."""
        times = []
        if self._away_until is not None:
            times.append(self._away_until)
        elif self.host.running:
            times.append(self.host.deadline)
        times += [way.pieces[0][0] for way in (self.up, self.down) if way.pieces]
        if self.loader.busy:
            idle = self.now >= max(self.down.free_at, self._boots_until)
            next_free = max(self.down.free_at, self._boots_until)
            times.append(self.now + _TICK_S if idle else next_free)
        return min(times)

    def _send(self, way: _Way, data: bytes) -> None:
        for start in range(0, len(data), _PIECE):
            piece = data[start : start + _PIECE]
            begin = max(self.now, way.free_at)
            way.free_at = begin + len(piece) * self._byte_s
            way.bytes += len(piece)
            way.busy_s += len(piece) * self._byte_s
            if self._away_until is None:
                spoiled = way.spoiler.spoiled(piece)
                way.pieces.append((way.free_at + self.faults.delay_s, spoiled))
            for accident in self._accidents.passed(len(piece)):
                self._happen(accident)

    def _happen(self, accident: str) -> None:
        self.events.append((self.now, accident))
        self.up.pieces.clear()
        if accident == "disconnect":
            self.down.pieces.clear()
            self._away_until = self.now + self.faults.outage_s
        else:
            self._boots_until = self.now + _BOOT_S
            self.loader.announce()

    def _deliver(self) -> None:
        if self._away_until is not None and self.now >= self._away_until:
            self._away_until = None
            self.host.line_restored(self.now)
        while self.up.pieces and self.up.pieces[0][0] <= self.now:
            _, piece = self.up.pieces.popleft()
            if self.now >= self._boots_until:
                self.loader.receive(piece, self._now_us)
        while self.down.pieces and self.down.pieces[0][0] <= self.now:
            _, piece = self.down.pieces.popleft()
            if self._away_until is None and self.host.running:
                self.host.receive(piece, self.now)
