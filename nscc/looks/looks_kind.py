"""The kind of programs whose pixels look at their light: a state machine opens the shutters."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, ClassVar

from nscc import checks
from nscc.lazy import LazyFunctions
from nscc.looks.checks import check_looking_gates, check_looking_plan
from nscc.looks.looks_proof import LookingReplay
from nscc.looks.passes import LookingLowered, container_of, lowered_of, plan_of
from nscc.lower import fit
from nscc.lower.lowered import Choice
from nscc.mappings import JsonObject
from nscc.operations import Op
from nscc.pipeline import Compiled, Found, Job, Pass, ProgramKind
from nscc.program.problems import counted
from nscc.prove.pixels import ReplayPixels
from nscc.words.container import Container

if TYPE_CHECKING:
    from networkx import DiGraph

_REPORT = LazyFunctions("nscc.looks.looks_report")


def lay_out_looking(layouts: Sequence[LookingLowered], job: Job) -> tuple[Choice, Found]:
    """Choose the words of the first, best lowering (way to compute the exposure).

    The errors say what does not fit the chip or the limits of the job. Without `layouts`, the
    choice is empty."""
    choice = Choice(tuple(layouts[:1]), {})
    return choice, fit.faults(choice, level=job.options.level)


class Looks(ProgramKind):
    """A program with senses, or with states that step from slot to slot."""

    passes: ClassVar[tuple[Pass, ...]] = (
        Pass("plan", plan_of, check_looking_plan, _REPORT.moments_text),
        Pass("gates", lowered_of, check_looking_gates, _REPORT.all_gates_text),
        Pass(
            "schedule",
            lay_out_looking,
            checks.check_schedule,
            LazyFunctions("nscc.emit.listing").choice_text,
        ),
    )
    shutters_known = False
    one_lowering_for = "pixels that look"
    has_simpler_programs = False

    def assemble(self, layout: Any, job: Job) -> tuple[Container, Found]:
        """Return the container (a compiled program) of the best lowered program of `layout` (the
        value of the pass `schedule`), and no diagnostics."""
        return container_of(layout.best, job.options.level), ()

    def replay(self, container: Container, kernels: Sequence[Sequence[Op]]) -> ReplayPixels:
        """Return the symbolic replay of a container (a compiled program) whose pixels look at their
        light.

        `kernels` are the words of each kernel, decoded."""
        return LookingReplay(container, kernels)

    def gates_text(self, lowered: Any) -> str:
        """Return the gates and words of every boundary of a lowered program, and its registers, as
        lines of text."""
        return str(_REPORT.looking_gates_text(lowered))

    def network(self, lowered: Any) -> DiGraph:
        """Return the network of gates of a lowered program as a graph (see `nscc.emit.network`)."""
        from nscc.looks.network import LookingNetwork

        return LookingNetwork(lowered).build_network()

    def report(self, compiled: Compiled) -> JsonObject:
        """Return the build report as JSON values, with the comparisons and states ("looks") and the
        number of proved answers.

        The program must be proved."""
        values = super().report(compiled)
        assert compiled.proof is not None
        values["proof"]["answers"] = compiled.proof.transitions
        # These two stand last in every report.
        end = {name: values.pop(name) for name in ("target", "source_sha256")}
        return {**values, "looks": _REPORT.looks_report(compiled.program), **end}

    def rows(self, compiled: Compiled) -> list[tuple[str, str]]:
        """Return the rows (label, text) of the summary: first the looks, and at last the number of
        proved answers, if there is a proof."""
        looks = _REPORT.looks_lines(compiled.program)
        # Only the first of several lines has the label.
        rows = [("looks" * (not number), text) for number, text in enumerate(looks)]
        rows += super().rows(compiled)
        if compiled.proof is not None:
            label, text = rows[-1]
            rows[-1] = label, f"{text}, {counted(compiled.proof.transitions, 'answer')}"
        return rows
