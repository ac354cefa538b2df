"""What frames say of the light that made them: the data term, for any sensor and any code."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from nscc_training.sensor_model import SensorModel


@dataclass(frozen=True, eq=False)
class Measured:
    """Frames of one exposure, B of them (buckets), and how they came about.

    `value` (batch, B, rows, cols) is sum over N of `mask` (batch or 1, B, N, rows, cols) times the
    light, whose unit is such that its whites are about 1, and noise of `variance` (as `value`).
    Where `saturated`, the light gave that much or more. `mask` may be weighted, by the length of
    slots for one.
    """

    value: Tensor
    mask: Tensor
    variance: Tensor
    saturated: Tensor

    @classmethod
    def exact(cls, value: Tensor, mask: Tensor) -> Measured:
        """One frame (batch, rows, cols) without noise; the mask (batch or 1, N, rows, cols)."""
        value = value.unsqueeze(1)
        return cls(
            value, mask.unsqueeze(1), torch.zeros_like(value),
            torch.zeros_like(value, dtype=torch.bool),
        )  # fmt: skip

    @classmethod
    def read(
        cls, frames: NDArray[np.float32], masks: NDArray[Any], sensor: SensorModel
    ) -> Measured:
        """Return frames (B, rows, cols) of a sensor, in codes above the offset, as electrons.

        `masks` are (B, N, rows, cols).
        """
        codes = torch.from_numpy(np.ascontiguousarray(frames, np.float32))[None]
        value = codes * sensor.electrons_per_lsb
        noise_lsb2 = sensor.adc_noise_lsb**2 + 1 / 12
        variance = torch.full_like(value, noise_lsb2 * sensor.electrons_per_lsb**2)
        if sensor.shot_noise:
            variance = variance + value.clamp(min=0)
        full = codes >= sensor.full_code
        opened = torch.from_numpy(np.ascontiguousarray(masks, np.float32))
        return cls(value, opened[None], variance, full)

    def over(self, unit: Tensor) -> Measured:
        """The same in other units (batch,) of light."""
        unit = unit.reshape(-1, 1, 1, 1)
        return replace(self, value=self.value / unit, variance=self.variance / unit.square())

    def of(self, clip: Tensor) -> Tensor:
        """The frames that a clip (batch, N, rows, cols) would give."""
        return (self.mask * clip.unsqueeze(1)).sum(dim=2)

    def missing(self, predicted: Tensor, target: Tensor) -> Tensor:
        """How far a clip's frames are from a target; where saturated, more is never too much."""
        gap = target - predicted
        return torch.where(self.saturated, gap.clamp(min=0), gap)

    def trust(self, sigma: Tensor) -> Tensor:
        """The part of a difference that is the clip's error, of standard deviation `sigma`
        (batch,), and not the frames' noise; as `value`."""
        spread = self.energy * sigma.reshape(-1, 1, 1, 1).square()
        error_share: Tensor = spread / (spread + self.variance).clamp(min=1e-20)
        return error_share

    def correction(self, gap: Tensor, sigma: Tensor) -> Tensor:
        """What to add to a clip for frames that differ by `gap`: its most likely error if that has
        the standard deviation `sigma` everywhere. Without noise, and with frames that share no
        light, this is the projection onto all clips that give the frames."""
        if self.disjoint:
            noise = self.variance / sigma.reshape(-1, 1, 1, 1).square()
            shares = gap / (self.energy + noise).clamp(min=1e-6)
            return (self.mask * shares.unsqueeze(2)).sum(dim=1)
        weights = torch.linalg.solve(self._joint(sigma), gap.permute(0, 2, 3, 1))
        update: Tensor = (self.mask * weights.permute(0, 3, 1, 2).unsqueeze(2)).sum(dim=1)
        return update

    @cached_property
    def disjoint(self) -> bool:
        """Whether no light of a pixel is in two frames, as in those of a film: then what one frame
        lacks says nothing of the others."""
        shared = (self.mask != 0).sum(dim=1) > 1
        return self.mask.shape[1] == 1 or not bool(shared.any())

    def _joint(self, sigma: Tensor) -> Tensor:
        """(batch, rows, cols, B, B): how frames of a pixel vary together, over sigma squared."""
        masks = self.mask.permute(0, 3, 4, 1, 2)
        noise = self.variance.permute(0, 2, 3, 1) / sigma.reshape(-1, 1, 1, 1).square()
        # A frame that a pixel is never open in says nothing, and is not to divide by 0.
        return masks @ masks.mT + torch.diag_embed(noise + 1e-4)

    @property
    def energy(self) -> Tensor:
        """The sum of squares of the mask, (batch or 1, B, rows, cols)."""
        return self.mask.square().sum(dim=2)

    def mean(self) -> Tensor:
        """The light (batch, rows, cols) that each pixel's open slots had on average, 0 where none
        was open."""
        total = self.mask.sum(dim=(1, 2))
        return torch.where(total > 0, self.value.sum(dim=1) / total.clamp(min=1e-6), 0.0)

    def planes(self) -> Tensor:
        """What a denoiser sees of it, (batch, 3, N, rows, cols): all frames' mask, their value over
        it, and the standard deviation of that, at most 1: the same for all N but the mask."""
        mask = self.mask.sum(dim=1).expand(len(self.value), -1, -1, -1)
        total = mask.sum(dim=1)
        opened = total > 0
        noise = (self.variance.sum(dim=1).sqrt() / total.clamp(min=1e-6)).clamp(max=1)
        known = opened & ~self.saturated.any(dim=1)
        noise = torch.where(known, noise, 1.0)
        flat = torch.stack([self.mean(), noise], dim=1).unsqueeze(2)
        return torch.cat([mask.unsqueeze(1), flat.expand(-1, -1, mask.shape[1], -1, -1)], dim=1)
