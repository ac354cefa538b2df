"""Both ends of a line in real time: for a loader that has a clock of its own."""

from __future__ import annotations

from select import select
from time import monotonic

from device_simulation import Simulation

_LONGEST_WAIT_S = 0.02


class RealTime(Simulation):
    """A host and a loader that takes its time; what is sent takes what the line takes at least."""

    _began: float | None = None

    def _next(self) -> float:
        """Now, once something has arrived or something is due."""
        if self._began is None:
            self._began = monotonic() - self.now
        wait = super()._next() - (monotonic() - self._began)
        select(self.loader.watched(), [], [], min(max(wait, 0.0), _LONGEST_WAIT_S))
        return monotonic() - self._began
