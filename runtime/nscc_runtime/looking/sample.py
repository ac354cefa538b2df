"""Pixels of a scene on which a plan for a program that looks is tried: some tiles of the array.

Effects are measured, not computed: the tiles are exposed with all of them and with some left out,
under the same draws. A difference in light is then a difference in exposures, but for the few
pixels whose comparisons it tips over: these end in other states, and are counted apart.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import Selection, everything
from nscc_runtime.effects.views import Scene
from nscc_runtime.light import Light
from nscc_runtime.looking.ways import BEFORE_WORDS, Ways
from nscc_runtime.reference.charge import Fallen, charge_of_rows
from nscc_runtime.reference.intervals import Intervals
from nscc_runtime.reference.looks import Executed, LookingReference
from nscc_runtime.remembered import remembered

Bits = NDArray[np.bool_]

_TILES, _SIDE = 8, 12
_WHOLE = 2048
"""Arrays of so few pixels are taken whole."""
_SEEDS = 0, 0


@dataclass(frozen=True)
class Difference:
    """What leaving effects out changes: the mean square of the exposures (buckets,) and their mean,
    in electrons, over the pixels that end in the same states, and the share of those that do not.
    """

    square: NDArray[np.float64]
    mean: NDArray[np.float64]
    other_states: float

    @property
    def error_e(self) -> float:
        """Root mean square of the worst bucket."""
        return float(np.sqrt(self.square.max()))


def difference(
    some: Executed, full: Executed, among: NDArray[np.bool_] | None = None
) -> Difference:
    """Of a frame with some effects from that with all of them; `among` (rows, cols) some pixels."""
    here = some.exposure.valid.all(axis=0) & full.exposure.valid.all(axis=0)
    if among is not None:
        here &= among
    same = np.ones(here.shape, np.bool_)
    for name, plane in full.planes.items():
        same &= some.planes[name] == plane
    error = (some.exposure.exposure_e - full.exposure.exposure_e)[:, here & same]
    count = max(1, error.shape[1])
    other = np.count_nonzero(here & ~same) / max(1, np.count_nonzero(here))
    return Difference((error**2).sum(axis=1) / count, error.sum(axis=1) / count, other)


@dataclass(frozen=True, eq=False)
class Sample:
    """Some of the pixels of a scene: `light` and the registers `loaded` on tiles that lie one above
    the other as an array of their own; `inner` (rows, cols) those whose neighbours are their own.
    `fraction` of the array's pixels.
    """

    ways: Ways
    light: Light
    loaded: Mapping[str, Bits]
    inner: Bits
    fraction: float

    @classmethod
    def of(cls, ways: Ways, light: Light) -> Sample:
        """Tiles spread over the array, the same on every call; small arrays as they are."""
        rows, cols = light.shape
        loaded = ways.container.planes()
        height, width = min(_SIDE + 2, rows), min(_SIDE + 2, cols)
        if rows * cols <= _WHOLE or min(height, width) < 4:
            return cls(ways, light, loaded, np.ones((rows, cols), np.bool_), 1.0)
        # An additive recurrence in two dimensions leaves no large gap.
        steps = np.arange(1, _TILES + 1)[:, None] * (0.7548776662466927, 0.5698402909980532) % 1.0
        corners = [
            (int(y * (rows - height + 1)), int(x * (cols - width + 1))) for y, x in steps.tolist()
        ]

        def tiles(values: NDArray[np.generic]) -> NDArray[np.generic]:
            parts = [values[..., y : y + height, x : x + width] for y, x in corners]
            return np.concatenate(parts, axis=-2)

        frames = tiles(light.frames).astype(np.float32)
        motion = None if light.motion is None else replace(light.motion, frames=frames)
        inner = np.zeros((height, width), np.bool_)
        inner[1:-1, 1:-1] = True
        whole = np.tile(inner, (_TILES, 1))
        return cls(
            ways,
            replace(light, frames=frames, motion=motion),
            {name: tiles(plane).astype(np.bool_) for name, plane in loaded.items()},
            whole,
            np.count_nonzero(whole) / (rows * cols),
        )

    @remembered
    def without(self, dropped: frozenset[str]) -> Difference:
        """What leaving these effects out changes."""
        full = self._executed(everything())
        return difference(self._executed(everything().without(*dropped)), full, self.inner)

    def _executed(self, effects: Selection) -> Executed:
        """The sample with these effects; those of all effects are kept."""
        if effects == everything():
            return self._full
        return self._exposed(effects)

    @cached_property
    def _full(self) -> Executed:
        return self._exposed(everything())

    def _exposed(self, effects: Selection) -> Executed:
        rows = range(self.light.shape[0])
        if self.ways.lacks(effects):
            reference = LookingReference(self.ways.container, self.ways.sensor, effects)
            return reference.expose(self._scene, self.loaded, _SEEDS, 0)
        before = frozenset(e.name for e in effects.effects if e.reference.keys() & BEFORE_WORDS)
        fallen = self._fallen(before, effects.noiseless)
        return self.ways.run(
            self._scene, self.loaded, effects, _SEEDS, 0, rows,
            lambda part: Fallen(*(each[..., part.start : part.stop, :] for each in fallen)),
        )  # fmt: skip

    @cached_property
    def _scene(self) -> Scene:
        slot_s = np.array(self.ways.container.slot_us, np.float64) * 1e-6
        return Scene(self.light, self.light, slot_s)

    @remembered
    def _fallen(self, before: frozenset[str], every_slot: bool) -> Fallen:
        """The charge under the effects that make it, which are fewer than all."""
        effects = everything()
        effects = effects.without(*(e.name for e in effects.effects if e.name not in before))
        joined = Intervals.of(self.ways.container, every_slot).joined(self._scene)
        rows = range(self.light.shape[0])
        return charge_of_rows(joined, None, self.ways.sensor, effects, _SEEDS, 0, rows)
