"""Measured points of a tradeoff, as a CSV file and as a text table."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from dataclasses import dataclass
from statistics import median

from nscc.columns import columns

COLUMNS = (
    "method", "setting", "error", "error_unit", "time_ms", "spread_ms", "device", "dominated",
)  # fmt: skip

STAGES = ("compile", "lowering", "slots", "effects", "decoder")
"""The stages of the joint tradeoff of one program, in order."""


@dataclass(frozen=True)
class Point:
    """One method at one setting, measured several times on one problem.

    Points with the same `case` and `error_unit` are comparable. A smaller `error` is better unless
    `more_is_better`, as for PSNR. `bound` is a lower bound for all settings of the method, None if
    unknown. `times_ms` are all measured times. `device` is their device if it differs from that of
    most points."""

    case: str
    method: str
    setting: str
    error: float
    error_unit: str
    times_ms: tuple[float, ...]
    bound: float | None = None
    more_is_better: bool = False
    device: str = ""

    @property
    def badness(self) -> float:
        """The error, negated if a larger value is better."""
        return -self.error if self.more_is_better else self.error

    @property
    def time_ms(self) -> float:
        """The median time in milliseconds."""
        return median(self.times_ms)

    @property
    def spread_ms(self) -> float:
        """The difference between the longest and the shortest time in milliseconds."""
        return max(self.times_ms) - min(self.times_ms)


@dataclass(frozen=True)
class Refused:
    """A setting that cannot be measured, with the error's code and message."""

    case: str
    method: str
    setting: str
    code: str
    reason: str


def dominated(points: Sequence[Point]) -> list[bool]:
    """Return for each point whether another point of its case and unit dominates it.

    A dominating point is no worse in error and time, and better in one of them."""
    flags = []
    for point in points:
        mine, kind = (point.badness, point.time_ms), (point.case, point.error_unit)
        rivals = ((p.badness, p.time_ms) for p in points if (p.case, p.error_unit) == kind)
        flags.append(any(e <= mine[0] and t <= mine[1] and (e, t) != mine for e, t in rivals))
    return flags


def csv_text(points: Sequence[Point], device: str, refused: Sequence[Refused] = ()) -> str:
    """Return the points, measured on `device`, as CSV with COLUMNS.

    The column `method` combines case and method; `spread_ms` is the longest minus the shortest
    time. The `refused` settings follow without numbers, with their code as unit."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(COLUMNS)
    for point, beaten in zip(points, dominated(points), strict=True):
        name, error = f"{point.case}, {point.method}", f"{point.error:.10g}"
        times = _csv_ms(point.time_ms), _csv_ms(point.spread_ms)
        made_on, flag = point.device or device, "yes" if beaten else "no"
        writer.writerow((name, point.setting, error, point.error_unit, *times, made_on, flag))
    for refusal in refused:
        name = f"{refusal.case}, {refusal.method}"
        writer.writerow((name, refusal.setting, "", refusal.code, "", "", device, ""))
    return text.getvalue()


def table_text(
    points: Sequence[Point], names: tuple[str, str, str], time: tuple[str, float] = ("ms", 1.0)
) -> str:
    """Return the points as a text table.

    `names` are the titles of the columns for method, setting and error. `time` is the unit of times
    and its number per millisecond. Repeated cases and methods are left blank. A column of bounds is
    added if there are any. Dominated points are marked."""
    head: tuple[str, ...] = ("case", *names, "bound", time[0], "spread", "")
    rows = [head]
    before = ("", "")
    for point, beaten in zip(points, dominated(points), strict=True):
        label = (point.case, point.method)
        rows.append(
            (
                point.case if point.case != before[0] else "",
                point.method if label != before else "",
                point.setting,
                f"{point.error:.6g}",
                "" if point.bound is None else f"{point.bound:.6g}",
                _three_digits(point.time_ms * time[1]),
                _three_digits(point.spread_ms * time[1]),
                "dominated" if beaten else "",
            )
        )
        before = label
    if not any(row[4] for row in rows[1:]):
        rows = [(*row[:4], *row[5:]) for row in rows]
    return columns(rows, left_aligned=(0, 1, 2, len(rows[0]) - 1))


def _three_digits(time: float) -> str:
    """Format a time with three significant digits, or as a whole number from 100 on."""
    return f"{time:.0f}" if time >= 100 else f"{time:.3g}"


def _csv_ms(time_ms: float) -> str:
    """Format a time in milliseconds with three decimals, six for times below 0.1 ms."""
    return f"{time_ms:.6f}" if 0 < time_ms < 0.1 else f"{time_ms:.3f}"
