"""Times of runs, without what only the first run of a process takes."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from time import perf_counter
from typing import Any, TypeVar

T = TypeVar("T")

SHORT_MS = 500.0
"""The first run of a setting does not count where it is shorter than this: what caches it fills
may be most of it, and another run costs little."""


class Stopwatch:
    """Times runs of kinds and settings; the first of a process compiles, loads and allocates, and
    is not timed.

    Runs of one `kind` compile and load the same things, as a method does on data of one shape;
    `setting` tells them apart. `clock` counts seconds.
    """

    def __init__(self, clock: Callable[[], float] = perf_counter) -> None:
        self._clock = clock
        self._seen: set[Hashable] = set()

    def ran(self, kind: Hashable, *settings: Hashable) -> None:
        """Takes note that these have been run already."""
        self._seen.update((kind, *((kind, setting) for setting in settings)))

    def ms(
        self,
        kind: Hashable,
        setting: Hashable,
        run: Callable[[], T],
        first: Callable[[], Any] | None = None,
    ) -> tuple[T, float]:
        """What a run gives, and its milliseconds.

        Before the first of its kind `first` is run, by default the same; the first of its setting
        is done again where it is short. So a long run is done once more for its kind at the most,
        and not at all where `first` is something smaller.
        """
        if kind not in self._seen:
            if first is None:
                run()
                self.ran(kind, setting)
            else:
                first()
                self.ran(kind)
        result, taken_ms = self._timed(run)
        if (kind, setting) not in self._seen:
            self.ran(kind, setting)
            if taken_ms < SHORT_MS:
                result, taken_ms = self._timed(run)
        return result, taken_ms

    def made_and_ms(
        self, repeats: int, kind: Hashable, setting: Hashable, run: Callable[[], T]
    ) -> tuple[T, list[float]]:
        """What the last of so many runs gives, and the milliseconds of each."""
        timed_runs = [self.ms(kind, setting, run) for _ in range(repeats)]
        return timed_runs[-1][0], [taken_ms for _, taken_ms in timed_runs]

    def times_ms(
        self, repeats: int, kind: Hashable, setting: Hashable, run: Callable[[], Any]
    ) -> list[float]:
        """The milliseconds of so many runs."""
        return self.made_and_ms(repeats, kind, setting, run)[1]

    def _timed(self, run: Callable[[], T]) -> tuple[T, float]:
        begin = self._clock()
        result = run()
        return result, (self._clock() - begin) * 1e3
