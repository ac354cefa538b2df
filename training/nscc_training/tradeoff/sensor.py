"""PSNR against the shortest slot: what a shutter class is worth, and what its words take."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import asdict, dataclass, field, replace
from functools import partial
from hashlib import sha256
from itertools import product
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from nscc.diagnostics.diagnostic import Diagnostic
from nscc.lower.plan import Lowering
from nscc.pipeline import Compiled
from nscc.program.program import Codes
from nscc.source import Source
from nscc.target.load import load_target
from nscc.target.target import Target
from nscc.tradeoff.points import Point, Refused
from nscc.tradeoff.rows import Rows
from nscc.tradeoff.synthesis import Case, Way, compiled_or_not
from nscc.words.container import Container
from nscc_runtime.light import Light
from nscc_runtime.sensor import Sensor, load_sensor
from nscc_runtime.simulate import Request, simulate
from nscc_training.baselines.sci import gap_tv
from nscc_training.design.chip import Chip as DesignChip
from nscc_training.encoders import ShutterSpec, make_encoder
from nscc_training.encoders.base import Encoder
from nscc_training.evaluation import hdr
from nscc_training.evaluation.hdr_looks import SLOTS
from nscc_training.measures import number
from nscc_training.programs import Chip, program_of
from nscc_training.sensor_model import SensorModel, laid
from nscc_training.tradeoff.looks import (
    Looking,
    looked_psnr_db,
    looking_kinds,
    looking_source,
    schedule_of,
)
from nscc_training.tradeoff.scenes import Kind, Scene, kinds_in, protocol_of, scenes
from nscc_training.tradeoff.ways import Taken, clip_light, merged_still

TILE = (8, 8)
ROWS = 64
_LONG_US = 1000.0
_ITERATIONS = 20
_TICK_US = 0.01
"""Slots are whole numbers of these: programs are for readers."""


@dataclass(frozen=True)
class Settings:
    """What to compare: `classes` in `slots` for clips, class b in `stop_slots` for stills, and for
    these pixels that look, with so many exposures (`looks`).

    A clip has `frames`, a multiple of all `slots`; None: the most of them. `slot_us` is what
    captures are made at, None for the shortest slot of each configuration. `sensor` is a file, by
    default that of every default, and `changes` are NAME=VALUE on top of it. Codes begin as `init`
    on a `tile`; None: random ones for clips, 2 x 2 stops for stills. Class c is open for `length`
    slots, None: a quarter of the frame; a codebook has `rows`.
    """

    classes: tuple[str, ...]
    slots: tuple[int, ...]
    stop_slots: tuple[int, ...]
    looks: tuple[int, ...]
    codes: tuple[Codes, ...]
    lowerings: tuple[Lowering, ...]
    target: str
    level: int
    effects: str
    slot_us: float | None
    data: Path | None
    count: int
    seed: int
    frames: int | None = None
    sensor: Path | None = None
    changes: tuple[str, ...] = ()
    tile: tuple[int, int] | None = None
    init: str | None = None
    length: int | None = None
    rows: int = ROWS


@dataclass(frozen=True)
class Configuration:
    """One shutter, one way to compile it.

    `exposures` are those of a pixel that looks, None of one that does not; such programs have one
    code and one lowering.
    """

    kind: Kind
    shutters: str
    slots: int
    codes: Codes
    lowering: Lowering
    exposures: int | None = None

    @property
    def method(self) -> str:
        """What stands in the tables."""
        if self.exposures is not None:
            return f"{self.shutters}-{self.exposures}"
        return f"{self.shutters}, {self.codes} codes, {self.lowering}"


@dataclass(frozen=True)
class Measured:
    """Points and what does not fit, in the order of the configurations."""

    points: tuple[Point, ...]
    refused: tuple[Refused, ...]
    target: str


Progress = Callable[[Sequence[Configuration]], Iterable[Configuration]]


def configurations(settings: Settings) -> list[Configuration]:
    """Every class, number of slots, way to take codes, and lowering."""
    kinds = ("clips", "stills") if settings.data is None else kinds_in(settings.data)
    shapes: list[tuple[Kind, str, int]] = []
    if "clips" in kinds:
        shapes += [("clips", *each) for each in product(settings.classes, settings.slots)]
    if "stills" in kinds:
        shapes += [("stills", "b", slots) for slots in settings.stop_slots]
    found = [
        Configuration(*shape, codes, lowering)
        for shape in shapes
        for codes, lowering in product(settings.codes, settings.lowerings)
    ]
    if "stills" in kinds:
        found += [
            Configuration("stills", kind, SLOTS, "open", "edges", exposures)
            for kind, exposures in looking_kinds(settings.looks)
        ]
    return found


def measure(settings: Settings, progress: Progress = iter, rows: Rows | None = None) -> Measured:
    """Compiles each configuration, and captures and decodes the scenes with its words.

    The time of a point is the shortest slot. What `rows` knows is not made again. Raises Rejected
    for data that does not serve, and for a target that does not exist.
    """
    target = load_target(settings.target, Path())
    todo = configurations(settings)
    benches = {kind: _bench(kind, target, settings) for kind in {each.kind for each in todo}}
    points: list[Point] = []
    refused: list[Refused] = []
    rows = rows or Rows()
    for each in progress(todo):
        name = f"{each.kind}, {each.method}, {each.slots}"
        found = rows.once(name, partial(_row, each, benches[each.kind], settings))
        if "code" in found:
            refused.append(Refused(**found))
        else:
            points.append(Point(**{**found, "times_ms": tuple(found["times_ms"])}))
    return Measured(tuple(points), tuple(refused), target.name)


def _row(each: Configuration, bench: _Bench, settings: Settings) -> dict[str, Any]:
    """The fields of a configuration's Point, or of what Refused says of it."""
    setting, shutters = f"{each.slots} slots", _shutters(each, bench, settings)
    found = compiled_for(each, shutters, settings)
    if isinstance(found, Diagnostic):
        return asdict(Refused(each.kind, each.method, setting, found.code, found.message))
    assert found.container is not None
    words = f"{setting}, {found.container.words_per_frame} words"
    psnr_db, slot_ms = shutters.psnr_db(found.container), found.shortest_slot_us / 1e3
    return asdict(
        Point(each.kind, each.method, words, psnr_db, "psnr_db", (slot_ms,), more_is_better=True)
    )


def compiled_for(
    each: Configuration, shutters: _Shutters, settings: Settings
) -> Compiled | Diagnostic:
    """The configuration compiled for the slots that it is captured with, or why it does not fit.

    Words do not depend on the slot's length but for refresh, which shorter slots need less of.
    """
    if settings.slot_us is not None:
        return _compiled(each, shutters, settings.slot_us, settings)
    found = _compiled(each, shutters, _LONG_US, settings)
    if isinstance(found, Diagnostic):
        return found
    ticks = math.ceil(found.shortest_slot_us / _TICK_US - 1e-6)
    return _compiled(each, shutters, max(1, ticks) * _TICK_US, settings)


def _compiled(
    each: Configuration, shutters: _Shutters, slot_us: float, settings: Settings
) -> Compiled | Diagnostic:
    chip = Chip(settings.target, slot_us)
    source = Source("shutter.nsl", shutters.text(chip))
    case = Case(each.method, source, Path(), each.codes, chip.file)
    return compiled_or_not(Way(case, each.lowering, settings.level))


class _Shutters(NamedTuple):
    """Shutters of a configuration: their program on a chip, and what its captures are worth."""

    text: Callable[[Chip], str]
    psnr_db: Callable[[Container], float]


def _shutters(each: Configuration, bench: _Bench, settings: Settings) -> _Shutters:
    if each.exposures is None:
        encoder = _encoder(each, settings)
        return _Shutters(
            lambda chip: program_of(encoder, chip).text,
            lambda container: bench.psnr_db(container, encoder, settings),
        )
    known = DesignChip.of(bench.target, bench.sensor)
    crops = [scene for scene in bench.shown if isinstance(scene, hdr.Crop)]
    kind: Looking = "looks" if each.shutters == "looks" else "designed"
    schedule = schedule_of(kind, each.exposures, known, crops)
    return _Shutters(
        lambda chip: looking_source(
            schedule, known, chip.slot_us, chip.target if chip.file is None else None
        ),
        lambda container: bench.looked_psnr_db(container, crops, settings),
    )


def _encoder(each: Configuration, settings: Settings) -> Encoder:
    """The codes that a configuration is captured with."""
    tile, start = ((2, 2), "quad") if each.kind == "stills" else (TILE, "random")
    length = settings.length or max(1, each.slots // 4)
    spec = ShutterSpec(
        each.shutters, each.slots, settings.tile or tile,
        length=length if each.shutters == "c" else None,
        rows=settings.rows if each.shutters == "codebook" else None,
    )  # fmt: skip
    return make_encoder(spec, settings.init or start, settings.seed)


@dataclass(frozen=True, eq=False)
class _Bench:
    """Scenes of one kind in front of one sensor; `known` are scores of captures seen before."""

    shown: tuple[Scene, ...]
    target: Target
    sensor: Sensor
    model: SensorModel
    known: dict[bytes, float] = field(default_factory=dict)

    def psnr_db(self, container: Container, encoder: Encoder, settings: Settings) -> float:
        """The mean over the scenes, by a decoder that needs no training."""
        scores = []
        for index, scene in enumerate(self.shown):
            request = Request.of(
                effects=settings.effects, seed=1000 * settings.seed + index,
                device_seed=settings.seed,
            )  # fmt: skip
            light = _light(scene, encoder.spec.slots)
            shot = simulate(container, light, self.sensor, request).frame
            frame = (shot.frame[0] - self.model.adc_offset_lsb).astype(np.float32)
            saturated = shot.saturated[0]
            mask = laid(encoder.hard(), *frame.shape).numpy().astype(np.float32)
            # The words of open and of fixed codes often give the same frame.
            digest = sha256(b"".join(a.tobytes() for a in (frame, saturated, mask))).digest()
            if digest not in self.known:
                self.known[digest] = self._decoded(Taken(scene, frame, saturated, mask, self.model))
            scores.append(self.known[digest])
        return float(np.mean(scores))

    def looked_psnr_db(
        self, container: Container, crops: Sequence[hdr.Crop], settings: Settings
    ) -> float:
        """The same of pixels that look, without a decoder."""
        seeds = [1000 * settings.seed + index for index in range(len(crops))]
        return float(np.mean([
            looked_psnr_db(container, crop, self.sensor, settings.effects, seed, settings.seed)
            for crop, seed in zip(crops, seeds, strict=True)
        ]))  # fmt: skip

    def _decoded(self, taken: Taken) -> float:
        scene = taken.scene
        if isinstance(scene, hdr.Crop):
            return number(scene.scores(merged_still(taken))["psnr_db"])
        made = clip_light(partial(gap_tv, iterations=_ITERATIONS), taken)
        each = len(scene.light_e) // len(made)
        return number(scene.scores(np.repeat(made / each, each, axis=0))["psnr_db"])


def _bench(kind: Kind, target: Target, settings: Settings) -> _Bench:
    sensor = load_sensor(target, settings.sensor, settings.changes)
    size, frames = max(target.rows, target.cols), settings.frames or max(settings.slots, default=1)
    protocol = protocol_of(kind, size, frames, sensor.full_well_e)
    shown = tuple(
        replace(scene, light_e=scene.light_e[..., : target.rows, : target.cols])
        for scene in scenes(kind, protocol, settings.data, settings.count, settings.seed)
    )
    return _Bench(shown, target, sensor, SensorModel.of(sensor, target))


def _light(scene: Scene, slots: int) -> Light:
    """A scene's light in so many slots, which last as long as all of its frames."""
    if isinstance(scene, hdr.Crop):
        return Light.of_still(scene.light_e.astype(np.float32), np.full(slots, 1.0 / slots))
    frames, rows, cols = scene.light_e.shape
    summed = scene.light_e.reshape(slots, frames // slots, rows, cols).sum(axis=1)
    return Light.of_clip(summed.astype(np.float32))


def refusals_text(refused: Sequence[Refused]) -> list[str]:
    """What does not fit, those together that have one reason."""
    together: dict[tuple[str, str], list[str]] = {}
    for each in refused:
        name = f"{each.case}, {each.method}, {each.setting}"
        together.setdefault((each.code, each.reason), []).append(name)
    lines = []
    for (code, reason), names in together.items():
        lines += ["", f"does not fit: {reason} ({code})", *(f"  {name}" for name in names)]
    return lines
