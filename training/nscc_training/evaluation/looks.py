"""The rows of hdr-v1 whose pixels look at the light: no decoder, an exposure over its own time.

The programs are compiled, and their words run on the emulator: with the protocol's noise and a
comparator's, and beside it with all effects of the sensor and with other comparators. Of `designed`
rows each crop has a program of its own, made for the light that it has (`nscc design`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.compiler import compile_source
from nscc.experiment_store import STORE, ExperimentStore
from nscc.pipeline import Options
from nscc.program.looking import level_steps
from nscc.source import Source
from nscc.target.load import builtin_target
from nscc.target.target import Target
from nscc.words.container import Container
from nscc_runtime import capture
from nscc_runtime.effects import Selection, selected
from nscc_runtime.light import Light
from nscc_runtime.looked_light import DEVIATION, LIGHT, merged_image
from nscc_runtime.sensor import Sensor, default_sensor
from nscc_training.design.chip import Chip
from nscc_training.design.looking import Model, Schedule
from nscc_training.design.scene import histogram
from nscc_training.design.text import looking_text
from nscc_training.evaluation.results import (
    Scored,
    Subject,
    also_saturated,
    mean_score,
    scored,
    usable_scenes,
    with_arrays,
)
from nscc_training.measures import number, stamp
from nscc_training.metrics import finite_mean
from nscc_training.protocol_scenes.files import files_of, scenes_in
from nscc_training.protocol_scenes.scene import Scene
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
DESIGNED = {"designed-2": 2, "designed-5": 5}
"""Exposures of the rows that are designed."""
LOOKING = (*ROWS, *DESIGNED)

_EFFECTS = "full_well,shot,adc_noise,comparator_noise"
_COMPARATORS = (0.01, 0.02, 0.04)
"""Noise and offset of the comparators, in full wells, that are tried beside the default."""
_EVERY_EFFECT = "all effects"


def row_of(name: str, target: Target) -> Schedule:
    """Return where the pixels of a row look, and at which step of IN, on a chip."""
    at, percent = ROWS[name]
    return Schedule(at, (level_steps(percent, "%", target),) * len(at))


def evaluate_looks(
    name: str, folder: Path, seed: int = 0
) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    """Return the result of one of LOOKING on a folder of panoramas, and its arrays by name.

    Beside the score, `also` has its means with all effects of the sensor, and with comparators of
    other noise and offset.
    """
    protocol = load_protocol("hdr-v1")
    files = files_of(protocol, folder)
    usable, left_out = usable_scenes(scenes_in(files, protocol), protocol)
    target = _target(protocol)
    read_noise_lsb = float(protocol["read_noise_lsb"])
    sensor = default_sensor(target).changed(adc_noise_lsb=read_noise_lsb, spread_noise_lsb=0.0)
    program = _programs(name, target, sensor)

    def decoded(
        shown: Sequence[Scene | None], sensor: Sensor = sensor,
        effects: Selection = selected(_EFFECTS),  # noqa: B008
    ) -> list[Scored]:  # fmt: skip
        def decode(crop: Scene, index: int) -> tuple[NDArray[np.float64], float]:
            seeds = 1000 * seed + index, 0
            return looked_light(program(crop), crop.light_e, sensor, effects, seeds), 0.0

        return list(scored(shown, decode))

    tried = [(_EVERY_EFFECT, sensor, selected("all"))]
    for size in _COMPARATORS:
        values = {"comparator_noise_fraction": size, "comparator_offset_fraction": size}
        both = selected(f"{_EFFECTS},comparator_offset")
        condition = f"comparators of {size:.0%} noise and offset"
        tried.append((condition, sensor.changed(**values), both))
    metrics = ("psnr_db", "ssim", "mu_psnr_db", "pu21_psnr_db")
    also = [
        {"sensor": condition, **{f"mean_{key}": mean_score(every, key) for key in metrics}}
        for condition, other, effects in tried
        for every in [decoded(usable, other, effects)]
    ]
    subject = Subject(name, {**_settings(name), "effects": _EFFECTS, "seed": seed}, decoder_ms=0.0)
    others = also_saturated(files, protocol, decoded)
    every = decoded(usable)
    return with_arrays(protocol, subject, files, every, left_out, **others, also=also)


def looked_light(
    container: Container, light_e: NDArray[Any], sensor: Sensor, effects: Selection | str,
    seeds: tuple[int, int],
) -> NDArray[np.float64]:  # fmt: skip
    """Return the light over the frame, in electrons, that pixels tell which look at `light_e`.

    `seeds` are those of noise and of the chip.
    """
    slot_s = np.array(container.slot_us) * 1e-6
    frame_s = float(slot_s.sum())
    light = Light.of_still((light_e / frame_s).astype(np.float32), slot_s)
    told = capture(
        container, light, sensor=sensor, effects=effects, seed=seeds[0], device_seed=seeds[1]
    ).told
    return merged_image(told[LIGHT], told[DEVIATION]) * frame_s


def every_row(
    folder: Path,
    results: Path,
    seed: int = 0,
    progress: Callable[[Sequence[str]], Iterable[str]] = iter,
) -> list[dict[str, Any]]:
    """Return the results of all LOOKING on a folder of panoramas, kept in a store in `results`."""
    files = [stamp(path) for path in files_of(load_protocol("hdr-v1"), folder)]
    results.mkdir(parents=True, exist_ok=True)
    with ExperimentStore(results / STORE) as store:
        found = []
        for name in progress(LOOKING):
            measure = partial(_result, name, folder, seed)
            found.append(store.once(f"{files} {seed}", name, measure))
        return found


def _result(name: str, folder: Path, seed: int) -> dict[str, Any]:
    return evaluate_looks(name, folder, seed)[0]


def conditions_of(found: dict[str, Any]) -> dict[str, tuple[float, float]]:
    """Return the means of PSNR-mu and of linear PSNR of a result, by the conditions of exposure."""
    ways = {f"{each['saturated_fraction']:.0%} saturated": each for each in found["also_saturated"]}
    ways |= {each["sensor"]: each for each in found["also"]}
    own = finite_mean(number(item["mu_psnr_db"]) for item in found["items"]), found["mean"]
    return {"as hdr-v1": own} | {
        name: (each["mean_mu_psnr_db"], each["mean_psnr_db"]) for name, each in ways.items()
    }


def rows_text(results: Sequence[dict[str, Any]]) -> str:
    """Return the rows as a table in Markdown: PSNR-mu and linear PSNR under each condition."""
    conditions = list(conditions_of(results[0]))
    rows = [["PSNR-mu / linear, dB", *conditions], ["---"] * (len(conditions) + 1)]
    for found in results:
        cells = (f"{mu:.1f} / {linear:.1f}" for mu, linear in conditions_of(found).values())
        rows.append([found["method"], *cells])
    return "\n".join(f"| {' | '.join(row)} |" for row in rows) + "\n"


def _settings(name: str) -> dict[str, Any]:
    if name in DESIGNED:
        return {"exposures": DESIGNED[name], "designed": "for each crop by its own light"}
    looks, percent = ROWS[name]
    return {"looks": list(looks), "level": f"{percent:g}%"}


def _target(protocol: Protocol) -> Target:
    """Return scamp5 with the protocol's array and range."""
    size, well = int(protocol["crop_size"]), float(protocol["full_well_e"])
    return replace(
        builtin_target("scamp5"), rows=size, cols=size, full_well_e=well, register_max_e=well,
        register_min_e=-well, adc_bits=int(protocol["adc_bits"]),
    )  # fmt: skip


def _programs(name: str, target: Target, sensor: Sensor) -> Callable[[Scene], Container]:
    """Return what gives the words for a crop: those of a row, or a crop's own."""
    if name in ROWS:
        words = _compiled(row_of(name, target), target)
        return lambda _: words
    chip, known = Chip.of(target, sensor), dict[tuple[Any, ...], Container]()

    def own(crop: Scene) -> Container:
        place = (crop.file.name, crop.crop, float(crop.light_e.sum()))
        if place not in known:
            model = Model(chip, histogram([crop.light_e]), [1.0] * SLOTS)
            known[place] = _compiled(model.best(DESIGNED[name] - 1, "mu"), target)
        return known[place]

    return own


def _compiled(schedule: Schedule, target: Target) -> Container:
    text = looking_text(schedule, SLOTS, 125.0, target, None, "")
    made = compile_source(Source("looks.nsl", text), Path(), Options(target=target)).container
    assert made is not None
    return made
