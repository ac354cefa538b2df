"""Frames by weighted sums on a device of torch, many at once.

What `nscc_runtime.planner.frame_loop` does to one frame, with the same keyed numbers: exposures are
the same to about 1e-3 electrons. Sums over the slots, and pixels that run through their words, stay
on the processor.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import torch
from numpy.typing import NDArray

from nscc_runtime.effects.counts import count_key
from nscc_runtime.noise import RATE_CAP, key
from nscc_runtime.noise.on_torch import key_tensor, normals, poisson
from nscc_runtime.planner.summed import Summed
from nscc_runtime.planner.weighing import Weighing
from nscc_runtime.reference.noise import SUM

_MOST_BYTES = 1 << 29
"""Of the tensors of the frames in work together."""
_ROOMS = 24
"""Tensors of a frame's pixels that random numbers take."""

_UP, _DOWN = (..., slice(1, None), slice(None)), (..., slice(None, -1), slice(None))
_LEFT, _RIGHT = (..., slice(1, None)), (..., slice(None, -1))
_NEIGHBOURS = (_UP, _DOWN), (_DOWN, _UP), (_LEFT, _RIGHT), (_RIGHT, _LEFT)
"""The pixels (rows, cols) that have a neighbour above, below, left, right, and those neighbours."""


@dataclass(frozen=True, eq=False)
class OnTorch:
    """A scene under a plan, laid out on a device."""

    summed: Summed
    device: torch.device

    @property
    def together(self) -> int:
        """How many frames are worth exposing at once."""
        groups, buckets = self._weights.shape[:2]
        each = 8 * len(self._places) * (_ROOMS * max(1, groups) + 4 * buckets)
        return max(1, _MOST_BYTES // each)

    def expose(self, seed: int, frames: range) -> tuple[NDArray[np.float64], NDArray[np.uint8]]:
        """Exposures (frames, buckets, pixels), and what cut them off."""
        summed, weighing, sizes = self.summed, self._weighing, self._weighing.sizes
        found = self._expected + self._deviations(seed, frames)
        marked = torch.zeros(found.shape, dtype=torch.uint8, device=self.device)
        if sizes["clipped"]:
            limits = self._tensor(summed.scene.chip.limits)
            marked[found > limits * sizes["full"]] = sizes["well_bit"]
            found = torch.minimum(found, limits)
        if sizes["patterned"]:
            found = found + self._tensor(summed.scene.chip.patterns)
        draws, sigmas = weighing.noise
        for (stream, draw), sigma in zip(draws, sigmas, strict=True):
            keys = [key(seed, stream, SUM, frame, draw) for frame in frames]
            z = normals(key_tensor(keys, self.device), self._places)
            found = found + self._tensor(sigma)[:, self._lanes] * z[:, None]
        return found.cpu().numpy() + 0.0, marked.cpu().numpy()

    def _deviations(self, seed: int, frames: range) -> torch.Tensor:
        """What deviations of counts make of exposures (frames, buckets, pixels)."""
        groups = self.summed.scene.counted
        shape = len(frames), len(groups), len(self._places)
        away = torch.zeros(shape, dtype=torch.float64, device=self.device)
        sources = zip(self._weighing.sources, self.summed.rates, strict=True)
        for (stream, source), rates in sources:
            keys = [
                count_key(seed, stream, source, frame, group)
                for frame in frames for group in groups
            ]  # fmt: skip
            each, rate = key_tensor(keys, self.device).reshape(shape[:2]), self._tensor(rates)
            away += poisson(each, self._places, rate, RATE_CAP) - rate
        if not self._weighing.sizes["exchanges"]:
            return (self._weights[:, :, self._lanes] * away[:, :, None]).sum(dim=1)
        return self._exchanged(away)

    def _exchanged(self, away: torch.Tensor) -> torch.Tensor:
        """The same where pixels that touch exchange their counts."""
        sizes, (own, neighbours) = self._weighing.sizes, self._weighing.overlap
        plane = sizes["rows"], sizes["cols"]
        each = away.reshape(*away.shape[:2], 1, *plane)
        mine = self._tensor(own).reshape(*own.shape[:2], *plane) * each
        total = mine.sum(dim=1)
        for direction, (here, there) in enumerate(_NEIGHBOURS):
            weight = self._tensor(neighbours[:, direction]).reshape(*own.shape[:2], *plane)
            taken = weight[here] * each[there] - mine[here]
            total[here] += sizes["fraction"] * taken.sum(dim=1)
        return total.reshape(*total.shape[:2], -1)

    def _tensor(self, values: NDArray[np.floating]) -> torch.Tensor:
        return torch.from_numpy(np.ascontiguousarray(values)).to(self.device)

    @property
    def _weighing(self) -> Weighing:
        return self.summed.weighing

    @cached_property
    def _places(self) -> torch.Tensor:
        return torch.arange(self._weighing.sizes["pixels"], device=self.device)

    @cached_property
    def _lanes(self) -> torch.Tensor:
        return torch.from_numpy(self.summed.scene.program.lanes).long().to(self.device)

    @cached_property
    def _expected(self) -> torch.Tensor:
        return self._tensor(self.summed.scene.expected)

    @cached_property
    def _weights(self) -> torch.Tensor:
        return self._tensor(self._weighing.weights)
