"""Measurement of PSNR against the shortest slot, for shutter classes."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import asdict, dataclass, field, replace
from functools import partial
from hashlib import sha256
from itertools import product
from pathlib import Path

import numpy as np

from nscc.chips.load import load_target
from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Diagnostic
from nscc.experiment_store import Rows
from nscc.lower.exposure_plan import Lowering
from nscc.pipeline import Compiled
from nscc.program.program import Codes
from nscc.source import Source
from nscc.tradeoff.points import Point, Refused
from nscc.tradeoff.synthesis import CompileVariant, SynthesisCase, compiled_or_not
from nscc.words.container import Container
from nscc_runtime.light import Light
from nscc_runtime.request import Request
from nscc_runtime.sensor import Sensor, load_sensor
from nscc_runtime.simulate import simulate
from nscc_training.design.chip import DesignChip
from nscc_training.design.looking import LookModel, LookSchedule
from nscc_training.design.scene import histogram
from nscc_training.design.text import looking_text
from nscc_training.encoders import ShutterSpec, make_encoder
from nscc_training.encoders.base import Encoder
from nscc_training.evaluation.looks_rows import ROWS as LOOKING_ROWS
from nscc_training.evaluation.looks_rows import SLOTS, looked_light, row_of
from nscc_training.evaluation.methods import CLIPS, STILLS, CapturedScene
from nscc_training.measures import number
from nscc_training.metrics import finite_mean
from nscc_training.programs import Chip, program_of
from nscc_training.protocol_scenes.file_scenes import Kind, kinds_in, protocol_of, some_scenes
from nscc_training.protocol_scenes.protocol_scene import ProtocolScene
from nscc_training.sensor_model import SensorModel
from nscc_training.tradeoff.bench import whole_ticks

_LONG_US = 1000.0
_ITERATIONS = 20


@dataclass(frozen=True)
class SensorStudySettings:
    """The settings of the measurement of shutters on a chip.

    Clips are captured with `classes` in `slots`; stills with class b in `stop_slots`, and with
    pixels that look and have `looks` exposures. A clip has `frames`, a multiple of all `slots`;
    None uses the largest of `slots`. Captures use slots of `slot_us`; None uses the shortest slot
    of each configuration. `sensor` is a sensor file, None for the default sensor; `changes` are
    NAME=VALUE. Codes start as `init` on a `tile`; None uses random codes for clips and 2 x 2 stops
    for stills. Class c is open for `length` slots, None for a quarter of the frame; a codebook has
    `rows`."""

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
    rows: int = 64


@dataclass(frozen=True)
class Configuration:
    """A shutter class with a number of slots, or of `exposures` of pixels that look, compiled in
    one way."""

    kind: Kind
    shutters: str
    slots: int
    codes: Codes
    lowering: Lowering
    exposures: int | None = None

    @property
    def method(self) -> str:
        """The name of the configuration in tables."""
        if self.exposures is not None:
            return f"{self.shutters}-{self.exposures}"
        return f"{self.shutters}, {self.codes} codes, {self.lowering}"


@dataclass(frozen=True)
class SensorStudyResult:
    """Measured points and refused configurations, in the order of the configurations."""

    points: tuple[Point, ...]
    refused: tuple[Refused, ...]
    target: str


Progress = Callable[[Sequence[Configuration]], Iterable[Configuration]]


def configurations(settings: SensorStudySettings) -> list[Configuration]:
    """Return all combinations of class, number of slots, kind of codes, and lowering."""
    kinds = ("clips", "stills") if settings.data is None else kinds_in(settings.data)
    shapes: list[tuple[Kind, str, int]] = []
    if "clips" in kinds:
        shapes += [
            ("clips", *class_and_slots)
            for class_and_slots in product(settings.classes, settings.slots)
        ]
    if "stills" in kinds:
        shapes += [("stills", "b", slots) for slots in settings.stop_slots]
    all_configurations = [
        Configuration(*shape, codes, lowering)
        for shape in shapes
        for codes, lowering in product(settings.codes, settings.lowerings)
    ]
    if "stills" in kinds:
        known = [k for k in settings.looks if f"looks-{k}" in LOOKING_ROWS]
        looking = [("looks", k) for k in known] + [("designed", k) for k in settings.looks]
        all_configurations += [
            Configuration("stills", name, SLOTS, "open", "edges", exposures)
            for name, exposures in looking
        ]
    return all_configurations


def measure(
    settings: SensorStudySettings, progress: Progress = iter, rows: Rows | None = None
) -> SensorStudyResult:
    """Compile each configuration, capture the scenes with its words, and decode them.

    The time of a point is the shortest slot. Measurements in `rows` are reused. Raises Rejected for
    unsuitable data and for an unknown target."""
    target = load_target(settings.target, Path())
    todo = configurations(settings)
    benches = {
        kind: SensorBench.of(kind, target, settings)
        for kind in {configuration.kind for configuration in todo}
    }
    measures = (
        (
            f"{configuration.kind}, {configuration.method}, {configuration.slots}",
            partial(_measured, configuration, benches[configuration.kind]),
        )
        for configuration in progress(todo)
    )
    return SensorStudyResult(*points_of(measures, rows), target.name)


def points_of(
    measures: Iterable[tuple[str, Callable[[], Point | Refused]]], rows: Rows | None
) -> tuple[tuple[Point, ...], tuple[Refused, ...]]:
    """Return the points and refused settings of measurements; those in `rows` are reused."""
    points: list[Point] = []
    refused: list[Refused] = []
    rows = rows or Rows()
    for name, measured in measures:
        row = rows.once(name, lambda measured=measured: asdict(measured()))  # type: ignore[misc]
        if "code" in row:
            refused.append(Refused(**row))
        else:
            points.append(Point(**{**row, "times_ms": tuple(row["times_ms"])}))
    return tuple(points), tuple(refused)


def _measured(configuration: Configuration, bench: SensorBench) -> Point | Refused:
    setting = f"{configuration.slots} slots"
    shutters = (
        _encoder(configuration, bench.settings)
        if configuration.exposures is None
        else bench.schedule(configuration)
    )
    compiled = compiled_for(configuration, shutters, bench)
    if isinstance(compiled, Diagnostic):
        return Refused(
            configuration.kind, configuration.method, setting, compiled.code, compiled.message
        )
    assert compiled.container is not None
    words = f"{setting}, {compiled.container.words_per_frame} words"
    psnr_db, slot_ms = bench.psnr_db(compiled.container, shutters), compiled.shortest_slot_us / 1e3
    return Point(
        configuration.kind, configuration.method, words, psnr_db, "psnr_db", (slot_ms,),
        more_is_better=True,
    )  # fmt: skip


def compiled_for(
    configuration: Configuration, shutters: Encoder | LookSchedule, bench: SensorBench
) -> Compiled | Diagnostic:
    """Return the configuration compiled for its capture slots, or why it does not fit."""
    settings = bench.settings

    def compiled(slot_us: float) -> Compiled | Diagnostic:
        chip = Chip(settings.target, slot_us)
        if isinstance(shutters, LookSchedule):
            named = chip.target if chip.file is None else None
            text = looking_text(shutters, SLOTS, slot_us, bench.target, named, "")
        else:
            text = program_of(shutters, chip).text
        source = Source("shutter.nsl", text)
        case = SynthesisCase(configuration.method, source, Path(), configuration.codes, chip.file)
        return compiled_or_not(CompileVariant(case, configuration.lowering, settings.level))

    if settings.slot_us is not None:
        return compiled(settings.slot_us)
    # Words depend on the slot length only through refresh, which shorter slots need less often.
    longest_compiled = compiled(_LONG_US)
    if isinstance(longest_compiled, Diagnostic):
        return longest_compiled
    return compiled(whole_ticks(longest_compiled.shortest_slot_us))


def _encoder(configuration: Configuration, settings: SensorStudySettings) -> Encoder:
    """Return an encoder with the codes of a configuration."""
    tile, start = ((2, 2), "quad") if configuration.kind == "stills" else ((8, 8), "random")
    length = settings.length or max(1, configuration.slots // 4)
    spec = ShutterSpec(
        configuration.shutters, configuration.slots, settings.tile or tile,
        length=length if configuration.shutters == "c" else None,
        rows=settings.rows if configuration.shutters == "codebook" else None,
    )  # fmt: skip
    return make_encoder(spec, settings.init or start, settings.seed)


@dataclass(frozen=True, eq=False)
class SensorBench:
    """Scenes of one kind, captured with one sensor; `known` caches scores of captures."""

    scenes: tuple[ProtocolScene, ...]
    target: Target
    sensor: Sensor
    model: SensorModel
    settings: SensorStudySettings
    known: dict[bytes, float] = field(default_factory=dict)

    @classmethod
    def of(cls, kind: Kind, target: Target, settings: SensorStudySettings) -> SensorBench:
        """Return the scenes of a kind, at the size of the target's array."""
        sensor = load_sensor(target, settings.sensor, settings.changes)
        size, frames = (
            max(target.rows, target.cols), settings.frames or max(settings.slots, default=1)
        )  # fmt: skip
        protocol = protocol_of(kind, size, frames, sensor.full_well_e)
        scenes = tuple(
            replace(scene, light_e=scene.light_e[..., : target.rows, : target.cols])
            for scene in some_scenes(protocol, settings.data, settings.count, settings.seed)
        )
        return cls(scenes, target, sensor, SensorModel.of(sensor, target), settings)

    def schedule(self, configuration: Configuration) -> LookSchedule:
        """Return looks: those of a method of hdr-v1, or designed for the scenes."""
        assert configuration.exposures is not None
        if configuration.shutters == "looks":
            return row_of(configuration.method, self.target)
        chip = DesignChip.of(self.target, self.sensor)
        lights = histogram([scene.light_e for scene in self.scenes])
        return LookModel(chip, lights, [1.0] * SLOTS).best(configuration.exposures - 1, "linear")

    def psnr_db(self, container: Container, shutters: Encoder | LookSchedule) -> float:
        """Return the PSNR, averaged over scenes, of a decoder that needs no training."""
        seed = self.settings.seed
        score = self._looked_db if isinstance(shutters, LookSchedule) else partial(
            self._decoded_db, shutters)  # fmt: skip
        return finite_mean(
            score(container, scene, (1000 * seed + k, seed)) for k, scene in enumerate(self.scenes)
        )

    def _looked_db(
        self, container: Container, scene: ProtocolScene, seeds: tuple[int, int]
    ) -> float:
        light = looked_light(container, scene.light_e, self.sensor, self.settings.effects, seeds)
        return number(scene.scores(light)["psnr_db"])

    def _decoded_db(
        self, encoder: Encoder, container: Container, scene: ProtocolScene, seeds: tuple[int, int]
    ) -> float:
        request = Request.of(effects=self.settings.effects, seed=seeds[0], device_seed=seeds[1])
        shot = simulate(container, _light(scene, encoder.spec.slots), self.sensor, request).frame
        codes = (shot.frame[:1] - self.model.adc_offset_lsb).astype(np.float32)
        tile = encoder.hard().numpy()[None]
        frames = CapturedScene(scene, codes, tile, shot.saturated[:1], self.model)
        # The words of open and of fixed codes often give the same frame.
        digest = sha256(b"".join(a.tobytes() for a in (codes, frames.saturated, tile))).digest()
        if digest not in self.known:
            if frames.is_still:
                decoded = STILLS["merged"].decode(frames)
            else:
                decoded = CLIPS["gap-tv"].decode(frames, iterations=_ITERATIONS)
                joined = len(scene.light_e) // len(decoded)
                decoded = np.repeat(decoded / joined, joined, axis=0)
            self.known[digest] = number(scene.scores(decoded)["psnr_db"])
        return self.known[digest]


def _light(scene: ProtocolScene, slots: int) -> Light:
    """Return a scene's light in `slots` slots, which together last as long as all its frames."""
    if scene.light_e.ndim == 2:
        return Light.of_still(scene.light_e.astype(np.float32), np.full(slots, 1.0 / slots))
    frames, rows, cols = scene.light_e.shape
    summed = scene.light_e.reshape(slots, frames // slots, rows, cols).sum(axis=1)
    return Light.of_clip(summed.astype(np.float32))


def refusals_text(refused: Sequence[Refused]) -> list[str]:
    """Return the refused configurations as lines, grouped by reason."""
    together: dict[tuple[str, str], list[str]] = {}
    for refusal in refused:
        name = f"{refusal.case}, {refusal.method}, {refusal.setting}"
        together.setdefault((refusal.code, refusal.reason), []).append(name)
    lines = []
    for (code, reason), names in together.items():
        lines += ["", f"does not fit: {reason} ({code})", *(f"  {name}" for name in names)]
    return lines
