"""Find the pixels of a scene that may saturate; these pixels run through their words.

The charge of pixels is computed with all requested effects."""

from __future__ import annotations

from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np

from nscc.arrays import Floats, Ints
from nscc.mappings import NamedValues
from nscc_runtime.effects.parts import Saturates, Soft, Well
from nscc_runtime.effects.selection import Selection
from nscc_runtime.execution.candidate_loop import (
    SIGMAS,
    Candidates,
    compare_candidates,
    find_candidates,
)
from nscc_runtime.execution.moments import exchanged_fraction, on_chip
from nscc_runtime.execution.program import AnalysedProgram, light_under
from nscc_runtime.execution.register_reach import reach_of
from nscc_runtime.execution.sum_loop import SlotWeights
from nscc_runtime.light import Light

Places = Ints

_SLACK = 1.0 - 1e-5
"""Factor on limits that allows for rounding, because light is added up in float32."""


@dataclass(frozen=True, eq=False)
class NearSaturation:
    """Pixels that may saturate.

    Attributes
    ----------
    places : int64, shape (count,)
        Places of the pixels on the chip (row * cols + col), ascending.
    most_e : float64, shape (count,)
        Largest charge on PIX at a read including noise, in electrons.
    """

    places: Places
    most_e: Floats


NO_PIXELS = NearSaturation(np.empty(0, np.int64), np.empty(0))


def near_saturation(
    program: AnalysedProgram, light: Light, device_seed: int, effects: Selection
) -> NearSaturation:
    """Return the pixels of the chip of `device_seed` that may saturate under `effects`, cached with
    the light; none if no effect saturates."""
    if not effects.names(Saturates):
        return NO_PIXELS
    source = light_under(effects, light)
    by_light: WeakKeyDictionary[Light, NearSaturation] = program.recent.of(
        (NearSaturation, device_seed, effects.on), WeakKeyDictionary
    )
    if source not in by_light:
        by_light[source] = _search(program, source, effects, device_seed)
    return by_light[source]


@dataclass(frozen=True, eq=False)
class _Limits:
    """When a pixel may saturate. A kind is a sum of charge: that on PIX first, then those in
    registers.

    `weights` (kinds, N, lanes): weights of the slots in each sum. `dark_part` (kinds, lanes): the
    part of the dark charge of a frame that it contains. `mean_e` (kinds, lanes): the smallest mean
    of the sum that noise may raise so far that a pixel saturates, infinite if it cannot. A lane is
    the pixels of one distinct shutter. PIX is the photodiode."""

    weights: SlotWeights
    dark_part: Floats
    mean_e: Floats


def _search(
    program: AnalysedProgram, light: Light, effects: Selection, device_seed: int
) -> NearSaturation:
    """Return the pixels that may saturate in `light`, possibly none. An upper bound for all pixels
    selects candidates, whose charge is then computed. `device_seed`: of the fixed patterns."""
    limits: _Limits = program.recent.of((_Limits, effects.on), lambda: _limits(program, effects))
    chip, (rows, cols) = on_chip(program, effects, device_seed), light.shape
    exchanged, weights = exchanged_fraction(effects, program), limits.weights.of_frames(light)
    most_part, table = weights.most_part, weights.weights
    # In dim light a bound for the brightest pixel excludes all; NaN does not compare as less.
    brightest_e = light.most_e * chip.most_factor
    most_light_e = (most_part.max() + 4.0 * exchanged) * brightest_e
    if most_light_e + (1.0 + 4.0 * exchanged) * chip.most_dark_e < limits.mean_e.min():
        return NO_PIXELS
    kinds, frames, lane_count = table.shape
    sizes: NamedValues = {
        "rows": rows,
        "cols": cols,
        "exchanged": exchanged,
        "lane_count": lane_count,
        "kinds": kinds,
        "frames": frames,
    }
    chip_e: NamedValues = {
        "sum_e": light.sum_e,
        "factor": chip.factor,
        "dark_e": chip.dark_e,
        "lanes": program.lanes,
    }
    places, count = np.empty(rows * cols, np.int64), np.zeros(1, np.int64)
    find_candidates(
        sizes=Candidates(candidates=0, lit_rows=0, first_row=0, **sizes),
        **chip_e,
        most_part=most_part,
        mean_e=limits.mean_e.min(axis=0),
        given_e=np.empty(3 * (cols + 2)),
        bound_e=np.empty(cols),
        places=places,
        count=count,
    )
    places = places[: count[0]].copy()
    pix_e, is_near = np.empty(len(places)), np.empty(len(places), np.bool_)
    for own_rows, first_row, strip in light.strips() if len(places) else ():
        ends = np.array([own_rows.start, own_rows.stop]) * cols
        part = slice(*np.searchsorted(places, ends).tolist())
        compare_candidates(
            sizes=Candidates(
                candidates=part.stop - part.start,
                lit_rows=strip.shape[0],
                first_row=first_row,
                **sizes,
            ),
            **chip_e,
            places=places[part],
            light=np.require(strip.ended, np.float32, ["C", "A"]),
            table=table,
            dark_part=limits.dark_part,
            mean_e=limits.mean_e,
            seen_e=np.zeros((kinds, len(places[part]))),
            pix_e=pix_e[part],
            is_near=is_near[part].view(np.uint8),
        )
    pix_e = pix_e[is_near]
    return NearSaturation(places[is_near], pix_e + SIGMAS * np.sqrt(pix_e))


def _limits(program: AnalysedProgram, effects: Selection) -> _Limits:
    """Return what decides whether a pixel may saturate, for each lane (the pixels of one distinct
    shutter) of `program` under these effects. Without an effect that saturates PIX (the photodiode)
    or registers, their limits are infinite."""
    model, soft = program.model(effects), effects.find_part(Soft)
    reach = None if soft is None else reach_of(program, effects)
    charge_weights = () if reach is None or reach.charge_weights is None else reach.charge_weights
    # Words that run for a while collect light of slots that no other word reads from PIX.
    collected = np.abs(program.weights(model).slots).max(axis=2)
    seen = np.where(program.seen_slots(model.decay), 1.0, collected)
    weights = np.stack([seen, *charge_weights]).astype(np.float64)
    saturation_e = np.full((len(weights), len(program.container.encoding)), np.inf)
    well = effects.find_part(Well)
    if well is not None:
        saturation_e[0] = well.full_e(program.sensor)
    if reach is not None:
        # If no register holds a sum of its own, row 0 stands for PIX and the registers.
        registers = saturation_e[1:] if len(charge_weights) else saturation_e
        np.minimum(registers, reach.least_e, out=registers)
    least_e = np.maximum(_SLACK * saturation_e, 0.0)
    # The smallest mean charge m that noise raises to the limit: m + SIGMAS sqrt(m) = least_e.
    mean_e = ((np.sqrt(SIGMAS**2 + 4.0 * least_e) - SIGMAS) / 2.0) ** 2
    dark_part = program.slot_s @ weights / program.slot_s.sum()
    return _Limits(SlotWeights(weights), dark_part, mean_e)
