"""The kind of programs whose shutters depend on the code of a pixel only. Other kinds change it.

The passes plan the exposure, find gates that decode the codes, and lay the words out."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from nscc import checks
from nscc.diagnostics.rejection import rejected
from nscc.lazy import LazyFunctions
from nscc.lower import fit
from nscc.lower.exposure_plan import Planned, frame_time, plan_exposures
from nscc.lower.gates import Gated, find_gates
from nscc.lower.lowered import Choice, assemble, lay_out
from nscc.operations import Op
from nscc.pipeline import Compiled, Found, Job, Pass
from nscc.program.problems import counted
from nscc.program.program import Program
from nscc.prove.pixels import ReplayPixels
from nscc.prove.proof import Failure, Proof, Replay, prove, readout_failure, shutters
from nscc.words.container import Container
from nscc.words.legality import decoded

if TYPE_CHECKING:
    from networkx import DiGraph

_TEXTS = LazyFunctions("nscc.emit.listing")
_SUMMARY = LazyFunctions("nscc.emit.summary")


def make_plans(program: Program, job: Job) -> tuple[Planned, Found]:
    """Make an exposure plan for each lowering that supports the program.

    Errors: NS0412 for more shutters than a pixel's registers can distinguish, NS0413 for more
    buckets than analog registers, NS0414 for a lowering that does not support the program."""
    fault = fit.capacity_fault(program)
    if fault is not None:
        return Planned(program, frame_time(program), (), (), {}), [fault]
    planned = plan_exposures(program, job.options.lowering)
    return planned, [] if planned.plans else [fit.plan_fault(program, planned.misfits)]


def choose_gates(planned: Planned, job: Job) -> tuple[Gated, Found]:
    """Find gates and encodings for the plans, with their costs; the best comes first.

    Plans that cannot be better than one that fits are not tried, unless all costs are requested.
    Errors: NS0502 if no gates are found, which does not prove that none exist; NS0905 if a
    generator of another package returns invalid gates. Warning: NS0504 if a generator fails."""
    options, results = job.options, job.results
    search = partial(
        find_gates,
        planned,
        options.level,
        price_all=options.price_all,
        results=results,
        most_words=options.max_words_per_slot,
    )
    gated = search()
    if results is not None and results.read and not gated.fits:
        # The result that nothing fits is never taken from the cache.
        results.distrust()
        gated = search()
    messages = list({fault.generator: fault.diagnostic() for fault in gated.faults}.values())
    if not gated.decodings:
        messages.append(fit.gates_fault(gated.program, gated.misfits, level=options.level))
    return gated, messages


def lay_out_words(gated: Gated, job: Job) -> tuple[Choice, Found]:
    """Assign kernels and launches to the frame's boundaries; the best lowering comes first.

    Errors: a program that exceeds the store (NS0501), the slots' time (NS0601), the retention time
    of registers (NS0602) or the user's limit (NS0603)."""
    most_words = job.options.max_words_per_slot
    layouts = (
        lay_out(gated.program, decoding, gated.time, most_words) for decoding in gated.decodings
    )
    failed = tuple(dict.fromkeys(fault.generator for fault in gated.faults))
    choice = Choice(tuple(layouts), gated.misfits, failed)
    return choice, fit.faults(choice, level=job.options.level)


class FixedShutters:
    """A program whose shutters depend on the code only; the methods are those of `ProgramKind`."""

    passes: ClassVar[tuple[Pass, ...]] = (
        Pass("plan", make_plans, checks.check_plans, _TEXTS.plans_text),
        Pass("gates", choose_gates, checks.check_gates, _TEXTS.all_gates_text),
        Pass("schedule", lay_out_words, checks.check_schedule, _TEXTS.choice_text),
    )
    subject = "words"
    shutters_known = True
    has_simpler_programs = True

    def assemble(self, layout: Any, job: Job) -> tuple[Container, Found]:
        return assemble(layout.best, job.options.level), ()

    # --- the proof

    def replay(self, container: Container, kernels: Sequence[Sequence[Op]]) -> ReplayPixels:
        """Return the pixels that the proof runs the words on."""
        return Replay(container, kernels)

    def after_frame(self, container: Container) -> Failure | None:
        """Return the first error of the words after the exposure."""
        return readout_failure(container)

    def prove(self, container: Container, kernels: Sequence[Sequence[Op]]) -> Proof:
        return prove(container, kernels, self.replay, self.after_frame)

    def replayed(self, container: Container, name: str) -> NDArray[np.bool_]:
        opened = shutters(container, decoded(container))
        if opened is None:
            raise rejected(
                "NS0442",
                f"the words of {name} do not implement shutters: the light of some slot has a "
                "weight other than 0 or 1",
                helps=("`nscc prove` shows the error in the words",),
                status=1,
            )
        return opened

    def refuse_unknown_shutters(self, name: str) -> None:
        """Shutters that depend on the code only are known."""

    def with_planes(self, container: Container) -> Container:
        return container

    # --- descriptions

    def product(self, product: str, compiled: Compiled, stem: str) -> dict[str, bytes]:
        from nscc.emit.products import word_product

        return word_product(product, compiled, stem, self)

    def gates_text(self, lowered: Any) -> str:
        return str(_TEXTS.gates_text(lowered.decoding, lowered.program))

    def network(self, lowered: Any) -> DiGraph:
        from nscc.emit.network import network_of

        return network_of(lowered)

    def words_text(self, container: Container) -> str:
        from nscc.words.disassembly import disassemble

        return disassemble(container)

    def report(self, compiled: Compiled) -> dict[str, Any]:
        from nscc.emit.report import report

        assert compiled.proof is not None
        return report(compiled.layout, compiled.proof)

    def rows(self, compiled: Compiled) -> list[tuple[str, str]]:
        rows: list[tuple[str, str]] = _SUMMARY.word_rows(compiled)
        return rows

    def cost_text(self, compiled: Compiled) -> str:
        return str(_SUMMARY.word_cost_text(compiled))

    def size_text(self, container: Container) -> str:
        return counted(container.words_per_frame, "word")

    def stored_row(self, container: Container) -> tuple[str, str]:
        stored = sum(len(kernel.words) for kernel in container.kernels)
        return "words", f"{stored} stored, {container.words_per_frame} a frame"

    def kept_text(self, container: Container) -> str:
        planes = counted(len(container.code_registers), "plane of code", "planes of code")
        return f"{counted(container.words_stored, 'word')}, {planes}"

    def readout_us(self, container: Container) -> float:
        return container.target.readout_us * len(container.readouts)

    def frame_text(self, compiled: Compiled) -> str:
        return str(_SUMMARY.word_frame_text(compiled.lowered))

    def slot_text(self, compiled: Compiled, slot: int) -> str:
        return str(_SUMMARY.word_slot_text(compiled.lowered, slot))
