"""The charge that falls on the pixels in every slot: light and dark, counted, smeared."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import Effect, Selection
from nscc_runtime.effects.crosstalk import CROSSTALK, smeared
from nscc_runtime.effects.dark import DARK, current_e_per_s
from nscc_runtime.effects.photons import (
    DARK as DARK_SOURCE,
)
from nscc_runtime.effects.photons import (
    LIGHT,
    PRNU,
    SHOT,
    count_key,
    response,
    thinning_key,
)
from nscc_runtime.effects.timing import LAG, MOTION
from nscc_runtime.light import Light
from nscc_runtime.noise import RATE_CAP, poisson, thin
from nscc_runtime.sensor.sensor import Sensor

Charge = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Groups:
    """The groups of slots: slots that are open in the same buckets.

    `of_slot` int64 (lanes, N): bit b is set where the slot is open in bucket b. `lane` intp
    (rows, cols): the lane of every pixel.
    """

    of_slot: NDArray[np.int64]
    lane: NDArray[np.intp]


@dataclass(frozen=True, eq=False)
class Scene:
    """The light of a frame and of the one before it, and how long the slots are."""

    light: Light
    previous: Light
    slot_s: NDArray[np.float64]


def charge_of_rows(
    scene: Scene,
    groups: Groups,
    sensor: Sensor,
    effects: Selection,
    seeds: tuple[int, int],
    frame: int,
    rows: range,
) -> tuple[Charge, NDArray[np.bool_]]:
    """Electrons (N, rows, cols) that fall on PIX in each slot, and where they are numbers.

    `seeds` are those of the frames' noise and of the device. What the pixels get does not depend
    on how the array is cut into rows.
    """
    height, cols = scene.light.shape
    halo = CROSSTALK in effects
    begin, end = max(rows.start - halo, 0), min(rows.stop + halo, height)
    part = slice(begin, end)
    places = np.arange(begin * cols, end * cols, dtype=np.int64)
    seed, device_seed = seeds

    light = _light(scene.light, MOTION in effects, part)
    if LAG in effects:
        light += sensor.lag_fraction * _light(scene.previous, MOTION in effects, part)
    if PRNU in effects:
        light *= response(sensor, device_seed, places).reshape(end - begin, cols)
    lanes = groups.lane[part].reshape(-1)
    valid = np.ones(len(places), np.bool_)
    charge = light.reshape(len(light), -1)
    if SHOT in effects:
        charge = _counted(charge, groups, lanes, places, (seed, SHOT, LIGHT, frame), valid)
    if DARK in effects:
        current = current_e_per_s(sensor, device_seed, places)
        rates = scene.slot_s[:, None] * current
        charge = charge + _counted(
            rates, groups, lanes, places, (seed, DARK, DARK_SOURCE, frame), valid
        )
    shaped = charge.reshape(len(charge), end - begin, cols)
    if halo:
        shaped = smeared(shaped, sensor.crosstalk_fraction)
    inner = slice(rows.start - begin, rows.stop - begin)
    return shaped[:, inner], valid.reshape(end - begin, cols)[inner]


def _light(light: Light, moving: bool, rows: slice) -> Charge:
    """The light of every slot (N, rows, cols), with or without motion inside slots."""
    source = light.motion if moving and light.motion is not None else light
    return np.stack([source.slot(n)[rows].astype(np.float64) for n in range(light.slots)])


def _counted(
    rates: Charge,
    groups: Groups,
    lanes: NDArray[np.intp],
    places: NDArray[np.int64],
    stream: tuple[int, Effect, int, int],
    valid: NDArray[np.bool_],
) -> Charge:
    """Counts (N, pixels) of Poisson processes with these rates.

    Clears `valid` where a rate is NaN; rates below 0 count as 0, above `RATE_CAP` as that.
    """
    valid &= ~np.isnan(rates).any(axis=0)
    rates = np.clip(np.nan_to_num(rates, nan=0.0, posinf=RATE_CAP), 0.0, RATE_CAP)
    counted = np.zeros_like(rates)
    for group in np.unique(groups.of_slot[lanes]):
        among = group == groups.of_slot[lanes].T
        shares = np.where(among, rates, 0.0)
        counts, good = poisson(
            count_key(*stream, int(group)), places, shares.sum(axis=0), exact=True
        )
        valid &= good
        counted += thin(thinning_key(*stream, int(group)), places, counts, shares.T).T
    return counted
