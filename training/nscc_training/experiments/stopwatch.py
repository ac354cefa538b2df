"""Measurement of run times without the overhead of the first run in a process."""

from __future__ import annotations

import platform
from collections.abc import Callable, Hashable
from pathlib import Path
from time import perf_counter
from typing import Any, TypeVar

_CPUINFO = Path("/proc/cpuinfo")
"""Where Linux describes the processor."""


def processor_name() -> str:
    """Return the name of this machine's processor, or if the system does not tell it, its
    architecture."""
    try:
        lines = _CPUINFO.read_text(errors="replace").splitlines()
    except OSError:
        lines = []
    for line in lines:
        name, _, value = line.partition(":")
        if name.strip() == "model name" and value.strip():
            return " ".join(value.split())
    return platform.processor() or platform.machine() or "unknown processor"


T = TypeVar("T")

SHORT_MS = 500.0
"""First runs shorter than this are repeated, because they may mainly consist of filling caches."""


class Stopwatch:
    """A stopwatch that leaves out first runs, in which code is compiled and data is loaded.

    Runs of one `kind`, such as one method on data of one shape, share this overhead. `setting`
    distinguishes the runs of a kind. `clock` returns seconds; tests replace it."""

    def __init__(self, clock: Callable[[], float] = perf_counter) -> None:
        """Begin with nothing loaded."""
        self._clock = clock
        self._seen: set[Hashable] = set()

    def ran(self, kind: Hashable, *settings: Hashable) -> None:
        """Record that a kind and these settings of it have already run, so that `ms` does not run
        them twice."""
        self._seen.update((kind, *((kind, setting) for setting in settings)))

    def ms(
        self,
        kind: Hashable,
        setting: Hashable,
        run: Callable[[], T],
        first: Callable[[], Any] | None = None,
    ) -> tuple[T, float]:
        """Call `run` and return its result and its time in milliseconds.

        Before the first run of a `kind`, `first` is called (None: `run`), and its time is dropped.
        If the first run of a `setting` takes less than `SHORT_MS`, it is repeated, and the second
        result counts. So a long run is repeated at most once for its kind, and not at all if
        `first` is shorter."""
        if kind not in self._seen:
            if first is None:
                run()
                self.ran(kind, setting)
            else:
                first()
                self.ran(kind)
        result, taken_ms = timed_ms(run, self._clock)
        if (kind, setting) not in self._seen:
            self.ran(kind, setting)
            if taken_ms < SHORT_MS:
                result, taken_ms = timed_ms(run, self._clock)
        return result, taken_ms


def timed_ms(run: Callable[[], T], clock: Callable[[], float] = perf_counter) -> tuple[T, float]:
    """Call `run` once and return its result and its time in milliseconds. `clock` returns
    seconds."""
    begin = clock()
    result = run()
    return result, (clock() - begin) * 1e3
