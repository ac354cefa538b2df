"""The measurement model of reconstruction, for any sensor and any code."""

from __future__ import annotations

import sys
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from torch import Tensor

    from nscc_training.sensor_model import SensorModel

Array = TypeVar("Array", "Tensor", NDArray[Any])
"""A torch tensor or a numpy array; this module only uses operations that both support."""


def namespace(array: object) -> Any:
    """Return the module whose functions take the array: numpy or torch."""
    return sys.modules[type(array).__module__.partition(".")[0]]


@dataclass(frozen=True, eq=False)
class Measured(Generic[Array]):
    """Frames of one exposure, B of them (buckets), and their measurement model.

    `value` (batch, B, rows, cols) is the sum over N of `mask` (batch or 1, B, N, rows, cols) times
    the light, plus noise of `variance` (shape of `value`). The unit of light is such that white is
    about 1. Where `saturated`, the value is a lower bound. `mask` may be weighted, for example by
    slot lengths."""

    value: Array
    mask: Array
    variance: Array
    saturated: Array

    @classmethod
    def exact(cls, value: Array, mask: Array) -> Measured[Array]:
        """Return the measurement of one bucket without noise and saturation, for white of about 1.
        `value` is (batch, rows, cols), `mask` (batch or 1, N, rows, cols)."""
        value, nothing = value[:, None], namespace(value).zeros_like(value[:, None])
        return cls(value, mask[:, None], nothing, nothing != 0)

    @classmethod
    def read(
        cls, frames: NDArray[np.float32], masks: NDArray[Any], sensor: SensorModel
    ) -> Measured[NDArray[Any]]:
        """Return the measurement of a frame in electrons, as a batch of one.

        `frames` (B, rows, cols) are converter codes above the offset, `masks` (B, N, rows, cols)
        the open fractions of the N slots. `sensor` gives the noise, and the converter code that
        counts as saturated."""
        codes = np.asarray(frames, np.float32)[None]
        value = codes * np.float32(sensor.electrons_per_lsb)
        # Rounding to whole codes adds the variance 1 / 12.
        noise_lsb2 = sensor.adc_noise_lsb**2 + 1 / 12
        variance = np.full_like(value, noise_lsb2 * sensor.electrons_per_lsb**2)
        if sensor.shot_noise:
            variance = variance + value.clip(min=0)
        full = codes >= sensor.full_code
        return Measured(value, np.asarray(masks, np.float32)[None], variance, full)

    def tensors(self: Measured[NDArray[Any]]) -> Measured[Tensor]:
        """Return the measurement with torch tensors, which share the memory of the arrays."""
        import torch

        arrays = (self.value, self.mask, self.variance, self.saturated)
        return Measured(*(torch.from_numpy(np.ascontiguousarray(array)) for array in arrays))

    def over(self, unit: Array) -> Measured[Array]:
        """Return the measurement with light divided by `unit` (batch,), and the variance by its
        square."""
        unit = unit.reshape(-1, 1, 1, 1)
        return replace(self, value=self.value / unit, variance=self.variance / unit**2)

    def crop(self, rows: slice, cols: slice) -> Measured[Array]:
        """Return the measurement of the rectangle of pixels in these rows and columns, all frames
        and slots."""
        arrays = (self.value, self.mask, self.variance, self.saturated)
        return Measured(*(array[..., rows, cols] for array in arrays))

    def of(self, clip: Array) -> Array:
        """Return the noiseless frames (batch, B, rows, cols) of a clip (batch, N, rows, cols)."""
        frames: Array = (self.mask * clip[:, None]).sum(2)
        return frames

    def missing(self, predicted: Array, target: Array) -> Array:
        """Return `target` minus `predicted` frames, both (batch, B, rows, cols): what a clip lacks.
        Where a pixel is saturated, a negative value becomes 0: its light may be larger than
        measured."""
        gap = target - predicted
        least: Array = namespace(gap).where(self.saturated, gap.clip(min=0), gap)
        return least

    def trust(self, sigma: Array) -> Array:
        """Return the fraction of a frame's difference that is due to the clip's error, not to the
        frame's noise: (batch, B, rows, cols), 0 to 1, and 0 for a pixel that never opens.

        `sigma` (batch,) is the standard deviation of the clip's error."""
        spread = self.energy * sigma.reshape(-1, 1, 1, 1) ** 2
        error_share: Array = spread / (spread + self.variance).clip(min=1e-20)
        return error_share

    def correction(self, gap: Array, sigma: Array) -> Array:
        """Return the most likely correction (batch, N, rows, cols) of a clip that lacks `gap`
        (batch, B, rows, cols) in its frames.

        `sigma` (batch,) is the standard deviation of the clip's error, the same in all pixels and
        slots; it is above 0. Without noise, and with frames that share no light, this is the
        projection onto all clips that match the frames."""
        if self.disjoint:
            noise = self.variance / sigma.reshape(-1, 1, 1, 1) ** 2
            # The limit is for pixels that never open, whose energy is 0.
            shares = gap / (self.energy + noise).clip(min=1e-6)
        else:
            # The covariance (batch, rows, cols, B, B) of each pixel's frames, over sigma squared.
            library = namespace(gap)
            noise = library.moveaxis(self.variance / sigma.reshape(-1, 1, 1, 1) ** 2, 1, -1)
            # Avoid a division by 0 for pixels that never open in a frame.
            identity = library.diagflat(library.ones_like(self.variance[0, :, 0, 0]))
            joint = self.overlap + (noise + 1e-4)[..., None] * identity
            last = library.moveaxis(gap, 1, -1)[..., None]
            shares = library.moveaxis(library.linalg.solve(joint, last)[..., 0], -1, 1)
        update: Array = (self.mask * shares[:, :, None]).sum(1)
        return update

    @cached_property
    def disjoint(self) -> bool:
        """Return whether each pixel is open in at most one of the frames in every slot, as in the
        frames of a film. The frames of a pixel are then independent."""
        shared = (self.mask != 0).sum(1) > 1
        return self.mask.shape[1] == 1 or not bool(shared.any())

    @cached_property
    def overlap(self) -> Array:
        """How much two frames of an exposure have in common: the sum over the N slots of the
        product of their masks, (batch or 1, rows, cols, B, B)."""
        masks = namespace(self.mask).moveaxis(self.mask, (1, 2), (3, 4))
        overlap: Array = masks @ masks.mT
        return overlap

    @property
    def energy(self) -> Array:
        """The sum of squares of the mask, (batch or 1, B, rows, cols)."""
        squares: Array = (self.mask**2).sum(2)
        return squares

    def mean(self) -> Array:
        """Return the mean light (batch, rows, cols) of each pixel over the slots in which it was
        open, in all frames; 0 if it never was."""
        total = self.mask.sum((1, 2))
        light = self.value.sum(1) / total.clip(min=1e-6)
        known: Array = namespace(light).where(total > 0, light, namespace(light).zeros_like(light))
        return known

    def planes(self: Measured[Tensor]) -> Tensor:
        """Return the inputs of a denoiser, (batch, 3, N, rows, cols): the mask summed over the
        frames, the mean light, and its standard deviation up to 1.

        The last two are the same in all N slots. The deviation of a pixel that is saturated or
        never opens is 1."""
        import torch

        mask = self.mask.sum(dim=1).expand(len(self.value), -1, -1, -1)
        total = mask.sum(dim=1)
        opened = total > 0
        noise = (self.variance.sum(dim=1).sqrt() / total.clamp(min=1e-6)).clamp(max=1)
        known = opened & ~self.saturated.any(dim=1)
        noise = torch.where(known, noise, 1.0)
        flat = torch.stack([self.mean(), noise], dim=1).unsqueeze(2)
        return torch.cat([mask.unsqueeze(1), flat.expand(-1, -1, mask.shape[1], -1, -1)], dim=1)
