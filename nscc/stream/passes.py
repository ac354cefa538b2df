"""Compiler passes for chips without logic; `nscc.pipeline` lists all passes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from nscc.diagnostics.diagnostic import Diagnostic, Label
from nscc.program.program import Program
from nscc.stream.planes import laid, no_route
from nscc.stream.route import NoRoute, route
from nscc.stream.sending import Sending, late_fault
from nscc.words.container import Container, Readout

Found = Sequence[Diagnostic]


def plan_of(
    program: Program, lowering: str, most_words: int | None
) -> tuple[Sending | NoRoute, Found]:
    """Return the route of the light, or the reason why there is none (NS0509).

    Options that only apply to words (a lowering, a limit on words) are refused (NS0510)."""
    word_options = [f"--lowering {lowering}"] * (lowering != "auto")
    word_options += ["--max-words-per-slot"] * (most_words is not None)
    if word_options:
        return NoRoute("", ""), [_no_words(program, word_options)]
    names = tuple(bucket.name for bucket in program.buckets)
    chosen_route = route(program.table.shutters, names, program.target)
    if isinstance(chosen_route, NoRoute):
        return chosen_route, [no_route(chosen_route, program.target.name, program)]
    return Sending(program, chosen_route), []


def timed(sending: Sending) -> tuple[Sending, Found]:
    """Return the same plan, and an error (NS0508) if a plane cannot be loaded in time."""
    fault = late_fault(sending)
    return sending, [fault] if fault else []


def container_of(sending: Sending) -> Container:
    """Return the container: no words, and bit planes if the pixels have codes."""
    program, target = sending.program, sending.program.target
    names = tuple(bucket.name for bucket in program.buckets)
    used = len(names)
    container = Container(
        target=target,
        slot_us=program.frame.slot_us,
        buckets=names,
        table=program.table,
        kernels=(),
        launches=(),
        code_registers=(),
        encoding=np.zeros((len(program.table.shutters), 0), np.bool_),
        pixel_codes=program.pixel_codes,
        readouts=tuple(
            Readout(tap, name, gain)
            for tap, name, gain in zip(target.taps[:used], names, target.gains[:used], strict=True)
        ),
        source_lines=tuple(program.source.text.splitlines()),
        notes={"class": program.class_name, "codes": program.mode, "lowering": "stream"},
    )
    return laid(container, sending.route)


def _no_words(program: Program, word_options: Sequence[str]) -> Diagnostic:
    options = " and ".join(word_options)
    return Diagnostic(
        "NS0510",
        f"{options} does not apply: the pixels of {program.target.name} have no logic and "
        "run no words",
        source=program.source,
        label=Label(program.buckets[0].span),
        notes=("on this chip, one bit per pixel and slot routes the light",),
        helps=(f"leave {options} out, or compile for a chip with a processor in every pixel",),
    )
