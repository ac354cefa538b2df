"""Patches of scenes as light on the sensor: which ones depends on seed and step alone."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from nscc_training.data.sources import Scene, Scenes
from nscc_training.protocols import load_protocol
from nscc_training.settings import DataSettings

_TRIES = 20
"""Patches of surroundings that are dark where they should saturate are drawn again so often."""
EXPOSED = 256
"""Rows and columns of what is exposed together: a patch may be its dark or its bright part."""
_POLES = 8
"""Such a part of a panorama's rows, at the top and at the bottom, is stretched as no lens does."""

_Patch = tuple[NDArray[np.float32], NDArray[np.float32], float, str]


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

    def prepared(self) -> Batch:
        """Itself, with everything calculated that takes no prediction."""
        _ = self.goal, self.most
        return self

    @cached_property
    def goal(self) -> Tensor:
        """The truth over the peak, at most 1."""
        return self._relative.clamp(max=1)

    @cached_property
    def most(self) -> Tensor | None:
        """What predictions over the peak count as at most: 1 wherever the truth reaches the peak,
        nothing elsewhere. None where it does so nowhere."""
        high = self._relative >= 1
        return torch.where(high, 1.0, torch.inf) if bool(high.any()) else None

    @cached_property
    def _relative(self) -> Tensor:
        return self.truth / self.peak.reshape(-1, *([1] * (self.truth.ndim - 1)))


class Batches:
    """The batches of a run: `train(step)` and `val()`, each the same whenever it is asked for."""

    def __init__(
        self, scenes: Scenes, settings: DataSettings, *, slots: int, full_well_e: float,
        batch: int, seed: int,
    ) -> None:  # fmt: skip
        self.scenes, self.settings = scenes, settings
        self.grey_e = load_protocol(settings.protocol).mid_grey_e
        self.slots, self.full_well_e = slots, full_well_e
        self.batch, self.seed = batch, seed

    def train(self, step: int) -> Batch:
        """The batch of a step."""
        drawn: list[_Patch] = []
        for place in range(0, self.batch, self.settings.together):
            generator = np.random.default_rng([self.seed, 4, step, place])
            scene = self.scenes.train[int(generator.integers(len(self.scenes.train)))]
            count = min(self.settings.together, self.batch - place)
            drawn += self._patches(scene, count, generator, self.settings.augment)
        return _joined(drawn)

    def val(self) -> list[Batch]:
        """The validation's patches, spread over its scenes, without augmentation."""
        found = []
        for index in range(self.settings.val_items):
            generator = np.random.default_rng([self.seed, 5, index])
            scene = self.scenes.val[index % len(self.scenes.val)]
            found.append(_joined(self._patches(scene, self.settings.together, generator, False)))
        return found

    def _patches(
        self, scene: Scene, count: int, generator: np.random.Generator, augment: bool
    ) -> list[_Patch]:
        """Patches of one exposure."""
        for _ in range(_TRIES):
            if scene.light.ndim == 2:
                around = _Exposed.still(scene, self.settings, generator)
            else:
                part = None if self.grey_e is None else self.grey_e / self.full_well_e
                around = _Exposed.clip(scene, self.settings, self.slots, generator, part)
            if around.level > 0:
                break
        if augment:
            around = around.augmented(generator)
        side = self.settings.patch
        corners = [_corner(around.light, side, generator) for _ in range(count)]
        return [self._patch(around, row, col) for row, col in corners]

    def _patch(self, around: _Exposed, row: int, col: int) -> _Patch:
        """The patch of an exposure at that corner: light, truth, peak and name."""
        values = around.part(row, col, self.settings.patch)
        # What has no light is dark at any exposure.
        scale = self.full_well_e / around.level if around.level > 0 else 0.0
        light = np.multiply(values, np.float32(scale), order="C")
        slots = 1 if values.ndim == 2 else self.slots
        truth = light * np.float32(slots / self.full_well_e)
        peak = max(around.white * scale * slots / self.full_well_e, 1e-6)
        return light, truth, peak, f"{around.name}+{row},{col}"


@dataclass(frozen=True, eq=False)
class _Exposed:
    """What is exposed together: `level` is the light over the frame that fills a well, `white` the
    one that counts as 1. `light` is yet to be raised to the power of `contrast`; they are not."""

    light: NDArray[np.float32]
    level: float
    white: float
    name: str
    contrast: float = 1.0

    @classmethod
    def still(
        cls, scene: Scene, settings: DataSettings, generator: np.random.Generator
    ) -> _Exposed:
        """A crop whose given part of pixels saturates."""
        light = scene.light
        side = max(settings.patch, EXPOSED)
        if light.shape[1] == 2 * light.shape[0] >= 4 * side:
            pole = light.shape[0] // _POLES
            light = light[pole:-pole]
        row, col = _corner(light, side, generator)
        light = light[row : row + side, col : col + side]
        low, high = settings.saturated
        share = generator.uniform(min(low, high), max(low, high))
        level, white = (float(v) for v in np.quantile(light, (1 - share, 0.999)))
        return cls(light, level, white, f"{scene.name} at {row},{col}")

    @classmethod
    def clip(
        cls, scene: Scene, settings: DataSettings, slots: int, generator: np.random.Generator,
        grey: float | None = None,
    ) -> _Exposed:  # fmt: skip
        """A window whose 99th percentile over time fills a well, or whose median fills the part
        `grey` of it; 1 is the source's white."""
        side = max(settings.patch, EXPOSED)
        row, col = _corner(scene.light, side, generator)
        first = int(generator.integers(len(scene.light) - slots + 1))
        light = scene.light[first : first + slots, row : row + side, col : col + side]
        total = light.sum(axis=0, dtype=np.float64)
        level = float(np.percentile(total, 99) if grey is None else np.median(total) / grey)
        return cls(light, level, 1.0, f"{scene.name} from {first} at {row},{col}")

    def augmented(self, generator: np.random.Generator) -> _Exposed:
        """Turned, mirrored; a still's contrast changed, a clip's time turned round."""
        light = np.rot90(self.light, int(generator.integers(4)), axes=(-2, -1))
        if generator.random() < 0.5:
            light = light[..., ::-1]
        if light.ndim == 3:
            return replace(self, light=light[::-1] if generator.random() < 0.5 else light)
        contrast = float(generator.uniform(0.8, 1.25))
        return replace(
            self, light=light, level=self.level**contrast, white=self.white**contrast,
            contrast=contrast,
        )  # fmt: skip

    def part(self, row: int, col: int, side: int) -> NDArray[np.float32]:
        """The light of a square part from that corner."""
        light = self.light[..., row : row + side, col : col + side]
        if self.contrast == 1:
            return light
        bent = np.maximum(light, np.float32(1e-20)) ** np.float32(self.contrast)
        return bent.astype(np.float32)


def _corner(
    light: NDArray[np.float32], side: int, generator: np.random.Generator
) -> tuple[int, int]:
    """Where a square part of that side begins; 0 in a direction where there is no room."""
    rows, cols = (max(0, size - side) for size in light.shape[-2:])
    return int(generator.integers(rows + 1)), int(generator.integers(cols + 1))


def _joined(drawn: list[_Patch]) -> Batch:
    light, truth, peaks, names = zip(*drawn, strict=True)
    # Put together by numpy: torch would start threads of its own for every thread that asks.
    together = [torch.from_numpy(np.stack(parts)) for parts in (light, truth)]
    return Batch(together[0], together[1], torch.tensor(peaks), names)
