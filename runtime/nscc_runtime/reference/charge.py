"""The charge that reaches the pixels in every slot: light and dark charge, counted, with
crosstalk."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from nscc.arrays import Bools, Floats, Ints
from nscc_runtime.effects import Selection, Sensor
from nscc_runtime.effects.views import Scene, Slots


def places_of(rows: range, cols: int) -> Ints:
    """Return the places, row * cols + column, of the pixels of consecutive rows, (pixels,)."""
    return np.arange(rows.start * cols, rows.stop * cols, dtype=np.int64)


def charge_of_rows(
    scene: Scene,
    sensor: Sensor,
    effects: Selection,
    seeds: tuple[int, int],
    frame: int,
    rows: range,
    starts: Sequence[int],
) -> tuple[Floats, Bools]:
    """Return the charge of the consecutive `rows`, electrons (intervals, rows, cols) that reach PIX
    (the photodiode) in each interval of slots, and a mask (rows, cols), False where light is NaN.

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
    slots = Slots(
        sensor=sensor,
        seed=seeds[0],
        device_seed=seeds[1],
        frame=frame,
        places=places_of(range(begin, end), cols),
        scene=scene,
        rows=slice(begin, end),
        starts=starts,
    )
    charge = slots.electrons(scene.light)
    for stage in ("light", "response", "count", "charge", "neighbours"):
        for change in effects.at(stage):
            charge = change(slots, charge)
    inner = slice(rows.start - begin, rows.stop - begin)
    valid = ~scene.light.is_nan[rows.start : rows.stop]
    return charge[:, inner], valid
