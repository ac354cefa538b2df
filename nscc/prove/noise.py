"""Pseudo-random numbers that are equal on all machines.

They come from a counter and the SplitMix64 mixer (Steele, Lea, Flood, OOPSLA 2014). Importing
numpy.random would take longer than most proofs."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


class Noise:
    """A pseudo-random stream from a seed."""

    def __init__(self, seed: int) -> None:
        self._next = seed << 32

    def levels(self, rows: int, columns: int) -> NDArray[np.float64]:
        """Return distinct values between 1/4 and 1: (rows, columns)."""
        end = self._next + rows * columns
        x = np.arange(self._next, end, dtype=np.uint64)
        self._next = end
        x *= np.uint64(0x9E3779B97F4A7C15)
        x ^= x >> np.uint64(30)
        x *= np.uint64(0xBF58476D1CE4E5B9)
        x ^= x >> np.uint64(27)
        x *= np.uint64(0x94D049BB133111EB)
        x ^= x >> np.uint64(31)
        unit = (x >> np.uint64(11)).astype(np.float64) * 2.0**-53
        return (0.25 + 0.75 * unit).reshape(rows, columns)
