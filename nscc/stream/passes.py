"""The passes for chips without logic, as `nscc.pipeline` lists them."""

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


def plan_of(program: Program, word_options: Sequence[str]) -> tuple[Sending | NoRoute, Found]:
    """The route of the light, or why there is none (NS0509). `word_options` names options that
    concern words, which such a chip does not have (NS0510)."""
    if word_options:
        return NoRoute("", ""), [_no_words(program, word_options)]
    names = tuple(bucket.name for bucket in program.buckets)
    chosen_route = route(program.table.shutters, names, program.target)
    if isinstance(chosen_route, NoRoute):
        return chosen_route, [no_route(chosen_route, program.target.name, program)]
    return Sending(program, chosen_route), []


def timed(sending: Sending) -> tuple[Sending, Found]:
    """The same plan if every plane can be loaded in time, else NS0508."""
    fault = late_fault(sending)
    return sending, [fault] if fault else []


def container_of(sending: Sending) -> Container:
    """The container: no words, and bit planes if pixels have codes."""
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
