"""A denoiser of clips of any length: a U-Net whose blocks look at the frame before and after."""

from __future__ import annotations

from contextlib import AbstractContextManager, nullcontext
from typing import Any

import torch
from torch import Tensor, nn
from torch.nn import functional

WIDTHS = (32, 64, 96)
SEEN = 3
"""Planes beside the noisy clip: mask, measurement over the mask's sum, its noise."""
_FOLD = 2
"""Pixels a side that the network takes for one place with as many more channels."""


class ClipDenoiser(nn.Module):
    """Takes away noise, or what an iteration has left, from a clip of any length and size.

    The clip (batch, T, rows, cols) is on about 0..1, its errors of a standard deviation of about
    `sigma` (batch,); `seen` (batch, SEEN, T, rows, cols) is what the measurement says, zeros
    where nothing is known. Each block gives a quarter of its channels to the next frame and a
    quarter to the one before (after the temporal shift of Lin, Gan and Han, ICCV 2019): with that,
    plane convolutions see motion, and weights have no number of frames in them.
    """

    def __init__(self, widths: tuple[int, ...] = WIDTHS) -> None:
        super().__init__()
        self.widths = widths
        fine, middle, coarse = widths
        planes = _FOLD**2
        self.first = nn.Conv2d(planes * (1 + SEEN) + 1, fine, 3, padding=1)
        self.down = nn.ModuleList([_pair(fine), _pair(middle)])
        self.shrink = nn.ModuleList(
            [nn.Conv2d(fine, middle, 2, stride=2), nn.Conv2d(middle, coarse, 2, stride=2)]
        )
        self.deep = _pair(coarse)
        self.grow = nn.ModuleList(
            [nn.ConvTranspose2d(middle, fine, 2, stride=2),
             nn.ConvTranspose2d(coarse, middle, 2, stride=2)]
        )  # fmt: skip
        self.up = nn.ModuleList([_pair(fine), _pair(middle)])
        self.last = nn.Conv2d(fine, planes, 3, padding=1)
        nn.init.zeros_(self.last.weight)
        nn.init.zeros_(self.last.bias)  # type: ignore[arg-type]
        with torch.no_grad():
            # Denoising is learned first, without a measurement to look at.
            self.first.weight[:, planes:-1] = 0

    def forward(self, clip: Tensor, measured_planes: Tensor, sigma: Tensor) -> Tensor:
        batch, frames, rows, cols = clip.shape
        x = torch.cat([clip.unsqueeze(1), measured_planes], dim=1)
        multiple = _FOLD * 2 ** len(self.down)
        margins = (0, -cols % multiple, 0, -rows % multiple)
        x = x.transpose(1, 2).reshape(batch * frames, 1 + SEEN, rows, cols)
        if any(margins):
            x = functional.pad(x, margins, mode="replicate")
        x = functional.pixel_unshuffle(x, _FOLD)
        level = sigma.reshape(-1, 1, 1, 1, 1).expand(batch, frames, 1, *x.shape[2:])
        x = torch.cat([x, level.reshape(batch * frames, 1, *x.shape[2:])], dim=1)
        x = x.contiguous(memory_format=torch.channels_last)
        x = self._through(self.first(x), frames)
        residual = functional.pixel_shuffle(x.float(), _FOLD)[..., :rows, :cols]
        # In units of sigma, so that every level of noise teaches alike.
        return clip + residual.reshape(clip.shape) * sigma.reshape(-1, 1, 1, 1)

    def _through(self, x: Tensor, frames: int) -> Tensor:
        skips = []
        for blocks, shrink in zip(self.down, self.shrink, strict=True):
            for block in blocks:  # type: ignore[attr-defined]
                x = block(x, frames)
            skips.append(x)
            x = shrink(x)
        for block in self.deep:
            x = block(x, frames)
        for k in reversed(range(len(self.up))):
            x = skips[k] + self.grow[k](x)
            for block in self.up[k]:  # type: ignore[attr-defined]
                x = block(x, frames)
        output: Tensor = self.last(x)
        return output


class FrameExchangeBlock(nn.Module):
    """Two convolutions that add to what they see, after channels went to the frames beside."""

    def __init__(self, width: int) -> None:
        super().__init__()
        self.one = nn.Conv2d(width, width, 3, padding=1)
        self.two = nn.Conv2d(width, width, 3, padding=1)

    def forward(self, x: Tensor, frames: int) -> Tensor:
        inner = functional.relu(self.one(exchanged(x, frames)), inplace=True)
        output: Tensor = x + self.two(inner)
        return output


def exchanged(x: Tensor, frames: int) -> Tensor:
    """(batch * T, channels, rows, cols) where a quarter of the channels is the frame before's and a
    quarter the frame after's; the first and the last frame stand in for those that are missing."""
    output: Tensor = _Exchanged.apply(x, frames)  # type: ignore[no-untyped-call]
    return output


class _Exchanged(torch.autograd.Function):
    """`exchanged` with a gradient of its own: that of five slices takes a fifth of a training."""

    @staticmethod
    def forward(ctx: Any, x: Tensor, frames: int) -> Tensor:
        ctx.frames = frames
        output = x.clone(memory_format=torch.channels_last)
        old, new = (values.view(-1, frames, *x.shape[1:]) for values in (x, output))
        count = x.shape[1] // 4
        new[:, 1:, :count] = old[:, :-1, :count]
        new[:, :-1, count : 2 * count] = old[:, 1:, count : 2 * count]
        return output

    @staticmethod
    def backward(ctx: Any, slope: Tensor) -> tuple[Tensor, None]:
        x_slope = slope.clone(memory_format=torch.channels_last)
        old, new = (values.view(-1, ctx.frames, *slope.shape[1:]) for values in (slope, x_slope))
        count = slope.shape[1] // 4
        if ctx.frames > 1:
            new[:, :-1, :count] = old[:, 1:, :count]
            new[:, 0, :count] += old[:, 0, :count]
            new[:, -1, :count] = 0
            after = slice(count, 2 * count)
            new[:, 1:, after] = old[:, :-1, after]
            new[:, -1, after] += old[:, -1, after]
            new[:, 0, after] = 0
        return x_slope, None


def _pair(width: int) -> nn.ModuleList:
    return nn.ModuleList([FrameExchangeBlock(width), FrameExchangeBlock(width)])


def bf16_where_multiplied() -> AbstractContextManager[object]:
    """Autocast to bfloat16 on processors that multiply it; elsewhere it would take longer."""
    knows = [torch.cpu._is_avx512_bf16_supported(), torch.cpu._is_amx_tile_supported()]
    return torch.autocast("cpu", torch.bfloat16) if any(knows) else nullcontext()
