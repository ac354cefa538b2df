"""Measured points of a tradeoff, as a CSV file and as a text table."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from nscc.columns import columns
from nscc_runtime.pictures.precision import Point, dominated

COLUMNS = (
    "method",
    "setting",
    "error",
    "error_unit",
    "time_ms",
    "spread_ms",
    "device",
    "dominated",
)


class Refused(NamedTuple):
    """A setting of a method on a case that was refused, with the `code` of the message ("" without
    one) and its text, the `reason`."""

    case: str
    method: str
    setting: str
    code: str
    reason: str


def csv_text(points: Sequence[Point], device: str, refused: Sequence[Refused] = ()) -> str:
    """Return the points, measured on `device`, as CSV with COLUMNS.

    The column `method` combines case and method; `spread_ms` is the longest minus the shortest
    time. `dominated` says whether another point is both more accurate and faster. The `refused`
    settings follow without numbers, with their code as unit."""
    rows = []
    for point, beaten in zip(points, dominated(points), strict=True):
        name, error = f"{point.case}, {point.method}", f"{point.error:.10g}"
        times = _csv_ms(point.time_ms), _csv_ms(point.spread_ms)
        made_on, flag = point.device or device, "yes" if beaten else "no"
        rows.append((name, point.setting, error, point.error_unit, *times, made_on, flag))
    for refusal in refused:
        name = f"{refusal.case}, {refusal.method}"
        rows.append((name, refusal.setting, "", refusal.code, "", "", device, ""))
    return csv_of(COLUMNS, rows)


def csv_of(head: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    """Return rows of cells as CSV; `head` are the names of the columns, in the first line."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(head)
    writer.writerows(rows)
    return text.getvalue()


def refusals_text(refused: Sequence[Refused]) -> list[str]:
    """Return a line for each reason why settings of a method have no point: "CASE, METHOD,
    SETTINGS: REASON (CODE)". Settings with the same names and reason share a line."""
    settings: dict[tuple[str, str], list[str]] = {}
    for refusal in refused:
        name = ", ".join(filter(None, (refusal.case, refusal.method)))
        code = f" ({refusal.code})" if refusal.code else ""
        settings.setdefault((name, f"{refusal.reason}{code}"), []).append(refusal.setting)
    return [
        f"{', '.join(filter(None, (name, ', '.join(named))))}: {reason}"
        for (name, reason), named in settings.items()
    ]


def table_text(
    points: Sequence[Point], names: tuple[str, str, str], time: tuple[str, float] = ("ms", 1.0)
) -> str:
    """Return the points as a text table, in their order, below a line of titles.

    `names` are the titles of the columns for method, setting and error. `time` is the unit of times
    and how many of it a millisecond has, such as ("us", 1e3). Repeated cases and methods are left
    blank. A column of lower bounds is added if any point has one. A point is marked as dominated if
    another is both more accurate and faster."""
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
                three_digits(point.time_ms * time[1]),
                three_digits(point.spread_ms * time[1]),
                "dominated" if beaten else "",
            )
        )
        before = label
    if not any(row[4] for row in rows[1:]):
        rows = [(*row[:4], *row[5:]) for row in rows]
    return columns(rows, left_aligned=(0, 1, 2, len(rows[0]) - 1))


def three_digits(time: float) -> str:
    """Return a number, here a time in any unit, as text with three significant digits, or as a
    whole number from 100 on."""
    return f"{time:.0f}" if time >= 100 else f"{time:.3g}"


def _csv_ms(time_ms: float) -> str:
    """Return a time in milliseconds as text with three decimals; with six if it is below 0.1 ms but
    not 0."""
    return f"{time_ms:.6f}" if 0 < time_ms < 0.1 else f"{time_ms:.3f}"
