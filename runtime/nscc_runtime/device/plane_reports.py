"""Reports that a device makes: where the bits of a plane are 1, instead of the plane itself.

The bytes of a report are the coordinates (u16 x, u16 y) of the first bits, then the u32 number of
bits and the u16 coordinates of the box around them. Coordinates that do not exist are 0xFFFF."""

from __future__ import annotations

from struct import Struct

import numpy as np

from nscc.words.container import Container
from nscc.words.reach import Reach, film_reaches
from nscc_runtime.container_cache import OfContainer
from nscc_runtime.device.messages import plane_bytes
from nscc_runtime.neighbours.plane_summary import NO_BOX, PlaneSummary

_COORDINATES = 4
_SUMMARY = Struct("<I4H")


def report_bytes(most: int) -> int:
    """Return the number of bytes of a report of at most `most` coordinates."""
    return _COORDINATES * most + _SUMMARY.size


@OfContainer
def device_reports(container: Container) -> dict[str, tuple[int, Reach]]:
    """Return the reports that need fewer bytes than their planes, by register: the most
    coordinates, and the margin of the plane.

    Planes that are read are sent anyway, and a margin that changes from frame to frame is known to
    the host only."""
    pictures, target = container.pictures, container.target
    if pictures is None or not pictures.reports:
        return {}
    film = film_reaches(container)
    if film is None or len(film) > 1:
        return {}
    reported: dict[str, tuple[int, Reach]] = {}
    for report in pictures.reports:
        register = pictures.registers[report.plane]
        most = max(report.most, reported.get(register, (0,))[0])
        reported[register] = most, film[0][report.plane]
    read = {pictures.registers[name] for name in pictures.reads}
    size = plane_bytes(target.rows * target.cols)
    return {
        name: (most, reach) for name, (most, reach) in reported.items()
        if name not in read and report_bytes(most) < size
    }  # fmt: skip


def split_reports(
    reports: dict[str, tuple[int, Reach]], data: bytes
) -> tuple[bytes, dict[str, PlaneSummary]]:
    """Return the bytes of a frame before its reports, and the summaries of planes by register."""
    summaries: dict[str, PlaneSummary] = {}
    for register, (most, _) in reversed(reports.items()):
        data, report = data[: -report_bytes(most)], data[-report_bytes(most) :]
        places = np.frombuffer(report, "<u2", 2 * most).reshape(most, 2)
        count, *box = _SUMMARY.unpack_from(report, _COORDINATES * most)
        places = places[: min(count, most)]
        summaries[register] = count, box if count else NO_BOX, places.astype(np.int32)
    return data, summaries
