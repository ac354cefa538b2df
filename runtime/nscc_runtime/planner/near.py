"""Which pixels of a scene may saturate in a way that sums over slots do not know.

What a pixel sees is told with all effects that are wanted: those that may saturate run with these.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects.parts import Exchange
from nscc_runtime.effects.selection import Selection
from nscc_runtime.light import Light
from nscc_runtime.planner.chip import Chip, chip_of
from nscc_runtime.planner.near_loop import Asked, may_saturate
from nscc_runtime.planner.program import Program
from nscc_runtime.planner.sums import sums_by_slot

Values = NDArray[np.float64]
Places = NDArray[np.int64]

_SIGMAS = 6.0
"""How far from its mean a pixel is taken to come when it is asked whether it may saturate."""
_SLACK = 1.0 - 1e-5
"""Light that is added up to float32 is compared with a little less than the limit."""
_SPILT = 0.02
"""Of a full well: a pixel that gets so much more of its neighbours than it gives is told apart."""


@dataclass(frozen=True, eq=False)
class Charges:
    """Pixels (count,) that see much light: their places, in order; the most charge that each is
    taken to see at a read, and without what its neighbours give; what these give more than they
    take, of a frame's light. No other pixel may saturate.
    """

    places: Places
    most_e: Values
    own_e: Values
    gained_e: Values

    def at(self, places: Places) -> Charges:
        """Those at some of the places, in order."""
        some = np.searchsorted(self.places, places)
        return Charges(places, self.most_e[some], self.own_e[some], self.gained_e[some])


def charges(
    program: Program, light: Light, device_seed: int, wanted: Selection, threads: int
) -> Charges:
    """Of a scene under all effects that are wanted; kept for as long as the light is."""
    key = Charges, device_seed, wanted.on
    kept: WeakKeyDictionary[Light, Charges] = program.recent.of(key, WeakKeyDictionary)
    if light not in kept:
        kept[light] = _charges(program, light, device_seed, wanted, threads)
    return kept[light]


def _charges(
    program: Program, light: Light, device_seed: int, wanted: Selection, threads: int
) -> Charges:
    chip, exchange = chip_of(program, device_seed, wanted, wanted), wanted.part(Exchange)
    fraction = 0.0 if exchange is None else exchange.fraction(program.sensor)
    rows, cols = light.shape
    found, inflow = np.empty(light.shape, np.uint8), np.empty(light.shape)
    may_saturate(
        asked=Asked(
            rows=rows, cols=cols, fraction=fraction, frame_s=float(program.slot_s.sum())
        ),
        total=light.sum_e,
        scale=chip.scale.reshape(light.shape),
        current=chip.current.reshape(light.shape),
        lanes=program.lanes.reshape(light.shape),
        limit=reached(_SLACK * chip.near_e),
        found=found,
        inflow=inflow,
    )  # fmt: skip
    places = np.flatnonzero(found.view(np.bool_))
    if not len(places):
        none = np.empty(0)
        return Charges(places, none, none, none)
    scale, lanes = chip.scale[places], program.lanes[places]
    seen = program.tables.seen().astype(np.float64)
    frames = np.take(light.frames.reshape(len(light.frames), -1), places, axis=1)
    seen_e = sums_by_slot(light, frames, lanes, [seen], threads)[0] * scale
    dark = chip.current[places] * (program.slot_s @ seen)[lanes]
    given, row, col = inflow.reshape(-1)[places], places // cols, places % cols
    neighbours = 0 + (row > 0) + (row < rows - 1) + (col > 0) + (col < cols - 1)
    taken = fraction * neighbours
    # Neighbours' light counts in the pixel's own slots, whatever their own codes are.
    most = _reaching(np.maximum(seen_e, (1.0 - taken) * seen_e + given) + dark)
    gained = given - taken * light.sum_e.reshape(-1)[places] * scale
    return Charges(places, most, _reaching(seen_e + dark), gained)


def _reaching(charge: Values) -> Values:
    return np.asarray(charge + _SIGMAS * np.sqrt(charge))


def reached(limit: Values) -> Values:
    """The least charge that `_reaching` takes to a limit."""
    return ((np.sqrt(_SIGMAS**2 + 4.0 * np.maximum(limit, 0.0)) - _SIGMAS) / 2.0) ** 2


@dataclass(frozen=True, eq=False)
class Near:
    """The pixels of a scene that may saturate under the effects of a chip."""

    chip: Chip
    charges: Charges

    @property
    def places(self) -> Places:
        """Where they are, in order."""
        return self.charges.places[self._reach(self.charges.most_e)]

    @property
    def spilt(self) -> Places:
        """Those of them that neighbours' light brings there, as suns do to what is beside them."""
        alone = self._reach(self.charges.own_e)
        alone &= self.charges.gained_e <= _SPILT * self.chip.full_e
        return self.charges.places[self._reach(self.charges.most_e) & ~alone]

    @cached_property
    def _limit(self) -> Values:
        return self.chip.near_e[self.chip.program.lanes[self.charges.places]]

    def _reach(self, charge: Values) -> NDArray[np.bool_]:
        return np.asarray(charge >= self._limit)
