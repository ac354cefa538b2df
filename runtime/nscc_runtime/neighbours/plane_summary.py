"""Where the bits of a plane are 1, and the reports that follow."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.words.pictures import PlaneReport

PlaneSummary = tuple[int, Sequence[int], NDArray[np.int32]]
"""The number of bits that are 1; their smallest x and y and largest x and y, four times -1 without
such bits; (x, y) of the first of them in reading order."""
NO_BOX = (-1, -1, -1, -1)


def summary_of(bits: NDArray[np.bool_]) -> PlaneSummary:
    """Return the summary of a plane (rows, cols), with the places of all bits that are 1."""
    rows, cols = np.nonzero(bits)
    places = np.stack([cols, rows], axis=1).astype(np.int32)
    box = (*places.min(axis=0), *places.max(axis=0)) if len(places) else NO_BOX
    return len(places), box, places


def reported(report: PlaneReport, summary: PlaneSummary) -> dict[str, NDArray[Any]]:
    """Return the arrays of a report about a plane; rows of -1 follow the last event."""
    name = report.key
    count, box, places = summary
    if report.kind == "flood":
        return {name: np.array(count == 0)}
    if report.kind == "any":
        return {name: np.array(count > 0)}
    if report.kind == "box":
        return {name: np.array(box, np.int32)}
    if report.kind == "count":
        return {name: np.array(count, np.int64)}
    events = np.full((report.most, 2), -1, np.int32)
    sent = min(count, report.most)
    events[:sent] = places[:sent]
    return {
        name: events,
        f"{name}_count": np.array(sent, np.int32),
        f"{name}_overflow": np.array(count > report.most),
    }
