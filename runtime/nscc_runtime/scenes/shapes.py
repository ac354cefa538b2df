"""Components of procedural pictures.

They use only sums, products, quotients and square roots, which every machine rounds alike, unlike
sines and powers of libraries, so that builtin scenes are bit-identical everywhere."""

from __future__ import annotations

import numpy as np

from nscc.arrays import Floats, Ints


def smooth(low: float, high: float, values: Floats) -> Floats:
    """Return, for each of `values`, 0 up to `low`, 1 from `high` on, and a smooth cubic in between.
    `low` is below `high`; both are in the unit of `values`."""
    t = np.clip((values - low) / (high - low), 0.0, 1.0)
    return t * t * (3.0 - 2.0 * t)


def hashed(x: Ints, y: Ints, seed: int) -> Floats:
    """Return a pseudo-random number in [0, 1) for every pair of integers of `x` and `y`, another
    one for each `seed`. The shapes of `x` and `y` are broadcast as in a sum."""
    # The odd factors and shifts mix the bits. Products beyond 64 bits wrap around, which leaves the
    # 32 bits that are kept exact. 24 bits are exact in a float.
    h = (x * 374761393 + y * 668265263 + seed * 1442695041) & 0xFFFFFFFF
    h = ((h ^ (h >> 13)) * 1274126177) & 0xFFFFFFFF
    h = ((h ^ (h >> 15)) * 2246822519) & 0xFFFFFFFF
    return ((h ^ (h >> 14)) & 0xFFFFFF) / float(1 << 24)


def noise(x: Floats, y: Floats, seed: int) -> Floats:
    """Return a smooth random field (len(y), len(x)) in [0, 1) with grain size 1. `x` and `y` are
    the coordinates of columns and of rows, in any order. Another `seed` gives another field.

    Random numbers at points of whole coordinates are interpolated."""
    column, row = np.floor(x).astype(np.int64), np.floor(y).astype(np.int64)
    first_col, first_row = int(column.min()), int(row.min())
    # Each position lies between two points, so there is one point after the last position.
    across = np.arange(first_col, int(column.max()) + 2, dtype=np.int64)
    down = np.arange(first_row, int(row.max()) + 2, dtype=np.int64)
    lattice = hashed(across[None, :], down[:, None], seed)
    u, v = smooth(0.0, 1.0, x - column), smooth(0.0, 1.0, y - row)[:, None]
    rows_above = lattice[row - first_row]
    rows_below = lattice[row - first_row + 1]
    between = rows_above + (rows_below - rows_above) * v
    at_left = between[:, column - first_col]
    return at_left + (between[:, column - first_col + 1] - at_left) * u


def fractal(x: Floats, y: Floats, seed: int, octaves: int) -> Floats:
    """Return noise in [0, 1), (len(y), len(x)), for the coordinates `x` of columns and `y` of rows.
    It is a mean of fields of `noise` at `octaves` scales (1 or more), each half as large and half
    as strong as the one before. `seed` numbers the first field."""
    total = np.zeros((len(y), len(x)))
    strength, sum_of_strengths = 1.0, 0.0
    for octave in range(octaves):
        factor = float(1 << octave)
        total += strength * noise(x * factor, y * factor, seed + octave)
        sum_of_strengths += strength
        strength *= 0.5
    return total / sum_of_strengths


def turn(phase: float) -> tuple[float, float]:
    """Return the point (x, y) of the unit circle after `phase` turns from (1, 0), at nearly even
    speed. Whole turns are ignored."""
    quarter, fraction = divmod((phase % 1.0) * 4.0, 1.0)
    # A point is ((1 - t^2), 2 t) / (1 + t^2) for t, the tangent of half its angle.
    t = fraction * (
        0.8284 + 0.1716 * fraction * fraction
    )  # near tan(fraction * 45 degrees), exact at 0 and 1
    x, y = (1.0 - t * t) / (1.0 + t * t), 2.0 * t / (1.0 + t * t)
    corners = ((x, y), (-y, x), (-x, -y), (y, -x))
    # `phase % 1.0` rounds to 1.0 for phases just below 0: quarter 4 is quarter 0.
    return corners[int(quarter) % 4]
