"""The charge that falls on the pixels in every slot: light and dark, counted, exchanged."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import Selection
from nscc_runtime.effects.counts import count_key, thinning_key
from nscc_runtime.effects.field import OnDevice
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Scene, Slots
from nscc_runtime.light import Light
from nscc_runtime.noise import RATE_CAP, poisson, thin

Charge = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Groups:
    """The groups of slots: slots that are open in the same buckets.

    `of_slot` int64 (lanes, N): bit b is set where the slot is open in bucket b. `lane` intp
    (rows, cols): the lane of every pixel.
    """

    of_slot: NDArray[np.int64]
    lane: NDArray[np.intp]


def charge_of_rows(
    scene: Scene,
    groups: Groups | None,
    sensor: Sensor,
    effects: Selection,
    seeds: tuple[int, int],
    frame: int,
    rows: range,
) -> tuple[Charge, NDArray[np.bool_]]:
    """Electrons (N, rows, cols) that fall on PIX in each slot, and where they are numbers.

    `groups` None: every slot is counted by itself. `seeds` are those of the frames' noise and of
    the device. What the pixels get does not depend
    on how the array is cut into rows.
    """
    height, cols = scene.light.shape
    halo = bool(effects.at("neighbours"))
    begin, end = max(rows.start - halo, 0), min(rows.stop + halo, height)
    for choose in effects.at("scene"):
        scene = choose(scene)
    slots = _Slots(
        sensor=sensor, seed=seeds[0], device_seed=seeds[1], frame=frame,
        places=np.arange(begin * cols, end * cols, dtype=np.int64),
        scene=scene, rows=slice(begin, end), of_slot=None if groups is None else groups.of_slot,
        lanes=None if groups is None else groups.lane[begin:end].reshape(-1),
    )  # fmt: skip
    charge = slots.electrons(scene.light)
    for stage in ("light", "response", "count", "charge", "neighbours"):
        for change in effects.at(stage):
            charge = change(slots, charge)
    inner = slice(rows.start - begin, rows.stop - begin)
    return charge[:, inner], slots.valid.reshape(end - begin, cols)[inner]


@dataclass(eq=False, kw_only=True)
class _Slots(Slots):
    """`valid` (pixels,) is cleared where a rate is no number."""

    rows: slice
    of_slot: NDArray[np.int64] | None
    lanes: NDArray[np.intp] | None

    def __post_init__(self) -> None:
        self.valid = np.ones(len(self.places), np.bool_)

    def fixed(self, make: OnDevice) -> Charge:
        return super().fixed(make).reshape(-1, self.scene.light.shape[1])

    def electrons(self, light: Light) -> Charge:
        slots = (light.slot(n, self.rows).astype(np.float64) for n in range(light.slots))
        return np.stack([*slots])

    def counted(self, stream: int, source: int, rates: Charge) -> Charge:
        """Rates below 0 count as 0, above `RATE_CAP` as that."""
        shape, rates = rates.shape, rates.reshape(len(rates), -1)
        self.valid &= ~np.isnan(rates).any(axis=0)
        named = self.seed, stream, source, self.frame
        counted = np.zeros(rates.shape)
        if self.of_slot is None or self.lanes is None:
            for n, each in enumerate(rates):
                counted[n], good = poisson(count_key(*named, n), self.places, each, exact=True)
                self.valid &= good
            return counted.reshape(shape)
        rates = np.clip(np.nan_to_num(rates, nan=0.0, posinf=RATE_CAP), 0.0, RATE_CAP)
        for group in np.unique(self.of_slot[self.lanes]).tolist():
            among = group == self.of_slot[self.lanes].T
            shares = np.where(among, rates, 0.0)
            total = shares.sum(axis=0)
            counts, good = poisson(count_key(*named, group), self.places, total, exact=True)
            self.valid &= good
            counted += thin(thinning_key(*named, group), self.places, counts, shares.T).T
        return counted.reshape(shape)
