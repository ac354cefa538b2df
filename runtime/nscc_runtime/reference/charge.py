"""The charge that reaches the pixels in every slot: light and dark charge, counted, with
crosstalk."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from nscc.arrays import Bools, Floats, Ints
from nscc_runtime.caches import remembered
from nscc_runtime.effects import Selection
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import OnDevice, Scene, Slots
from nscc_runtime.light import Light
from nscc_runtime.noise import key, poisson

Charge = Floats


def places_of(rows: range, cols: int) -> Ints:
    """Return the places, row * cols + column, of the pixels of consecutive rows, (pixels,)."""
    return np.arange(rows.start * cols, rows.stop * cols, dtype=np.int64)


class Fallen(NamedTuple):
    """The charge of some rows in successive intervals of slots.

    `charge` float64 (intervals, rows, cols): electrons that reach PIX (the photodiode) in each
    interval. `light`, of the same shape: the electrons of the scene alone, without effects. `valid`
    (rows, cols): False where light is NaN."""

    charge: Charge
    light: Charge
    valid: Bools

    def rows(self, rows: slice) -> Fallen:
        """Return the charge of some of these rows: the slice `rows`, where 0 is the first row that
        this object has, not that of the array."""
        return Fallen(self.charge[:, rows], self.light[:, rows], self.valid[rows])


def charge_of_rows(
    scene: Scene,
    sensor: Sensor,
    effects: Selection,
    seeds: tuple[int, int],
    frame: int,
    rows: range,
    starts: Sequence[int],
) -> Fallen:
    """Return the charge of the consecutive `rows` in intervals of slots.

    `starts`: the first slot of each interval, ascending from 0; an interval ends where the next
    begins. `seeds`: noise seed, device seed. `frame`: number of the frame, from 0. The charge of a
    pixel does not depend on how the array is cut into rows."""
    height, cols = scene.light.shape
    # Crosstalk needs one row of neighbours on each side.
    halo = bool(effects.at("neighbours"))
    begin, end = max(rows.start - halo, 0), min(rows.stop + halo, height)
    for choose in effects.at("scene"):
        scene = choose(scene)
    scene = replace(scene, slot_s=np.add.reduceat(scene.slot_s, starts))
    slots = _Slots(
        sensor=sensor,
        seed=seeds[0],
        device_seed=seeds[1],
        frame=frame,
        places=places_of(range(begin, end), cols),
        scene=scene,
        rows=slice(begin, end),
        starts=starts,
    )
    charge = light = slots.electrons(scene.light)
    for stage in ("light", "response", "count", "charge", "neighbours"):
        for change in effects.at(stage):
            charge = change(slots, charge)
    inner = slice(rows.start - begin, rows.stop - begin)
    valid = ~scene.light.is_nan[rows.start : rows.stop]
    return Fallen(charge[:, inner], light[:, inner], valid)


@dataclass(eq=False, kw_only=True)
class _Slots(Slots):
    """The intervals of slots of some rows of the array.

    `rows`: these rows. `starts`: the first slot of each interval."""

    rows: slice
    starts: Sequence[int]

    def fixed(self, make: OnDevice) -> Charge:
        """Return the fixed pattern of the chip that `make` computes, for these rows, (rows,
        cols)."""
        return super().fixed(make).reshape(-1, self.scene.light.shape[1])

    @remembered
    def electrons(self, light: Light) -> Charge:
        """Return the electrons that `light` gives in each interval of slots, (intervals, rows,
        cols); remembered for each light. Callers do not change the result.

        Light that is NaN counts as 0, so that neighbours of its pixel stay valid."""
        shape = len(self.starts), len(self.places) // light.shape[1], light.shape[1]
        out = np.zeros(shape)
        for interval, (start, stop) in enumerate(pairwise([*self.starts, light.slots])):
            for n in range(start, stop):
                out[interval] += light.slot(n, self.rows)
        out[np.isnan(out)] = 0.0
        return out

    def counted(self, stream: int, source: int, rates: Charge) -> Charge:
        """Return Poisson counts with the means `rates`, both float64 (intervals, rows, cols).

        Rates outside 0..`RATE_CAP` are clipped to it. `stream` (of the effect) and `source` (light
        or dark charge) select the random numbers. The count of a NaN is 0."""
        shape, rates = rates.shape, rates.reshape(len(rates), -1)
        counted = np.zeros(rates.shape)
        for n, slot_rates in enumerate(rates):
            of_slot = key(self.seed, stream, source, self.frame, n)
            counted[n], _ = poisson(of_slot, self.places, slot_rates)
        return counted.reshape(shape)
