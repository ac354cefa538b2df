"""The rows of hdr-v1 whose pixels look at the light: no decoder, an exposure over its own time.

The programs are compiled, and their words run on the emulator: with the protocol's noise and a
comparator's, and beside it with all effects of the sensor and with other comparators.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.compiler import compile_source
from nscc.pipeline import Options
from nscc.program.looking import level_steps
from nscc.source import Source
from nscc.target.load import builtin_target
from nscc.target.target import Target
from nscc.words.container import Container
from nscc_runtime.effects import Selection, selected
from nscc_runtime.light import Light
from nscc_runtime.looked_light import DEVIATION, LIGHT, merged_image
from nscc_runtime.reference.looks import looking_frames
from nscc_runtime.sensor import Sensor, default_sensor
from nscc_training import metrics
from nscc_training.design.looking import Schedule
from nscc_training.design.text import looking_text
from nscc_training.evaluation.hdr import Crop, Picture, also_saturated, panoramas, parted
from nscc_training.evaluation.results import Item, Scene, Scored, Subject, scored, with_arrays
from nscc_training.measures import number
from nscc_training.protocols import Protocol, load_protocol

SLOTS = 256
"""Of hdr-v1."""
ROWS: dict[str, tuple[tuple[int, ...], float]] = {
    "looks-2": ((16,), 6.25),
    "looks-5": ((1, 4, 16, 64), 22.0),
    "looks-9": ((1, 2, 4, 8, 16, 32, 64, 128), 45.0),
}
"""The boundaries of SLOTS at which each row's pixels look, the last exposure being the frame's end,
and the percentage of a full well above which they close."""

_EFFECTS = "full_well,shot,adc_noise,comparator_noise"
_COMPARATORS = (0.01, 0.02, 0.04)
"""Noise and offset of the comparators, in full wells, that are tried beside the default."""


def row_of(name: str, target: Target) -> Schedule:
    """Where the pixels of a row look, and at which step of IN, on a chip."""
    at, percent = ROWS[name]
    return Schedule(at, (level_steps(percent, "%", target),) * len(at))


def evaluate_looks(
    name: str, folder: Path, seed: int = 0
) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    """The result of one of ROWS on a folder of panoramas, and its pictures: arrays by name.

    Beside the score, `also` has its means with all effects of the sensor, and with comparators of
    other noise and offset.
    """
    protocol = load_protocol("hdr-v1")
    files = panoramas(folder)
    usable, left_out = parted(files, protocol)
    container, sensor = _made(name, protocol)
    effects = selected(_EFFECTS)
    every = _decoded(usable, container, sensor, effects, seed)

    def items(others: list[Crop]) -> list[Item]:
        return [each.item for each in _decoded(others, container, sensor, effects, seed)]

    tried = [("all effects", sensor, selected("all"))]
    for size in _COMPARATORS:
        values = {"comparator_noise_fraction": size, "comparator_offset_fraction": size}
        other = sensor.changed(**values)
        both = selected(f"{_EFFECTS},comparator_offset")
        tried.append((f"comparators of {size:.0%} noise and offset", other, both))
    also = [
        {"sensor": what, **_means(_decoded(usable, container, other, chosen, seed))}
        for what, other, chosen in tried
    ]
    looks, percent = ROWS[name]
    settings = {"looks": list(looks), "level": f"{percent:g}%", "effects": _EFFECTS, "seed": seed}
    subject = Subject(name, settings, decoder_ms=0.0)
    passed = [crop.as_json() for crop in left_out]
    others = also_saturated(files, protocol, items)
    return with_arrays(protocol, subject, files, every, passed, also_saturated=others, also=also)


def _made(name: str, protocol: Protocol) -> tuple[Container, Sensor]:
    """The compiled program and the protocol's sensor."""
    well = float(protocol["full_well_e"])
    target = replace(
        builtin_target("scamp5"), rows=int(protocol["crop_size"]), cols=int(protocol["crop_size"]),
        full_well_e=well, register_max_e=well, register_min_e=-well,
        adc_bits=int(protocol["adc_bits"]),
    )  # fmt: skip
    text = looking_text(row_of(name, target), SLOTS, 125.0, target, None, "")
    made = compile_source(Source(f"{name}.nsl", text), Path(), Options(target=target)).container
    assert made is not None
    sensor = default_sensor(target)
    noise = float(protocol["read_noise_lsb"])
    return made, sensor.changed(adc_noise_lsb=noise)


def _decoded(
    usable: list[Crop], container: Container, sensor: Sensor, effects: Selection, seed: int
) -> list[Scored]:
    slot_s = np.array(container.slot_us) * 1e-6
    frame_s = float(slot_s.sum())

    def decode(crop: Scene, index: int) -> tuple[Picture, float]:
        light = Light.of_still((crop.light_e / frame_s).astype(np.float32), slot_s)
        made = looking_frames(container, light, sensor, effects, seed=1000 * seed + index)
        told = next(iter(made)).told
        return merged_image(told[LIGHT], told[DEVIATION]) * frame_s, 0.0

    return list(scored(usable, decode, []))


def _means(every: list[Scored]) -> dict[str, float]:
    names = ("psnr_db", "ssim", "mu_psnr_db", "pu21_psnr_db")
    return {
        f"mean_{name}": metrics.finite_mean(number(each.item.metrics[name]) for each in every)
        for name in names
    }
