"""Total variation and GAP-TV of batches of clips, as operators of torch on any device."""

from __future__ import annotations

import numpy as np
import torch
from torch import Tensor

from nscc_training.baselines.tv_loop import Volume, denoise
from nscc_training.measured import Measured

START = 20
"""Iterations of GAP-TV at the start of decoders."""
_WEIGHT, _INNER, _TIME = 0.1, 5, 0.3
_FAR = 1.0
"""Standard deviation of the clip's error that GAP-TV assumes, so large that frames are fitted
exactly."""


def gap_tv_of(measured: Measured, iterations: int = START) -> tuple[Tensor, Tensor]:
    """Return the clip (batch, N, rows, cols) after `iterations` of GAP-TV, and its target for
    `gap_step`.

    Frames may have several buckets, and be saturated and noisy. The start is a static clip, with
    each pixel's light spread over the frame: from a dark start, slots that no pixel recorded would
    stay about a fifth too dark (64 slots).
    """
    far = measured.value.new_full((len(measured.value),), _FAR)
    target = measured.value
    clip = measured.mean().unsqueeze(1).expand(-1, measured.mask.shape[2], -1, -1)
    for _ in range(iterations):
        clip, target = gap_step(measured, clip, target, far)
        clip = tv_denoised(clip, _WEIGHT, _INNER, _TIME).to(clip)
    return clip, target


def gap_step(
    measured: Measured, clip: Tensor, target: Tensor, sigma: Tensor
) -> tuple[Tensor, Tensor]:
    """Return the clip after a step towards the frames, and the updated target."""
    predicted = measured.of(clip)
    target = target + measured.missing(predicted, measured.value) * measured.trust(sigma)
    return clip + measured.correction(measured.missing(predicted, target), sigma), target


@torch.library.custom_op("nscc::tv_denoise", mutates_args=(), device_types="cpu")
def tv_denoised(clips: Tensor, weight: float, iterations: int, time: float) -> Tensor:
    """Return clips (batch, T, rows, cols) denoised as `nscc_training.baselines.tv.tv_denoise` does.

    On the CPU a compiled loop goes over the pixels, because torch's operators go over the memory
    fifteen times as often; on other devices they are used. No gradient passes.
    """
    # The same memory as arrays: nothing is copied.
    image = np.asarray(np.from_dlpack(clips.detach().float().contiguous()), np.float32)
    field = np.zeros((3, *image.shape), np.float32)
    out = np.empty_like(image)
    batch, frames, rows, cols = image.shape
    volume = Volume(
        clips=batch, frames=frames, rows=rows, cols=cols, iterations=iterations, weight=weight,
        time=time,
    )  # fmt: skip
    denoise(volume=volume, image=image, later=field[0], down=field[1], right=field[2], out=out)
    return torch.from_numpy(out)


@tv_denoised.register_kernel(None)
def _by_operators(clips: Tensor, weight: float, iterations: int, time: float) -> Tensor:
    return tv_by_operators(clips, weight, iterations, time)


@tv_denoised.register_fake
def _shape(clips: Tensor, weight: float, iterations: int, time: float) -> Tensor:
    return torch.empty_like(clips, dtype=torch.float32)


def tv_by_operators(clips: Tensor, weight: float, iterations: int, time: float) -> Tensor:
    """Return the result of `tv_denoised` by torch's operators, on any device."""
    image = clips.detach().float()
    scales = (time, 1.0, 1.0)
    step = 1.0 / (4.0 + 2.0 * time * time)
    field = [torch.zeros_like(image) for _ in scales]
    out = image
    for turn in range(iterations + 1):
        out = image.clone()
        for axis, (component, scale) in enumerate(zip(field, scales, strict=True), start=1):
            out.sub_(component, alpha=scale)
            _after(out, axis).add_(_before(component, axis), alpha=scale)
        if turn == iterations:
            break
        slopes = [
            torch.diff(out, dim=axis).mul_(scale) for axis, scale in enumerate(scales, start=1)
        ]
        squared = torch.zeros_like(image)
        for axis, slope in enumerate(slopes, start=1):
            _before(squared, axis).addcmul_(slope, slope)
        shrink = squared.sqrt_().mul_(step / weight).add_(1.0).reciprocal_()
        for axis, (component, slope) in enumerate(zip(field, slopes, strict=True), start=1):
            _before(component, axis).sub_(slope, alpha=step).mul_(_before(shrink, axis))
    return out


def _before(values: Tensor, axis: int) -> Tensor:
    """Return all but the last along an axis."""
    return values.narrow(axis, 0, values.shape[axis] - 1)


def _after(values: Tensor, axis: int) -> Tensor:
    """Return all but the first along an axis."""
    return values.narrow(axis, 1, values.shape[axis] - 1)
