"""Times of a clip's frames: clips whose frames last unequally are resampled to even steps."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import compress, islice, pairwise, repeat
from typing import Any

import numpy as np

from nscc.arrays import Floats
from nscc_runtime.scenes.pages import Edges, Note, Pages

_CLOCK_S = 1e-3
"""Clocks of files round times to this unit."""
_SLACK = 1e-6
"""Error of sums of floating-point times, in seconds."""
_EVEN_SHARE = 0.5
"""Durations that differ by at most this fraction of the shortest are equal, within the clock."""


def timed(pages: Pages) -> Pages:
    """Return the clip `pages`; if its frames last unequally, with their starts in `edges`, in units
    of the shortest duration.

    Frames of 0 ms are left out, because no viewer shows them. Notes say what is unusual. A file
    without a clock, of one picture, or of frames that all last 0 ms is returned as it is."""
    if pages.durations_s is None or pages.count < 2:
        return pages
    durations_s = pages.durations_s()
    shown = durations_s > 0
    if not shown.any():
        return pages
    notes: list[Note] = []
    if not shown.all():
        count = int(np.count_nonzero(~shown))
        # 's' * False is "".
        text = f"has {count} frame{'s' * (count > 1)} of 0 ms, which {'are' if count > 1 else 'is'}"
        notes.append((f"{text} left out", "give every frame a duration to expose it"))
        frames = pages.read
        pages = replace(
            pages, count=len(shown) - count, read=lambda: compress(frames(), shown.tolist())
        )
        durations_s = durations_s[shown]
    edges = None if _even(durations_s) else _edges(durations_s)
    if edges is not None:
        low, high = (1e3 * float(size) for size in (durations_s.min(), durations_s.max()))
        notes.append(
            (
                f"has frames of {low:.4g} to {high:.4g} ms: without --fps they are repeated "
                f"in steps of {low:.4g} ms, the shortest",
                "--fps F shows each frame for its own time, and F of these steps per second",
            )
        )
    return replace(pages, edges=edges, notes=(*pages.notes, *notes))


def _even(durations_s: Floats) -> bool:
    """Return whether the frame durations `durations_s` (one or more) are equal, up to the rounding
    of a clock to 1 ms."""
    shortest, difference_s = float(durations_s.min()), float(np.ptp(durations_s))
    if difference_s > _CLOCK_S + _SLACK:
        return False
    # Durations that are short beside the clock's unit differ by much of themselves: they are even
    # if the rounding errors do not add up, so that no frame is off by more than a unit.
    mean = np.arange(len(durations_s) + 1) * durations_s.mean()
    drift_s = np.ptp(np.cumsum([0, *durations_s]) - mean)
    return bool(difference_s <= _EVEN_SHARE * shortest or drift_s <= _CLOCK_S + _SLACK)


def _edges(durations_s: Floats) -> tuple[Fraction, ...]:
    """Return the starts of frames with these `durations_s` (above 0), and the end of the last, as
    fractions in units of the shortest duration."""
    steps = durations_s / durations_s.min()
    edges = [Fraction(0)]
    for step in steps.tolist():
        # Ratios of rounded times are close to simple fractions; these keep exact sums short.
        edges.append(edges[-1] + Fraction(step).limit_denominator(1_000_000))
    return tuple(edges)


def from_frame(edges: Edges, first: int) -> Edges:
    """Return the `edges` of a clip (starts of its frames and its end, or None) that begins with
    frame number `first`, from 0. They are unchanged if the clip ends earlier, which the caller
    reports."""
    if edges is None or first >= len(edges):
        return edges
    return tuple(edge - edges[first] for edge in edges[first:])


def evenly(frames: Iterator[Any], edges: Edges) -> Iterator[Any]:
    """Yield the frame of each step of equal length: a frame is shown from the step nearest to its
    start in `edges` up to that nearest to its end.

    `edges` are the starts of frames and the end, in steps. Frames after the end are left out, and
    so are frames too short for a step. If `edges` is None, every frame is one step."""
    if edges is None:
        yield from frames
        return
    # The nearest whole number: `round` would take half a step to the even neighbour.
    starts = [int(edge + Fraction(1, 2)) for edge in edges]
    steps = [end - start for start, end in pairwise(starts)]
    for k, frame in enumerate(islice(frames, len(steps))):
        yield from repeat(frame, steps[k])
