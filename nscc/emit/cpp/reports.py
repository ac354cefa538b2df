"""C++ that reports planes and sums of images, and the margins that the reports leave out."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import product
from math import prod

from nscc.emit.cpp.cpp_text import comment, literal, template_lines
from nscc.words.assembly_text import number_text
from nscc.words.container import Container
from nscc.words.reach import Reach, beyond_reaches, film_reaches
from nscc.words.readout import converted_buckets, preparation_of

_MOST_MARGINS = 1024
"""Most combinations of values of parameters with a margin of their own."""


@dataclass(frozen=True)
class Margins:
    """How far from each side of the array pixels depend on light beyond it, in several cases.

    `cases` has the reach of every plane and image, by name. `of_frame` are C++ expressions for the
    numbers of the cases that hold in a frame: its margin is on each side the smallest of them. The
    last case stands for larger numbers, too. `remark` says in which cases a margin may be too
    large, "" if in none."""

    cases: list[dict[str, Reach]]
    of_frame: list[str]
    remark: str = ""


def margins_of(container: Container) -> Margins | None:
    """Return the margins of all frames; None if they grow with every frame.

    The cases are frames or, if parameters set numbers of steps, the values of these parameters: all
    combinations, or the values of each parameter if there are too many combinations."""
    pictures = container.pictures
    looped = {loop.times.param for loop in pictures.loops}
    places = {n: param for n, param in enumerate(pictures.params) if param.name in looped}
    film = film_reaches(container, [param.name for param in places.values()])
    if film is None:
        return None
    if not places:
        return Margins(film, ["frame"])
    before = {name: film[-1][name] for name in pictures.stepping}
    sizes = {n: param.high - param.low + 1 for n, param in places.items()}
    axes, remarks = [[*places]], []
    if prod(sizes.values()) > _MOST_MARGINS:
        axes = [[n] for n in places if sizes[n] <= _MOST_MARGINS]
        remarks.append("the largest for all values of the other sliders")
    if any(reach != Reach() for reach in before.values()):
        remarks.append("the largest for all values of the sliders in earlier frames")
    margins = Margins([], [], " and ".join(remarks))
    for axis in axes:
        row = "0"
        for n in axis:
            row = f"({row}) * {sizes[n]} + param_{n} - ({places[n].low})"
        margins.of_frame.append(f"{len(margins.cases)} + {row}")
        others = [param.name for n, param in places.items() if n not in axis]
        ranges = (range(places[n].low, places[n].high + 1) for n in axis)
        for values in product(*ranges):
            params = {places[n].name: value for n, value in zip(axis, values, strict=True)}
            margins.cases.append(beyond_reaches(container, before, params, others))
    return margins if axes else replace(margins, cases=film[-1:], of_frame=["0"])


def report_lines(container: Container, margins: Margins) -> Iterator[str]:
    """Yield the C++ functions that report, and the margins of each report.

    `container` is the compiled program without the words of images and planes."""
    pictures, target = container.pictures, container.target
    yield "#ifdef __LPC43XX__"
    if margins.remark:
        yield from comment(f"Margins of a value of a slider are {margins.remark}.")
    for number, report in enumerate(pictures.reports):
        widths = ([min(far, 65535) for far in case[report.plane]] for case in margins.cases)
        rows = ", ".join(f"{{{', '.join(map(str, row))}}}" for row in widths)
        yield f"const uint16_t margin_{number}[][4] = {{{rows}}};"
    sizes = {"rows": target.rows, "cols": target.cols}
    yield from template_lines("margins")
    kinds = {report.kind == "sum" for report in pictures.reports}
    if False in kinds:
        yield from ["", *template_lines("report", **sizes)]
    if True in kinds:
        yield from ["", *template_lines("sum", **sizes)]
    yield from ["#endif", ""]


def reporting_lines(container: Container, margins: Margins) -> Iterator[str]:
    """Yield the C++ lines that send the reports of a frame to the host; `container` is the compiled
    program with the words of images and planes."""
    pictures = container.pictures
    yield "#ifdef __LPC43XX__"
    cases = ", ".join(f"uint32_t({case})" for case in margins.of_frame)
    yield f"        const uint32_t cases[] = {{{cases}}};"
    spread = converted_buckets(container) if preparation_of(container).level is not None else {}
    for number, report in enumerate(pictures.reports):
        register, title = pictures.registers[report.plane], f"{report.kind} {report.plane}"
        function, last = "report", str(report.most)
        if report.kind == "sum":
            # The converter is symmetric around 0, except for exposures spread over its codes.
            full = replace(container.target, readout="full")
            converter = container.target if register in spread else full
            step_e = number_text(round(converter.electrons_per_lsb, 3))
            title = f"sum {report.subject} (steps of {step_e} e)"
            function, last = "sum", number_text(converter.zero_lsb)
        yield f"        {function}({literal(title)}, {register}, margin_{number}, cases, {last});"
    yield "        frame += frame < 65535;"
    yield "#endif"
