"""Where the bits of a plane are 1, and the reports that follow."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from nscc.arrays import Array, Bools, Ints32
from nscc.words.pictures import PlaneReport

PlaneSummary = tuple[int, Sequence[int], Ints32]
"""The number of bits that are 1; their smallest x and y and largest x and y, four times -1 without
such bits; (bits, 2): x and y of the first of these bits in reading order, at least as many as the
reports of the plane may send. x is a column, y a row."""
NO_BOX = (-1, -1, -1, -1)


def summary_of(bits: Bools) -> PlaneSummary:
    """Return the summary of a plane (rows, cols), with x and y of all bits that are 1, row after
    row. Without such bits the box is `NO_BOX`, and the coordinates have shape (0, 2)."""
    rows, cols = np.nonzero(bits)
    places = np.stack([cols, rows], axis=1).astype(np.int32)
    box = (*places.min(axis=0), *places.max(axis=0)) if len(places) else NO_BOX
    return len(places), box, places


def report_of(report: PlaneReport, values: Array, margin: Bools) -> dict[str, Array]:
    """Return the arrays of a report, by key, about `values` (rows, cols): the electrons of an image
    for a report of its sum, else the bits of a plane. Pixels of the `margin` do not count."""
    if report.kind == "sum":
        return {report.key: np.array(values[~margin].sum())}
    return reported(report, summary_of(values & ~margin))


def reported(report: PlaneReport, summary: PlaneSummary) -> dict[str, Array]:
    """Return the arrays of a report about a plane, by the report's key.

    `flood`: whether no bit is 1; `any`: whether a bit is; `box`: smallest x and y, largest x and y,
    or -1; `count`: the number of bits. `events`: x and y of the first bits, (most, 2), with rows of
    -1 after the last; KEY_count tells how many, and KEY_overflow whether there are more."""
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
