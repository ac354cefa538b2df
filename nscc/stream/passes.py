"""Compiler passes for chips without logic; `nscc.pipeline` lists all passes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from nscc.diagnostics.diagnostic import Diagnostic, Label, Rejected
from nscc.lower.resources import chip_label
from nscc.program.program import Program
from nscc.stream.route import NoRoute, Route, route
from nscc.stream.sending import Sending, late_fault
from nscc.words.container import Container, Readout
from nscc.words.stream import Stream


def laid(container: Container, way: Route) -> Container:
    """Add the bit planes of the pixel codes on a route to a container; none without pixel codes."""
    pixels = container.pixel_codes
    if pixels is None:
        return replace(container, stream=None)
    shutter = container.table.shutter_of_code[pixels]
    planes = [
        np.packbits(way.bits[:, slot][shutter], axis=1, bitorder="little")
        for slot in range(container.slots)
    ]
    return replace(container, stream=Stream(np.stack(planes), way.ones, way.zeros))


def with_planes(container: Container) -> Container:
    """Add the bit planes of the current pixel codes to a container of a chip without logic.

    Raises Rejected (NS0509) if there is no route for the light of its shutters."""
    chosen_route = route(container.table.shutters, container.buckets, container.target)
    if isinstance(chosen_route, NoRoute):
        raise Rejected(no_route(chosen_route, container.target.name))
    return laid(container, chosen_route)


def no_route(missing_route: NoRoute, chip: str, program: Program | None = None) -> Diagnostic:
    """Return the error (NS0509) that the chip cannot route the light as the program requires."""
    message = f"the pixels of {chip} cannot route light like this: {missing_route.reason}"
    help_text = (missing_route.help,)
    if program is None:
        return Diagnostic("NS0509", message, helps=help_text, data={"slot": missing_route.slot})
    taps = ", ".join(program.target.taps)
    return Diagnostic(
        "NS0509",
        message,
        source=program.source,
        label=Label(program.buckets[missing_route.bucket].span),
        related=chip_label(program, f"taps: {taps}" + "; a drain" * program.target.drain),
        notes=("certain: in each slot all pixels choose between the same two destinations",),
        helps=help_text,
        data={"slot": missing_route.slot},
    )


Found = Sequence[Diagnostic]


def plan_of(
    program: Program, lowering: str, most_words: int | None
) -> tuple[Sending | NoRoute, Found]:
    """Return the route of the light, or the reason why there is none (NS0509).

    Options that only apply to words (a lowering, a limit on words) are refused (NS0510)."""
    word_options = [f"--lowering {lowering}"] * (lowering != "auto")
    word_options += ["--max-words-per-slot"] * (most_words is not None)
    if word_options:
        options = " and ".join(word_options)
        no_words = Diagnostic(
            "NS0510",
            f"{options} does not apply: the pixels of {program.target.name} have no logic and "
            "run no words",
            source=program.source,
            label=Label(program.buckets[0].span),
            notes=("on this chip, one bit per pixel and slot routes the light",),
            helps=(f"leave {options} out, or compile for a chip with a processor in every pixel",),
        )
        return NoRoute("", ""), [no_words]
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
