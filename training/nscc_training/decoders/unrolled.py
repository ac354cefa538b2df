"""Unrolled GAP: alternates projections and learned denoisers, for clips of any code."""

from __future__ import annotations

from collections.abc import Sequence

import torch
from torch import Tensor, nn

from nscc_training.baselines.gap_tv import gap_tv_of
from nscc_training.decoders.declared import DecoderTask
from nscc_training.decoders.guess import clip_guess
from nscc_training.decoders.unet import UNet, begin_with_nothing
from nscc_training.measured import Measured
from nscc_training.sensor_model import laid, lifted

_STAGES = {"paper": 9, "small": 3}
"""Number of stages, by the size of the decoder."""


class Unrolled(nn.Module):
    """A decoder that alternates a projection and a 2D U-Net.

    The projection is that of generalised alternating projection (Liao, Li and Carin, SIAM Journal
    on Imaging Sciences 2014): it distributes the difference between the frame and the clip's own
    capture over the slots in which each pixel was open. A U-Net has a channel per slot and sees the
    shutters.

    The clip starts from the first guess, or from `tv_iterations` of GAP-TV."""

    tv_iterations = 0
    """Iterations of GAP-TV that the clip starts from; 0 starts from the first guess."""

    def __init__(self, channels: Sequence[int], task: DecoderTask, size: str) -> None:
        """Build a denoiser, whose levels have `channels` channels, and a step size for each stage.
        `size` ("paper" or "small") chooses the number of stages."""
        super().__init__()
        self.slots = task.slots
        self.steps = nn.Parameter(torch.ones(_STAGES[size]))
        self.denoisers = nn.ModuleList(
            begin_with_nothing(
                UNet(2 * task.slots, outputs=task.slots, widths=channels, dimensions=2)
            )
            for _ in range(len(self.steps))
        )

    def forward(self, frame: Tensor, shutters: Tensor) -> Tensor:
        """Return the light of clips (batch, N, rows, cols), in full wells / N for each slot.

        `frame` (batch, rows, cols) is in full wells, `shutters` (N, r, c) are those of a tile. Each
        stage first corrects the clip so that it fits the measurement, then denoises it."""
        opened = laid(shutters, *frame.shape[-2:]).to(frame.dtype)
        energy = opened.square().sum(dim=0).clamp(min=1)
        # 1 is a full well for a frame, a full well / N for a slot.
        total = frame * self.slots
        if self.tv_iterations:
            clip = self._gap_tv(total, opened)
        else:
            clip = clip_guess(lifted(total, opened)[0], opened)
        shutter_channels = opened.expand_as(clip)
        for step, denoiser in zip(self.steps, self.denoisers, strict=True):
            missing = (total - (opened * clip).sum(dim=1)) / energy
            clip = clip + step * opened * missing.unsqueeze(1)
            clip = clip + denoiser(torch.cat([clip, shutter_channels], dim=1)).float()
        return clip

    @torch.no_grad()
    def _gap_tv(self, total: Tensor, opened: Tensor) -> Tensor:
        """Return clips (batch, N, rows, cols) by GAP-TV, from which the stages start; they pass no
        gradient.

        `total` (batch, rows, cols) is the frame in units of a slot, `opened` (N, rows, cols) its
        shutters."""
        measured = Measured.exact(total.float(), opened.float().unsqueeze(0))
        return gap_tv_of(measured, self.tv_iterations)[0].to(total)


class Refined(Unrolled):
    """The decoder `Unrolled`, started from a clip by GAP-TV. This start is better than the first
    guess, but passes no gradient to the codes."""

    tv_iterations = 20
