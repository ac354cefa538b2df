"""Baselines for plans: two simple numpy implementations of an exposure, and the speed of memory."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from time import perf_counter

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.execution.program import AnalysedProgram
from nscc_runtime.frame_file import Frame, read_out
from nscc_runtime.interface import Exposure
from nscc_runtime.light import Light

_MOST_BYTES = 1 << 28
"""Light and shutters of all slots are prepared as arrays before timing, unless they are larger than
this; then they are computed slot by slot."""
_COPIED_BYTES = 1 << 26
_COPIES = 25


@dataclass(frozen=True, eq=False)
class Naive:
    """Two simple exposures of a scene with a program's shutters, both read out without noise."""

    program: AnalysedProgram
    light: Light

    def summed(self) -> Frame:
        """Return a frame that sums the light over the open slots in float32, without effects."""
        total = self._dark(np.float32)
        with np.errstate(over="ignore"):
            for light, opened in self._slots():
                for bucket, open_pixels in zip(total, opened, strict=True):
                    np.add(bucket, light, out=bucket, where=open_pixels)
        return self._read(total)

    def drawn(self, seed: int) -> Frame:
        """Return a frame that sums numpy's Poisson counts over the open slots, without other
        effects.

        Raises ValueError for light beyond the range of numpy, about 9e18 electrons per slot."""
        random = np.random.default_rng(seed)
        total = self._dark(np.float64)
        for light, opened in self._slots():
            charge = random.poisson(light)
            for bucket, open_pixels in zip(total, opened, strict=True):
                np.add(bucket, charge, out=bucket, where=open_pixels)
        return self._read(total)

    def _dark(self, kind: type[np.floating]) -> NDArray[np.floating]:
        return np.zeros((len(self.program.container.buckets), *self.light.shape), kind)

    def _read(self, total: NDArray[np.floating]) -> Frame:
        exposure = Exposure(total.astype(np.float64, copy=False), np.ones(total.shape, np.bool_))
        return read_out(exposure, self.program.container.target, self.program.sensor)

    def _slots(self) -> Iterator[tuple[NDArray[np.float32], NDArray[np.bool_]]]:
        """Yield the light (rows, cols) and the open pixels (buckets, rows, cols) slot by slot."""
        if self._ready is not None:
            yield from zip(*self._ready, strict=True)
        else:
            for n in range(self.light.slots):
                yield self.light.slot(n), self._opened(n)

    @cached_property
    def _ready(self) -> tuple[NDArray[np.float32], NDArray[np.bool_]] | None:
        buckets, slots = len(self.program.container.buckets), self.light.slots
        if slots * (4 + buckets) * self.light.frames[0].size > _MOST_BYTES:
            return None
        return self.light.dense(), np.stack([self._opened(n) for n in range(slots)])

    def _opened(self, n: int) -> NDArray[np.bool_]:
        groups = self.program.reference.groups
        buckets = np.arange(len(self.program.container.buckets))[:, None]
        opened = groups.of_slot[:, n] >> buckets & 1
        return opened.astype(np.bool_)[:, groups.lane]


def copy_gb_per_s() -> float:
    """Return the memory traffic in GB/s of copying more than the caches hold, the best of some
    runs."""
    source = np.ones(_COPIED_BYTES // 8)
    target = np.zeros_like(source)
    best_s = np.inf
    for _ in range(_COPIES):
        begin = perf_counter()
        np.copyto(target, source)
        best_s = min(best_s, perf_counter() - begin)
    return 2 * source.nbytes / best_s / 1e9


def floor_ms(light: Light, gb_per_s: float) -> float:
    """Return the milliseconds for reading a stored scene once at this speed."""
    return light.frames.nbytes / gb_per_s / 1e6
