"""Standard normal numbers in single precision: `nscc_runtime.noise.gaussian` for plans.

Parabolas about the middle of each of 32 cells an octave, so small a table that it stays in the
fastest cache. Within 2e-6 of the exact number where |z| < 6.
"""

from __future__ import annotations

from statistics import NormalDist

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.loop import inlined, table
from nscc_runtime.noise.gaussian import taylor

_CELL_BITS = 5
_SHIFT = np.int32(23 - _CELL_BITS)
_HALF_CELL = np.int32(1 << (22 - _CELL_BITS))
_FIRST = np.int32((127 - 53) << _CELL_BITS)
_CELLS = (52 << _CELL_BITS) + 1


def _table() -> NDArray[np.float32]:
    """Three coefficients of each cell: all constants, then all slopes, then all bends."""
    cells = np.zeros((3, _CELLS))
    for cell in range(_CELLS - 1):
        octave, step = divmod(cell, 1 << _CELL_BITS)
        middle = 2.0 ** (octave - 53) * (1 + (step + 0.5) / (1 << _CELL_BITS))
        # `taylor` is in the distance towards 0.
        value, slope, bend = taylor(-NormalDist().inv_cdf(middle))[:3]
        cells[:, cell] = value, -slope, bend
    # The last cell holds 1/2 alone, half a cell away from its middle.
    return cells.astype(np.float32).reshape(-1)


_TABLE = table(_table)


@inlined
def normal_fast(u: float) -> np.float32:
    """The standard normal quantile of u in [2**-53, 1 - 2**-53]."""
    v = np.float32(u if u < 0.5 else 1.0 - u)
    cell = (v.view(np.int32) >> _SHIFT) - _FIRST
    middle = np.int32(((cell + _FIRST) << _SHIFT) | _HALF_CELL).view(np.float32)
    t = v - middle
    z: np.float32 = _TABLE[cell + 2 * _CELLS]
    z = _TABLE[cell + _CELLS] + t * z
    z = _TABLE[cell] + t * z
    return z if u >= 0.5 else -z
