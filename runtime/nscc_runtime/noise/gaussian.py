"""Standard normal numbers from uniform numbers: the inverse of the normal distribution function.

For v = min(u, 1 - u) the quantile is a Taylor polynomial about the upper end of v's cell; there are
32 cells per octave, from 2**-53 to 1/2. As functions of the distance t >= 0 from that end all
coefficients are positive, so rounding keeps each polynomial increasing, and no cell ends above the
start of the next: the result never decreases in u. The coefficients follow from the differential
equation of the quantile: Steinbrecher and Shaw, "Quantile mechanics", European Journal of Applied
Mathematics 19 (2008)."""

from __future__ import annotations

import math

import numpy as np

from nscc.arrays import Floats, Floats32
from nscc_runtime.loop import inlined, table

_TERMS = 8
"""Number of Taylor coefficients of a cell; with them the relative error is below 1e-12."""
_CELL_BITS = 5
"""Number of bits of the fraction of v that select a cell: 32 cells per octave."""
_SHIFT = np.int64(52 - _CELL_BITS)
_FIRST = np.int64(1023 - 53) << np.int64(_CELL_BITS)
_CELLS = 52 << _CELL_BITS
_LAST = np.int64(_CELLS - 1)


def taylor(z: float) -> list[float]:
    """Return `_TERMS` Taylor coefficients of the quantile, in ascending powers, about the
    probability at which it is `z`, at least 0. Their variable is the distance of v = min(u, 1 - u)
    towards 0, in which all coefficients are positive."""
    density = math.exp(-z * z / 2) / math.sqrt(2 * math.pi)
    terms = [z]
    # The n-th derivative is polynomial(z) / density**n.
    polynomial = [1]
    for n in range(1, _TERMS):
        value = math.fsum(c * z**i for i, c in enumerate(polynomial))
        terms.append(value / math.factorial(n) / density**n)
        slope = [*(i * c for i, c in enumerate(polynomial) if i), 0, 0]
        polynomial = [s + n * c for s, c in zip(slope, [0, *polynomial], strict=True)]
    return terms


def _quantile(v: float) -> float:
    """Return the absolute value of the normal quantile of `v`, a probability below 1/2."""
    from statistics import NormalDist  # slow to import, and only needed to compile loops

    return -NormalDist().inv_cdf(v)


def _table() -> Floats:
    """Return the Taylor coefficients of the quantile about the upper end of each cell of v, in
    ascending order of v: (cells, _TERMS), flattened."""
    width = 2.0**-_CELL_BITS
    cells = np.empty((_CELLS, _TERMS))
    below = 0.0
    for cell in reversed(range(_CELLS)):
        octave, step = divmod(cell, 1 << _CELL_BITS)
        size = 2.0 ** (octave - 53)
        upper = size * (1 + (step + 1) * width)
        terms = taylor(_quantile(upper) if upper < 0.5 else 0.0)
        # Not below the end of the cell before, despite rounding: the quantile must not decrease.
        terms[0] = max(terms[0], below)
        cells[cell] = terms
        below = 0.0
        for term in reversed(terms):
            below = term + size * width * below
    return cells.reshape(-1)


_TABLE = table(_table)


@inlined
def normal(u: float) -> float:
    """Return the normal quantile of u in [2**-53, 1 - 2**-53]; relative error below 1e-12."""
    v = u if u < 0.5 else 1.0 - u
    cell = (np.float64(v).view(np.int64) >> _SHIFT) - _FIRST
    cell = cell if cell < _LAST else _LAST
    t = np.int64((cell + _FIRST + np.int64(1)) << _SHIFT).view(np.float64) - v
    at = cell * _TERMS
    z: float = _TABLE[at + _TERMS - 1]
    for term in range(2, _TERMS + 1):
        z = _TABLE[at + _TERMS - term] + t * z
    return z if u >= 0.5 else -z


_FAST_SHIFT = np.int32(23 - _CELL_BITS)
_FAST_HALF_CELL = np.int32(1 << (22 - _CELL_BITS))
_FAST_FIRST = np.int32((127 - 53) << _CELL_BITS)
_FAST_CELLS = (52 << _CELL_BITS) + 1
_HALF = np.uint64(32)
_LOWER = np.uint64(0xFFFF_FFFF)


def _cells() -> Floats32:
    """Return float32 (cells, 3): constant, slope and bend of the parabola about the middle of each
    cell of v, in ascending order of v."""
    cells = np.zeros((_FAST_CELLS, 3))
    for cell in range(_FAST_CELLS - 1):
        octave, step = divmod(cell, 1 << _CELL_BITS)
        middle = 2.0 ** (octave - 53) * (1 + (step + 0.5) / (1 << _CELL_BITS))
        # `taylor` expands in the distance towards 0.
        value, slope, bend = taylor(_quantile(middle))[:3]
        cells[cell] = value, -slope, bend
    # The last cell contains only 1/2, whose quantile is 0.
    return cells.astype(np.float32)


_CONSTANTS = table(lambda: np.ascontiguousarray(_cells()[:, 0]))
_SLOPES_AND_BENDS = table(lambda: np.ascontiguousarray(_cells()[:, 1:]).view(np.uint64).reshape(-1))
"""Slope and bend packed into one number, because separate table look-ups dominate the time."""


@inlined
def normal_fast(u: float) -> np.float32:
    """Return the normal quantile of u in [2**-53, 1 - 2**-53] in single precision, by a parabola
    about the middle of each cell.

    The table is small enough for the fastest cache. The error is below 2e-6 for |z| < 6."""
    v = np.float32(u if u < 0.5 else 1.0 - u)
    cell = (v.view(np.int32) >> _FAST_SHIFT) - _FAST_FIRST
    middle = np.int32(((cell + _FAST_FIRST) << _FAST_SHIFT) | _FAST_HALF_CELL).view(np.float32)
    t = v - middle
    both = _SLOPES_AND_BENDS[cell]
    slope = np.uint32(both & _LOWER).view(np.float32)
    bend = np.uint32(both >> _HALF).view(np.float32)
    z: np.float32 = _CONSTANTS[cell] + t * (slope + t * bend)
    return z if u >= 0.5 else -z
