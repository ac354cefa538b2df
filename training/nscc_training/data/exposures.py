"""Random exposures of scenes, determined by seed and step, and cut on the run's device."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np
import torch
from torch import Tensor
from torch.utils.data import Dataset

from nscc.arrays import Floats32
from nscc_training.data.sources import Scenes, SourceScene
from nscc_training.protocols import load_protocol
from nscc_training.random_streams import DrawStream
from nscc_training.settings import DataSettings

_TRIES = 20
"""Most random draws of a region, if the regions are too dark to saturate."""
EXPOSED = 256
"""Rows and columns of a region that is exposed together; a patch is a part of a region."""
_POLES = 8
"""1/8 of a panorama's rows is removed at the top and at the bottom, where it is distorted."""
_WHITE = 0.999
"""The quantile of a still's light that metrics and losses count as 1."""


@dataclass(frozen=True)
class Batch:
    """Patches of light, and the truth to reconstruct.

    Attributes
    ----------
    light : Tensor
        Stills (batch, rows, cols) in electrons over the frame; clips (batch, N, rows, cols) in
        electrons per slot.
    truth : Tensor
        `light` over a full well, or over a full well / N, as decoders return it.
    peak : Tensor
        (batch,): the truth that metrics and losses count as 1.
    names : tuple of str
        The scenes and places of the patches.
    classes : Tensor, optional
        (batch, classes): 1 for the class of a patch, else 0.
    """

    light: Tensor
    truth: Tensor
    peak: Tensor
    names: tuple[str, ...]
    classes: Tensor | None = None

    def patches(self, first: int, last: int) -> Batch:
        """Return the part of the batch from patch number `first` (0 is the first) up to, but
        without, `last`."""
        cut = slice(first, last)
        return replace(
            self,
            light=self.light[cut],
            truth=self.truth[cut],
            peak=self.peak[cut],
            names=self.names[cut],
            classes=None if self.classes is None else self.classes[cut],
        )

    @cached_property
    def goal(self) -> Tensor:
        """Return the ground truth divided by the peak and clipped to 1, which losses compare with
        predictions. Shape of `truth`."""
        return self._relative.clamp(max=1)

    @cached_property
    def most(self) -> Tensor:
        """Return the limit to which losses clip predictions over the peak: 1 where the truth
        reaches the peak, else infinity, in the shape of `truth`.

        A decoder is so not punished for light beyond white, but is for a false bright pixel."""
        return torch.where(self._relative >= 1, 1.0, torch.inf)

    @cached_property
    def _relative(self) -> Tensor:
        """The truth in units of the peak, the light that counts as 1."""
        return self.truth / self.peak.reshape(-1, *([1] * (self.truth.ndim - 1)))


class Exposures(NamedTuple):
    """E random exposures of square regions for a batch, before patches are cut.

    `light` is (E, rows, cols) for stills and (E, N, rows, cols) for clips. Each exposure is rotated
    by `turns` right angles, `mirrored`, and reversed in time if `backwards`. Light is raised to the
    power `contrast`. The fraction `share` of a still's pixels saturates at `brightness` 1, which is
    a factor on the light. Patch k is cut from exposure `source[k]` at `corner[k]` (row, column) and
    called `names[k]`. `classes` (batch, classes) are 1 for the class of a patch, None without
    classes."""

    light: Tensor
    share: Tensor
    contrast: Tensor
    turns: Tensor
    mirrored: Tensor
    backwards: Tensor
    source: Tensor
    corner: Tensor
    brightness: Tensor
    names: tuple[str, ...]
    classes: Tensor | None = None


class ExposureSet(Dataset[Exposures]):
    """The random exposures of a training run: item `step` is those of that training step."""

    def __init__(
        self,
        scenes: Scenes,
        settings: DataSettings,
        *,
        slots: int,
        batch: int,
        seed: int,
        classes: Sequence[str] = (),
    ) -> None:
        """Prepare to draw `batch` patches a step from the training scenes of `scenes`, with the
        size and augmentation of `settings`. A region is as large as a patch or `EXPOSED`, or the
        smallest scene.

        `slots` is the number of frames of a clip. `seed` and the step determine all draws.
        `classes` are the names of the scenes' classes, if the decoder classifies; empty otherwise.
        """
        self.lights = [_without_poles(scene, settings) for scene in scenes.train]
        self.names = [scene.name for scene in scenes.train]
        self.settings, self.slots, self.batch, self.seed = settings, slots, batch, seed
        wanted_side = max(settings.patch, EXPOSED)
        self.side = min(wanted_side, *(side for light in self.lights for side in light.shape[-2:]))
        grey = load_protocol(settings.protocol).mid_grey_e is not None
        # The exposure of a clip follows its median or its brightest percent (`cut_batch`), so that
        # this fraction of its pixels must have light.
        self._lit = 0.5 if grey else 0.01
        self._classes = torch.tensor(
            [[float(scene.label == name) for name in classes] for scene in scenes.train]
        )

    def __getitem__(self, step: int) -> Exposures:
        """Return the light of one training step and how it is cut, turned and exposed.

        Groups of `settings.together` patches come from the same region of a scene, with the same
        exposure. The same step always gives the same draws."""
        lights: list[Tensor] = []
        draws: list[tuple[float, float, int, bool, bool, float]] = []
        source: list[int] = []
        pixel_index, names, drawn_scenes = [], [], []
        # `together` patches share one exposure: the same scene, brightness and turn.
        for start in range(0, self.batch, self.settings.together):
            # The generator depends on the step alone, so that a resumed run draws the same
            # patches.
            generator = np.random.default_rng([self.seed, DrawStream.PATCHES, step, start])
            scene = int(generator.integers(len(self.lights)))
            drawn_scenes.append(scene)
            light, lit, place_text = self._surroundings(scene, generator)
            turned, flipped, reversed_, power = 0, False, False, 1.0
            if self.settings.augment:
                turned, flipped = int(generator.integers(4)), bool(generator.random() < 0.5)
                if light.ndim == 3:
                    reversed_ = bool(generator.random() < 0.5)
                else:
                    power = float(generator.uniform(0.8, 1.25))
            count = min(self.settings.together, self.batch - start)
            rooms = self.side - self.settings.patch + 1
            drawn = generator.integers(rooms, size=(count, 2))
            source += [len(lights)] * count
            names += [
                f"{self.names[scene]} {place_text}+{row},{col}" for row, col in drawn.tolist()
            ]
            pixel_index.append(drawn)
            lights.append(torch.from_numpy(np.ascontiguousarray(light)))
            factor = 1.0
            if self.settings.brightness != (1.0, 1.0):
                factor = float(np.exp(generator.uniform(*np.log(self.settings.brightness))))
            draws.append((lit, power, turned, flipped, reversed_, factor))
        share, contrast, turns, mirrored, backwards, brightness = (
            torch.tensor(values) for values in zip(*draws, strict=True)
        )
        return Exposures(
            torch.stack(lights),
            share,
            contrast,
            turns,
            mirrored,
            backwards,
            source=torch.tensor(source),
            corner=torch.from_numpy(np.concatenate(pixel_index)),
            brightness=brightness,
            names=tuple(names),
            classes=self._classes[drawn_scenes] if self._classes.numel() else None,
        )

    def _surroundings(
        self, scene: int, generator: np.random.Generator
    ) -> tuple[Floats32, float, str]:
        """Return a random region of the light of scene number `scene`, of `self.side` rows and
        columns; the fraction of its pixels that will saturate; and its coordinates as text.

        The region of a clip has `self.slots` frames. A region with too few lit pixels to saturate
        is drawn again, up to `_TRIES` times; then the last one is returned."""
        light, region, share, crop_text = self.lights[scene], None, self._lit, ""
        low, high = sorted(self.settings.saturated)
        for _ in range(_TRIES):
            row, col = (int(generator.integers(side - self.side + 1)) for side in light.shape[-2:])
            crop_text = f"at {row},{col}"
            region = light[..., row : row + self.side, col : col + self.side]
            if light.ndim == 2:
                share = float(generator.uniform(low, high))
            else:
                first = int(generator.integers(len(light) - self.slots + 1))
                region, crop_text = (
                    region[first : first + self.slots],
                    f"from {first} {crop_text}",
                )
            lit = region > 0 if light.ndim == 2 else region.any(axis=0)
            if np.count_nonzero(lit) > share * lit.size:
                break
        assert region is not None
        return region, share, crop_text


def cut_batch(
    drawn: Exposures, settings: DataSettings, full_well_e: float, device: torch.device
) -> Batch:
    """Return the patches of a batch: the regions in `drawn` are exposed for a chip with the full
    well `full_well_e`, cut and augmented on `device`. `settings` give the side of a patch and the
    protocol.

    Stills are exposed so that the drawn fraction of a region saturates if it is always open. The
    brightest percent of a clip's pixels would fill a well in a frame; under a protocol with a
    mid-grey, its median has that exposure."""
    light, share, contrast, turns, mirrored, backwards, source, corner, brightness = (
        tensor.to(device, non_blocking=True)
        for tensor in drawn[:9]  # the fields of `Exposures` up to `brightness`
    )
    classes = None if drawn.classes is None else drawn.classes.to(device)[source]
    still = light.ndim == 3
    slots = 1 if still else light.shape[1]
    protocol = load_protocol(settings.protocol)
    grey_e = protocol.mid_grey_e
    if still:
        levels, whites = (
            quantiles(light.flatten(1), level_share) for level_share in (1 - share, _WHITE)
        )
        level, white = levels**contrast, whites**contrast
    else:
        total = light.sum(dim=1, dtype=torch.float64).flatten(1)
        level = quantiles(total, 0.99 if grey_e is None else 0.5)
        level = level if grey_e is None else level * (full_well_e / grey_e)
        white = torch.ones_like(level)
    # A region without light is dark at any exposure.
    scale = torch.where(level > 0, full_well_e / level, 0.0) * brightness * protocol.light
    values = _cut(light, settings.patch, turns, mirrored, backwards, source, corner)
    wide = (-1,) + (1,) * (values.ndim - 1)
    if still:
        power = contrast[source].reshape(wide).to(values.dtype)
        values = values.clamp(min=1e-20) ** power
    exposed = values * scale[source].reshape(wide).to(values.dtype)
    peak = (white * scale * (slots / full_well_e)).clamp(min=1e-6)[source]
    return Batch(
        exposed, exposed * (slots / full_well_e), peak.to(values.dtype), drawn.names, classes
    )


def _cut(
    light: Tensor,
    patch: int,
    turns: Tensor,
    mirrored: Tensor,
    backwards: Tensor,
    source: Tensor,
    corner: Tensor,
) -> Tensor:
    """Return the patches (batch, [N,] patch, patch) that begin at `corner` (row, column) in the
    regions `source` of `light`.

    A region is first rotated by `turns` right angles, mirrored, and, if `backwards`, reversed in
    time. All tensors are on the device of `light`. One gather copies the pixels, because loops over
    patches are slow on a GPU."""
    last = light.shape[-1] - 1
    step = torch.arange(patch, device=light.device)
    rows = (corner[:, 0, None] + step)[:, :, None]
    cols = (corner[:, 1, None] + step)[:, None, :]
    cols = torch.where(mirrored[source, None, None], last - cols, cols)
    # The source pixel of np.rot90 by this number of right angles.
    rows, cols = rows.expand(-1, -1, patch), cols.expand(-1, patch, -1)
    sides = torch.stack([rows, cols, last - rows, last - cols])
    turned, patches = turns[source], torch.arange(len(source), device=light.device)
    pixel_index = sides[turned, patches] * (last + 1) + sides[(turned + 1) % 4, patches]
    if light.ndim == 3:
        return light.flatten(1)[source[:, None, None], pixel_index]
    slots = light.shape[1]
    n = torch.arange(slots, device=light.device)
    moments = torch.where(backwards[source, None], slots - 1 - n, n)
    first = (source[:, None] * slots + moments) * (last + 1) ** 2
    return torch.take(light, first[:, :, None, None] + pixel_index[:, None])


def quantiles(values: Tensor, quantile: Tensor | float) -> Tensor:
    """Return the quantile of each row of `values` (batch, count), float64 (batch,).

    `quantile` is a float from 0 to 1, or a tensor with one for each row (batch,). Rows have at
    least one value. Values between two elements are interpolated linearly, as numpy does."""
    last = values.shape[1] - 1
    if isinstance(quantile, float):
        below = int(quantile * last)
        # Only the largest values down to the two around the quantile are sorted.
        most = values.topk(last - below + 1, dim=1).values.double()  # in descending order
        # The largest value alone is left for the quantile 1.
        low, high = most[:, -1], most[:, max(-2, -most.shape[1])]
        return low + (high - low) * (quantile * last - below)
    rank = quantile.double() * last
    lower_index = rank.floor().long()
    pair = values.sort(dim=1).values.gather(
        1, torch.stack([lower_index, (lower_index + 1).clamp(max=last)], 1)
    )
    low, high = pair.double().unbind(1)
    return low + (high - low) * (rank - lower_index)


def _without_poles(scene: SourceScene, settings: DataSettings) -> Floats32:
    """Return the light of a scene, (rows, cols) or (T, rows, cols). A panorama, twice as wide as
    high, loses the distorted eighths at its top and bottom, if enough rows remain for a region."""
    light = scene.light
    side = max(settings.patch, EXPOSED)
    if light.ndim == 2 and light.shape[1] == 2 * light.shape[0] >= 4 * side:
        pole = light.shape[0] // _POLES
        return light[pole:-pole]
    return light
