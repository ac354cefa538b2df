"""The bit planes of a chip without logic for the codes of its pixels."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from nscc.diagnostics.diagnostic import Diagnostic, Label, Rejected
from nscc.lower.resources import chip_label
from nscc.program.program import Program
from nscc.stream.route import NoRoute, Route, route
from nscc.words.container import Container
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
