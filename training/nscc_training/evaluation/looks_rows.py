"""The methods of hdr-v1 without a decoder: pixels that look at their light, and a bracket.

The programs are compiled and their words run on the emulator, with the protocol's noise and
comparator noise, or with other effects. The `designed` methods design a program for each crop
(`nscc design`). The bracket has three readouts in one exposure time."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from nscc.arrays import Array, Floats
from nscc.chips.load import builtin_target
from nscc.chips.target import Target
from nscc.compiler import compile_source
from nscc.mappings import JsonObject
from nscc.options import Options
from nscc.program.looking import level_steps
from nscc.source import Source
from nscc.words.container import Container
from nscc_runtime import Capture, capture
from nscc_runtime.effects import Selection, selected
from nscc_runtime.light import Light
from nscc_runtime.looked_light import DEVIATION, LIGHT, merged_image
from nscc_runtime.response import response_of
from nscc_runtime.sensor import Sensor, load_sensor
from nscc_training.command_settings import EvaluationSettings
from nscc_training.design.bracket import bracket_slots, camera, merged_bracket
from nscc_training.design.chip import DesignChip
from nscc_training.design.looking import LookModel, LookSchedule
from nscc_training.design.scene import histogram
from nscc_training.design.text import looking_text
from nscc_training.evaluation.results import (
    Evaluated,
    Scored,
    ScoredMethod,
    Scorer,
    also_saturated,
    result_of,
    usable_scenes,
)
from nscc_training.protocol_scenes.file_scenes import files_of, scenes_in
from nscc_training.protocol_scenes.protocol_scene import ProtocolScene
from nscc_training.protocols import load_protocol

SLOTS = 256
"""Slots of hdr-v1."""
ROWS: dict[str, tuple[tuple[int, ...], float]] = {
    "looks-2": ((16,), 6.25),
    "looks-5": ((1, 4, 16, 64), 22.0),
    "looks-9": ((1, 2, 4, 8, 16, 32, 64, 128), 45.0),
}
"""For each method the boundaries of the looks, and the closing level in percent of a full well.

The last exposure ends with the frame."""
DESIGNED = {"designed-2": 2, "designed-5": 5}
"""The number of exposures of each designed method."""
BRACKET = "bracket"
UNDECODED = (*ROWS, *DESIGNED, BRACKET)

_EFFECTS = "full_well,shot,adc_noise,comparator_noise"
"""The effects of the protocol's sensor, with the noise of comparators."""


def row_of(name: str, target: Target) -> LookSchedule:
    """Return the looks of the method `name`, a key of ROWS (else KeyError), on a chip: boundaries,
    and levels in steps of IN (the level sent to all pixels), which depend on its full well."""
    at, percent = ROWS[name]
    return LookSchedule(at, (level_steps(percent, "%", target),) * len(at))


def evaluate_looks(wanted: EvaluationSettings, scorer: Scorer | None = None) -> Evaluated:
    """Return the result of `wanted.subject`, a method of UNDECODED, on a folder of panoramas, as
    JSON values, and the arrays of `--save` by name.

    `scorer` keeps scores (None: in memory). `wanted.effects` replace the protocol's noise and
    comparator noise, and then the readout has the noise of the chip. Programs are designed for the
    sensor without `wanted.changes`."""
    protocol, scorer = load_protocol("hdr-v1"), scorer or Scorer()
    name, effects, changes = wanted.subject, wanted.effects, wanted.changes
    files = files_of(protocol, wanted.data)
    usable, left_out = usable_scenes(scenes_in(files, protocol), protocol)
    size, well = int(protocol["crop_size"]), float(protocol["full_well_e"])
    target = replace(
        builtin_target("scamp5"),
        rows=size,
        cols=size,
        full_well_e=well,
        register_max_e=well,
        register_min_e=-well,
        adc_bits=int(protocol["adc_bits"]),
    )
    noise_settings = (
        ()
        if effects
        else (f"adc_noise_lsb={float(protocol['read_noise_lsb'])}", "spread_noise_lsb=0.0")
    )
    program = _programs(name, target, load_sensor(target, None, noise_settings))
    sensor = load_sensor(target, None, (*noise_settings, *changes))
    chosen = selected(effects or _EFFECTS)

    def decoded(shown: Sequence[ProtocolScene | None]) -> list[Scored]:
        """Return the scores of the scenes `shown`, which are exposed on the emulator. The light is
        what the pixels measure, without a decoder."""

        def decode(crop: ProtocolScene, index: int) -> tuple[Floats, float]:
            """Return the light that the pixels measure of a scene; nothing is decoded, so the
            time is 0."""
            # Each scene has its own noise; all are exposed on the same chip, number 0.
            seeds = 1000 * wanted.seed + index, 0
            measure = bracket_light if name == BRACKET else looked_light
            return measure(program(crop), crop.light_e, sensor, chosen, seeds), 0.0

        return scorer.scored(shown, decode)

    method: JsonObject
    if name == BRACKET:
        method = {"slots": [*bracket_slots(SLOTS)]}
    elif name in DESIGNED:
        method = {"exposures": DESIGNED[name], "designed": "for each crop by its own light"}
    else:
        looks, percent = ROWS[name]
        method = {"looks": list(looks), "level": f"{percent:g}%"}
    settings = {"effects": effects or _EFFECTS, "sensor_changes": [*changes], "seed": wanted.seed}
    return result_of(
        protocol,
        ScoredMethod(name, {**method, **settings}, decoder_ms=0.0),
        files,
        decoded(usable),
        left_out,
        **also_saturated(files, protocol, decoded),
    )


def looked_light(
    container: Container,
    light_e: Array,
    sensor: Sensor,
    effects: Selection | str,
    seeds: tuple[int, int],
) -> Floats:
    """Return the light over the frame in electrons (rows, cols) that pixels which look measure of
    the constant light `light_e`, of this shape.

    `container` is the program of pixels that look (another raises KeyError), `sensor` that of the
    chip, and `effects` a selection or the names of effects. `seeds` are those of the noise and of
    the device."""
    readings = _still_capture(container, light_e, sensor, effects, seeds).told
    return merged_image(readings[LIGHT], readings[DEVIATION]) * float(container.slot_s.sum())


def bracket_light(
    container: Container,
    light_e: Array,
    sensor: Sensor,
    effects: Selection,
    seeds: tuple[int, int],
) -> Floats:
    """Return the light over the frame in electrons (rows, cols) that an ordinary bracket measures
    of the constant light `light_e`, of this shape.

    `container` is the program of a camera with several readouts. The frame has these `effects`;
    `seeds` are those of noise and of the device."""
    taken = _still_capture(container, light_e, sensor, effects, seeds)
    response = response_of(container, sensor, effects)
    exposure_e = response.electrons(taken.frame) * response.gain
    open_share = container.table.shutters[0].mean(axis=-1)
    chip = DesignChip(container.target, sensor, effects)
    return merged_bracket(exposure_e, open_share, taken.saturated, chip)


def _still_capture(
    container: Container,
    light_e: Array,
    sensor: Sensor,
    effects: Selection | str,
    seeds: tuple[int, int],
) -> Capture:
    """Return the frame that `container` exposes of the constant light `light_e`, (rows, cols) in
    electrons over the frame, under `effects`; `seeds` are those of noise and of the device."""
    slot_s = container.slot_s
    # A still is stored as electrons per second.
    light = Light.of_still((light_e / float(slot_s.sum())).astype(np.float32), slot_s)
    return capture(
        container, light, sensor=sensor, effects=effects, seed=seeds[0], device_seed=seeds[1]
    )


def _programs(name: str, target: Target, sensor: Sensor) -> Callable[[ProtocolScene], Container]:
    """Return a function that takes a scene (a crop of a panorama) and returns the compiled program
    to expose it with.

    `name` is that of a row of the table: a key of `ROWS` (fixed looks), `BRACKET`, or a key of
    `DESIGNED`. The program of the first two is the same for all scenes. A designed one is made for
    the light of each scene, with the noise of `sensor`."""
    if name in ROWS:
        words = _compiled(row_of(name, target), target)
        return lambda _: words
    if name == BRACKET:
        # 125.0: the length of a slot in microseconds.
        readouts = camera(SLOTS, 125.0, target, lengths=bracket_slots(SLOTS))
        return lambda _: readouts
    chip = DesignChip.of(target, sensor)

    def words_for(crop: ProtocolScene) -> Container:
        """Design the looks for the light of a crop, and return the compiled program."""
        # Slots of equal length: the times of looks count only as parts of the frame.
        model = LookModel(chip, histogram([crop.light_e]), [1.0] * SLOTS)
        return _compiled(model.best(DESIGNED[name] - 1, "mu"), target)

    return words_for


def _compiled(schedule: LookSchedule, target: Target) -> Container:
    """Return the compiled program of pixels that look as the schedule says, with `SLOTS` slots of
    125 us. Raise Rejected if it does not fit the chip."""
    text = looking_text(schedule, SLOTS, 125.0, target, None, "")
    return compile_source(Source("looks.nsl", text), Path(), Options(target=target)).built
