"""Light from frames of any code, by the weights that come with nscc."""

from __future__ import annotations

from functools import cache
from importlib.resources import as_file, files

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from nscc_training.any_code.measured import Measured
from nscc_training.any_code.network import ClipDenoiser, bf16_where_multiplied
from nscc_training.any_code.stages import STAGES, led, mirrored, schedule, stage, started
from nscc_training.any_code.stills import STILL_STAGES, started_still, still_schedule, still_stage

WEIGHTS = "weights.safetensors"
Clip = NDArray[np.float32]


@cache
def shipped(kind: str) -> ClipDenoiser:
    """The denoiser for `clip` or `still` with its weights."""
    from safetensors.torch import load_file

    with as_file(files(__package__) / WEIGHTS) as path:
        every = load_file(path)
    state = {
        name.removeprefix(f"{kind}."): part.float()
        for name, part in every.items()
        if name.startswith(f"{kind}.")
    }
    made = ClipDenoiser()
    made.load_state_dict(state)
    return made.eval().requires_grad_(False)


@torch.no_grad()
def decoded_clip(measured: Measured, count: int = STAGES) -> Tensor:
    """The clip (batch, N, rows, cols) of frames of any code, in their unit, after `count` stages;
    at last it is led to the frames once more.

    The whites of the light need not be 1 here, as a denoiser wants them: what the brightest pixels
    say is taken for that.
    """
    unit = white(measured)
    measured = measured.over(unit)
    clip, target = started(measured)
    with bf16_where_multiplied():
        for number, sigma in enumerate(schedule(count)):
            denoiser = mirrored(shipped("clip"), number)
            clip, target = stage(measured, denoiser, clip, target, sigma)
        clip = led(measured, clip)
    return clip.clamp(min=0) * unit.reshape(-1, 1, 1, 1)


@torch.no_grad()
def decoded_still(measured: Measured, count: int = STILL_STAGES) -> Tensor:
    """The light over the frame (batch, rows, cols) of frames of any code, in their unit, after
    `count` stages."""
    # A well is filled by the largest value there is, nearly: by 1, as the stages want it.
    unit = measured.value.amax(dim=(1, 2, 3)).clamp(min=1e-6)
    measured = measured.over(unit)
    light = started_still(measured)
    with bf16_where_multiplied():
        for sigma in still_schedule(count):
            light = still_stage(measured, shipped("still"), light, sigma)
    return light * unit.reshape(-1, 1, 1)


def any_clip(measurement: NDArray[np.float32], mask: Clip, count: int = STAGES) -> Clip:
    """The same of one frame (rows, cols) without noise, and its mask (N, rows, cols)."""
    frame, opened = (torch.from_numpy(np.asarray(part, np.float32)) for part in (measurement, mask))
    return decoded_clip(Measured.exact(frame[None], opened[None]), count)[0].numpy()


def white(measured: Measured) -> Tensor:
    """The light (batch,) that all but the brightest half percent of the pixels have on average."""
    total = measured.mask.sum(dim=(1, 2))
    mean = measured.mean()
    levels = []
    for index in range(len(mean)):
        opened = total[min(index, len(total) - 1)] > 0
        values = mean[index][opened]
        levels.append(np.quantile(values.numpy(), 0.995) if len(values) else 1.0)
    return torch.tensor(levels, dtype=torch.float32).clamp(min=1e-6)
