"""Stages of the decoder for any code: a projection towards the frames, and denoising in tiles.

A still is denoised as `log(1 + light / floor)`, in which errors of bright and dark pixels have
equal weight. Its frames have masks of one slot: the fraction of the frame for which a pixel was
open."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import log, sqrt

import numpy as np
import torch
from torch import Tensor

from nscc_training.baselines.gap_tv import gap_step
from nscc_training.decoders.guess import averaged
from nscc_training.measured import Measured

Denoiser = Callable[[Tensor, Tensor, Tensor], Tensor]
"""A function of a clip, measurement planes and sigma; see `ClipDenoiser`."""

STAGES = 12
"""Number of stages for clips."""
_SIGMA = (16 / 255, 12 / 255)
"""Assumed standard deviation of the clip's error before the first and before the last stage."""
_LEFT = 4 / 255
"""Assumed standard deviation of the clip's error after the last stage."""
_MIRRORS = ((), (-1,), (-2,), (-2, -1))
"""Axes along which clips are mirrored in successive stages: rows, columns."""


def schedule(count: int, still: bool = False) -> list[float]:
    """Return the assumed standard deviation of the error before each of `count` stages, falling
    linearly. A single stage has the first value. `still` chooses the values for stills, whose error
    is that of a logarithm."""
    return [float(sigma) for sigma in np.linspace(*(_STILL_SIGMA if still else _SIGMA), count)]


def stage(
    measured: Measured[Tensor], denoiser: Denoiser, clip: Tensor, target: Tensor, sigma: float
) -> tuple[Tensor, Tensor]:
    """Return clip (batch, N, rows, cols) and target (batch, B, rows, cols) after one stage of
    accelerated GAP (Liao, Li and Carin 2014): a correction towards the frames, then the denoiser.

    `sigma` is the assumed standard deviation of the clip's error before the stage. The target is
    the frames plus the residuals of earlier stages, which accelerates convergence; the first stage
    receives the frames."""
    level = clip.new_full((len(clip),), sigma)
    clip, target = gap_step(measured, clip, target, level)
    return denoiser(clip, measured.planes(), level), target


def mirror_axes(number: int) -> tuple[int, ...]:
    """Return the axes along which the denoiser sees the clip mirrored in stage `number` (0 is the
    first)."""
    return _MIRRORS[number % len(_MIRRORS)]


def mirrored(denoiser: Denoiser, number: int) -> Denoiser:
    """Return a denoiser that mirrors its inputs along the axes of stage `number`, and mirrors the
    result back.

    The network's errors have a direction. If stages see the clip in different ways, these errors do
    not add up: this gains 0.2 dB."""
    axes = mirror_axes(number)

    def denoised(clip: Tensor, planes: Tensor, level: Tensor) -> Tensor:
        """Denoise a mirrored clip, and mirror the result back."""
        return denoiser(clip.flip(axes), planes.flip(axes), level).flip(axes)

    return denoised


def led(measured: Measured[Tensor], clip: Tensor) -> Tensor:
    """Return a clip (batch, N, rows, cols) corrected once towards the frames of `measured`, as in a
    stage without a denoiser. The error of the clip after the last stage is assumed to be `_LEFT`.
    """
    gap = measured.missing(measured.of(clip), measured.value)
    return measured.correction(gap, clip.new_full((len(clip),), _LEFT)).add_(clip)


STILL_STAGES = 1
"""Number of stages; more stages do not improve results with the shipped weights."""
_STILL_SIGMA = (0.05, 0.02)
"""Assumed error of the logarithm before the first and the last stage, if there are several."""
_FLOOR = 1e-3
"""Floor of the logarithm, relative to the light 1, which about fills a well over the whole
frame."""
_SPAN = log(1 + 200 / _FLOOR)
"""Scale that maps the logarithm of the light 200, which few scenes exceed, to 1."""


def started_still(measured: Measured[Tensor]) -> Tensor:
    """Return a first estimate of the light over the frame (batch, rows, cols), from which the
    stages start. The masks of `measured` have one slot.

    Each pixel is the mean of its own and its neighbours' measurements, weighted by precision. A
    saturated pixel has at least the light at which it saturates; one that never opens has its
    neighbours' light."""
    mask = measured.mask[:, :, 0]
    opened = (mask > 0).expand_as(measured.value)
    # The light over the frame that each readout shows by itself.
    readout_light = torch.where(opened, measured.value / mask.clamp(min=1e-9), 0.0)
    precision = mask.square() / measured.variance.clamp(min=1e-20)
    precision = torch.where(opened & ~measured.saturated, precision, 0.0)
    total = precision.sum(dim=1)
    pixel_light = (precision * readout_light).sum(dim=1) / total.clamp(min=1e-20)
    # Relative to the frame's own scale, so that a measurement counts more than wide surroundings.
    scale = measured.value.abs().amax(dim=(1, 2, 3)).clamp(min=1e-9).square().reshape(-1, 1, 1)
    light = averaged(pixel_light.unsqueeze(1), (total * scale).unsqueeze(1)).squeeze(1)
    # Of several saturated readouts, the shortest shows the most light.
    least = torch.where(opened & measured.saturated, readout_light, 0.0).amax(dim=1)
    return torch.maximum(light, least)


def still_stage(
    measured: Measured[Tensor], denoiser: Denoiser, light: Tensor, sigma: float
) -> Tensor:
    """Return the light (batch, rows, cols) after one stage: the most likely light, given the
    estimate `light` and the frames, and then denoised.

    `sigma` is the assumed standard deviation of the error of `coded_light`, the scaled logarithm.
    Light of about 1 fills a well."""
    spread = sigma * _SPAN * (light + _FLOOR)
    mask = measured.mask[:, :, 0]
    data_precision = mask.square() / measured.variance.clamp(min=1e-12)
    gap = measured.missing(mask * light.unsqueeze(1), measured.value)
    # The values of saturated pixels contain no further information.
    data_precision = torch.where(measured.saturated & (gap <= 0), 0.0, data_precision)
    step = (data_precision * gap / mask.clamp(min=1e-9)).sum(dim=1)
    light = (light + step / (spread.pow(-2) + data_precision.sum(dim=1))).clamp(min=0)
    level = light.new_full((len(light),), sigma)
    denoised = denoiser(coded_light(light).unsqueeze(1), _planes(measured), level)[:, 0]
    return light_of(denoised)


def still_stages(
    measured: Measured[Tensor], denoiser: Denoiser, light: Tensor, count: int
) -> Iterator[Tensor]:
    """Yield the light (batch, rows, cols) after each of `count` stages, which begin with the
    estimate `light` of the same shape. Each stage is one correction towards the frames of
    `measured`, and the `denoiser`."""
    for sigma in schedule(count, still=True):
        light = still_stage(measured, denoiser, light, sigma)
        yield light


def coded_light(light: Tensor) -> Tensor:
    """Return the scaled logarithm of light, in full wells, that the denoiser for stills takes: 0
    for no light or less, and 1 for 200 full wells."""
    return torch.log1p(light.clamp(min=0) / _FLOOR) / _SPAN


def light_of(coded: Tensor) -> Tensor:
    """Return the light in full wells of scaled logarithms `coded`, the inverse of `coded_light`.
    Values are first clipped to 0..1.5, so that errors of the denoiser stay finite."""
    return torch.expm1(coded.float().clamp(0, 1.5) * _SPAN) * _FLOOR


def _planes(measured: Measured[Tensor]) -> Tensor:
    """Return the denoiser's inputs (batch, 3, 1, rows, cols) that describe the measurement of a
    still.

    They are logarithms of the open fraction, the light and its noise, for each pixel from the
    readout with the least noise. A saturated readout has noise 1, the largest."""
    mask = measured.mask[:, :, 0]
    opened = mask > 0
    readout_light = torch.where(opened, measured.value / mask.clamp(min=1e-9), 0.0).clamp(min=0)
    noise = measured.variance.sqrt() / mask.clamp(min=1e-9) / (readout_light + _FLOOR) / _SPAN
    noise = torch.where(opened & ~measured.saturated, noise.clamp(max=0.5), 1.0)
    noise, best = noise.min(dim=1, keepdim=True)
    # From 0 for 1 / 4096 of the frame or less, to 1 for the whole frame.
    share = torch.log2(mask.clamp(min=2.0**-12)).expand_as(readout_light) / 12 + 1
    planes = [share.gather(1, best), coded_light(readout_light.gather(1, best)), noise]
    return torch.stack(planes, dim=1)


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
