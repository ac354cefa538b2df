"""The rows of hdr-v1 whose pixels look at the light: no decoder, an exposure over its own time.

The programs are compiled, and their words run on the emulator: with the protocol's noise and a
comparator's, and beside it with all effects of the sensor and with other comparators. Of `designed`
rows each crop has a program of its own, made for the light that it has (`nscc design`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.compiler import compile_source
from nscc.diagnostics.rejection import rejected
from nscc.files import write_whole
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
from nscc_training import metrics
from nscc_training.design.chip import Chip
from nscc_training.design.looking import Model, Schedule
from nscc_training.design.scene import histogram
from nscc_training.design.text import looking_text
from nscc_training.evaluation.hdr import Crop, Picture, also_saturated, panoramas, parted
from nscc_training.evaluation.result_text import result_json
from nscc_training.evaluation.results import (
    Item,
    Scene,
    Scored,
    Subject,
    read_result,
    scored,
    with_arrays,
)
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
DESIGNED = {"designed-2": 2, "designed-5": 5}
"""Exposures of the rows that are designed."""
LOOKING = (*ROWS, *DESIGNED)

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
    """The result of one of LOOKING on a folder of panoramas, and its pictures: arrays by name.

    Beside the score, `also` has its means with all effects of the sensor, and with comparators of
    other noise and offset.
    """
    protocol = load_protocol("hdr-v1")
    files = panoramas(folder)
    usable, left_out = parted(files, protocol)
    target = _target(protocol)
    read_noise_lsb = float(protocol["read_noise_lsb"])
    sensor = default_sensor(target).changed(adc_noise_lsb=read_noise_lsb, spread_noise_lsb=0.0)
    program = _programs(name, target, sensor)
    effects = selected(_EFFECTS)
    every = _decoded(usable, program, sensor, effects, seed)

    def items(others: list[Crop]) -> list[Item]:
        return [each.item for each in _decoded(others, program, sensor, effects, seed)]

    tried = [(EVERY_EFFECT, sensor, selected("all"))]
    for size in _COMPARATORS:
        values = {"comparator_noise_fraction": size, "comparator_offset_fraction": size}
        both = selected(f"{_EFFECTS},comparator_offset")
        tried.append((comparators(size), sensor.changed(**values), both))
    also = [
        {"sensor": what, **_means(_decoded(usable, program, other, chosen, seed))}
        for what, other, chosen in tried
    ]
    subject = Subject(name, {**_settings(name), "effects": _EFFECTS, "seed": seed}, decoder_ms=0.0)
    passed = [crop.as_json() for crop in left_out]
    others = also_saturated(files, protocol, items)
    return with_arrays(protocol, subject, files, every, passed, also_saturated=others, also=also)


def every_row(
    folder: Path,
    results: Path,
    seed: int = 0,
    progress: Callable[[Sequence[str]], Iterable[str]] = iter,
) -> list[dict[str, Any]]:
    """The results of all LOOKING on a folder of panoramas. Each is written to `results` as
    NAME.json as soon as it is done, and one that is there is not done again.

    Rejected (NS0807) for a file of that name that is no result, NS0808 for one of other data.
    """
    data = {path.name for path in panoramas(folder)}
    found = []
    for name in progress(LOOKING):
        path = results / f"{name}.json"
        if not path.is_file():
            made, _ = evaluate_looks(name, folder, seed)
            results.mkdir(parents=True, exist_ok=True)
            write_whole(path, result_json(made).encode())
        kept = read_result(path)
        if {each["file"] for each in kept["data"]} != data:
            raise rejected(
                "NS0808",
                f"'{path}' is of other panoramas than '{folder}'",
                helps=("name another folder for --results, or remove the file",),
            )
        found.append(kept)
    return found


def rows_text(results: Sequence[dict[str, Any]]) -> str:
    """The rows as a table in Markdown: means of PSNR-mu and linear PSNR under each condition."""
    conditions = [PROTOCOL, *(saturated(part) for part in (0.1, 0.5)), EVERY_EFFECT]
    conditions += [comparators(size) for size in _COMPARATORS]
    lines = ["| PSNR-mu / linear, dB | " + " | ".join(conditions) + " |"]
    lines.append("|---" * (len(conditions) + 1) + "|")
    for found in results:
        cells = (means_under(found, each) for each in conditions)
        texts = (f"{mu:.1f} / {linear:.1f}" for mu, linear in cells)
        lines.append(f"| {found['method']} | " + " | ".join(texts) + " |")
    return "\n".join(lines) + "\n"


PROTOCOL, EVERY_EFFECT = "as hdr-v1", "all effects"


def saturated(part: float) -> str:
    """What a condition is called under which so many pixels saturate."""
    return f"{part:.0%} saturated"


def comparators(size: float) -> str:
    """What a condition is called whose comparators have that noise and offset."""
    return f"comparators of {size:.0%} noise and offset"


def means_under(found: dict[str, Any], condition: str) -> tuple[float, float]:
    """The means of PSNR-mu and of linear PSNR that a result has under a condition; KeyError for one
    that it does not have."""
    if condition == PROTOCOL:
        scores = [number(item["mu_psnr_db"]) for item in found["items"]]
        return metrics.finite_mean(scores), found["mean"]
    ways = {each["sensor"]: each for each in found["also"]}
    ways |= {saturated(each["saturated_fraction"]): each for each in found["also_saturated"]}
    return ways[condition]["mean_mu_psnr_db"], ways[condition]["mean_psnr_db"]


def _settings(name: str) -> dict[str, Any]:
    if name in DESIGNED:
        return {"exposures": DESIGNED[name], "designed": "for each crop by its own light"}
    looks, percent = ROWS[name]
    return {"looks": list(looks), "level": f"{percent:g}%"}


def _target(protocol: Protocol) -> Target:
    """scamp5 with the protocol's array and range."""
    size, well = int(protocol["crop_size"]), float(protocol["full_well_e"])
    return replace(
        builtin_target("scamp5"), rows=size, cols=size, full_well_e=well, register_max_e=well,
        register_min_e=-well, adc_bits=int(protocol["adc_bits"]),
    )  # fmt: skip


Programs = Callable[[Crop], Container]


def _programs(name: str, target: Target, sensor: Sensor) -> Programs:
    """The words for a crop: those of a row, or a crop's own."""
    if name in ROWS:
        made = _compiled(row_of(name, target), target)
        return lambda _: made
    chip, known = Chip.of(target, sensor), dict[tuple[Any, ...], Container]()

    def own(crop: Crop) -> Container:
        place = (crop.file.name, crop.corner, float(crop.light_e.sum()))
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


def _decoded(
    usable: list[Crop], program: Programs, sensor: Sensor, effects: Selection, seed: int
) -> list[Scored]:
    def decode(crop: Scene, index: int) -> tuple[Picture, float]:
        assert isinstance(crop, Crop)
        container = program(crop)
        slot_s = np.array(container.slot_us) * 1e-6
        frame_s = float(slot_s.sum())
        light = Light.of_still((crop.light_e / frame_s).astype(np.float32), slot_s)
        noise = 1000 * seed + index
        told = capture(container, light, sensor=sensor, effects=effects, seed=noise).told
        return merged_image(told[LIGHT], told[DEVIATION]) * frame_s, 0.0

    return list(scored(usable, decode, []))


def _means(every: list[Scored]) -> dict[str, float]:
    names = ("psnr_db", "ssim", "mu_psnr_db", "pu21_psnr_db")
    return {
        f"mean_{name}": metrics.finite_mean(number(each.item.metrics[name]) for each in every)
        for name in names
    }
