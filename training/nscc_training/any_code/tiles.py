"""Denoising of large clips in overlapping tiles: memory does not grow with the picture.

A tile is read with a margin around it. Beyond the margin, pixels change the network's result by
less than 2e-5 of white."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import sqrt

from torch import Tensor

from nscc_training.any_code.stages import Denoiser, mirror_axes, mirrored

_MARGIN = 40
"""Pixels around a tile that the network reads with it."""
_GRID = 8
"""Tiles begin at multiples of the largest square that the network shrinks to one value."""
MOST_VALUES = 3 << 18
"""Largest number of values, pixels times frames, of a tile."""
_SMALLEST = 64
"""Least side of a tile in pixels."""


def denoised_in_tiles(
    denoiser: Denoiser,
    clip: Tensor,
    planes: Callable[[slice, slice], Tensor],
    level: Tensor,
    number: int = 0,
) -> Tensor:
    """Return a clip (batch, T, rows, cols) denoised tile by tile, which gives almost the result of
    the whole clip.

    `planes` returns the denoiser's other inputs for a range of rows and a range of columns. `level`
    (batch,) is the assumed standard deviation of the clip's error. `number` is the stage, which
    decides along which axes the denoiser sees the clip mirrored. A tile has at most `MOST_VALUES`
    values or sides of `_SMALLEST`."""
    frames, (rows, cols) = clip.shape[0] * clip.shape[1], clip.shape[-2:]
    side = max(_SMALLEST, int(sqrt(MOST_VALUES / frames)) // _GRID * _GRID)
    axes = mirror_axes(number)
    through, result = mirrored(denoiser, number), clip.new_empty(clip.shape)
    for own_rows, read_rows in _tiles(rows, side, -2 in axes):
        for own_cols, read_cols in _tiles(cols, side, -1 in axes):
            part = clip[..., read_rows, read_cols]
            denoised = through(part, planes(read_rows, read_cols), level)
            inner_rows = slice(own_rows.start - read_rows.start, own_rows.stop - read_rows.start)
            inner_cols = slice(own_cols.start - read_cols.start, own_cols.stop - read_cols.start)
            result[..., own_rows, own_cols] = denoised[..., inner_rows, inner_cols]
    return result


def _tiles(length: int, side: int, is_mirrored: bool) -> Iterator[tuple[slice, slice]]:
    """Yield two ranges for each tile along an axis of `length` pixels: the tile's own pixels, and
    those that are read for it, with a margin.

    `side` is the length of a tile. The grid of tiles begins at the first pixel, or at the last if
    the network sees the clip mirrored along this axis (`is_mirrored`), so that the mirrored clip
    has the same grid."""
    for first in range(0, length, side):
        ends = (first, min(first + side, length))
        for_tile = (max(0, first - _MARGIN), min(first + side + _MARGIN, length))
        if is_mirrored:
            ends, for_tile = ((length - b, length - a) for a, b in (ends, for_tile))
        yield slice(*ends), slice(*for_tile)
