"""Which pixels of a scene may saturate in a way that sums over slots do not know.

What a pixel sees is told with all effects that are wanted: those that may saturate run with these.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects.parts import Exchange
from nscc_runtime.effects.selection import Selection
from nscc_runtime.light import Light
from nscc_runtime.planner.chip import Chip, chip_of
from nscc_runtime.planner.near_loop import TOGETHER, Asked, charges_at, may_saturate
from nscc_runtime.planner.program import Program
from nscc_runtime.planner.sums import Weights

Values = NDArray[np.float64]
Places = NDArray[np.int64]

_SIGMAS = 6.0
"""How far from its mean a pixel is taken to come when it is asked whether it may saturate."""
_SLACK = 1.0 - 1e-5
"""Light that is added up to float32 is compared with a little less than the limit."""
_SPILT = 0.02
"""Of a full well: a pixel that gets so much more of its neighbours than it gives is told apart."""
_FEW = 1 / 64
"""Of the pixels that may saturate under all effects: where no more would not under those of a
plan, these run as well."""


@dataclass(frozen=True, eq=False)
class Charges:
    """Pixels (count,) that see much light: their places, in order; the most charge (kinds, count)
    that PIX of each is taken to see at a read and that registers are taken to hold, and without
    what its neighbours give; what these give more than they take, of a frame's light. No other
    pixel may saturate.
    """

    places: Places
    most: Values
    own: Values
    gained_e: Values

    @property
    def most_e(self) -> Values:
        """The most charge (count,) that each is taken to see at a read."""
        found: Values = self.most[0]
        return found

    @property
    def own_e(self) -> Values:
        """The same without what its neighbours give."""
        found: Values = self.own[0]
        return found

    def at(self, places: Places) -> Charges:
        """Those at some of the places, in order."""
        some = np.searchsorted(self.places, places)
        return Charges(places, self.most[:, some], self.own[:, some], self.gained_e[some])


def charges(program: Program, light: Light, device_seed: int, wanted: Selection) -> Charges:
    """Of a scene under all effects that are wanted; kept for as long as the light is."""
    key = Charges, device_seed, wanted.on
    kept: WeakKeyDictionary[Light, Charges] = program.recent.of(key, WeakKeyDictionary)
    if light not in kept:
        kept[light] = _charges(program, light, device_seed, wanted)
    return kept[light]


def _charges(program: Program, light: Light, device_seed: int, wanted: Selection) -> Charges:
    chip, exchange = chip_of(program, device_seed, wanted, wanted), wanted.part(Exchange)
    weights, dark_s, limit = chip.own(_of_lanes)
    shape, of_frames = light.shape, weights.of_frames(light)
    kinds, count, lane_count = of_frames.weights.shape
    sizes: dict[str, Any] = {
        "rows": shape[0], "cols": shape[1], "count": count, "lane_count": lane_count,
        "kinds": kinds, "frame_s": float(program.slot_s.sum()), "sigmas": _SIGMAS,
        "fraction": 0.0 if exchange is None else exchange.fraction(program.sensor),
    }  # fmt: skip
    arrays: dict[str, Any] = {
        "total": light.sum_e, "scale": chip.scale.reshape(shape),
        "current": chip.current.reshape(shape), "lanes": program.lanes.reshape(shape),
    }  # fmt: skip
    found, places = np.empty(1, np.int64), np.empty(shape[0] * shape[1], np.int64)
    may_saturate(
        asked=Asked(places=0, **sizes), part=of_frames.most_part, limit=limit,
        inflow=np.empty(shape[1]), found=found, places=places, **arrays,
    )  # fmt: skip
    many = int(found[0])
    places, gained = places[:many].copy(), np.empty(many)
    most, own = np.empty((2, kinds, many))
    if many:
        charges_at(
            asked=Asked(places=many, **sizes), places=places, most=most, own=own, gained=gained,
            frames=np.require(light.ended, np.float32, ["C", "A"]), dark_s=dark_s,
            weights=of_frames.weights, light=np.empty(TOGETHER), **arrays,
        )  # fmt: skip
    return Charges(places, most, own, gained)


def _of_lanes(chip: Chip) -> tuple[Weights, Values, Values]:
    """How much of each slot (kinds, N, lanes) PIX sees, and registers hold; for how long these
    gather dark charge, in seconds; and the least of it with which a lane may saturate.
    """
    program = chip.program
    held = () if program.reach.held is None else program.reach.held
    weights = np.stack([program.tables.seen(), *held]).astype(np.float64)
    return Weights(weights), program.slot_s @ weights, reached(_SLACK * chip.near_e.min(axis=0))


def reached(limit: Values) -> Values:
    """The least charge that noise takes to a limit."""
    return ((np.sqrt(_SIGMAS**2 + 4.0 * np.maximum(limit, 0.0)) - _SIGMAS) / 2.0) ** 2


@dataclass(frozen=True, eq=False)
class Near:
    """The pixels of a scene that may saturate under the effects of a chip."""

    chip: Chip
    charges: Charges

    @property
    def places(self) -> Places:
        """Where they are, in order."""
        return self.charges.places[self._running]

    @property
    def spilt(self) -> Places:
        """Those of them that neighbours' light brings there, as suns do to what is beside them."""
        alone = self._reach(self.charges.own, self._limits)
        alone &= self.charges.gained_e <= _SPILT * self.chip.full_e
        return self.charges.places[self._running & ~alone]

    @cached_property
    def _running(self) -> NDArray[np.bool_]:
        return self._reach(self.charges.most, self._limits)

    @cached_property
    def _limits(self) -> Values:
        """The charge (kinds, lanes) from which they run through their words.

        Of few pixels that only effects which are left out could saturate a sample has none, and so
        nothing would tell what sums make of them.
        """
        own, wanted = self.chip.near_e, self.chip.own(_wanted).near_e
        if np.array_equal(own, wanted):
            return own
        some, most = (
            np.count_nonzero(self._reach(self.charges.most, limits)) for limits in (own, wanted)
        )
        return wanted if most - some <= _FEW * most else own

    @cached_property
    def _lanes(self) -> NDArray[np.int32]:
        return self.chip.program.lanes[self.charges.places]

    def _reach(self, charge: Values, limits: Values) -> NDArray[np.bool_]:
        lanes, found = self._lanes, np.zeros(charge.shape[1], np.bool_)
        for each, limit in zip(charge, limits, strict=True):
            if limit.min() < np.inf:
                found |= each >= limit[lanes]
        return found


def _wanted(chip: Chip) -> Chip:
    """The same chip with all effects that are wanted."""
    return chip_of(chip.program, chip.device_seed, chip.wanted, chip.wanted)
