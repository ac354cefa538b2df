"""Measure the error of the emulator relative to the reference, and the time of a frame, beside two
simple numpy implementations of an exposure."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from time import perf_counter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.experiment_store import Rows
from nscc.tradeoff.points import Point
from nscc.tradeoff.stopwatch import Stopwatch
from nscc_runtime.effects import everything, selected
from nscc_runtime.effects.parts import CountedLight
from nscc_runtime.execution.program import AnalysedProgram
from nscc_runtime.frame_file import Frame, read_out
from nscc_runtime.interface import Exposure
from nscc_runtime.light import Light
from nscc_runtime.planning.audit import audit
from nscc_runtime.planning.make import make_plan
from nscc_runtime.planning.plan import Plan
from nscc_runtime.planning.plan_request import PlanRequest
from nscc_runtime.planning.planned_scene import PlannedScene
from nscc_runtime.planning.tolerance import Tolerance, tolerance_of
from nscc_runtime.reference import frames as reference_frames
from nscc_runtime.reference.capture import Reference, scene_of

_MOST_BYTES = 1 << 28
"""Light and shutters of all slots are prepared as arrays before timing, unless they are larger than
this; then they are computed slot by slot."""
_COPIED_BYTES = 1 << 26
_COPIES = 25


@dataclass(frozen=True, eq=False)
class Naive:
    """Two simple exposures of a scene with a program's shutters, both read out without noise."""

    program: AnalysedProgram
    light: Light

    def summed(self) -> Frame:
        """Return a frame that sums the light over the open slots in float32, without effects."""
        total = self._dark(np.float32)
        with np.errstate(over="ignore"):
            for light, opened in self._slots():
                for bucket, open_pixels in zip(total, opened, strict=True):
                    np.add(bucket, light, out=bucket, where=open_pixels)
        return self._read(total)

    def drawn(self, seed: int) -> Frame:
        """Return a frame that sums numpy's Poisson counts over the open slots, without other
        effects.

        Raises ValueError for light beyond the range of numpy, about 9e18 electrons per slot."""
        random = np.random.default_rng(seed)
        total = self._dark(np.float64)
        for light, opened in self._slots():
            charge = random.poisson(light)
            for bucket, open_pixels in zip(total, opened, strict=True):
                np.add(bucket, charge, out=bucket, where=open_pixels)
        return self._read(total)

    def _dark(self, kind: type[np.floating]) -> NDArray[np.floating]:
        return np.zeros((len(self.program.container.buckets), *self.light.shape), kind)

    def _read(self, total: NDArray[np.floating]) -> Frame:
        exposure = Exposure(total.astype(np.float64, copy=False), np.ones(total.shape, np.bool_))
        return read_out(exposure, self.program.container.target, self.program.sensor)

    def _slots(self) -> Iterator[tuple[NDArray[np.float32], NDArray[np.bool_]]]:
        """Yield the light (rows, cols) and the open pixels (buckets, rows, cols) slot by slot."""
        if self._ready is not None:
            yield from zip(*self._ready, strict=True)
        else:
            for n in range(self.light.slots):
                yield self.light.slot(n), self._opened(n)

    @cached_property
    def _ready(self) -> tuple[NDArray[np.float32], NDArray[np.bool_]] | None:
        buckets, slots = len(self.program.container.buckets), self.light.slots
        if slots * (4 + buckets) * self.light.frames[0].size > _MOST_BYTES:
            return None
        return self.light.dense(), np.stack([self._opened(n) for n in range(slots)])

    def _opened(self, n: int) -> NDArray[np.bool_]:
        return np.moveaxis(self.program.opened[n][self.program.lane], -1, 0)


def copy_gb_per_s() -> float:
    """Return the memory traffic in GB/s of copying more than the caches hold, the best of some
    runs."""
    source = np.ones(_COPIED_BYTES // 8)
    target = np.zeros_like(source)
    best_s = np.inf
    for _ in range(_COPIES):
        begin = perf_counter()
        np.copyto(target, source)
        best_s = min(best_s, perf_counter() - begin)
    return 2 * source.nbytes / best_s / 1e9


def floor_ms(light: Light, gb_per_s: float) -> float:
    """Return the milliseconds for reading a stored scene once at this speed."""
    return light.frames.nbytes / gb_per_s / 1e6


REFERENCE, OTHER_DRAWS, SUMMED, DRAWN = "reference", "reference redrawn", "f32", "per-slot"
PLANNED, WITH_PLANNING = "planned", "planned with planning"
_ORDER = (REFERENCE, OTHER_DRAWS, SUMMED, DRAWN, PLANNED, WITH_PLANNING)
ELECTRONS, LSB = "e", "lsb"

_POOLED, _MOST_POOLED = 65536, 64
"""Errors of small scenes use more frames, up to `_POOLED` pixels, `_MOST_POOLED` frames."""

PROGRAM = """nsl 1
frame 16 slots of 1ms
code stop : 1..16
open when n < stop
pixels stop = tile [[1, 4], [8, 16]]
"""
"""The default program."""
SCENES = ("builtin:hdr", "builtin:motion", "builtin:flat:300")


@dataclass(frozen=True)
class NamedLight:
    name: str
    light: Light


@dataclass(frozen=True)
class StudySettings:
    """Settings of a study.

    `tolerances`: tolerances to plan for; percentages refer to the mean signal of each scene.
    `budget`: the tolerance whose plan is shown effect by effect. `frames`: number of frames that
    errors are averaged over, at least 2; more for small scenes, up to 65536 pixels or 64 frames.
    `repeats`: number of times of which the median is taken."""

    tolerances: tuple[str | float, ...] = (0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0)
    budget: str | float = 5.0
    frames: int = 2
    repeats: int = 5
    seed: int = 0
    device_seed: int = 0


@dataclass(frozen=True)
class MeasuredPlan:
    """A plan for the tolerance `setting`, and its measured RMS error in the worst bucket."""

    setting: str
    plan: Plan
    measured_e: float

    @property
    def tolerance_e(self) -> float:
        """The tolerance in electrons."""
        return self.plan.tolerance_e or 0.0

    @property
    def predicted_e(self) -> float:
        """The error predicted from a sample of the scene, in electrons."""
        return self.plan.predicted_e or 0.0


@dataclass(frozen=True)
class Study:
    """The result of one scene: points in electrons and in LSB, plans by tolerance, and bounds.

    `resolution_e`, `resolution_lsb`: RMS difference of two reference frames with different draws.
    `floor_ms`: time to read the scene from memory once. `budget`: the plan for the error budget.
    `missing`: methods that could not run, with the reasons."""

    scene: str
    points: tuple[Point, ...]
    measured_plans: tuple[MeasuredPlan, ...]
    resolution_e: float
    resolution_lsb: float
    floor_ms: float
    budget: Plan
    missing: tuple[tuple[str, str], ...]


Progress = Callable[[Sequence["_Bench"]], Iterable["_Bench"]]
"""A function that iterates over the work and may show progress."""


def measure(
    program: AnalysedProgram,
    scenes: Sequence[NamedLight],
    settings: StudySettings,
    gb_per_s: float,
    progress: Progress = iter,
    rows: Rows | None = None,
) -> tuple[Study, ...]:
    """Measure the errors of every method on every scene, then the times in turn.

    Timing in turn distributes disturbances of the machine over all methods. All random numbers have
    the seeds of `settings`: plan and reference draw the same numbers. The time of analysing the
    program is not included. Results in `rows` are not computed again; names of scenes must differ.
    Before measuring, raises ValueError for less than 2 frames and Rejected (NS0746) for an invalid
    tolerance."""
    if settings.frames < 2 or settings.repeats < 1:
        raise ValueError(f"{settings.frames} frames, {settings.repeats} repeats")
    watch, rows = Stopwatch(), rows or Rows()
    benches = [_Bench(program, scene, settings, rows, watch) for scene in scenes]
    work = [*benches, *[bench for _ in range(settings.repeats) for bench in benches]]
    for bench in progress(work):
        if bench.errors:
            bench.time()
        else:
            bench.compare()
    return tuple(bench.study(gb_per_s) for bench in benches)


_Key = tuple[str, str]
"""Method and setting."""


@dataclass(eq=False)
class _Bench:
    """The measurement of a scene: `plans` by setting; `errors`, `times_ms` by (method, setting)."""

    program: AnalysedProgram
    scene: NamedLight
    settings: StudySettings
    rows: Rows
    watch: Stopwatch
    plans: dict[str, Plan] = field(default_factory=dict)
    errors: dict[_Key, tuple[float, float]] = field(default_factory=dict)
    times_ms: dict[_Key, list[float]] = field(default_factory=dict)
    missing: list[tuple[str, str]] = field(default_factory=list)
    timed: int = 0

    def __post_init__(self) -> None:
        self.naive = Naive(self.program, self.scene.light)
        ((counting, _),) = everything().having(CountedLight)
        self.counted = counting.name
        on_light = self._on(self.scene.light)
        self.budget, *allowed = (
            tolerance_of(tolerance, on_light.sensor, on_light)
            for tolerance in (self.settings.budget, *self.settings.tolerances)
        )
        by_name = {tolerance.name: tolerance for tolerance in allowed}
        self.tolerances = sorted(by_name.values(), key=lambda tolerance: tolerance.electrons)
        rows, cols = self.scene.light.shape
        pooled = math.ceil(_POOLED / max(1, rows * cols))
        self.frames = max(self.settings.frames, min(pooled, _MOST_POOLED))

    def _on(self, light: Light) -> PlannedScene:
        program, seed = self.program, self.settings.device_seed
        return PlannedScene(program.container, program.sensor, light, seed, threads=1)

    def compare(self) -> None:
        """Measure the errors of all methods, and the times of the reference's frames."""
        self.plans = {tolerance.name: self._plan(tolerance) for tolerance in self.tolerances}
        self.watch.ran(WITH_PLANNING, *((self.scene.name, setting) for setting in self.plans))
        row = self.rows.once(f"{self.scene.name}, errors", self._compared)
        self.errors = {(method, setting): (e, lsb) for method, setting, e, lsb in row["errors"]}
        self.missing = [(method, why) for method, why in row["missing"]]
        for method in (REFERENCE, OTHER_DRAWS):
            self.times_ms[method, "all"] = row["ms"]

    def _compared(self) -> dict[str, Any]:
        settings, light, count = self.settings, self.scene.light, self.frames
        frames = iter(
            reference_frames(
                self.program.container, light, self.program.sensor, selected("all"),
                seed=settings.seed, device_seed=settings.device_seed, count=count,
            )
        )  # fmt: skip
        # One row compiles and loads everything; each frame is then drawn once and timed.
        scene = scene_of(self.program.container, light)
        program = self.program
        Reference.of(program.container, program.sensor, selected("all")).expose_rows(
            scene, range(1)
        )
        self.watch.ran(REFERENCE, self.scene.name)
        drawing = partial(self.watch.ms, REFERENCE, self.scene.name, partial(next, frames))
        truth, times_ms = zip(*(drawing() for _ in range(count)), strict=True)
        errors = {
            (REFERENCE, "all"): (0.0, 0.0),
            (OTHER_DRAWS, "all"): error(truth[1:], truth[:-1]),
            (SUMMED, "none"): error([self.naive.summed()] * count, truth),
        }
        missing = []
        try:
            drawn = [self.naive.drawn(settings.seed + i) for i in range(count)]
            errors[DRAWN, self.counted] = error(drawn, truth)
        except ValueError as wrong:
            missing.append((DRAWN, f"numpy cannot draw this light: {wrong}"))
        for setting, plan in self.plans.items():
            rms_e = audit(self._on(light), plan).measured_rms_e
            plan_errors = rms_e, rms_e / self.program.sensor.electrons_per_lsb
            errors[PLANNED, setting] = errors[WITH_PLANNING, setting] = plan_errors
        for method, setting in errors:
            self.watch.ran(method, (self.scene.name, setting))
        rows = [(*key, *values) for key, values in errors.items()]
        return {"errors": rows, "missing": missing, "ms": times_ms}

    def time(self) -> None:
        """Time one frame of every method except the reference."""
        turn, self.timed = self.timed, self.timed + 1
        for method, setting, ms in self.rows.once(f"{self.scene.name}, {turn}", self._times):
            self.times_ms.setdefault((method, setting), []).append(ms)

    def _times(self) -> list[tuple[str, str, float]]:
        times = [self._timed(SUMMED, "none", self.naive.summed)]
        if (DRAWN, self.counted) in self.errors:
            drawn = partial(self.naive.drawn, self.settings.seed)
            times.append(self._timed(DRAWN, self.counted, drawn))
        for tolerance in self.tolerances:
            name = tolerance.name
            *_, planning_ms = self._timed(WITH_PLANNING, name, partial(self._plan, tolerance))
            *_, frame_ms = self._timed(PLANNED, name, partial(self._first, self.plans[name]))
            times.append((PLANNED, name, frame_ms))
            times.append((WITH_PLANNING, name, planning_ms + frame_ms))
        return times

    def _timed(
        self, method: str, setting: str, run: Callable[[], object]
    ) -> tuple[str, str, float]:
        return method, setting, self.watch.ms(method, (self.scene.name, setting), run)[1]

    def study(self, gb_per_s: float) -> Study:
        light, errors, rank = self.scene.light, self.errors, _ORDER.index
        points = [
            Point(self.scene.name, *key, errors[key][i], unit, tuple(self.times_ms[key]))
            for i, unit in enumerate((ELECTRONS, LSB))
            for key in errors
        ]
        measured_plans = (
            MeasuredPlan(setting, plan, errors[PLANNED, setting][0])
            for setting, plan in self.plans.items()
        )
        return Study(
            self.scene.name,
            tuple(sorted(points, key=lambda p: (p.error_unit != ELECTRONS, rank(p.method)))),
            tuple(measured_plans),
            *errors[OTHER_DRAWS, "all"],
            floor_ms(light, gb_per_s),
            self._plan(self.budget),
            tuple(self.missing),
        )

    def _plan(self, tolerance: Tolerance) -> Plan:
        light = unknown(self.scene.light)
        return make_plan(self._on(light), PlanRequest(selected("auto"), tolerance, figures=True))

    def _first(self, plan: Plan) -> Frame:
        """Return a frame under a plan without cached results: its time includes all sums."""
        light = unknown(self.scene.light)
        return next(iter(self._on(light).frames(plan.kept, self.settings.seed, 1)))


def unknown(light: Light) -> Light:
    """Return the same light without cached results."""
    motion = light.motion
    return replace(light, motion=None if motion is None else unknown(motion))


def error(frames: Sequence[Frame], truth: Sequence[Frame]) -> tuple[float, float]:
    """Return the RMS difference in electrons and in codes, each of the worst bucket. Only pixels
    that are valid in both frames count. Both are infinite if a bucket has no valid pixel."""
    totals = [np.zeros(len(truth[0].valid)) for _ in range(3)]
    for mine, theirs in zip(frames, truth, strict=True):
        valid = mine.valid & theirs.valid
        with np.errstate(invalid="ignore", over="ignore"):
            away = np.where(valid, mine.exposure_e - theirs.exposure_e, 0.0)
            codes = np.where(valid, mine.frame.astype(float) - theirs.frame, 0.0)
            for total, increments in zip(totals, (away**2, codes**2, valid), strict=True):
                total += increments.sum(axis=(1, 2))
    if not totals[2].all():
        return math.inf, math.inf
    electrons, lsb = (math.sqrt(float(np.max(total / totals[2]))) for total in totals[:2])
    return electrons, lsb
