"""A denoiser for clips of any length: a U-Net whose blocks exchange channels between frames."""

from __future__ import annotations

from contextlib import AbstractContextManager, nullcontext
from typing import Any

import torch
from torch import Tensor, nn
from torch.nn import functional

WIDTHS = (32, 64, 96)
SEEN = 3
"""Input channels besides the noisy clip: mask, measurement divided by the mask's sum, its noise."""
_FOLD = 2
"""Side in pixels of the squares that are folded into channels at the input."""


class ClipDenoiser(nn.Module):
    """A network that removes noise or reconstruction errors from a clip of any length and size.

    The clip (batch, T, rows, cols) has values of about 0 to 1 and errors with the standard
    deviation `sigma` (batch,). `seen` (batch, SEEN, T, rows, cols) describes the measurement; it is
    0 if unknown. Each block moves a quarter of its channels to the next frame and a quarter to the
    previous one (temporal shift; Lin, Gan and Han, ICCV 2019). Thereby 2D convolutions respond to
    motion, and the weights do not depend on the number of frames."""

    def __init__(self, widths: tuple[int, ...] = WIDTHS) -> None:
        """Build a network of three scales; `widths` are the three numbers of channels, from fine to
        coarse. It begins as the identity, because its last weights are 0."""
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
            [
                nn.ConvTranspose2d(middle, fine, 2, stride=2),
                nn.ConvTranspose2d(coarse, middle, 2, stride=2),
            ]
        )
        self.up = nn.ModuleList([_pair(fine), _pair(middle)])
        self.last = nn.Conv2d(fine, planes, 3, padding=1)
        nn.init.zeros_(self.last.weight)
        nn.init.zeros_(self.last.bias)  # type: ignore[arg-type]
        with torch.no_grad():
            # Denoising is learned first, without a measurement.
            self.first.weight[:, planes:-1] = 0

    def forward(self, clip: Tensor, measured_planes: Tensor, sigma: Tensor) -> Tensor:
        """Return an estimate of the clip (batch, frames, rows, cols) without its noise.

        `sigma` (batch,) is the standard deviation of the noise. `measured_planes` (batch, SEEN,
        frames, rows, cols) are features of the measurement: `Measured.planes`, or 0. Sides that are
        no multiple of the coarsest scale are padded and cut again."""
        batch, frames, rows, cols = clip.shape
        x = torch.cat([clip.unsqueeze(1), measured_planes], dim=1)
        multiple = _FOLD * 2 ** len(self.down)
        # Torch takes the margins of the last axis first.
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
        # In units of sigma, so that all noise levels have the same weight.
        return clip + residual.reshape(clip.shape) * sigma.reshape(-1, 1, 1, 1)

    def _through(self, x: Tensor, frames: int) -> Tensor:
        """Return the output (batch * frames, channels, rows, cols) of the U-Net. `x` has the shape
        of frames that are stacked as a batch, and `frames` says how many belong to a clip."""
        skips = []
        for blocks, shrink in zip(self.down, self.shrink, strict=True):
            for block in blocks:  # type: ignore[attr-defined]
                x = block(x, frames)
            skips.append(x)
            x = shrink(x)
        for block in self.deep:
            x = block(x, frames)
        for k in reversed(range(len(self.up))):
            x = self.grow[k](x).add_(skips.pop())
            for block in self.up[k]:  # type: ignore[attr-defined]
                x = block(x, frames)
        output: Tensor = self.last(x)
        return output


class FrameExchangeBlock(nn.Module):
    """A residual block of two convolutions. Before them, neighbouring frames of a clip exchange
    channels (`exchanged`)."""

    def __init__(self, width: int) -> None:
        """Build two convolutions of `width` channels."""
        super().__init__()
        self.one = nn.Conv2d(width, width, 3, padding=1)
        self.two = nn.Conv2d(width, width, 3, padding=1)

    def forward(self, x: Tensor, frames: int) -> Tensor:
        """Return `x` (batch * frames, channels, rows, cols) plus two convolutions of it. Before the
        first, the frames of a clip exchange channels (`exchanged`). `frames` is the number of
        frames of each clip of the batch."""
        inner = functional.relu(self.one(exchanged(x, frames)), inplace=True)
        output: Tensor = self.two(inner)
        return output.add_(x)


def exchanged(x: Tensor, frames: int) -> Tensor:
    """Return `x` (batch * T, channels, rows, cols) with half of its channels moved between frames.

    `frames` is T, the length of each clip in the batch. The first quarter of the channels comes
    from the previous frame and the second from the next; the first and last frame keep their own
    where they have no neighbour."""
    output: Tensor = _Exchanged.apply(x, frames)  # type: ignore[no-untyped-call]
    return output


class _Exchanged(torch.autograd.Function):
    """The function `exchanged` with a gradient written by hand, because the automatic gradient of
    slices is slow."""

    @staticmethod
    def forward(ctx: Any, x: Tensor, frames: int) -> Tensor:
        """Return x (batch * frames, channels, rows, cols) in which the first quarter of the
        channels is taken from the frame before, and the second quarter from the frame after.

        The first and the last frame keep their own channels where they have no neighbour."""
        ctx.frames = frames
        output = x.clone(memory_format=torch.channels_last)
        old, new = (values.view(-1, frames, *x.shape[1:]) for values in (x, output))
        count = x.shape[1] // 4
        new[:, 1:, :count] = old[:, :-1, :count]
        new[:, :-1, count : 2 * count] = old[:, 1:, count : 2 * count]
        return output

    @staticmethod
    def backward(ctx: Any, slope: Tensor) -> tuple[Tensor, None]:
        """Return the gradient of x from that of the result, `slope`: each exchanged channel goes
        back to the frame that it came from. The number of frames has no gradient (None)."""
        x_slope = slope.clone(memory_format=torch.channels_last)
        old, new = (values.view(-1, ctx.frames, *slope.shape[1:]) for values in (slope, x_slope))
        count = slope.shape[1] // 4
        if ctx.frames > 1:
            # The first frame kept its own channels of the first quarter as well as giving them to
            # the second frame; the last frame's reached no other frame. The second quarter is the
            # reverse.
            new[:, :-1, :count] = old[:, 1:, :count]
            new[:, 0, :count] += old[:, 0, :count]
            new[:, -1, :count] = 0
            after = slice(count, 2 * count)
            new[:, 1:, after] = old[:, :-1, after]
            new[:, -1, after] += old[:, -1, after]
            new[:, 0, after] = 0
        return x_slope, None


def _pair(width: int) -> nn.ModuleList:
    """Return two blocks of `width` channels, one after the other."""
    return nn.ModuleList([FrameExchangeBlock(width), FrameExchangeBlock(width)])


def bf16_where_multiplied() -> AbstractContextManager[object]:
    """Return a context in which torch multiplies in bfloat16, if this processor does so in
    hardware; otherwise a context that changes nothing."""
    knows = [torch.cpu._is_avx512_bf16_supported(), torch.cpu._is_amx_tile_supported()]
    return torch.autocast("cpu", torch.bfloat16) if any(knows) else nullcontext()
