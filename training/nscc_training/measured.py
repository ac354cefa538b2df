"""The data term of reconstruction, for any sensor and any code."""

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
    """Frames of one exposure, B of them (buckets), and their measurement model.

    `value` (batch, B, rows, cols) is the sum over N of `mask` (batch or 1, B, N, rows, cols) times
    the light, plus noise of `variance` (shape of `value`). The unit of light is such that white is
    about 1. Where `saturated`, the value is a lower bound. `mask` may be weighted, for example by
    slot lengths.
    """

    value: Tensor
    mask: Tensor
    variance: Tensor
    saturated: Tensor

    @classmethod
    def exact(cls, value: Tensor, mask: Tensor) -> Measured:
        """Return one frame (batch, rows, cols) without noise; the mask is (batch or 1, N, rows,
        cols)."""
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
        `masks` are (B, N, rows, cols)."""
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
        """Return the measurement in other units (batch,) of light."""
        unit = unit.reshape(-1, 1, 1, 1)
        return replace(self, value=self.value / unit, variance=self.variance / unit.square())

    def of(self, clip: Tensor) -> Tensor:
        """Return the frames of a clip (batch, N, rows, cols)."""
        return (self.mask * clip.unsqueeze(1)).sum(dim=2)

    def missing(self, predicted: Tensor, target: Tensor) -> Tensor:
        """Return the difference of a target and a clip's frames; where saturated, an excess counts
        as 0."""
        gap = target - predicted
        return torch.where(self.saturated, gap.clamp(min=0), gap)

    def trust(self, sigma: Tensor) -> Tensor:
        """Return the fraction of a difference due to the clip's error rather than noise, in the
        shape of `value`. The error has the standard deviation `sigma` (batch,)."""
        spread = self.energy * sigma.reshape(-1, 1, 1, 1).square()
        error_share: Tensor = spread / (spread + self.variance).clamp(min=1e-20)
        return error_share

    def correction(self, gap: Tensor, sigma: Tensor) -> Tensor:
        """Return the most likely correction of a clip whose frames differ by `gap`. The prior error
        has the standard deviation `sigma` everywhere. Without noise, and with frames that share no
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
        """Whether no light of a pixel is in two frames, as in the frames of a film."""
        shared = (self.mask != 0).sum(dim=1) > 1
        return self.mask.shape[1] == 1 or not bool(shared.any())

    def _joint(self, sigma: Tensor) -> Tensor:
        """Return the covariance (batch, rows, cols, B, B) of the frames of a pixel, over sigma
        squared."""
        masks = self.mask.permute(0, 3, 4, 1, 2)
        noise = self.variance.permute(0, 2, 3, 1) / sigma.reshape(-1, 1, 1, 1).square()
        # A frame in which a pixel never opens must not divide by 0.
        return masks @ masks.mT + torch.diag_embed(noise + 1e-4)

    @property
    def energy(self) -> Tensor:
        """Sum of squares of the mask, (batch or 1, B, rows, cols)."""
        return self.mask.square().sum(dim=2)

    def mean(self) -> Tensor:
        """Return the mean light (batch, rows, cols) of each pixel's open slots, 0 without open
        slots."""
        total = self.mask.sum(dim=(1, 2))
        return torch.where(total > 0, self.value.sum(dim=1) / total.clamp(min=1e-6), 0.0)

    def planes(self) -> Tensor:
        """Return the inputs of a denoiser, (batch, 3, N, rows, cols). They are the mask of all
        frames, the value over the mask, and its standard deviation, at most 1; only the mask
        differs between slots."""
        mask = self.mask.sum(dim=1).expand(len(self.value), -1, -1, -1)
        total = mask.sum(dim=1)
        opened = total > 0
        noise = (self.variance.sum(dim=1).sqrt() / total.clamp(min=1e-6)).clamp(max=1)
        known = opened & ~self.saturated.any(dim=1)
        noise = torch.where(known, noise, 1.0)
        flat = torch.stack([self.mean(), noise], dim=1).unsqueeze(2)
        return torch.cat([mask.unsqueeze(1), flat.expand(-1, -1, mask.shape[1], -1, -1)], dim=1)
