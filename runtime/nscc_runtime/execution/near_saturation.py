"""Which pixels of a scene may saturate in a way that sums over slots do not know.

What a pixel sees is computed with all effects that are wanted: pixels near saturation run through
their words.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects.parts import Exchange, Moving, Saturates
from nscc_runtime.effects.selection import Selection
from nscc_runtime.execution.chip import Chip, chip_of
from nscc_runtime.execution.program import Program
from nscc_runtime.execution.sums import Weights
from nscc_runtime.light import Light

Values = NDArray[np.float64]
Places = NDArray[np.int64]

_SIGMAS = 6.0
"""How far from its mean a pixel is taken to come when it is asked whether it may saturate."""
_SLACK = 1.0 - 1e-5
"""Light that is added up to float32 is compared with a little less than the limit."""


@dataclass(frozen=True, eq=False)
class NearSaturation:
    """Pixels that may saturate.

    Attributes
    ----------
    places : int64, shape (count,)
        Where they are, in order.
    most_e, own_e : float64, shape (count,)
        The most charge that PIX of each may see at a read, noise included; and the same without
        what its neighbours give.
    spilt : bool, shape (count,)
        Which of them only their neighbours' light brings there, as suns do to what is beside them.
    """

    places: Places
    most_e: Values
    own_e: Values
    spilt: NDArray[np.bool_]


NO_PIXELS = NearSaturation(
    np.empty(0, np.int64), np.empty(0), np.empty(0), np.empty(0, np.bool_)
)  # fmt: skip


def near_saturation(
    program: Program, light: Light, device_seed: int, requested_effects: Selection
) -> NearSaturation:
    """The pixels of a scene that may saturate under the effects in `requested_effects`; kept for as
    long as the light is."""
    if not requested_effects.names(Saturates):
        return NO_PIXELS
    source = (requested_effects.find_part(Moving) and light.motion) or light
    key = NearSaturation, device_seed, requested_effects.on
    by_light: WeakKeyDictionary[Light, NearSaturation] = program.recent_chips.of(
        key, WeakKeyDictionary
    )
    if source not in by_light:
        by_light[source] = _Search(
            chip_of(program, device_seed, requested_effects, requested_effects), source
        ).near_pixels
    return by_light[source]


@dataclass(frozen=True, eq=False)
class _Search:
    """One search: first a bound on all pixels, then the charge of those that may be near."""

    chip: Chip
    light: Light

    @property
    def near_pixels(self) -> NearSaturation:
        candidates = self._candidates
        if not len(candidates):
            return NO_PIXELS
        most_e, own_e = self._charges(candidates)
        limits = self.chip.saturation_e[:, self.chip.array.flat_lanes[candidates]]
        is_near = np.any(most_e >= limits, axis=0)
        spilt = ~np.any(own_e >= limits, axis=0)
        return NearSaturation(
            candidates[is_near], most_e[0, is_near], own_e[0, is_near], spilt[is_near]
        )

    @cached_property
    def _of_lanes(self) -> tuple[Weights, Values, Values]:
        return self.chip.compute_once(_of_lanes)

    @cached_property
    def _total_e(self) -> Values:
        """All light of each pixel (rows, cols)."""
        return np.asarray(self.light.sum_e * self.chip.scale.reshape(self.light.shape))

    @cached_property
    def _gained_e(self) -> Values:
        """What neighbours give to each pixel of all their light."""
        gained_e, total_e = np.zeros(self.light.shape), self._total_e
        if self.chip.kept_effects.find_part(Exchange) is not None:
            gained_e[1:] += total_e[:-1]
            gained_e[:-1] += total_e[1:]
            gained_e[:, 1:] += total_e[:, :-1]
            gained_e[:, :-1] += total_e[:, 1:]
            gained_e *= self.chip.exchanged
        return gained_e.reshape(-1)

    @property
    def _candidates(self) -> Places:
        """Where the frame's dark current, all that neighbours give, and the part of the light that
        a lane sees at most come to the limit of the lane."""
        weights, _, limit = self._of_lanes
        lanes, seen_fraction = self.chip.array.flat_lanes, weights.of_frames(self.light).most_part
        most_e = seen_fraction.take(lanes) * self._total_e.reshape(-1)
        most_e += self.chip.current * float(self.chip.program.slot_s.sum())
        most_e += self._gained_e
        return np.flatnonzero(most_e >= limit.take(lanes))

    def _charges(self, places: Places) -> tuple[Values, Values]:
        """The most charge (kinds, places) of each pixel, and without what its neighbours give:
        neighbours' light counts in the pixel's own slots, whatever their own codes are."""
        weights, dark_s, _ = self._of_lanes
        lanes = self.chip.array.flat_lanes[places]
        frames = self.light.ended.reshape(len(self.light.ended), -1)
        of_frames = weights.of_frames(self.light).weights
        seen_e = np.zeros((len(of_frames), len(places)))
        for frame, weight in zip(frames, of_frames.swapaxes(0, 1), strict=True):
            seen_e += weight.take(lanes, axis=1) * frame.take(places)
        seen_e *= self.chip.scale[places]
        dark_e = self.chip.current[places] * dark_s[:, lanes]
        given_fraction = self.chip.exchanged * _neighbours(places, *self.light.shape)
        most_e = np.maximum(seen_e, (1.0 - given_fraction) * seen_e + self._gained_e[places])
        return _reaching(most_e + dark_e), _reaching(seen_e + dark_e)


def _neighbours(places: Places, rows: int, cols: int) -> Places:
    """How many neighbours pixels have."""
    row, col = np.divmod(places, cols)
    beside: Places = (row > 0).astype(np.int64) + (row + 1 < rows) + (col > 0) + (col + 1 < cols)
    return beside


def _of_lanes(chip: Chip) -> tuple[Weights, Values, Values]:
    """How much of each slot (kinds, N, lanes) PIX sees, and registers hold; for how long these
    gather dark charge, in seconds; and the least of it with which a lane may saturate."""
    program = chip.program
    held_weights = () if program.reach.held_weights is None else program.reach.held_weights
    weights = np.stack([program.tables.seen_slots(), *held_weights]).astype(np.float64)
    limit = _reached(_SLACK * chip.saturation_e.min(axis=0))
    return Weights(weights), program.slot_s @ weights, limit


def _reaching(charge_e: Values) -> Values:
    """How far counts of these means may go."""
    return np.asarray(charge_e + _SIGMAS * np.sqrt(charge_e))


def _reached(limit: Values) -> Values:
    """The least charge that noise takes to a limit."""
    return ((np.sqrt(_SIGMAS**2 + 4.0 * np.maximum(limit, 0.0)) - _SIGMAS) / 2.0) ** 2
