"""Measure the error of the emulator relative to the reference, and the time of a frame, beside two
simple numpy implementations of an exposure."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property, partial
from typing import Any, NamedTuple

import numpy as np

from nscc.arrays import Array, Bools, Floats32
from nscc_runtime.effects import everything, selected
from nscc_runtime.effects.parts import CountedLight
from nscc_runtime.execution.program import AnalysedProgram
from nscc_runtime.exposed_frame import Exposure
from nscc_runtime.frame_file import Frame, read_out
from nscc_runtime.light import Light
from nscc_runtime.pictures.precision import Point
from nscc_runtime.planning.audit import SLACK, audit
from nscc_runtime.planning.make import make_plan
from nscc_runtime.planning.plan import Plan, PlanRequest
from nscc_runtime.planning.planned_scene import PlannedScene
from nscc_runtime.planning.tolerance import Tolerance, tolerance_of, unit_of
from nscc_runtime.reference import frames as reference_frames
from nscc_runtime.reference.capture import Reference, reference_scene
from nscc_training.command_settings import EmulatorStudySettings
from nscc_training.experiments.engine import Figures
from nscc_training.experiments.study import NotMeasured, StudyPoint, StudyResult, timed_ms
from nscc_training.experiments.study_table import Refused

_MOST_BYTES = 1 << 28
"""Light and shutters of all slots are prepared as arrays before timing, unless they are larger than
this; then they are computed slot by slot."""
_COPIED_BYTES = 1 << 26
"""Bytes of the copy whose speed is measured."""
_COPIES = 25
"""Number of copies, of which the fastest counts."""


@dataclass(frozen=True, eq=False)
class Naive:
    """Two simple exposures of a scene with a program's shutters, as users would write them in
    numpy, for comparison. Both are read out without noise."""

    program: AnalysedProgram
    light: Light

    def summed(self) -> Frame:
        """Return a frame that sums the light over the open slots in float32, without noise or any
        other effect. Sums beyond float32 become infinite."""
        with np.errstate(over="ignore"):
            return self._read_out(np.float32, lambda light: light)

    def drawn(self, seed: int) -> Frame:
        """Return a frame that sums Poisson counts, which numpy draws with `seed` for every slot,
        over the open slots, without other effects.

        Raises NotMeasured for light beyond the range of numpy, about 9e18 electrons per slot."""
        try:
            return self._read_out(np.float64, np.random.default_rng(seed).poisson)
        except ValueError as wrong:
            raise NotMeasured(f"numpy cannot draw this light: {wrong}") from wrong

    def _read_out(self, kind: type[np.floating], charge_of: Callable[[Floats32], Array]) -> Frame:
        """Return the frame, without noise of the readout, of sums of this type over the open slots.
        `charge_of` gives the electrons of a slot from its light."""
        container = self.program.container
        total = np.zeros((len(container.buckets), *self.light.shape), kind)
        for light, opened in self._slots():
            charge = charge_of(light)
            for bucket, open_pixels in zip(total, opened, strict=True):
                np.add(bucket, charge, out=bucket, where=open_pixels)
        exposure = Exposure(total.astype(np.float64, copy=False), np.ones(total.shape, np.bool_))
        return read_out(exposure, container.target, self.program.sensor)

    def _slots(self) -> Iterator[tuple[Floats32, Bools]]:
        """Yield, slot by slot, the light (rows, cols) in electrons and which pixels are open
        (buckets, rows, cols)."""
        if self._ready is not None:
            yield from zip(*self._ready, strict=True)
        else:
            for n in range(self.light.slots):
                yield self.light.slot(n), self._opened(n)

    @cached_property
    def _ready(self) -> tuple[Floats32, Bools] | None:
        """The light (slots, rows, cols) and the open pixels (slots, buckets, rows, cols) of all
        slots as dense arrays, prepared once; None if they take more than `_MOST_BYTES`."""
        buckets, slots = len(self.program.container.buckets), self.light.slots
        if slots * (4 + buckets) * self.light.frames[0].size > _MOST_BYTES:
            return None
        return self.light.dense(), np.stack([self._opened(n) for n in range(slots)])

    def _opened(self, n: int) -> Bools:
        """Return which pixels are open in slot `n` (0 is the first), bool (buckets, rows, cols)."""
        return np.moveaxis(self.program.opened[n][self.program.lane], -1, 0)


def copy_gb_per_s() -> float:
    """Return the memory traffic, read and written, of copying an array that is larger than the
    caches, in GB/s. The best of `_COPIES` copies counts."""
    source = np.ones(_COPIED_BYTES // 8)
    copy = partial(np.copyto, np.zeros_like(source), source)
    best_ms = min(timed_ms(copy)[1] for _ in range(_COPIES))
    return 2 * source.nbytes / best_ms / 1e6


def floor_ms(light: Light, gb_per_s: float) -> float:
    """Return the milliseconds that reading a stored scene once from memory takes at this speed."""
    return len(light.frames) * light.frames[0].nbytes / gb_per_s / 1e6


REFERENCE, OTHER_DRAWS, SUMMED, DRAWN = "reference", "reference redrawn", "f32", "per-slot"
"""Names of the methods. `OTHER_DRAWS` is the reference with other random numbers."""
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
"""The default scenes."""


class NamedLight(NamedTuple):
    """The light of a scene, and a name for tables."""

    name: str
    light: Light


class MeasuredPlan(NamedTuple):
    """A plan for the tolerance that is called `setting`, and `measured_e`, its measured RMS error
    in electrons in the worst bucket. A plan is a choice of the effects that are simulated."""

    setting: str
    plan: Plan
    measured_e: float

    @property
    def tolerance_e(self) -> float:
        """The tolerance in electrons."""
        return self.plan.tolerance_e or 0.0

    @property
    def in_electrons(self) -> bool:
        """Whether the tolerance was given in electrons."""
        return unit_of(self.plan.tolerance) == "e"

    @property
    def keeps_promise(self) -> bool:
        """Whether the measured error is at most `SLACK` times the tolerance."""
        return self.measured_e <= SLACK * self.tolerance_e

    @property
    def predicted_e(self) -> float:
        """The error predicted from a sample of the scene, in electrons."""
        return self.plan.predicted_e or 0.0


class EmulatorStudy(NamedTuple):
    """The result of one scene: `points` in electrons and in LSB, `measured_plans` by tolerance, and
    bounds.

    `floor_ms` is the time to read the scene from memory once. `budget` is the plan (the effects
    that are simulated) that is shown effect by effect. `refused` are methods that could not run,
    with the reasons."""

    scene: str
    points: tuple[Point, ...]
    measured_plans: tuple[MeasuredPlan, ...]
    floor_ms: float
    budget: Plan
    refused: tuple[Refused, ...]

    def resolution(self, unit: str) -> float:
        """Return the RMS difference of two reference frames with different random numbers, in the
        unit "e" or "lsb". Smaller errors are not visible in a single frame."""
        return next(p.error for p in self.points if (p.method, p.error_unit) == (OTHER_DRAWS, unit))


@dataclass(frozen=True, eq=False)
class EmulatorBench:
    """The methods to compare on one scene, and their errors against frames of the reference, which
    are computed once."""

    program: AnalysedProgram
    scene: NamedLight
    settings: EmulatorStudySettings

    def points(self) -> list[StudyPoint]:
        """Return the points of all methods: the reference, the simple exposures, and for each
        tolerance a frame with a plan that exists and one whose plan is made in the same time."""
        ((counting, _),) = everything().having(CountedLight)
        naive, seed = Naive(self.program, self.scene.light), self.settings.seed
        seeds = range(seed, seed + self.frames)
        # Each method has a name, a setting, a call whose time is measured, and one for its
        # errors.
        methods: list[tuple[str, str, Callable[[], Any], Callable[[], tuple[float, float]]]] = [
            (SUMMED, "none", naive.summed, lambda: self.error([naive.summed()] * self.frames)),
            (
                DRAWN,
                counting.name,
                partial(naive.drawn, seed),
                lambda: self.error(list(map(naive.drawn, seeds))),
            ),
        ]
        for tolerance in self.tolerances:
            name, errors = tolerance.name, partial(self.plan_error, tolerance.name)
            methods.append((PLANNED, name, partial(self.first_frame, name), errors))
            methods.append((WITH_PLANNING, name, partial(self.first_planned, tolerance), errors))
        scene = self.scene.name
        return [
            StudyPoint(scene, REFERENCE, "all", lambda: self._of_reference(0.0, 0.0)),
            StudyPoint(
                scene,
                OTHER_DRAWS,
                "all",
                lambda: self._of_reference(*error(self.truth[0][1:], self.truth[0][:-1])),
            ),
            *(
                StudyPoint(scene, method, setting, run, partial(_error_figures, errors))
                for method, setting, run, errors in methods
            ),
        ]

    @cached_property
    def tolerances(self) -> list[Tolerance]:
        """The distinct tolerances in electrons, in ascending order."""
        allowed = (self._tolerance(tolerance) for tolerance in self.settings.tolerances)
        by_name = {tolerance.name: tolerance for tolerance in allowed}
        return sorted(by_name.values(), key=lambda tolerance: tolerance.electrons)

    @cached_property
    def frames(self) -> int:
        """The number of frames from which errors are measured: those of the settings, or for small
        scenes as many as have `_POOLED` pixels, at most `_MOST_POOLED`."""
        rows, cols = self.scene.light.shape
        return max(
            self.settings.frames, min(math.ceil(_POOLED / max(1, rows * cols)), _MOST_POOLED)
        )

    @cached_property
    def plans(self) -> dict[str, Plan]:
        """The plan (the effects that are simulated) of each tolerance, by its name."""
        return {tolerance.name: self._plan(tolerance) for tolerance in self.tolerances}

    @cached_property
    def budget(self) -> Plan:
        """The plan (the effects that are simulated) that is shown effect by effect."""
        return self._plan(self._tolerance(self.settings.budget))

    @cached_property
    def truth(self) -> tuple[list[Frame], list[float]]:
        """The frames of the reference (the simulation with every effect, word by word), and the
        time of each in milliseconds."""
        settings, light, program = self.settings, self.scene.light, self.program
        drawn = iter(
            reference_frames(
                program.container,
                light,
                program.sensor,
                selected("all"),
                seed=settings.seed,
                device_seed=settings.device_seed,
                count=self.frames,
            )
        )
        # One row compiles and loads everything; each frame is then drawn once and timed.
        reference = Reference.of(program.container, program.sensor, selected("all"))
        scene = reference_scene(program.container, light)
        reference.execute(scene, program.container.planes(), (0, 0), 0, range(1))
        timed = [timed_ms(partial(next, drawn)) for _ in range(self.frames)]
        return [frame for frame, _ in timed], [ms for _, ms in timed]

    def error(self, frames: Sequence[Frame]) -> tuple[float, float]:
        """Return the RMS difference of `frames` from those of the reference, in electrons and in
        converter codes."""
        return error(frames, self.truth[0])

    @cache  # noqa: B019  # a bench lives as long as the command
    def plan_error(self, name: str) -> tuple[float, float]:
        """Return the RMS error of the plan for the tolerance `name`, in electrons and in converter
        codes, measured against the reference with the same random numbers. Results are cached. A
        plan is a choice of the effects that are simulated."""
        rms_e = audit(self._on(self.scene.light), self.plans[name]).measured_rms_e
        return rms_e, rms_e / self.program.sensor.electrons_per_lsb

    def first_frame(self, name: str) -> Frame:
        """Return a frame under the plan (the effects that are simulated) for the tolerance `name`,
        which exists before the time is measured."""
        return self._first(self.plans[name])

    def first_planned(self, tolerance: Tolerance) -> Frame:
        """Make a plan (the effects that are simulated) for a tolerance, and return a frame under
        it."""
        return self._first(self._plan(tolerance))

    def result(self, measured: StudyResult, gb_per_s: float) -> EmulatorStudy:
        """Return the results of this scene among all `measured`, ordered by unit and method.

        `gb_per_s` is the speed of memory copies, which bounds the time of any method."""
        name = self.scene.name
        points = [point for point in measured.points if point.case == name]
        points.sort(key=lambda p: (p.error_unit != ELECTRONS, _ORDER.index(p.method)))
        # Backwards, so that errors in electrons, which come first, replace those in LSB.
        errors_e = {p.setting: p.error for p in points[::-1] if p.method == PLANNED}
        plans = (MeasuredPlan(n, plan, errors_e[n]) for n, plan in self.plans.items())
        return EmulatorStudy(
            name,
            tuple(points),
            tuple(plans),
            floor_ms(self.scene.light, gb_per_s),
            self.budget,
            tuple(refusal for refusal in measured.refused if refusal.case == name),
        )

    def _of_reference(self, error_e: float, error_lsb: float) -> Figures:
        """Return the figures of the reference: these errors, and the times of its frames."""
        return {ELECTRONS: error_e, LSB: error_lsb, "ms": self.truth[1]}

    def _on(self, light: Light) -> PlannedScene:
        """Return the program on some light, to be simulated in one thread, so that times do not
        depend on other processes."""
        program, seed = self.program, self.settings.device_seed
        return PlannedScene(program.container, program.sensor, light, seed, threads=1)

    def _tolerance(self, tolerance: str | float) -> Tolerance:
        """Return a tolerance for this scene from its text or number (electrons). Raise Rejected
        (NS0746) for an invalid one."""
        scene = self._on(self.scene.light)
        return tolerance_of(tolerance, scene.sensor, scene.signal_e, scene.noise_e)

    def _plan(self, tolerance: Tolerance) -> Plan:
        """Make the plan (the effects that are simulated) for a tolerance, of light without stored
        sums, so that its time includes them."""
        light = unknown(self.scene.light)
        return make_plan(self._on(light), PlanRequest(selected("auto"), tolerance, figures=True))

    def _first(self, plan: Plan) -> Frame:
        """Return a frame under a plan (the effects that are simulated), of light without stored
        sums, so that its time includes them."""
        light = unknown(self.scene.light)
        return next(iter(self._on(light).frames(plan.kept, self.settings.seed, 1)))


def _error_figures(errors: Callable[[], tuple[float, float]], _frame: Frame) -> Figures:
    """Return the errors that `errors` measures, in electrons and in converter codes, by the name of
    the unit. The frame of the timed run is not used."""
    return dict(zip((ELECTRONS, LSB), errors(), strict=True))


def unknown(light: Light) -> Light:
    """Return the same light, also of its motion, without the results that it caches."""
    motion = light.motion
    return replace(light, motion=None if motion is None else unknown(motion))


def error(frames: Sequence[Frame], truth: Sequence[Frame]) -> tuple[float, float]:
    """Return the RMS difference of `frames` from `truth`, in electrons and in converter codes, each
    of the worst bucket. Both have the same number of frames.

    Only pixels that are valid in both frames count. Both are infinite if a bucket has no valid
    pixel."""
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
