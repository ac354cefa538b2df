"""Total variation of batches of clips, as an operator of torch on any device."""

from __future__ import annotations

import numpy as np
import torch
from torch import Tensor

from nscc_training.baselines.tv_loop import tv_denoised_arrays

# Declared by its schema: calling an operator of `torch.library.custom_op` imports the compiler of
# torch, which takes seconds.
torch.library.define(
    "nscc::tv_denoise", "(Tensor clips, float weight, int iterations, float time) -> Tensor"
)


def tv_denoised(clips: Tensor, weight: float, iterations: int, time: float) -> Tensor:
    """Denoise clips (batch, T, rows, cols) by `iterations` of Chambolle's method for total
    variation of this `weight` (above 0). Differences between frames count `time` times those
    between pixels. The result is float32 and has no gradient.

    On the CPU a compiled loop computes, which reads memory less often; on other devices torch's
    operators do."""
    denoised: Tensor = torch.ops.nscc.tv_denoise(clips, weight, iterations, time)
    return denoised


def _by_loop(clips: Tensor, weight: float, iterations: int, time: float) -> Tensor:
    """Denoise clips (batch, T, rows, cols) on the CPU by the compiled loop. The result has no
    gradient."""
    # The same memory as an array: nothing is copied.
    image = np.from_dlpack(clips.detach().float().contiguous())
    return torch.from_numpy(tv_denoised_arrays(image, weight, iterations, time))


def _shape(clips: Tensor, weight: float, iterations: int, time: float) -> Tensor:
    """Return an empty float32 tensor with the shape of the result, from which torch learns it
    without computing."""
    return torch.empty_like(clips, dtype=torch.float32)


def tv_by_operators(clips: Tensor, weight: float, iterations: int, time: float) -> Tensor:
    """Denoise clips (batch, T, rows, cols) as `tv_denoised` does, but with torch's operators, on
    any device: `weight`, `iterations` and `time` mean the same. The result is float32 and has no
    gradient."""
    image = clips.detach().float()
    scales = (time, 1.0, 1.0)
    # 1 / (2 dimensions) is where the projection is known to converge.
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


torch.library.impl("nscc::tv_denoise", "CPU", _by_loop)
torch.library.impl("nscc::tv_denoise", "CompositeExplicitAutograd", tv_by_operators)
torch.library.register_fake("nscc::tv_denoise", _shape)


def _before(values: Tensor, axis: int) -> Tensor:
    """Return `values` without the last element along an axis."""
    return values.narrow(axis, 0, values.shape[axis] - 1)


def _after(values: Tensor, axis: int) -> Tensor:
    """Return `values` without the first element along an axis."""
    return values.narrow(axis, 1, values.shape[axis] - 1)
