"""Tiles in which equal exposure times are far apart: starts for classes with one field.

The starts are those of L-SVPE (Nguyen, Martel and Wetzstein, "Learning Spatially Varying Pixel
Exposures for Motion Deblurring", ICCP 2022). Tiles repeat, so neighbourhoods wrap around edges."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Tile = NDArray[np.int64]


def scattered(
    name: str, levels: Tile, tile: tuple[int, int], generator: np.random.Generator
) -> Tile:
    """Return one of `levels` (values,) for each place of a tile, for one of SCATTERED."""
    pattern = {"poisson-disc": _poisson_disc, "non-adjacent": _non_adjacent}[name]
    chosen: Tile = levels[pattern(len(levels), tile, generator)]
    return chosen


def _poisson_disc(count: int, tile: tuple[int, int], generator: np.random.Generator) -> Tile:
    """Return a level index for each place; places of one level keep a distance from each other.

    Each level in turn takes its share of free places, nearest to the points of a Poisson-disc
    sampler. Each remaining place gets the level whose own places are farthest away."""
    from scipy.stats.qmc import PoissonDisk

    rows, cols = tile
    chosen = np.full(tile, -1, np.int64)
    y, x = np.mgrid[:rows, :cols]
    share = -(-rows * cols // count)
    for level in generator.permutation(count).tolist():
        # Discs of half that radius around `share` points cover about 70 % of the tile.
        sampler = PoissonDisk(d=2, radius=min(0.95 / share**0.5, 1.0), rng=generator)
        for down, across in sampler.random(share) * tile:
            away = np.hypot(_around(y + 0.5 - down, rows), _around(x + 0.5 - across, cols))
            away[chosen >= 0] = np.inf
            if away.min() <= 1.0:
                chosen[np.unravel_index(int(away.argmin()), tile)] = level
    for row, col in np.argwhere(chosen < 0).tolist():
        away = np.hypot(_around(y - row, rows), _around(x - col, cols))
        distances = [away[chosen == level].min(initial=np.inf) for level in range(count)]
        chosen[row, col] = int(np.argmax(distances))
    return chosen


def _non_adjacent(count: int, tile: tuple[int, int], generator: np.random.Generator) -> Tile:
    """Return random level indices that differ from those of the eight neighbours, if possible."""
    rows, cols = tile
    chosen = np.full(tile, -1, np.int64)
    for row, col in generator.permutation(np.argwhere(chosen < 0)).tolist():
        around = [
            chosen[(row + down) % rows, (col + across) % cols]
            for down in (-1, 0, 1)
            for across in (-1, 0, 1)
        ]
        times = np.bincount([level for level in around if level >= 0], minlength=count)
        chosen[row, col] = generator.choice(np.flatnonzero(times == times.min()))
    return chosen


def _around(distance: NDArray[np.float64], length: int) -> NDArray[np.float64]:
    """Return absolute distances along an axis of `length` that wraps around."""
    away = np.abs(distance) % length
    return np.asarray(np.minimum(away, length - away))
