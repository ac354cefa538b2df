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
    found = route(container.table.shutters, container.buckets, container.target)
    if isinstance(found, NoRoute):
        raise Rejected(no_route(found, container.target.name))
    return laid(container, found)


def no_route(found: NoRoute, chip: str, program: Program | None = None) -> Diagnostic:
    """NS0509: light cannot be sorted as the program wants. Certain."""
    said = f"the pixels of {chip} cannot route light like this: {found.reason}"
    help_text = (found.help,)
    if program is None:
        return Diagnostic("NS0509", said, helps=help_text, data={"slot": found.slot})
    taps = ", ".join(program.target.taps)
    return Diagnostic(
        "NS0509",
        said,
        source=program.source,
        label=Label(program.buckets[found.bucket].span),
        related=chip_label(program, f"taps: {taps}" + "; a drain" * program.target.drain),
        notes=("certain: in each slot all pixels choose between the same two destinations",),
        helps=help_text,
        data={"slot": found.slot},
    )
