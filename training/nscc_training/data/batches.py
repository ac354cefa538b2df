"""Patches of scenes as light on the sensor: which ones depends on seed and step alone."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from nscc_training.data.sources import Scene, Scenes
from nscc_training.settings import DataSettings

_TRIES = 20
"""Patches that are dark where they should saturate are drawn again so often."""


@dataclass(frozen=True)
class Batch:
    """Patches of light, and what is to be found.

    `light` (batch, rows, cols), electrons over the frame, of stills; (batch, N, rows, cols),
    electrons a slot, of clips. `truth` is the same over a full well (over a full well / N), as
    decoders give it. `peak` (batch,) is the truth that metrics and losses count as 1. `names` are
    the scenes' and places.
    """

    light: Tensor
    truth: Tensor
    peak: Tensor
    names: tuple[str, ...]

    def part(self, first: int, last: int) -> Batch:
        """Some of its patches."""
        cut = slice(first, last)
        return Batch(self.light[cut], self.truth[cut], self.peak[cut], self.names[cut])

    def to(self, device: torch.device) -> Batch:
        """The same on a device."""
        return Batch(self.light.to(device), self.truth.to(device), self.peak.to(device), self.names)


class Batches:
    """The batches of a run: `train(step)` and `val()`, each the same whenever it is asked for."""

    def __init__(
        self, scenes: Scenes, settings: DataSettings, *, slots: int, full_well_e: float,
        batch: int, seed: int,
    ) -> None:  # fmt: skip
        self.scenes, self.settings = scenes, settings
        self.slots, self.full_well_e = slots, full_well_e
        self.batch, self.seed = batch, seed

    def train(self, step: int) -> Batch:
        """The batch of a step."""
        drawn = []
        for place in range(self.batch):
            generator = np.random.default_rng([self.seed, 4, step, place])
            scene = self.scenes.train[int(generator.integers(len(self.scenes.train)))]
            drawn.append(self._patch(scene, generator, self.settings.augment))
        return _joined(drawn)

    def val(self) -> list[Batch]:
        """The validation's patches, spread over its scenes, without augmentation."""
        found = []
        for index in range(self.settings.val_items):
            generator = np.random.default_rng([self.seed, 5, index])
            scene = self.scenes.val[index % len(self.scenes.val)]
            found.append(_joined([self._patch(scene, generator, False)]))
        return found

    def _patch(self, scene: Scene, generator: np.random.Generator, augment: bool) -> Batch:
        for _ in range(_TRIES):
            values, name = self._cut(scene, generator)
            if augment:
                values = _augmented(values, generator)
            level, white = self._level(values, generator)
            if level > 0:
                break
        # A patch without any light is dark at any exposure.
        scale = self.full_well_e / level if level > 0 else 0.0
        light = torch.from_numpy(np.ascontiguousarray(values * np.float32(scale)))
        slots = 1 if values.ndim == 2 else self.slots
        truth = light * (slots / self.full_well_e)
        peak = max(white * scale * slots / self.full_well_e, 1e-6)
        return Batch(light[None], truth[None], torch.tensor([peak]), (name,))

    def _cut(self, scene: Scene, generator: np.random.Generator) -> tuple[NDArray[np.float32], str]:
        light, patch = scene.light, self.settings.patch
        row = int(generator.integers(light.shape[-2] - patch + 1))
        col = int(generator.integers(light.shape[-1] - patch + 1))
        part = light[..., row : row + patch, col : col + patch]
        if light.ndim == 2:
            return part, f"{scene.name} at {row},{col}"
        first = int(generator.integers(len(light) - self.slots + 1))
        return part[first : first + self.slots], f"{scene.name} from {first} at {row},{col}"

    def _level(
        self, values: NDArray[np.float32], generator: np.random.Generator
    ) -> tuple[float, float]:
        """The light over the frame that fills a well, and the one that counts as 1."""
        if values.ndim == 2:
            low, high = self.settings.saturated
            share = generator.uniform(min(low, high), max(low, high))
            level = float(np.quantile(values, 1 - share))
            return level, float(np.percentile(values, 99.9))
        # Clips: the 99th percentile of what an open pixel gathers; 1 is the source's white.
        return float(np.percentile(values.sum(axis=0, dtype=np.float64), 99)), 1.0


def _augmented(values: NDArray[np.float32], generator: np.random.Generator) -> NDArray[np.float32]:
    """Turned, mirrored; a still's contrast changed, a clip's time turned round."""
    values = np.rot90(values, int(generator.integers(4)), axes=(-2, -1))
    if generator.random() < 0.5:
        values = values[..., ::-1]
    if values.ndim == 3:
        return values[::-1] if generator.random() < 0.5 else values
    contrast = np.float32(generator.uniform(0.8, 1.25))
    return np.asarray(np.maximum(values, np.float32(1e-20)) ** contrast, np.float32)


def _joined(drawn: list[Batch]) -> Batch:
    return Batch(
        torch.cat([b.light for b in drawn]),
        torch.cat([b.truth for b in drawn]),
        torch.cat([b.peak for b in drawn]),
        tuple(name for b in drawn for name in b.names),
    )
