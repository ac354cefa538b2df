"""Pixels that look, among the shutters that a tradeoff compares: rows of hdr-v1, and designs."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import numpy as np

from nscc.words.container import Container
from nscc_runtime import capture
from nscc_runtime.light import Light
from nscc_runtime.looked_light import DEVIATION, LIGHT, merged_image
from nscc_runtime.sensor import Sensor
from nscc_training.design.chip import Chip
from nscc_training.design.looking import Model, Schedule
from nscc_training.design.scene import histogram
from nscc_training.design.text import looking_text
from nscc_training.evaluation.hdr import Crop
from nscc_training.evaluation.hdr_looks import ROWS, SLOTS, row_of
from nscc_training.measures import number

Looking = Literal["looks", "designed"]


def looking_kinds(exposures: Sequence[int]) -> list[tuple[Looking, int]]:
    """What there is of so many exposures a pixel: a row of hdr-v1 where it has one, and one that is
    designed for the scenes."""
    rows: list[tuple[Looking, int]] = [("looks", k) for k in exposures if f"looks-{k}" in ROWS]
    return rows + [("designed", k) for k in exposures]


def schedule_of(kind: Looking, exposures: int, chip: Chip, shown: Sequence[Crop]) -> Schedule:
    """Where such pixels look: designed for the least square error of the scenes' light."""
    if kind == "looks":
        return row_of(f"looks-{exposures}", chip.target)
    model = Model(chip, histogram([scene.light_e for scene in shown]), [1.0] * SLOTS)
    return model.best(exposures - 1, "linear")


def looking_source(schedule: Schedule, chip: Chip, slot_us: float, named: str | None) -> str:
    """The program's text, for slots of that length."""
    return looking_text(schedule, SLOTS, slot_us, chip.target, named, "")


def looked_psnr_db(
    container: Container, scene: Crop, sensor: Sensor, effects: str, seed: int, device_seed: int
) -> float:
    """The linear PSNR of a scene that such pixels saw: exposures over their times, no decoder."""
    slot_s = np.array(container.slot_us) * 1e-6
    frame_s = float(slot_s.sum())
    light = Light.of_still((scene.light_e / frame_s).astype(np.float32), slot_s)
    taken = capture(
        container, light, sensor=sensor, effects=effects, seed=seed, device_seed=device_seed
    )
    made = merged_image(taken.told[LIGHT], taken.told[DEVIATION]) * frame_s
    return number(scene.scores(made)["psnr_db"])
