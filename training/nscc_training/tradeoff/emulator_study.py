"""The study of the emulator: all methods on all scenes, with its tables and diagrams."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from nscc_runtime.execution.program import AnalysedProgram
from nscc_runtime.pictures.precision import Point
from nscc_training.command_settings import EmulatorStudySettings
from nscc_training.experiments.study import Study, StudyResult
from nscc_training.tradeoff.emulator import (
    EmulatorBench,
    EmulatorStudy,
    NamedLight,
    copy_gb_per_s,
)
from nscc_training.tradeoff.emulator_diagrams import budget_diagram, promise_diagram, study_diagram
from nscc_training.tradeoff.emulator_text import keeps_promise, studies_text

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class EmulatorBenches:
    """The methods on all scenes of a study, one of `benches` for each scene, and the speed of
    memory copies in GB/s."""

    benches: tuple[EmulatorBench, ...]
    gb_per_s: float

    @classmethod
    def of(
        cls, program: AnalysedProgram, scenes: Sequence[NamedLight], settings: EmulatorStudySettings
    ) -> EmulatorBenches:
        """Prepare the study of a program on scenes, whose names must differ, and measure the speed
        of memory.

        The time of analysing the program is not included in times. There is at least one scene.
        Raises ValueError for less than 2 frames or less than 1 repeat."""
        if settings.frames < 2 or settings.repeats < 1:
            raise ValueError(f"{settings.frames} frames, {settings.repeats} repeats")
        benches = tuple(EmulatorBench(program, scene, settings) for scene in scenes)
        return cls(benches, copy_gb_per_s())

    def study(self) -> Study:
        """Return the study: its points, tables and diagrams. Raise Rejected (NS0746) for an invalid
        tolerance."""
        return Study(
            [point for bench in self.benches for point in bench.points()],
            lambda measured: studies_text(self.results(measured), self.gb_per_s),
            {
                "png": self._diagram,
                "calibration": lambda measured, _device: promise_diagram(self.results(measured)),
                "budget": lambda measured, _device: budget_diagram(self.results(measured)),
            },
            self.benches[0].settings.repeats,
            csv_of=self._in_order,
        )

    def results(self, measured: StudyResult) -> tuple[EmulatorStudy, ...]:
        """Return the results of each scene among all that were measured, in the order of the
        scenes."""
        return tuple(bench.result(measured, self.gb_per_s) for bench in self.benches)

    def keep_promises(self, measured: StudyResult) -> bool:
        """Return whether no plan (the effects that are simulated) has a measured error above its
        tolerance, with the slack of `keeps_promise`."""
        results = self.results(measured)
        return all(keeps_promise(plan) for scene in results for plan in scene.measured_plans)

    def _diagram(self, measured: StudyResult, device: str) -> Figure:
        """Draw errors against times of all scenes."""
        return study_diagram(self.results(measured), measured.times, device)

    def _in_order(self, points: Sequence[Point]) -> list[Point]:
        """Return the points scene by scene, for the CSV file."""
        results = self.results(StudyResult(tuple(points)))
        return [point for scene in results for point in scene.points]
