"""The diagram of words against compile time."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby
from typing import TYPE_CHECKING

from nscc.tradeoff.points import Point
from nscc_runtime.pictures.precision import Panel, PointReading, precision_diagram

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def images_diagram(points: Sequence[Point]) -> Figure:
    """Draw, for each image of `nscc.tradeoff.synthesis`, noise against time, a line per kernel."""
    groups = groupby(points, key=lambda point: point.case)
    panels = [Panel(case, "errors of one word", list(group)) for case, group in groups]
    return precision_diagram(
        panels, "Programs of words for kernels",
        "standard deviation of the error that the words add (numbers: words; hollow: dominated) "
        "against their time",
        PointReading("time, us", 1e3, text=lambda point: point.setting.partition(" ")[0]),
    )  # fmt: skip


def synthesis_diagram(points: Sequence[Point], words: str, repeats: int, device: str) -> Figure:
    """Draw, for each program of `nscc.tradeoff.synthesis`, words against time, one line per
    lowering.

    `words` names the words that are counted. `repeats` compilations were timed on `device`."""
    panels = [
        Panel(case, words, list(group)) for case, group in groupby(points, key=lambda p: p.case)
    ]
    levels = " ".join(sorted({point.setting for point in points}))
    times = "one compilation" if repeats == 1 else f"median and range of {repeats} compilations"
    return precision_diagram(
        panels, "What compile time buys",
        f"{words} at {levels} (numbers; hollow: dominated) against {times}, from text to proof, "
        f"on {device}",
        PointReading("time, s", 1e-3, text=lambda point: point.setting.removeprefix("-O")),
    )  # fmt: skip
