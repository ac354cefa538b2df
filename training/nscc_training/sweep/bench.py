"""Scenes of a protocol, captured by the emulated chip and decoded without training."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import lru_cache
from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np

from nscc.arrays import Array
from nscc.chips.load import load_target
from nscc.chips.target import Target
from nscc.options import Options
from nscc.pipeline import Compiled, run_passes
from nscc.source import Source
from nscc.words.container import Container
from nscc_runtime.light import Light
from nscc_runtime.request import Request
from nscc_runtime.sensor import Sensor
from nscc_runtime.simulate import simulate
from nscc_training.design.chip import DesignChip
from nscc_training.design.looking import LookModel, LookSchedule
from nscc_training.design.scene import histogram
from nscc_training.design.text import looking_text
from nscc_training.emulated import light_on_array
from nscc_training.encoders.base import Encoder
from nscc_training.evaluation.looks_rows import ROWS as LOOKING_ROWS
from nscc_training.evaluation.looks_rows import SLOTS, looked_light, row_of
from nscc_training.evaluation.methods import CLIPS, STILLS, CapturedScene
from nscc_training.experiments.engine import Figures
from nscc_training.measures import number
from nscc_training.metrics import finite_mean
from nscc_training.programs import Chip
from nscc_training.protocol_scenes.file_scenes import Kind, protocol_of, some_scenes
from nscc_training.protocol_scenes.protocol_scene import ProtocolScene
from nscc_training.sensor_model import SensorModel
from nscc_training.sweep.point import Values
from nscc_training.sweep.point_programs import compiled_of, encoder_of, sensor_of, whole_ticks

LONG_US = 1000.0
"""A slot length that all words fit into."""
_ITERATIONS = 20
"""Iterations of GAP-TV."""


def bench_figures(values: Values) -> Figures:
    """Return the figures of a class of shutters on scenes: mean PSNR, words (instructions of the
    chip), and the shortest slot. `values` are those of a point of kind emulate with a `bench`.

    `at_us` is the slot length; None takes the shortest possible slots. Words depend on the slot
    length only because stored values are refreshed, which shorter slots need less often. So
    programs are compiled for long slots first."""
    slot_us = values["at_us"]
    if slot_us is None:
        longest = compiled_of({**values, "slot_us": LONG_US})
        slot_us = whole_ticks(longest.shortest_slot_us)
    compiled = compiled_of({**values, "slot_us": slot_us})
    return scenes_of(values).figures(compiled, encoder_of(values))


def looks_figures(values: Values) -> Figures:
    """Return the figures of `bench_figures` for pixels that look. `values` are those of the point.

    The looks are those of a method of hdr-v1 with this number of `exposures`, or with `designed`
    they are designed for the scenes."""
    scenes = scenes_of(values)
    name = f"looks-{values['exposures']}"
    looks = (
        scenes.designed(values["exposures"])
        if values["designed"]
        else (row_of(name, scenes.target))
    )
    chip = Chip(values["target"])
    named = chip.target if chip.file is None else None

    def compiled(slot_us: float) -> Compiled:
        """Compile the program of the looks with slots of `slot_us` microseconds."""
        text = looking_text(looks, SLOTS, slot_us, scenes.target, named, "")
        options = Options(
            level=values["level"], codes="open", lowering="edges", target=chip.file, cache=False
        )
        return run_passes(Source("shutter.nsl", text), Path(), options)

    slot_us = values["at_us"] or whole_ticks(compiled(LONG_US).shortest_slot_us)
    return scenes.figures(compiled(slot_us), looks)


def is_looks_row(exposures: int) -> bool:
    """Return whether hdr-v1 has a method of pixels that look with this number of exposures."""
    return f"looks-{exposures}" in LOOKING_ROWS


@dataclass(frozen=True, eq=False)
class BenchScenes:
    """Scenes of one kind, and the emulated chip (`target` and `sensor`) that captures them under
    `effects`. `seed` seeds noise and chip. `model` is its sensor for decoders.

    `known` holds the scores of frames, by their digest, so that equal frames are decoded once."""

    scenes: tuple[ProtocolScene, ...]
    target: Target
    sensor: Sensor
    model: SensorModel
    effects: str
    seed: int
    known: dict[bytes, float] = field(default_factory=dict)

    def designed(self, exposures: int) -> LookSchedule:
        """Return the looks with this number of `exposures` that have the smallest expected linear
        error on the scenes, which are stills with light."""
        lights = histogram([scene.light_e for scene in self.scenes])
        model = LookModel(DesignChip.of(self.target, self.sensor), lights, [1.0] * SLOTS)
        return model.best(exposures - 1, "linear")

    def figures(self, compiled: Compiled, shutters: Encoder | LookSchedule) -> Figures:
        """Return the words and the shortest slot of the program `compiled`, and the mean PSNR over
        scenes, in dB, with a decoder that needs no training. Infinite scores are left out of the
        mean unless all are.

        `shutters` are the codes, or the looks, that the program was compiled from."""
        container = compiled.built
        scores = (
            self._looked_db(container, scene, index)
            if isinstance(shutters, LookSchedule)
            else self._decoded_db(shutters, container, scene, index)
            for index, scene in enumerate(self.scenes)
        )
        return {
            "psnr_db": finite_mean(scores),
            "words": container.words_per_frame,
            "shortest_slot_us": compiled.shortest_slot_us,
        }

    def request(self, index: int) -> Request:
        """Return the effects of a frame, and its seeds: of its noise for scene number `index`, and
        of the chip."""
        seed = 1000 * self.seed + index
        return Request.of(effects=self.effects, seed=seed, device_seed=self.seed)

    def _looked_db(self, container: Container, scene: ProtocolScene, index: int) -> float:
        """Return the PSNR in dB of scene number `index` that pixels which look measure, without a
        decoder."""
        seeds = 1000 * self.seed + index, self.seed
        light = looked_light(container, scene.light_e, self.sensor, self.effects, seeds)
        return number(scene.scores(light)["psnr_db"])

    def _decoded_db(
        self, encoder: Encoder, container: Container, scene: ProtocolScene, index: int
    ) -> float:
        """Return the PSNR in dB of scene number `index`, exposed with the program of the codes in
        `encoder` and decoded.

        `container` is the compiled program. Equal frames are decoded once."""
        light = _light(scene, encoder.spec.slots, self.target)
        shot = simulate(container, light, self.sensor, self.request(index)).frame
        codes = (shot.frame[:1] - self.model.adc_offset_lsb).astype(np.float32)
        tile = encoder.hard().numpy()[None]
        frames = CapturedScene(scene, codes, tile, shot.saturated[:1], self.model)
        # The words of open and of fixed codes often give the same frame.
        digest = sha256(b"".join(a.tobytes() for a in (codes, frames.saturated, tile))).digest()
        if digest not in self.known:
            self.known[digest] = number(scene.scores(_decoded(frames))["psnr_db"])
        return self.known[digest]


def scenes_of(values: Values) -> BenchScenes:
    """Return the scenes of a point, at the size of the target's array."""
    names = ("bench", "target", "effects", "seed", "frames", "data", "scenes", "sensor.file")
    changes = tuple((n, v) for n, v in values.items() if n.startswith("sensor."))
    return _scenes(tuple((name, values[name]) for name in names) + changes)


@lru_cache(maxsize=2)  # clips and stills
def _scenes(items: tuple[tuple[str, Any], ...]) -> BenchScenes:
    """Return the scenes that the values of a point describe (`items` are pairs of name and value,
    so that they can be cached), cut to the array, with target and sensor."""
    values: Mapping[str, Any] = dict(items)
    target = load_target(values["target"], Path())
    sensor = sensor_of(values, target)
    kind: Kind = values["bench"]
    size, data = max(target.rows, target.cols), values["data"]
    protocol = protocol_of(kind, size, values["frames"], sensor.full_well_e)
    scenes = tuple(
        replace(scene, light_e=scene.light_e[..., : target.rows, : target.cols])
        for scene in some_scenes(
            protocol, Path(data) if data else None, values["scenes"], values["seed"]
        )
    )
    model = SensorModel.of(sensor, target)
    return BenchScenes(scenes, target, sensor, model, values["effects"], values["seed"])


def _decoded(frames: CapturedScene) -> Array:
    """Return the light of frames in electrons: neighbours are merged for stills, clips are decoded
    by GAP-TV. If a decoded clip has fewer slots than the truth has frames, each slot is repeated
    and its light is divided among the copies. The result then has the frames of the truth."""
    if frames.is_still:
        return STILLS["merged"].decode(frames)
    decoded = CLIPS["gap-tv"].decode(frames, iterations=_ITERATIONS)
    joined = len(frames.scene.light_e) // len(decoded)
    return np.repeat(decoded / joined, joined, axis=0)


def _light(scene: ProtocolScene, slots: int, target: Target) -> Light:
    """Return a scene's light on the array. The frames of a clip, a multiple of `slots`, are joined
    to `slots` slots, which together last as long."""
    light_e = scene.light_e
    if light_e.ndim == 3:
        light_e = light_e.reshape(slots, -1, *light_e.shape[1:]).sum(axis=1)
    return light_on_array(light_e, slots, target)
