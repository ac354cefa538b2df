"""Find the pixels of a scene that may saturate; these pixels run through their words.

The charge of pixels is computed with all requested effects."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects.parts import Exchange, Moving, Saturates
from nscc_runtime.effects.selection import Selection
from nscc_runtime.execution.chip import SimulatedChip, chip_of
from nscc_runtime.execution.overlap import NEIGHBOURS
from nscc_runtime.execution.program import AnalysedProgram
from nscc_runtime.execution.sum_loop import SlotWeights
from nscc_runtime.light import Light

Values = NDArray[np.float64]
Places = NDArray[np.int64]

_SIGMAS = 6.0
"""Number of standard deviations of noise that are added to a pixel's mean charge."""
_SLACK = 1.0 - 1e-5
"""Factor on limits that allows for rounding, because light is added up in float32."""


@dataclass(frozen=True, eq=False)
class NearSaturation:
    """Pixels that may saturate.

    Attributes
    ----------
    places : int64, shape (count,)
        Places of the pixels on the chip (row * cols + col), ascending.
    most_e, own_e : float64, shape (count,)
        Largest charge on PIX at a read including noise, with and without crosstalk, in electrons.
    spilt : bool, shape (count,)
        Whether a pixel is near saturation only because of the light of its neighbours.
    """

    places: Places
    most_e: Values
    own_e: Values
    spilt: NDArray[np.bool_]


NO_PIXELS = NearSaturation(
    np.empty(0, np.int64), np.empty(0), np.empty(0), np.empty(0, np.bool_)
)  # fmt: skip


def near_saturation(
    program: AnalysedProgram, light: Light, device_seed: int, requested_effects: Selection
) -> NearSaturation:
    """Return the pixels that may saturate under `requested_effects`; cached with the light."""
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
    """A search for pixels near saturation: an upper bound for all pixels selects candidates, whose
    charge is then computed."""

    chip: SimulatedChip
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
    def _of_lanes(self) -> tuple[SlotWeights, Values, Values]:
        return self.chip.compute_once(_of_lanes)

    @cached_property
    def _total_e(self) -> Values:
        """Total light of each pixel (rows, cols) in electrons."""
        return np.asarray(self.light.sum_e * self.chip.scale.reshape(self.light.shape))

    @cached_property
    def _gained_e(self) -> Values:
        """Charge that each pixel receives from its neighbours by crosstalk, in electrons."""
        gained_e, total_e = np.zeros(self.light.shape), self._total_e
        if self.chip.kept_effects.find_part(Exchange) is not None:
            for pixels, neighbours in NEIGHBOURS:
                gained_e[pixels] += total_e[neighbours]
            gained_e *= self.chip.exchanged
        return gained_e.reshape(-1)

    @property
    def _candidates(self) -> Places:
        """Places whose upper bound of the charge reaches the limit. The bound adds up the dark
        charge of the frame, crosstalk, and the largest fraction of the light that PIX or a register
        can contain."""
        weights, _, limit = self._of_lanes
        lanes, seen_fraction = self.chip.array.flat_lanes, weights.of_frames(self.light).most_part
        most_e = seen_fraction.take(lanes) * self._total_e.reshape(-1)
        most_e += self.chip.current * float(self.chip.program.slot_s.sum())
        most_e += self._gained_e
        return np.flatnonzero(most_e >= limit.take(lanes))

    def _charges(self, places: Places) -> tuple[Values, Values]:
        """Return the largest charge (kinds, places) of each pixel, with and without crosstalk.
        Crosstalk is counted in the pixel's own slots, whatever the codes of the neighbours."""
        weights, dark_s, _ = self._of_lanes
        lanes = self.chip.array.flat_lanes[places]
        frames = self.light.ended.reshape(len(self.light.ended), -1)
        of_frames = weights.of_frames(self.light).weights
        seen_e = np.zeros((len(of_frames), len(places)))
        for frame, weight in zip(frames, of_frames.swapaxes(0, 1), strict=True):
            seen_e += weight.take(lanes, axis=1) * frame.take(places)
        seen_e *= self.chip.scale[places]
        row, col = np.divmod(places, self.light.shape[1])
        below, right = row + 1 < self.light.shape[0], col + 1 < self.light.shape[1]
        neighbours = (row > 0).astype(np.int64) + below + (col > 0) + right
        dark_e = self.chip.current[places] * dark_s[:, lanes]
        given_fraction = self.chip.exchanged * neighbours
        most_e = np.maximum(seen_e, (1.0 - given_fraction) * seen_e + self._gained_e[places])
        return _reaching(most_e + dark_e), _reaching(seen_e + dark_e)


def _of_lanes(chip: SimulatedChip) -> tuple[SlotWeights, Values, Values]:
    """Return for each lane the weights of slots (kinds, N, lanes) on PIX and in registers, the
    seconds of dark charge in them, and the smallest charge with which a pixel may saturate."""
    program = chip.program
    held_weights = () if program.reach.held_weights is None else program.reach.held_weights
    weights = np.stack([program.tables.seen_slots(), *held_weights]).astype(np.float64)
    least_e = np.maximum(_SLACK * chip.saturation_e.min(axis=0), 0.0)
    # The smallest mean charge whose upper bound (see `_reaching`) is the limit.
    limit = ((np.sqrt(_SIGMAS**2 + 4.0 * least_e) - _SIGMAS) / 2.0) ** 2
    return SlotWeights(weights), program.slot_s @ weights, limit


def _reaching(charge_e: Values) -> Values:
    """Return an upper bound of counts whose mean is `charge_e`."""
    return np.asarray(charge_e + _SIGMAS * np.sqrt(charge_e))
