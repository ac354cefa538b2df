"""Step 1 of planning: draw a weighted sample of the pixels of a scene.

Errors grow with light and with differences of light between neighbours, and a few lamps may cause
most of the error. Therefore tiles of 2 x 2 pixels are drawn partly evenly and partly in proportion
to light and differences (`chances`). Each is the centre of a tile of 4 x 4 pixels that contains its
neighbours. Two strata are drawn separately, pixel by pixel: pixels near saturation, and pixels that
only the light of their neighbours brings near saturation. They are ordered by charge and drawn with
the same chances."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.execution.near_saturation import NearSaturation
from nscc_runtime.planning.differences import WeightedPixels

Values = NDArray[np.float64]
Places = NDArray[np.int64]

TILES, _SIDE = 160, 2
"""Number of tiles to draw; side of the measured part of a tile, in pixels."""
_WHOLE = 2048
"""Scenes of at most this number of pixels are measured completely."""
_ENOUGH, _MOST_FRAMES = 512, 16
"""Scenes of fewer than `_ENOUGH` pixels are exposed several times, at most `_MOST_FRAMES` times."""
_OWN, _SPILT, _MORE = 48, 24, 208
"""Sample sizes near saturation: pixels brought there by their own light, pixels brought there by
neighbours, and the increase of the first if the whole scene is near saturation."""
_EXTREMES = 8
"""Near saturation, this number of the brightest pixels, of the darkest pixels, and of the pixels
nearest to a full well is always drawn."""
_SURE = 2.0
"""A pixel with at least this expected number of draws is certain to be drawn."""
_GOLDEN = 0.6180339887498949


@dataclass(frozen=True, eq=False, kw_only=True)
class Sample(WeightedPixels):
    """The sampled pixels of a scene.

    Attributes
    ----------
    corners : int64, shape (tiles, 2)
        Row and column of the upper left pixel of each tile of `side` x `side` pixels.
    side : int
        Side of a tile; 0 if the whole scene is measured.
    places : int64, shape (pixels,)
        Index of each sampled pixel in the flattened scene: pixels far from saturation, tile by
        tile, then pixels near saturation. A pixel occurs once per exposure.
    frame : int64, shape (pixels,)
        The number of the exposure, below `frames`.
    inner : int64, shape (far pixels,)
        Indices of the pixels far from saturation in the array of all tiles side by side.
    drawn_near : int
        Number of sampled pixels near saturation whose weight is above 1.
    """

    side: int
    corners: Places
    places: Places
    frame: Places
    frames: int
    inner: Places
    drawn_near: int

    @property
    def fraction(self) -> float:
        """Fraction of the scene's pixels that is sampled."""
        return len(self.places) / self.frames / self.scene_pixels

    @property
    def far_pixels(self) -> slice:
        """Slice of the sample that contains the pixels far from saturation."""
        return slice(0, self.frames * len(self.inner))

    @property
    def near_pixels(self) -> slice:
        """Slice of the sample that contains the pixels near saturation."""
        return slice(self.frames * len(self.inner), len(self.places))

    @cached_property
    def near_part(self) -> float:
        """Estimated fraction of the scene's pixels that are near saturation."""
        return float(self.weight[self.near_pixels].sum()) / self.scene_pixels

    @cached_property
    def one_each(self) -> NDArray[np.intp]:
        """Index (tiles,) of one sampled pixel of each tile. Its position in the tile varies,
        because codes may repeat with the tile size."""
        starts = self.cluster_starts
        starts = starts[starts < len(self.inner)]
        counts = np.diff(starts, append=len(self.inner))
        turn = np.arange(len(starts)) * _GOLDEN % 1.0
        return starts + (turn * counts).astype(np.intp)


def near_sampled(near_count: int, scene_pixels: int) -> int:
    """Return the largest sample size of `near_count` pixels near saturation."""
    return min(near_count, _OWN + _SPILT + _MORE * near_count // scene_pixels)


def sample_of(
    total_e: Values, near_pixels: NearSaturation, full_well_e: float, tiles: int = TILES
) -> Sample:
    """Draw the sample of a scene, deterministically.

    Parameters
    ----------
    total_e : float64, shape (rows, cols)
        Total charge of each pixel in a frame, in electrons.
    near_pixels : NearSaturation
        The pixels near saturation.
    full_well_e : float
        Full well, in electrons.
    tiles : int
        Number of tiles to draw.
    """
    rows, cols = total_e.shape
    contrasts = contrasts_of(total_e, full_well_e)
    near_chance = chances(contrasts, np.empty(0, np.int64)).reshape(-1)
    near_places, near_weight = _near_sample(near_pixels, near_chance, full_well_e)
    is_near = np.zeros(rows * cols, np.bool_)
    is_near[near_pixels.places] = True
    if rows * cols <= _WHOLE or min(rows, cols) < _SIDE + 2:
        corners, side = np.empty((0, 2), np.int64), 0
        inner = far_places = np.flatnonzero(~is_near)
        far_weight, far_cluster = np.ones(len(inner)), np.arange(len(inner))
    else:
        corners, tile_weight = tile_corners(chances(contrasts, near_pixels.places), tiles)
        side = _SIDE + 2
        inner, far_places, far_cluster = _inner_pixels(corners, side, cols, is_near)
        far_weight = _standing_for(tile_weight[far_cluster], rows * cols - len(near_pixels.places))
    near_cluster = np.arange(len(near_places)) + (int(far_cluster.max(initial=-1)) + 1)
    frames = min(-(-_ENOUGH // max(rows * cols, 1)), _MOST_FRAMES)
    clusters = int(near_cluster.max(initial=far_cluster.max(initial=-1))) + 1

    def again(far: NDArray[Any], near_pixels: NDArray[Any]) -> NDArray[Any]:
        return np.concatenate([np.tile(far, frames), np.tile(near_pixels, frames)])

    frame = np.concatenate(
        [np.repeat(np.arange(frames), len(places)) for places in (far_places, near_places)]
    )
    return Sample(
        weight=again(far_weight, near_weight) / frames,
        cluster=again(far_cluster, near_cluster) + clusters * frame,
        scene_pixels=rows * cols,
        side=side,
        corners=corners,
        places=again(far_places, near_places),
        frame=frame,
        frames=frames,
        inner=inner,
        drawn_near=int(np.count_nonzero(near_weight > 1.0)),
    )


def _inner_pixels(
    corners: Places, side: int, cols: int, is_near: NDArray[np.bool_]
) -> tuple[Places, Places, Places]:
    """Return the inner pixels of tiles that are not near saturation.

    Returns their indices in the array of all tiles side by side, their indices in the flattened
    scene, and their tile numbers."""
    tile, row, col = (
        axis.reshape(-1) for axis in np.mgrid[: len(corners), 1 : side - 1, 1 : side - 1]
    )
    places = (corners[tile, 0] + row) * cols + corners[tile, 1] + col
    inner = row * (side * len(corners)) + tile * side + col
    far = ~is_near[places]
    return inner[far], places[far], tile[far]


def tile_corners(chance: Values, tile_count: int) -> tuple[Places, Values]:
    """Draw tiles with probabilities proportional to the sum of `chance` (rows, cols) over their
    pixels.

    Returns the upper left corners (tiles, 2), and the unnormalised weight of a pixel in each tile.
    """
    rows, cols = chance.shape
    down, right = -(-rows // _SIDE), -(-cols // _SIDE)
    if rows % _SIDE or cols % _SIDE:
        chance = np.pad(chance, ((0, down * _SIDE - rows), (0, right * _SIDE - cols)))
    blocks = chance.reshape(down, _SIDE, right, _SIDE).sum(axis=(1, 3)).reshape(-1)
    drawn, weight = drawn_with_weights(blocks, min(tile_count, len(blocks)))
    row = np.minimum(drawn // right * _SIDE, rows - _SIDE) - 1
    col = np.minimum(drawn % right * _SIDE, cols - _SIDE) - 1
    return np.stack([row, col], axis=1), weight


def _near_sample(
    near_pixels: NearSaturation, chance: Values, full_well_e: float
) -> tuple[Places, Values]:
    """Draw pixels near saturation with the relative probabilities `chance` (rows * cols,). Return
    their indices in the flattened scene, and their weights."""
    seen_e = near_pixels.most_e[~near_pixels.spilt]
    sure = np.zeros(len(seen_e), np.bool_)
    own_count = _OWN + _MORE * len(near_pixels.places) // len(chance)
    if len(seen_e) > own_count:
        for size in (seen_e, -seen_e, -np.abs(seen_e - full_well_e)):
            sure[np.argpartition(size, -_EXTREMES)[-_EXTREMES:]] = True
    by_light, spilt = (
        places[np.argsort(most_e, kind="stable")]
        for places, most_e in (
            (near_pixels.places[~near_pixels.spilt][~sure], seen_e[~sure]),
            (near_pixels.places[near_pixels.spilt], near_pixels.most_e[near_pixels.spilt]),
        )
    )
    places = [near_pixels.places[~near_pixels.spilt][sure]]
    weight = [np.ones(np.count_nonzero(sure))]
    for ordered, count in ((by_light, own_count - len(places[0])), (spilt, _SPILT)):
        drawn, stand_for = _some_of(ordered, chance, count)
        places.append(drawn)
        weight.append(stand_for)
    return np.concatenate(places), np.concatenate(weight)


def _some_of(ordered: Places, chance: Values, count: int) -> tuple[Places, Values]:
    """Draw at most `count` of the `ordered` pixel indices. Return them and their weights."""
    if len(ordered) <= count:
        return ordered, np.ones(len(ordered))
    drawn, weight = drawn_with_weights(chance[ordered], count)
    return ordered[drawn], _standing_for(weight, len(ordered))


def drawn_with_weights(chance: Values, count: int) -> tuple[NDArray[np.intp], Values]:
    """Draw indices with `drawn_by`. Return the distinct indices and their weights: 1 for pixels
    certain to be drawn, otherwise an unnormalised weight."""
    drawn, times = np.unique(drawn_by(chance, count), return_counts=True)
    expected = chance[drawn] * (count / max(float(chance.sum()), 1e-300))
    return drawn, np.where(expected >= _SURE, 1.0, times / np.maximum(expected, 1e-300))


def _standing_for(weight: Values, count: int) -> Values:
    """Scale the weights other than 1 so that all weights sum to `count`."""
    sure = weight == 1.0
    drawn_weight = max(float(weight[~sure].sum()), 1e-300)
    return np.where(sure, 1.0, weight * ((count - np.count_nonzero(sure)) / drawn_weight))


def drawn_by(chance: Values, count: int) -> NDArray[np.intp]:
    """Draw `count` indices in ascending order, with probabilities proportional to `chance`,
    deterministically.

    One point is drawn in each of `count` equal strata, by an additive recurrence, so that the
    points do not align with tiles of codes."""
    points = np.arange(count) + (np.arange(count) * _GOLDEN) % 1.0
    upto = np.cumsum(chance)
    drawn = np.searchsorted(upto, points * (upto[-1] / count), side="right")
    return np.asarray(np.minimum(drawn, len(chance) - 1))


def contrasts_of(total_e: Values, full_well_e: float) -> tuple[Values, Values]:
    """Return the contrast of each pixel (rows, cols): its light plus its absolute differences to
    its neighbours.

    The first array uses light clipped to the full well; the second uses all light and is squared.
    """
    return _contrast(np.minimum(total_e, full_well_e)), _contrast(total_e) ** 2


def chances(contrasts: tuple[Values, Values], never: Places) -> Values:
    """Return the relative probability (rows, cols) of drawing each pixel; 0 for the indices in
    `never`.

    Of seven draws, four are even, two are proportional to the contrast of light up to the full
    well, and one to the squared contrast of all light: neighbours of lamps may cause most of the
    mean square error."""
    within_well, squares = contrasts
    drawn = np.ones(squares.shape)
    drawn.reshape(-1)[never] = 0.0
    chance = np.zeros(squares.shape)
    for share, weights in ((4.0, drawn), (2.0, within_well * drawn), (1.0, squares * drawn)):
        chance += weights * (share / max(float(weights.sum()), 1e-300))
    return chance


def _contrast(light_e: Values) -> Values:
    """Return each pixel's light plus the absolute differences to its four neighbours."""
    score = light_e.copy()
    for axis in (0, 1):
        step = np.abs(np.diff(light_e, axis=axis))
        before, after = (
            (slice(None),) * axis + (index_range,) for index_range in (slice(-1), slice(1, None))
        )
        score[before] += step
        score[after] += step
    return score
