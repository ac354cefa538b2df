"""The charge that reaches the pixels in every slot: light and dark charge, counted, with
crosstalk."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.caches import remembered
from nscc_runtime.effects import Selection
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import THINNED, OnDevice, Scene, Slots
from nscc_runtime.light import Light
from nscc_runtime.noise import RATE_CAP, key, poisson, thin

Charge = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Groups:
    """Groups of slots: slots that are open in the same buckets.

    `of_slot` int64 (lanes, N): bit b is set if the slot is open in bucket b. `lane` intp (rows,
    cols): the lane (code number) of each pixel. `places` int64 (rows * cols,): the place of each
    pixel on the chip; None for all pixels in order."""

    of_slot: NDArray[np.int64]
    lane: NDArray[np.intp]
    places: NDArray[np.int64] | None = None

    def places_of(self, rows: range) -> NDArray[np.int64]:
        """Return the places (pixels,) of the pixels of some rows."""
        cols = self.lane.shape[1]
        if self.places is not None:
            return self.places[rows.start * cols : rows.stop * cols]
        return np.arange(rows.start * cols, rows.stop * cols, dtype=np.int64)


class Fallen(NamedTuple):
    """The charge of some rows.

    `charge` float64 (N, rows, cols): electrons that reach PIX in each slot. `light` (N, rows,
    cols): the electrons of the scene alone. `valid` (rows, cols): where all values are numbers."""

    charge: Charge
    light: Charge
    valid: NDArray[np.bool_]

    def rows(self, rows: slice) -> Fallen:
        """Return the charge of a slice of these rows."""
        return Fallen(self.charge[:, rows], self.light[:, rows], self.valid[rows])


def charge_of_rows(
    scene: Scene,
    groups: Groups | None,
    sensor: Sensor,
    effects: Selection,
    seeds: tuple[int, int],
    frame: int,
    rows: range,
) -> Fallen:
    """Return the charge of consecutive rows.

    `groups`: None to draw the counts of each slot separately. `seeds`: noise seed, device seed. The
    charge of a pixel does not depend on how the array is cut into rows."""
    height, cols = scene.light.shape
    halo = bool(effects.at("neighbours"))
    begin, end = max(rows.start - halo, 0), min(rows.stop + halo, height)
    for choose in effects.at("scene"):
        scene = choose(scene)
    places = np.arange(begin * cols, end * cols, dtype=np.int64)
    if groups is not None:
        places = groups.places_of(range(begin, end))
    slots = _Slots(
        sensor=sensor, seed=seeds[0], device_seed=seeds[1], frame=frame,
        places=places, scene=scene, rows=slice(begin, end),
        of_slot=None if groups is None else groups.of_slot,
        lanes=None if groups is None else groups.lane[begin:end].reshape(-1),
    )  # fmt: skip
    charge = light = slots.electrons(scene.light)
    for stage in ("light", "response", "count", "charge", "neighbours"):
        for change in effects.at(stage):
            charge = change(slots, charge)
    inner = slice(rows.start - begin, rows.stop - begin)
    valid = slots.valid.reshape(end - begin, cols)[inner]
    return Fallen(charge[:, inner], light[:, inner], valid)


@dataclass(eq=False, kw_only=True)
class _Slots(Slots):
    """The slots of some rows. `valid` (pixels,) becomes False where a rate is NaN."""

    rows: slice
    of_slot: NDArray[np.int64] | None
    lanes: NDArray[np.intp] | None

    def __post_init__(self) -> None:
        self.valid = np.ones(len(self.places), np.bool_)

    def fixed(self, make: OnDevice) -> Charge:
        return super().fixed(make).reshape(-1, self.scene.light.shape[1])

    @remembered
    def electrons(self, light: Light) -> Charge:
        out = np.empty((light.slots, len(self.places) // light.shape[1], light.shape[1]))
        for n in range(light.slots):
            out[n] = light.slot(n, self.rows)
        return out

    def counted(self, stream: int, source: int, rates: Charge) -> Charge:
        """Return Poisson counts of `rates`, clipped to 0 .. `RATE_CAP`."""
        shape, rates = rates.shape, rates.reshape(len(rates), -1)
        self.valid &= ~np.isnan(rates).any(axis=0)
        named = self.seed, stream, source, self.frame
        counted = np.zeros(rates.shape)
        if self.of_slot is None or self.lanes is None:
            for n, slot_rates in enumerate(rates):
                counted[n], is_valid = poisson(key(*named, n), self.places, slot_rates)
                self.valid &= is_valid
            return counted.reshape(shape)
        rates = np.clip(np.nan_to_num(rates, nan=0.0, posinf=RATE_CAP), 0.0, RATE_CAP)
        for group in np.unique(self.of_slot[self.lanes]).tolist():
            among = group == self.of_slot[self.lanes].T
            shares = np.where(among, rates, 0.0)
            total = shares.sum(axis=0)
            counts, is_valid = poisson(key(*named, group), self.places, total)
            self.valid &= is_valid
            split_key = key(self.seed, stream, THINNED + source, self.frame, group)
            counted += thin(split_key, self.places, counts, shares.T).T
        return counted.reshape(shape)
