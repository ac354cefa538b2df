"""U-Nets in two and three dimensions: double convolutions, average pooling, linear upsampling."""

from __future__ import annotations

from collections.abc import Sequence

import torch
from torch import Tensor, nn
from torch.nn import functional

from nscc_training.curves import log_curve_inverse
from nscc_training.sensor_model import laid, lifted

LOG_FLOOR = 1e-3
"""Stills are predicted as log(1 + light / LOG_FLOOR)."""


class UNet(nn.Module):
    """The common shape of both: `widths` channels from the finest level to the coarsest.

    Any size of input is padded to a multiple of 2 ** (levels - 1) by repeating its edge, and the
    result is cut to what came in.
    """

    def __init__(self, inputs: int, outputs: int, widths: Sequence[int], dimensions: int) -> None:
        super().__init__()
        self.dimensions = dimensions
        convolution = nn.Conv2d if dimensions == 2 else nn.Conv3d
        self.pool = nn.AvgPool2d(2) if dimensions == 2 else nn.AvgPool3d(2)

        def double(channels: int, width: int) -> nn.Module:
            return nn.Sequential(
                convolution(channels, width, 3, padding=1), nn.ReLU(inplace=True),
                convolution(width, width, 3, padding=1), nn.ReLU(inplace=True),
            )  # fmt: skip

        self.down = nn.ModuleList(
            double(before, width) for before, width in zip([inputs, *widths], widths, strict=False)
        )
        self.up = nn.ModuleList(
            double(widths[k + 1] + widths[k], widths[k]) for k in reversed(range(len(widths) - 1))
        )
        self.last = convolution(widths[0], outputs, 1)
        self.multiple = 2 ** (len(widths) - 1)
        for layer in self.modules():
            if isinstance(layer, convolution) and layer.bias is not None:
                # He et al. 2015: without it the signal fades on the way through so many layers.
                nn.init.kaiming_normal_(layer.weight, nonlinearity="relu")
                nn.init.zeros_(layer.bias)

    def forward(self, x: Tensor) -> Tensor:
        """(batch, inputs, [N,] rows, cols) to (batch, outputs, [N,] rows, cols)."""
        sizes = x.shape[2:]
        x = self.padded(x)
        kept: list[Tensor] = []
        for level, layer in enumerate(self.down):
            x = layer(x if level == 0 else self.pool(x))
            kept.append(x)
        kept.pop()
        mode = "bilinear" if self.dimensions == 2 else "trilinear"
        for layer in self.up:
            finer = kept.pop()
            x = functional.interpolate(x, size=finer.shape[2:], mode=mode, align_corners=False)
            x = layer(torch.cat([x, finer], dim=1))
        found: Tensor = self.last(x)
        return found[(slice(None), slice(None), *(slice(0, size) for size in sizes))]

    def padded(self, x: Tensor) -> Tensor:
        """x with its edges repeated up to the next multiple."""
        margins: list[int] = []
        for size in reversed(x.shape[2:]):
            margins += [0, -size % self.multiple]
        return functional.pad(x, margins, mode="replicate") if any(margins) else x


class StillUNet(nn.Module):
    """2D U-Net. Sees the frame; with `sees_code`, for stills also the part of the frame that each
    pixel was open for and its light by itself, for clips S^T E, a channel a slot.

    The result of stills is the logarithm of light, that of clips (`slots`) has a channel a slot.
    """

    def __init__(self, widths: Sequence[int], slots: int | None, sees_code: bool) -> None:
        super().__init__()
        self.slots, self.sees_code = slots, sees_code
        known = 2 if slots is None else slots
        self.network = UNet(1 + known if sees_code else 1, slots or 1, widths, 2)

    def forward(self, frame: Tensor, shutters: Tensor) -> Tensor:
        x = frame.unsqueeze(1)
        if self.sees_code and self.slots is not None:
            volume, _valid = lifted(frame * self.slots, shutters.to(frame.dtype))
            x = torch.cat([x, volume], dim=1)
        elif self.sees_code:
            share = laid(shutters.mean(dim=0), *frame.shape[-2:]).expand_as(frame)
            alone = torch.where(share > 0, frame / share.clamp(min=1e-6), torch.zeros_like(frame))
            x = torch.stack([frame, share, torch.log1p(alone / LOG_FLOOR)], dim=1)
        found: Tensor = self.network(x).float()
        return found if self.slots is not None else log_curve_inverse(found[:, 0], LOG_FLOOR)


class ClipUNet(nn.Module):
    """3D U-Net on S^T E: the frame copied over time and masked by the shutters."""

    def __init__(self, widths: Sequence[int], slots: int) -> None:
        super().__init__()
        self.slots = slots
        self.network = UNet(1, 1, widths, 3)

    def forward(self, frame: Tensor, shutters: Tensor) -> Tensor:
        # A frame is the sum over its open slots; S^T E is in light a slot, so 1 is full well / N.
        volume, _valid = lifted(frame * self.slots, shutters.to(frame.dtype))
        found: Tensor = self.network(volume.unsqueeze(1)).squeeze(1)
        return found.float()
