"""Reconstruction from frames with any code, with the weights that come with nscc."""

from __future__ import annotations

from functools import cache
from importlib.resources import as_file, files
from pathlib import Path

import torch
from torch import Tensor

from nscc_training.any_code.network import ClipDenoiser, bf16_where_multiplied
from nscc_training.any_code.readouts import FIRST_STAGE, always_open, joined
from nscc_training.any_code.stages import STAGES, led, mirrored, schedule, stage
from nscc_training.any_code.stills import STILL_STAGES, started_still, still_schedule, still_stage
from nscc_training.baselines.gap_tv import gap_tv_of
from nscc_training.measured import Measured

WEIGHTS = "weights.safetensors"
_BRIGHT = 0.995


@cache
def shipped(kind: str) -> ClipDenoiser:
    """Return the denoiser for clips or stills, `kind` "clip" or "still", with its weights."""
    from safetensors.torch import load_file

    with as_file(files(__package__) / WEIGHTS) as path:
        weights = load_file(path)
    state = {
        name.removeprefix(f"{kind}."): weight.float()
        for name, weight in weights.items()
        if name.startswith(f"{kind}.")
    }
    denoiser = ClipDenoiser()
    denoiser.load_state_dict(state)
    return denoiser.eval().requires_grad_(False)


def write_shipped(clip: Path, still: Path, out: Path) -> None:
    """Write the weights of a clip run and a still run in half precision, as nscc ships them."""
    from safetensors.torch import load_file, save_file

    state = {
        f"{kind}.{name.removeprefix('denoiser.')}": weight.half()
        for kind, run in (("clip", clip), ("still", still))
        for name, weight in load_file(run / "decoder.safetensors").items()
        if name.startswith("denoiser.")
    }
    save_file(state, out)


@torch.no_grad()
def decoded_clip(measured: Measured[Tensor], count: int = STAGES) -> Tensor:
    """Reconstruct the clip (batch, N, rows, cols) from frames, in their unit, in `count` stages.

    If one of several readouts was always open, `joined` adds static content from all readouts. A
    last step brings the clip closer to the frames. The denoiser expects white to be 1, so the
    measurement is first divided by an estimate of white."""
    unit = white(measured)
    measured = measured.over(unit)
    number = always_open(measured)
    if number is None:
        clip = _coded_clip(measured, count, count)
    else:
        clip = joined(measured, _coded_clip(measured, count, min(count, FIRST_STAGE)), number)
    return clip.clamp(min=0) * unit.reshape(-1, 1, 1, 1)


def _coded_clip(measured: Measured[Tensor], count: int, first: int) -> Tensor:
    """Return the mean of the clips after stages `first` to `count`, corrected towards the frames.

    White is 1 in the unit of light."""
    clip, target = gap_tv_of(measured)
    mean = torch.zeros_like(clip)
    with bf16_where_multiplied():
        for number, sigma in enumerate(schedule(count)):
            denoiser = mirrored(shipped("clip"), number)
            clip, target = stage(measured, denoiser, clip, target, sigma)
            if number + 1 >= first:
                mean += clip / (count + 1 - first)
        return led(measured, mean)


@torch.no_grad()
def decoded_still(measured: Measured[Tensor], count: int = STILL_STAGES) -> Tensor:
    """Reconstruct the light over the frame (batch, rows, cols), in the frames' unit, in `count`
    stages."""
    # Scale so that nearly the largest value is 1, as the stages require.
    unit = measured.value.amax(dim=(1, 2, 3)).clamp(min=1e-6)
    measured = measured.over(unit)
    light = started_still(measured)
    with bf16_where_multiplied():
        for sigma in still_schedule(count):
            light = still_stage(measured, shipped("still"), light, sigma)
    return light * unit.reshape(-1, 1, 1)


def white(measured: Measured[Tensor]) -> Tensor:
    """Return an estimate of white (batch,): the light at the 99.5 % quantile of the opened pixels.

    The result is 1 if no pixel is ever open."""
    total = measured.mask.sum(dim=(1, 2))
    mean = measured.mean()
    opened = (total > 0).expand_as(mean).flatten(1)
    # Pixels that never open are sorted to the front and not counted.
    ordered = torch.where(opened, mean.flatten(1), -torch.inf).sort(dim=1).values
    count = opened.sum(dim=1)
    closed = ordered.shape[1] - count
    place = closed + _BRIGHT * (count - 1).clamp(min=0)
    below = place.floor().long().clamp(max=ordered.shape[1] - 1)
    above = (below + 1).clamp(max=ordered.shape[1] - 1)
    low, high = (ordered.gather(1, index[:, None])[:, 0] for index in (below, above))
    level = torch.where(count > 0, low + (high - low) * (place - below).to(low), 1.0)
    return level.clamp(min=1e-6)
