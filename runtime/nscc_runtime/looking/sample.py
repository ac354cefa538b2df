"""Pixels of a scene on which a plan for a program that looks is tried: some tiles of the array.

Effects are measured, not computed: the tiles are exposed with all of them and with some left out,
under the same draws. A difference in light is then a difference in exposures, but for the few
pixels whose comparisons it tips over: these end in other states, and are counted apart. Where
states are kept, a film's later frames begin in others than its first: all of them are tried.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import Selection, everything
from nscc_runtime.effects.views import Scene
from nscc_runtime.interface import Exposure
from nscc_runtime.light import Light
from nscc_runtime.looking.ways import BEFORE_WORDS, Ways
from nscc_runtime.planner.sample import chances, drawn_by
from nscc_runtime.planner.worst import Worst, worst_measured
from nscc_runtime.reference.charge import Fallen, charge_of_rows
from nscc_runtime.reference.film import Executed, next_planes
from nscc_runtime.reference.intervals import Intervals
from nscc_runtime.reference.looks import LookingReference
from nscc_runtime.remembered import remembered

Bits = NDArray[np.bool_]

_TILES, _SIDE = 256, 2
"""How many tiles, and how many of their pixels in each direction have all their neighbours."""
_WHOLE = 2048
"""Arrays of so few pixels are taken whole."""
_ENOUGH = 1024
"""What is chosen is tried on so many pixels, those of several frames where one has fewer."""
_SLOTS = 16
"""Slots whose light decides where tiles are taken."""
_SEEDS = 0, 0
_FRAMES = 16
"""At most so many frames of a film are tried."""
_SETTLED = 0.005
"""A film has shown what it does once no more than this part of its pixels begins a frame as it has
begun none before."""


@dataclass(frozen=True)
class Difference:
    """What leaving effects out changes: the mean square of the exposures (buckets,) and their mean,
    in electrons, over the pixels that end in the same states, and the share of those that do not;
    `worst`, of the former the worst pixels. `unsure` (buckets,): the standard error of `square`, as
    another frame, or other tiles, would have another.
    """

    square: NDArray[np.float64]
    unsure: NDArray[np.float64]
    mean: NDArray[np.float64]
    other_states: float
    worst: Worst

    @property
    def error_e(self) -> float:
        """Root mean square of the worst bucket."""
        return float(np.sqrt(self.square.max()))

    @property
    def likely_e(self) -> float:
        """The same with the standard error of its square: where a few pixels have most of it,
        another frame has more."""
        return float(np.sqrt((self.square + self.unsure).max()))


def difference(
    some: Executed, full: Executed, weight: NDArray[np.float64], pixels: int
) -> Difference:
    """Of frames with some effects from those with all of them; `weight` (rows, cols): how many
    of the `pixels` of a scene each stands for."""
    valid = some.exposure.valid.all(axis=0) & full.exposure.valid.all(axis=0)
    weight = np.where(valid, weight, 0.0)
    alike = np.where(same_states(some, full), weight, 0.0)
    error = np.where(alike > 0, some.exposure.exposure_e - full.exposure.exposure_e, 0.0)
    much = alike / max(float(alike.sum()), 1e-300)
    square = (error**2 * much).sum(axis=(1, 2))
    away = (error**2 - square[:, None, None]) * much
    return Difference(
        square,
        np.sqrt((away**2).sum(axis=(1, 2))),
        (error * much).sum(axis=(1, 2)),
        float(1.0 - alike.sum() / weight.sum()) if weight.any() else 0.0,
        worst_measured(error[:, alike > 0], much[alike > 0], pixels),
    )


def of_all(found: Sequence[Difference]) -> Difference:
    """Of several frames what is worst in any of them; the mean is that of the worst bucket's."""
    squares = np.array([each.square for each in found])
    means = np.array([each.mean for each in found])
    return Difference(
        squares.max(axis=0),
        np.max([each.unsure for each in found], axis=0),
        np.take_along_axis(means, squares.argmax(axis=0)[None], axis=0)[0],
        max(each.other_states for each in found),
        Worst(max(each.worst.p999_e for each in found), max(each.worst.max_e for each in found)),
    )


def one_above_the_other(frames: Sequence[Executed]) -> Executed:
    """Frames of the same pixels as if they were one of as many more rows."""
    if len(frames) == 1:
        return frames[0]
    exposures = [each.exposure for each in frames]
    exposure = Exposure(
        np.concatenate([each.exposure_e for each in exposures], axis=1),
        np.concatenate([each.valid for each in exposures], axis=1),
    )
    names = frames[0].planes
    return Executed(
        exposure, {name: np.concatenate([each.planes[name] for each in frames]) for name in names}
    )


def same_states(some: Executed, full: Executed) -> Bits:
    """Where (rows, cols) two frames end in the same states."""
    same = np.ones(full.exposure.valid.shape[1:], np.bool_)
    for name, plane in full.planes.items():
        same &= some.planes[name] == plane
    return same


@dataclass(frozen=True, eq=False)
class Sample:
    """Some of the pixels of a scene: `light` and the registers `loaded` on tiles that lie one above
    the other as an array of their own. `weight` (rows, cols): how many pixels of the scene each
    stands for, 0 at the tiles' edges, whose neighbours are not their own. `pixels` the scene has.
    """

    ways: Ways
    light: Light
    loaded: Mapping[str, Bits]
    weight: NDArray[np.float64]
    pixels: int

    @property
    def fraction(self) -> float:
        """Of the scene's pixels."""
        return np.count_nonzero(self.weight) / self.pixels

    @classmethod
    def of(cls, ways: Ways, light: Light) -> Sample:
        """Tiles spread over the scene, more of them where light or its steps are large; the same
        on every call. Small scenes are taken as they are."""
        (rows, cols), side = light.shape, _SIDE + 2
        loaded = ways.container.planes()
        if rows * cols <= _WHOLE or min(rows, cols) < side:
            return cls(ways, light, loaded, np.ones((rows, cols)), rows * cols)
        corners, counts = _corners(light)

        def tiles(values: NDArray[Any]) -> NDArray[Any]:
            parts = [values[..., y : y + side, x : x + side] for y, x in corners]
            return np.concatenate(parts, axis=-2)

        frames = tiles(light.frames)
        motion = None if light.motion is None else replace(light.motion, frames=frames)
        inner = np.zeros((side, side))
        inner[1:-1, 1:-1] = 1.0
        return cls(
            ways,
            replace(light, frames=frames, motion=motion),
            {name: tiles(plane) for name, plane in loaded.items()},
            np.concatenate([count * inner for count in counts]),
            rows * cols,
        )

    def without(self, dropped: frozenset[str]) -> Difference:
        """What leaving these effects out changes, in the worst of a film's frames."""
        return self._of_times(dropped, 1)

    def tried(self, dropped: frozenset[str]) -> Difference:
        """The same of as many pixels as a plan is tried on."""
        return self._of_times(dropped, self.times)

    @remembered
    def _of_times(self, dropped: frozenset[str], times: int) -> Difference:
        """The same of frames that are exposed so many times, with noise of their own."""
        some, weight = everything().without(*dropped), np.tile(self.weight, (times, 1))
        found = []
        for number, (loaded, full) in enumerate(self._film):
            again = range(number + _FRAMES, number + _FRAMES * times, _FRAMES)
            mine = [self._exposed(some, frame, loaded) for frame in (number, *again)]
            fulls = [full, *(self._exposed(everything(), frame, loaded) for frame in again)]
            each = one_above_the_other(mine), one_above_the_other(fulls)
            found.append(difference(*each, weight, self.pixels))
        return of_all(found)

    @cached_property
    def times(self) -> int:
        """How many times what is chosen is tried: one frame of few pixels shows little of what
        happens to few of them."""
        return math.ceil(_ENOUGH / np.count_nonzero(self.weight))

    @property
    def frames(self) -> int:
        """How many frames are tried."""
        return len(self._film)

    @cached_property
    def noise_e(self) -> float:
        """The root mean square over pixels and buckets of the standard deviation of exposures with
        every effect: of those that end in the same states."""
        other = self._exposed(everything(), 1, self.loaded)
        found = difference(other, self._film[0][1], self.weight, self.pixels)
        return float(np.sqrt(found.square.mean() / 2))

    @cached_property
    def _film(self) -> list[tuple[Mapping[str, Bits], Executed]]:
        """The registers with which each frame starts, and the frame with all effects: as many as
        it takes until pixels begin them as they have begun others."""
        container, weight = self.ways.container, self.weight / self.weight.sum()
        loaded, found = self.loaded, list[tuple[Mapping[str, Bits], Executed]]()
        while len(found) < _FRAMES:
            seen = np.zeros(self.weight.shape, np.bool_)
            for before, _ in found:
                seen |= np.all([loaded[name] == before[name] for name in loaded], axis=0)
            if found and float(weight[~seen].sum()) <= _SETTLED:
                break
            found.append((loaded, self._exposed(everything(), len(found), loaded)))
            loaded = {**self.loaded, **next_planes(container, loaded, found[-1][1].planes)}
        return found

    def _exposed(self, effects: Selection, frame: int, loaded: Mapping[str, Bits]) -> Executed:
        rows = range(self.light.shape[0])
        if self.ways.lacks(effects):
            reference = LookingReference(self.ways.container, self.ways.sensor, effects)
            return reference.expose(self._scene, loaded, _SEEDS, frame)
        before = frozenset(e.name for e in effects.effects if e.reference.keys() & BEFORE_WORDS)
        fallen = self._fallen(before, effects.noiseless, frame)
        return self.ways.run(
            self._scene, loaded, effects, _SEEDS, frame, rows,
            lambda part: fallen.rows(slice(part.start, part.stop)), among=self.weight > 0,
        )  # fmt: skip

    @cached_property
    def _scene(self) -> Scene:
        slot_s = np.array(self.ways.container.slot_us, np.float64) * 1e-6
        return Scene(self.light, self.light, slot_s)

    @remembered
    def _fallen(self, before: frozenset[str], every_slot: bool, frame: int) -> Fallen:
        """The charge under the effects that make it, which are fewer than all."""
        effects = everything()
        effects = effects.without(*(e.name for e in effects.effects if e.name not in before))
        joined = Intervals.of(self.ways.container, every_slot).joined(self._scene)
        rows = range(self.light.shape[0])
        return charge_of_rows(joined, None, self.ways.sensor, effects, _SEEDS, frame, rows)


def _corners(light: Light) -> tuple[list[tuple[int, int]], list[float]]:
    """The upper left corners of the tiles, and how many pixels each of a tile's stands for."""
    rows, cols = light.shape
    some = np.unique(np.linspace(0, light.slots - 1, min(_SLOTS, light.slots)).astype(int))
    score = chances(np.sum([light.slot(n) for n in some.tolist()], axis=0, dtype=np.float64))
    down, right = -(-rows // _SIDE), -(-cols // _SIDE)
    padded = np.pad(score, ((0, down * _SIDE - rows), (0, right * _SIDE - cols)))
    chance = padded.reshape(down, _SIDE, right, _SIDE).sum(axis=(1, 3)).reshape(-1)
    places, times = np.unique(drawn_by(chance, min(_TILES, len(chance))), return_counts=True)
    counts = times / chance[places]
    counts *= rows * cols / (_SIDE**2 * counts.sum())
    y = np.clip(places // right * _SIDE - 1, 0, rows - _SIDE - 2)
    x = np.clip(places % right * _SIDE - 1, 0, cols - _SIDE - 2)
    return [*zip(y.tolist(), x.tolist(), strict=True)], counts.tolist()
