"""Find the pixels of a scene that may saturate; these pixels run through their words.

The charge of pixels is computed with all requested effects."""

from __future__ import annotations

from dataclasses import dataclass
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
        chip = chip_of(program, device_seed, requested_effects, requested_effects)
        by_light[source] = _search(chip, source)
    return by_light[source]


def _search(chip: SimulatedChip, light: Light) -> NearSaturation:
    """Return the pixels that may saturate: an upper bound for all pixels selects candidates, whose
    charge is then computed."""
    weights, dark_s, limit = chip.compute_once(_of_lanes)
    total_e = light.sum_e * chip.scale.reshape(light.shape)
    gained_e: Values = np.zeros(light.shape)
    if chip.kept_effects.find_part(Exchange) is not None:
        for pixels, neighbours in NEIGHBOURS:
            gained_e[pixels] += total_e[neighbours]
        gained_e *= chip.exchanged
    gained_e = gained_e.reshape(-1)
    # The bound adds up the dark charge of the frame, crosstalk, and the largest fraction of the
    # light that PIX or a register can contain.
    lanes = chip.array.flat_lanes
    bound_e = weights.of_frames(light).most_part.take(lanes) * total_e.reshape(-1)
    bound_e += chip.current * float(chip.program.slot_s.sum())
    bound_e += gained_e
    places = np.flatnonzero(bound_e >= limit.take(lanes))
    if not len(places):
        return NO_PIXELS
    most_e, own_e = _charges(chip, light, weights, dark_s, places, gained_e[places])
    limits = chip.saturation_e[:, lanes[places]]
    is_near = np.any(most_e >= limits, axis=0)
    spilt = ~np.any(own_e >= limits, axis=0)
    return NearSaturation(places[is_near], most_e[0, is_near], own_e[0, is_near], spilt[is_near])


def _charges(
    chip: SimulatedChip, light: Light, weights: SlotWeights, dark_s: Values, places: Places,
    gained_e: Values,
) -> tuple[Values, Values]:  # fmt: skip
    """Return the largest charge (kinds, places) of each pixel, with and without crosstalk.

    Crosstalk is counted in the pixel's own slots, whatever the codes of the neighbours. `gained_e`
    (places,): the charge that pixels receive from their neighbours."""
    lanes = chip.array.flat_lanes[places]
    frames = light.ended.reshape(len(light.ended), -1)
    of_frames = weights.of_frames(light).weights
    seen_e = np.zeros((len(of_frames), len(places)))
    for frame, weight in zip(frames, of_frames.swapaxes(0, 1), strict=True):
        seen_e += weight.take(lanes, axis=1) * frame.take(places)
    seen_e *= chip.scale[places]
    row, col = np.divmod(places, light.shape[1])
    below, right = row + 1 < light.shape[0], col + 1 < light.shape[1]
    neighbours = (row > 0).astype(np.int64) + below + (col > 0) + right
    dark_e = chip.current[places] * dark_s[:, lanes]
    given_fraction = chip.exchanged * neighbours
    most_e = np.maximum(seen_e, (1.0 - given_fraction) * seen_e + gained_e)
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
