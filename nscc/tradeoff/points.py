"""Measured points of a tradeoff: which of them others beat, as a CSV file and as a table."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from dataclasses import dataclass
from statistics import median

COLUMNS = (
    "method", "setting", "error", "error_unit", "time_ms", "spread_ms", "device", "dominated",
)  # fmt: skip


@dataclass(frozen=True)
class Point:
    """One method at one setting, measured several times on one problem.

    Points compare within their `case` and `error_unit`. `error` is the less the better; `bound` is
    what no setting of the method can get below, None where that is not known. `times_ms` are all
    measurements.
    """

    case: str
    method: str
    setting: str
    error: float
    error_unit: str
    times_ms: tuple[float, ...]
    bound: float | None = None

    @property
    def time_ms(self) -> float:
        """The median."""
        return median(self.times_ms)

    @property
    def spread_ms(self) -> float:
        """From the shortest measurement to the longest."""
        return max(self.times_ms) - min(self.times_ms)


def dominated(points: Sequence[Point]) -> list[bool]:
    """For each point, whether another of its case and unit has neither more error nor more time,
    and less of one of them."""
    flags = []
    for point in points:
        mine, kind = (point.error, point.time_ms), (point.case, point.error_unit)
        others = ((p.error, p.time_ms) for p in points if (p.case, p.error_unit) == kind)
        flags.append(any(e <= mine[0] and t <= mine[1] and (e, t) != mine for e, t in others))
    return flags


def csv_text(points: Sequence[Point], device: str) -> str:
    """The points as CSV with COLUMNS; `device` is what they were measured on.

    `method` is case and method together; `spread_ms` is the longest less the shortest measurement.
    """
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(COLUMNS)
    for point, beaten in zip(points, dominated(points), strict=True):
        writer.writerow(
            (
                f"{point.case}, {point.method}",
                point.setting,
                f"{point.error:.10g}",
                point.error_unit,
                f"{point.time_ms:.3f}",
                f"{point.spread_ms:.3f}",
                device,
                "yes" if beaten else "no",
            )
        )
    return text.getvalue()


def table_text(points: Sequence[Point], names: tuple[str, str, str]) -> str:
    """The points for a reader; `names` head the columns of method, setting and error.

    A case or method is named once. Points that another one beats say so.
    """
    head = ("case", *names, "bound", "ms", "spread", "")
    rows = [head]
    before = ("", "")
    for point, beaten in zip(points, dominated(points), strict=True):
        here = (point.case, point.method)
        rows.append(
            (
                point.case if point.case != before[0] else "",
                point.method if here != before else "",
                point.setting,
                f"{point.error:.6g}",
                "" if point.bound is None else f"{point.bound:.6g}",
                _ms(point.time_ms),
                _ms(point.spread_ms),
                "dominated" if beaten else "",
            )
        )
        before = here
    widths = [max(len(row[i]) for row in rows) for i in range(len(head))]
    left = (0, 1, 2, len(head) - 1)
    lines = []
    for row in rows:
        cells = (
            f"{cell:<{width}}" if i in left else f"{cell:>{width}}"
            for i, (cell, width) in enumerate(zip(row, widths, strict=True))
        )
        lines.append("  ".join(cells).rstrip())
    return "\n".join(lines)


def _ms(time_ms: float) -> str:
    """Milliseconds with three digits, more where there are that many before the point."""
    return f"{time_ms:.0f}" if time_ms >= 100 else f"{time_ms:.3g}"
