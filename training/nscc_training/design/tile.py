"""Search for the best fixed 2 x 2 tile of exposure times (stops), by enumeration.

The criterion is that of spatially varying exposures (Qu, Chi and Chan, "Spatially Varying Exposure
with 2-by-2 Multiplexing: Optimality and Universality", 2023, SVE-Risk). An ideal decoder uses for
each pixel the best measurement in its tile, and knows which one is best. The remaining error is the
risk. It includes the measurement's noise and clipping, and the difference between the light of the
two pixels."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations_with_replacement

import numpy as np
from numpy.typing import NDArray

from nscc_training.design.chip import Curve, DesignChip, on_curve
from nscc_training.design.scene import peak_of, stops_tried

Values = NDArray[np.float64]

_PLACES = 4
_MOST_TILES = 2048
"""Most tiles of a scene that are evaluated, evenly spaced over the scene."""


@dataclass(frozen=True)
class Tile:
    """Four stops, row by row from the top left, and their risk: a mean square error on a curve."""

    stops: tuple[int, int, int, int]
    risk: float


def best_tile(
    chip: DesignChip, scenes: Sequence[NDArray[np.floating]], slots: int, curve: Curve
) -> tuple[Tile, int]:
    """Return the tile with the smallest mean risk over the scenes, and the number of tried tiles.

    Scenes are in electrons over the frame (rows, cols). Raises Rejected (NS0824) for a scene
    without light."""
    stops = stops_tried(slots)
    tiles = list(combinations_with_replacement(range(len(stops)), _PLACES))
    risks = np.zeros(len(tiles))
    for number, scene in enumerate(scenes):
        stop_errors, apart = _tables(
            chip, np.asarray(scene, np.float64), number, stops, slots, curve
        )
        for k, tile in enumerate(tiles):
            # The error of pixel p of each tile if estimated from pixel q: the error of q's own
            # measurement, and the difference between the light of q and p.
            by = np.stack([stop_errors[:, q, stop] for q, stop in enumerate(_laid(tile))], axis=1)
            risks[k] += (by[:, None, :] + apart).min(axis=2).mean() / len(scenes)
    best = int(risks.argmin())
    a, b, c, d = (stops[k] for k in _laid(tiles[best]))
    return Tile((a, b, c, d), float(risks[best])), len(tiles)


def _laid(tile: tuple[int, ...]) -> tuple[int, ...]:
    """Return the stops of a tile from long to short."""
    return tuple(reversed(tile))


def _tables(
    chip: DesignChip, scene: Values, number: int, stops: Sequence[int], slots: int, curve: Curve
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Return the tables from which the risk is computed, for each tile of the scene.

    The first is the error of each place's own light by stop (tiles, places, stops). The second is
    the squared difference between the light of two places (tiles, places, places)."""
    peak = peak_of(scene.reshape(-1), number)
    # A scene of one row or column has no tiles: it is repeated.
    scene = np.tile(scene, [2 if side == 1 else 1 for side in scene.shape])
    rows, cols = (side // 2 * 2 for side in scene.shape)
    squares = scene[:rows, :cols].reshape(rows // 2, 2, cols // 2, 2).swapaxes(1, 2)
    tiles = squares.reshape(-1, _PLACES)
    tiles = tiles[:: -(-len(tiles) // _MOST_TILES)]
    light, peaks = tiles.reshape(-1), np.full(tiles.size, peak)
    stop_errors = chip.errors(light, peaks, np.array(stops) / slots, curve)
    on = on_curve(tiles, np.array(peak), curve, chip.code_e)
    apart = (on[:, :, None] - on[:, None, :]) ** 2
    shape = (*tiles.shape, len(stops))
    return stop_errors.reshape(shape).astype(np.float32), apart.astype(np.float32)
