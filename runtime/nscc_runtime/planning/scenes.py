"""Implementations of `PlannedScene` for programs with fixed shutters and for pixels that look."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.caches import remembered
from nscc_runtime.effects import Selection, everything, selected
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.emulator.capture import check_size
from nscc_runtime.execution.chip import chip_of
from nscc_runtime.execution.frames import ExecutedScene, Path, executed
from nscc_runtime.execution.pixel_loop import run_pixels
from nscc_runtime.execution.program import AnalysedProgram, analysed
from nscc_runtime.execution.summed import SummedScene
from nscc_runtime.frame_file import Frame
from nscc_runtime.light import Light
from nscc_runtime.looked_frames import Planes, exposer, frames, looking_program_of, next_planes
from nscc_runtime.looking.looking_program import LookingProgram
from nscc_runtime.looking.path_loop import run_paths
from nscc_runtime.loop import Loop
from nscc_runtime.planless import refuse_planless
from nscc_runtime.planning.audit import Audit, Compared, audit
from nscc_runtime.planning.look_trial import LOOKS, LookTrial, same_states
from nscc_runtime.planning.make import still_fits
from nscc_runtime.planning.plan import Plan
from nscc_runtime.planning.planned_scene import NONE, Names, PlannedScene, Trial
from nscc_runtime.planning.prices import Work
from nscc_runtime.planning.summed_trial import SummedTrial
from nscc_runtime.planning.tolerance import Tolerance, mean_signal_e
from nscc_runtime.planning.word_trial import (
    APPROXIMATE,
    ReferenceTrial,
    WordTrial,
)
from nscc_runtime.pool import threads_of
from nscc_runtime.reference.capture import Reference, scene_of
from nscc_runtime.reference.looks import Intervals, LookingReference

_SURELY = 0.4
"""If nothing is measured, the variance of counts that sums neglect may make up this fraction of the
tolerance, because sums have other approximation errors, too."""


@dataclass(frozen=True, eq=False)
class FixedShutters(PlannedScene):
    """A program with fixed shutters on a scene, to be planned, exposed and audited."""

    @property
    def loop(self) -> Loop[Any]:
        return run_pixels

    def ready(self) -> None:
        if not run_pixels.is_compiled():  # now, so that only one run waits for the compilation
            run_pixels.load()
        self.program  # noqa: B018  # computes the cached property

    @cached_property
    def program(self) -> AnalysedProgram:
        """The analysed program."""
        return analysed(self.container, self.sensor)

    def signal_e(self) -> float:
        check_size(self.container, self.light)
        none = selected("none")
        chip = chip_of(self.program, self.device_seed, none, none)
        summed = SummedScene(chip, self.light, threads_of(self.threads))
        return mean_signal_e(summed.expected, self.sensor)

    @remembered
    def trial(self, forced_off: Names) -> SummedTrial:
        check_size(self.container, self.light)
        threads = threads_of(self.threads)
        return SummedTrial(forced_off, self.program, self.light, self.device_seed, threads)

    def slower_trial(self, trial: Trial, tolerance_e: float) -> Trial | None:
        """Return the next trial if weighted sums are not accurate enough; None if there is none.

        The next trial runs all pixels word by word. If only the reference supports an effect, or if
        the reference is faster, it uses the reference."""
        if not isinstance(trial, SummedTrial) or isinstance(trial, WordTrial):
            return None
        values = trial.forced_off, self.program, self.light, self.device_seed, trial.threads
        slow = trial.slow - trial.absent - trial.forced_off
        if slow or self._reference_is_faster:
            return ReferenceTrial(*values)
        return WordTrial(*values, limit_e=tolerance_e)

    @property
    def _reference_is_faster(self) -> bool:
        work = Work.of(self.program)
        return work.reference_ns < work.words_ns(everything(), "all")

    def exact_path(self, tolerance: Tolerance | None) -> tuple[Path, str]:
        """Return "sums", or a slower path if sums may be too inaccurate, and the reason."""
        if tolerance is None or self.approximates(tolerance.electrons, None):
            return "sums", ""
        return ("reference" if self._reference_is_faster else "words"), APPROXIMATE

    def approximates(self, tolerance_e: float | None, noise_part: float | None) -> bool:
        """Return whether the error of sums is certainly small beside a tolerance or a fraction of
        the noise.

        The error is the variance of counts due to slots of a group whose weights differ from the
        mean weight of the group."""
        uneven, square = self.program.uneven_seconds(self.program.full)
        if tolerance_e is None:
            noise_fraction = np.divide(uneven, square, out=np.zeros_like(uneven), where=square > 0)
            return math.sqrt(float(noise_fraction.max(initial=0.0))) <= _SURELY * (
                noise_part or 0.0
            )
        light_e_per_s = self.light.sum_e.reshape(-1) / max(self.program.slot_s.sum(), 1e-300)
        square_e2 = (uneven[:, self.program.lanes] * light_e_per_s).mean(axis=1)
        return math.sqrt(float(square_e2.max(initial=0.0))) <= _SURELY * tolerance_e

    @property
    def open_part(self) -> NDArray[np.float32]:
        return self.program.open_part

    def frames(self, plan: Plan, seed: int, count: int) -> Iterable[Frame]:
        return self._executed(plan).frames(seed, count)

    def _executed(self, plan: Plan) -> ExecutedScene:
        return executed(
            self.program, self.light, plan.execution, device_seed=self.device_seed,
            threads=self.threads,
        )  # fmt: skip

    def audit(self, plan: Plan, seed: int, count: int) -> Audit:
        planned = self._executed(plan)
        reference = Reference.of(self.container, self.sensor, everything())
        scene, threads = scene_of(self.container, self.light), threads_of(self.threads)

        def compare(frame: int, rows: Sequence[range]) -> Compared:
            mine, seeds = planned.expose(seed, frame).exposure_e, (seed, self.device_seed)
            full = [
                reference.expose_rows(scene, band, *seeds, frame, threads).exposure_e
                for band in rows
            ]
            mine = np.concatenate([mine[:, band.start : band.stop] for band in rows], axis=1)
            return Compared(mine, np.concatenate(full, axis=1))

        return audit(compare, self.light, self.container.slots, plan, count)


@dataclass(frozen=True, eq=False)
class LookingPixels(PlannedScene):
    """A program whose pixels look, on a scene. Execution by words approximates nothing."""

    @property
    def loop(self) -> Loop[Any]:
        return run_paths

    def ready(self) -> None:
        self._program  # noqa: B018  # computes the cached property

    @cached_property
    def _program(self) -> LookingProgram:
        return looking_program_of(self.container, self.sensor)

    def signal_e(self) -> float:
        [frame] = self._frames(selected("none"), 0, 1)
        return mean_signal_e(frame.exposure_e, self.sensor)

    @remembered
    def trial(self, forced_off: Names) -> LookTrial:
        return LookTrial(forced_off, self._program, self.light)

    def exact_path(self, tolerance: Tolerance | None) -> tuple[Path, str]:
        lacking = self._program.lacks(everything())
        return ("reference", lacking[0]) if lacking else ("words", LOOKS)

    def serves(self, plan: Plan) -> bool:
        """Return whether the plan keeps its tolerance on a sample of this scene with all its
        dropped effects dropped at once."""
        dropped = everything().on - plan.kept.on
        return not dropped or still_fits(self.trial(NONE), plan, dropped)

    def frames(self, plan: Plan, seed: int, count: int) -> Iterable[Frame]:
        return self._frames(plan.kept, seed, count)

    def _frames(self, effects: Selection, seed: int, count: int) -> Iterable[Frame]:
        return frames(
            self.container, self.light, self.sensor, effects, seed=seed,
            device_seed=self.device_seed, count=count, threads=self.threads,
        )  # fmt: skip

    def audit(self, plan: Plan, seed: int, count: int) -> Audit:
        """Compare up to `count` frames with the reference. Every frame begins with the kept states
        of the previous frame of the reference."""
        container = self.container
        scene, seeds = scene_of(container, self.light), (seed, self.device_seed)
        reference = LookingReference(container, self.sensor, everything()).expose
        planned = exposer(self._program, plan.kept, threads_of(self.threads))
        loaded: Planes = container.planes()

        def compare(frame: int, rows: Sequence[range]) -> Compared:
            nonlocal loaded
            next_loaded = {name: plane.copy() for name, plane in loaded.items()}
            mine, full, same = [], [], []
            for band in rows:
                planned_frame = planned(scene, loaded, seeds, frame, band)
                reference_frame = reference(scene, loaded, seeds, frame, band)
                same.append(same_states(planned_frame, reference_frame))
                mine.append(planned_frame.exposure.exposure_e)
                full.append(reference_frame.exposure.exposure_e)
                for name, plane in reference_frame.planes.items():
                    final_plane = next_loaded.setdefault(name, np.zeros(self.light.shape, np.bool_))
                    final_plane[band.start : band.stop] = plane
            loaded = next_planes(container, loaded, next_loaded)
            return Compared(
                np.concatenate(mine, axis=1), np.concatenate(full, axis=1), np.concatenate(same)
            )

        intervals = Intervals.of(container, every_slot=False)
        return audit(compare, self.light, len(intervals), plan, count)


def planning_of(
    container: Container,
    sensor: Sensor,
    light: Light,
    device_seed: int = 0,
    threads: int | None = None,
) -> PlannedScene:
    """Return a program on a scene, to be planned, exposed and audited.

    Raises Rejected for programs with images or planes."""
    refuse_planless(container, "planning")
    if container.machine.stages:
        return LookingPixels(container, sensor, light, device_seed, threads)
    return FixedShutters(container, sensor, light, device_seed, threads)
