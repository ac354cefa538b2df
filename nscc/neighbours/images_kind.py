"""The kind of programs that compute images and planes after the last slot.

It adds to a program of another kind, whose words expose the frame."""

from __future__ import annotations

from typing import Any

from nscc.lazy import LazyFunctions
from nscc.neighbours.passes import with_pictures
from nscc.pipeline import Compiled, Found, Job, ProgramKind
from nscc.prove.proof import Failure
from nscc.words.container import Container

_REPORT = LazyFunctions("nscc.neighbours.picture_report")


class Images(ProgramKind):
    """What the compiler does for a program with images or planes.

    The exposure before them is that of another kind, whose class comes next in the order of
    methods."""

    has_simpler_programs = False

    def assemble(self, layout: Any, job: Job) -> tuple[Container, Found]:
        """Return the container of the exposure with the words of images and planes after it, and
        diagnostics.

        After an error, the container has only the exposure."""
        container, found = super().assemble(layout, job)
        program, level = layout.program, job.options.level
        container, errors = with_pictures(container, program, level, job.results)
        return container, [*found, *errors]

    def after_frame(self, container: Container) -> Failure | None:
        """Return the failure of the proof of images and planes after the frame, or None."""
        from nscc.neighbours.pictures_proof import pictures_failure

        return super().after_frame(container) or pictures_failure(container)

    def report(self, compiled: Compiled) -> dict[str, Any]:
        """Return the report of a program with what its images and planes cost."""
        report: dict[str, Any] = _REPORT.with_pictures(super().report(compiled), compiled.container)
        return report

    def rows(self, compiled: Compiled) -> list[tuple[str, str]]:
        """Return the rows of the summary, those of images and planes first."""
        rows = super().rows(compiled)
        return [*_REPORT.picture_rows(compiled.container), *rows] if rows else rows
