"""The planes of bits that a chip without logic is sent for the codes of its pixels."""

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
    """The container with the planes of its pixels' codes; without pixels it has none."""
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
    """The container of a chip without logic with planes for the codes that its pixels have now.

    Raises Rejected (NS0509) where the light of its shutters has no way.
    """
    chosen_route = route(container.table.shutters, container.buckets, container.target)
    if isinstance(chosen_route, NoRoute):
        raise Rejected(no_route(chosen_route, container.target.name))
    return laid(container, chosen_route)


def no_route(missing_route: NoRoute, chip: str, program: Program | None = None) -> Diagnostic:
    """NS0509: light cannot be sorted as the program wants. Certain."""
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
