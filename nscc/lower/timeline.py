"""The times of a frame, and the retention of digital registers."""

from __future__ import annotations

from collections.abc import Collection
from itertools import accumulate, pairwise

from nscc.chips.target import Target
from nscc.record import Record

# Share of the retention time that may be used: words take time, and the retention is a typical
# value.
RETENTION_SHARE = 0.9


class Timeline(Record):
    """The frame's times in microseconds.

    `boundary_us[n]` is the time of boundary n. `between_us` is the time from boundary N to the next
    frame's boundary 0 (readout). `keep_us` is the time for which registers keep their content.
    `refresh_at` are the boundaries within the frame at which registers must be refreshed; None if
    that is not enough."""

    boundary_us: tuple[float, ...]
    between_us: float
    keep_us: float
    refresh_at: tuple[int, ...] | None


def timeline(slot_us: tuple[float, ...], buckets: int, target: Target) -> Timeline:
    """Return the timeline of a frame with `buckets` readouts."""
    boundary_us = (0.0, *accumulate(slot_us))
    between_us = target.readout_us * buckets
    keep_us = RETENTION_SHARE * target.digital_retention_us
    refresh_at = _refresh_boundaries(boundary_us, between_us, keep_us)
    return Timeline(boundary_us, between_us, keep_us, refresh_at)


def _refresh_boundaries(
    boundary_us: tuple[float, ...], between_us: float, keep_us: float
) -> tuple[int, ...] | None:
    """Return the fewest boundaries that keep every gap, including the readout, within keep_us.

    None if a single slot or the readout is too long."""
    at: list[int] = []
    last = -between_us
    for n in range(1, len(boundary_us)):
        if boundary_us[n] - last > keep_us:
            if boundary_us[n] - boundary_us[n - 1] > keep_us or boundary_us[n - 1] <= last:
                return None
            at.append(n - 1)
            last = boundary_us[n - 1]
    return tuple(at)


def fades(written_at: Collection[int], time: Timeline) -> bool:
    """Return whether a register written at these boundaries of every frame exceeds the retention
    time."""
    if not written_at:
        return True
    times = [time.boundary_us[n] for n in sorted(written_at)]
    wrap = time.boundary_us[-1] - times[-1] + time.between_us + times[0]
    gaps = [b - a for a, b in pairwise(times)]
    return max([wrap, *gaps]) > time.keep_us
