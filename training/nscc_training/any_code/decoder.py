"""The decoder `any` for training: runs start from the weights of the decoder for any code."""

from __future__ import annotations

from collections.abc import Sequence

import torch
from torch import Tensor, nn

from nscc_training.any_code.decode import shipped, white
from nscc_training.any_code.network import WIDTHS, ClipDenoiser
from nscc_training.any_code.stages import (
    STILL_STAGES,
    led,
    mirrored,
    schedule,
    stage,
    started_still,
    still_stages,
)
from nscc_training.baselines.gap_tv import gap_tv_of
from nscc_training.decoders.declared import DecoderTask
from nscc_training.measured import Measured
from nscc_training.sensor_model import laid, shared_out

_STAGES = {"paper": 8, "small": 4}
"""Number of stages for clips, by the size of the decoder that the settings name."""
_NOISE = (1e-5, 3e-5)
"""Variance of a dark pixel, and its increase up to a full pixel, relative to the squared full well.

The values fit a full well of 30,000 electrons and 8 bits. Runs use their own noise."""


class AnyCode(nn.Module):
    """The decoder for any code as a torch module: `stages` times a step towards the frames and a
    denoiser.

    It starts from nscc's weights if it has their widths.

    Inputs: frames (batch, rows, cols), or of two buckets (batch, 2, rows, cols), in full wells and
    saturated at 1; shutters (N, r, c) of the first bucket, as a tile. Output: light in full wells
    over the frame (batch, rows, cols), or for clips in full wells / N per slot (batch, N, rows,
    cols). Clips start from GAP-TV, which passes no gradient."""

    def __init__(self, channels: Sequence[int], task: DecoderTask, size: str) -> None:
        """Build the decoder. Take the shipped weights if `channels`, the widths of its three
        scales, are those of the shipped network, else random ones.

        `task` says whether to decode stills or clips. `size` ("paper" or "small") chooses the
        number of stages for clips, 8 or 4. The two noise parameters are learned, too."""
        super().__init__()
        self.still = task.kind == "still"
        self.stages = STILL_STAGES if self.still else _STAGES[size]
        self.denoiser = ClipDenoiser(tuple(channels))
        if self.denoiser.widths == WIDTHS:
            self.denoiser.load_state_dict(shipped(task.kind).state_dict())
        self.noise = nn.Parameter(torch.tensor(_NOISE).log())

    def begin_anew(self) -> None:
        """Replace the weights of the denoiser, which may be those that nscc ships, by random
        weights."""
        self.denoiser = ClipDenoiser(self.denoiser.widths)

    def forward(self, frame: Tensor, shutters: Tensor) -> Tensor:
        """Return the light of frames: (batch, rows, cols) for stills, (batch, N, rows, cols) for
        clips.

        `frame` (batch, [buckets,] rows, cols) is in full wells; a value of 1 counts as saturated.
        `shutters` (N, r, c) are 1 where the first bucket is open, for one tile that is repeated
        over the frame. Light over the frame is in full wells, the light of a slot in full wells /
        N."""
        opened = laid(shutters, *frame.shape[-2:]).to(frame.dtype)
        slots = 1 if self.still else opened.shape[-3]
        mask = opened.mean(dim=-3, keepdim=True) if self.still else opened
        if frame.ndim == 3:
            frame, masks = frame.unsqueeze(1), mask.unsqueeze(-4)
        else:
            masks = shared_out(mask, frame.shape[1])
        dark, gained = self.noise.exp()
        # Frames of clips are multiplied by N, because light is in units of a full well / N.
        variance = slots**2 * (dark + gained * frame.clamp(min=0))
        masks = masks if masks.ndim == 5 else masks.unsqueeze(0)
        measured = Measured(slots * frame, masks, variance, frame >= 1)
        if self.still:
            start = started_still(measured)
            *_, light = still_stages(measured, self.denoiser, start, self.stages)
            return light
        # The start of a clip has no gradient: GAP-TV would need the memory of all its iterations.
        with torch.no_grad():
            unit = white(measured)
            clip, target = gap_tv_of(measured.over(unit))
        measured = measured.over(unit)
        for number, sigma in enumerate(schedule(self.stages)):
            clip, target = stage(measured, mirrored(self.denoiser, number), clip, target, sigma)
        return led(measured, clip) * unit.reshape(-1, 1, 1, 1)
