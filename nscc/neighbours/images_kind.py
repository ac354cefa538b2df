"""The kind of programs that compute images and planes after the last slot.

It adds to a program of another kind, whose words expose the frame."""

from __future__ import annotations

from typing import Any

from nscc.lazy import LazyFunctions
from nscc.mappings import JsonObject
from nscc.neighbours.passes import with_pictures
from nscc.pipeline import Compiled, Found, Job, ProgramKind
from nscc.prove.proof import Failure
from nscc.words.container import Container

_REPORT = LazyFunctions("nscc.neighbours.picture_report")


class Images(ProgramKind):
    """What the compiler does for a program with images or planes.

    The exposure before them belongs to a program of another kind. A class inherits from this one
    first, then from that kind, so that `super()` is that kind."""

    has_simpler_programs = False

    def assemble(self, layout: Any, job: Job) -> tuple[Container, Found]:
        """Return the container (a compiled program) of the exposure with the words of images and
        planes after it, and diagnostics.

        `layout` is the value of the pass `schedule`, which contains the program. If an image or
        plane does not fit the chip, the container has only the exposure, and an error says why."""
        container, found = super().assemble(layout, job)
        program, level = layout.program, job.options.level
        container, errors = with_pictures(container, program, level, job.results)
        return container, [*found, *errors]

    def after_frame(self, container: Container) -> Failure | None:
        """Return the failure of the proof of the words after the frame; None if they are proved.

        What the kind of the exposure checks comes first, then images and planes."""
        from nscc.neighbours.pictures_proof import pictures_failure

        return super().after_frame(container) or pictures_failure(container)

    def report(self, compiled: Compiled) -> JsonObject:
        """Return the build report of the exposure (JSON values by key) with what images and planes
        cost.

        Their time is added to `frame_us`."""
        report: JsonObject = _REPORT.with_pictures(super().report(compiled), compiled.container)
        return report

    def rows(self, compiled: Compiled) -> list[tuple[str, str]]:
        """Return the rows (label, text) of the summary: those of images and planes, then those of
        the exposure.

        Return [] if the exposure has no rows."""
        rows = super().rows(compiled)
        return [*_REPORT.picture_rows(compiled.container), *rows] if rows else rows
