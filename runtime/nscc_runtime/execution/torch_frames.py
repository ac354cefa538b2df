"""Frames by weighted sums on a torch device, many at once.

The results equal those of `nscc_runtime.execution.frame_loop` to about 1e-3 electrons, with the
same keyed random numbers. Sums over slots, and pixels that run through their words, stay on the
processor."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import torch
from numpy.typing import NDArray

from nscc_runtime.execution.overlap import NEIGHBOURS
from nscc_runtime.execution.summed import SummedScene
from nscc_runtime.noise import RATE_CAP, key
from nscc_runtime.noise.on_torch import key_tensor, normals, poisson
from nscc_runtime.reference.capture import SUM

_MOST_BYTES = 1 << 29
"""Largest number of bytes of the tensors in use."""
_ROOMS = 24
"""Number of tensors per frame that drawing random numbers needs."""


@dataclass(frozen=True, eq=False)
class OnTorch:
    """A scene by weighted sums on a torch device."""

    summed: SummedScene
    device: torch.device

    @property
    def together(self) -> int:
        """Number of frames to expose at once."""
        groups, buckets = self.summed.chip.own_weights.shape[:2]
        frame_bytes = 8 * len(self._places) * (_ROOMS * max(1, groups) + 4 * buckets)
        return int(max(1, _MOST_BYTES // frame_bytes))

    def expose(self, seed: int, frames: range) -> NDArray[np.float64]:
        """Return exposures (frames, buckets, pixels) in electrons."""
        exposure = self._expected + self._deviations(seed, frames)
        draws, sigmas = self.summed.chip.noise
        for (stream, draw), sigma in zip(draws, sigmas, strict=True):
            keys = [key(seed, stream, SUM, frame, draw) for frame in frames]
            z = normals(key_tensor(keys, self.device), self._places)
            exposure = exposure + self._tensor(sigma)[:, self._lanes] * z[:, None]
        return exposure.cpu().numpy() + 0.0

    def _deviations(self, seed: int, frames: range) -> torch.Tensor:
        """Return the deviations of exposures (frames, buckets, pixels) due to counts."""
        groups = self.summed.chip.counted
        shape = len(frames), len(groups), len(self._places)
        away = torch.zeros(shape, dtype=torch.float64, device=self.device)
        sources = zip(self.summed.chip.sources, self.summed.rates, strict=True)
        for (stream, source), rates in sources:
            keys = [
                key(seed, stream, source, frame, group)
                for frame in frames for group in groups
            ]  # fmt: skip
            stream_keys = key_tensor(keys, self.device).reshape(shape[:2])
            rate = self._tensor(rates)
            away += poisson(stream_keys, self._places, rate, RATE_CAP) - rate
        own_weights, (rows, cols) = self.summed.chip.own_weights, self.summed.chip.array.shape
        deviation = away.reshape(*away.shape[:2], 1, rows, cols)
        own_e = self._tensor(own_weights).reshape(*own_weights.shape[:2], rows, cols) * deviation
        total = own_e.sum(dim=1)
        if groups and self.summed.chip.exchanged > 0:
            beside, fraction = self.summed.chip.beside_weights, self.summed.chip.exchanged
            for direction, pixels in enumerate(NEIGHBOURS):
                pixel_index, neighbour_index = ((..., *index) for index in pixels)
                weight = self._tensor(beside[:, direction]).reshape(
                    *own_weights.shape[:2], rows, cols
                )
                received = weight[pixel_index] * deviation[neighbour_index] - own_e[pixel_index]
                total[pixel_index] += fraction * received.sum(dim=1)
        return total.reshape(*total.shape[:2], -1)

    def _tensor(self, values: NDArray[np.floating]) -> torch.Tensor:
        return torch.from_numpy(np.ascontiguousarray(values)).to(self.device)

    @cached_property
    def _places(self) -> torch.Tensor:
        return torch.from_numpy(self.summed.chip.array.places).to(self.device)

    @cached_property
    def _lanes(self) -> torch.Tensor:
        return torch.from_numpy(self.summed.chip.array.flat_lanes).long().to(self.device)

    @cached_property
    def _expected(self) -> torch.Tensor:
        return self._tensor(self.summed.expected)
