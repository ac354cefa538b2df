"""Where the bits of a plane are 1, and the reports that follow."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.words.pictures import PlaneReport


@dataclass(frozen=True, eq=False)
class PlaneSummary:
    """Where the bits of a plane are 1.

    `count`: the number of bits that are 1. `box`: the smallest x and y and the largest x and y of
    these bits, None if there are none. `places`: (x, y) of the first bits in reading order."""

    count: int
    box: tuple[int, ...] | None
    places: NDArray[np.int32]


def summary_of(bits: NDArray[np.bool_]) -> PlaneSummary:
    """Return the summary of a plane (rows, cols), with the places of all bits that are 1."""
    rows, cols = np.nonzero(bits)
    places = np.stack([cols, rows], axis=1).astype(np.int32)
    box = (*places.min(axis=0), *places.max(axis=0)) if len(places) else None
    return PlaneSummary(len(places), box, places)


def reported(report: PlaneReport, summary: PlaneSummary) -> dict[str, NDArray[Any]]:
    """Return the arrays of a report about a plane.

    Events are (x, y) in reading order, followed by rows of -1. The box is four times -1 if no bit
    is 1."""
    name = f"report_{report.kind}_{report.plane}"
    if report.kind == "any":
        return {name: np.array(summary.count > 0)}
    if report.kind == "box":
        return {name: np.array(summary.box or [-1] * 4, np.int32)}
    places = np.full((report.most, 2), -1, np.int32)
    count = min(summary.count, report.most)
    places[:count] = summary.places[:count]
    return {
        name: places,
        f"{name}_count": np.array(count, np.int32),
        f"{name}_overflow": np.array(summary.count > report.most),
    }
