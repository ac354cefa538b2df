"""Timing of clips: the times of their frames, the overlap of slots and frames, and motion within
slots. Clips whose frames last unequally are resampled to even steps."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import accumulate, compress, islice, pairwise, repeat
from math import ceil
from typing import Any

import numpy as np

from nscc.arrays import Floats, Floats32, Ints, Ints32
from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc_runtime.light import DrawnFrames, Light
from nscc_runtime.scenes.errors import Path_or_name
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


_SLACK_FRAMES = Fraction(1, 1000)
"""The last slot may exceed the clip by this fraction of a frame (16.667 ms at 60 Hz)."""


@dataclass(frozen=True, eq=False)
class Overlaps:
    """Sparse matrix (slots, frames), as CSR, of the seconds that each slot spends in each frame.

    The entries of slot n are `row_start[n]` to `row_start[n + 1]` - 1. An entry is the frame
    `frame_index` and the time `seconds`."""

    row_start: Ints
    frame_index: Ints32
    seconds: Floats


def slot_edges_us(slot_us: Sequence[float]) -> list[Fraction]:
    """Return the N + 1 boundaries of slots of lengths `slot_us` in microseconds, from 0 on, as
    exact fractions of the decimals in which the lengths are written."""
    exact = {length: Fraction(repr(float(length))) for length in set(slot_us)}
    return [*accumulate((exact[length] for length in slot_us), initial=Fraction(0))]


def frames_needed(slot_us: Sequence[float], fps: Fraction, edges: Edges = None) -> int:
    """Return the number of frames, counted from the first, that slots of lengths `slot_us`
    (microseconds) need at `fps` frames per second; 1 or more.

    `edges`: the starts of frames that last unequally, and the end, in steps of 1 / `fps`; None if
    every frame lasts one. If they end too early, the result is one more than the clip has
    frames."""
    end = slot_edges_us(slot_us)[-1] * fps / 1_000_000 - _SLACK_FRAMES
    return max(1, ceil(end) if edges is None else bisect_left(edges, end))


def overlaps(slot_us: Sequence[float], fps: Fraction, edges: Edges = None) -> Overlaps:
    """Return the overlap of slots of lengths `slot_us` (microseconds) with frames, of which there
    are `fps` a second.

    Frame k covers [k / fps, (k + 1) / fps), or with `edges` from edges[k] / fps to edges[k + 1] /
    fps. Time beyond the last frame, number `frames_needed` - 1, counts as the last frame.
    Boundaries are exact fractions, so a slot that ends with a frame contains nothing of the next
    frame, for any number of slots."""
    per_us = fps / 1_000_000
    last = frames_needed(slot_us, fps, edges) - 1
    row_start, frame_index, seconds = [0], [], []
    begin = Fraction(0)
    for edge_us in slot_edges_us(slot_us)[1:]:
        end = edge_us * per_us
        k = min(int(begin) if edges is None else bisect_right(edges, begin) - 1, last)
        time = begin
        while time < end:
            frame_end = Fraction(k + 1) if edges is None else edges[k + 1]
            stop = end if k == last else min(end, frame_end)
            frame_index.append(k)
            seconds.append(float((stop - time) / fps))
            time, k = stop, k + 1
        row_start.append(len(frame_index))
        begin = end
    return Overlaps(
        np.array(row_start, np.int64),
        np.array(frame_index, np.int32),
        np.array(seconds, np.float64),
    )


def spread(
    frames: Floats32 | DrawnFrames,
    overlap: Overlaps,
    factor_of: Callable[[Floats], float],
) -> Light:
    """Return the light of a clip; each frame is constant for its time.

    `frames` (K, rows, cols): light per second in any unit. `overlap`: for each slot the frames that
    it sees, and for how many seconds. `factor_of`: returns the factor to electrons for the light of
    all slots, (rows, cols) in the unit of `frames` times seconds."""
    share = np.bincount(overlap.frame_index, overlap.seconds, len(frames))
    open_sum = np.zeros(frames.shape[1:], np.float64)
    for frame, time_s in zip(frames, share, strict=True):
        open_sum += frame * time_s
    factor = factor_of(open_sum)
    weight = overlap.seconds * factor
    return Light(frames, overlap.row_start, overlap.frame_index, weight, "clip", factor)


def still(frame: Floats32, slot_us: Sequence[float], factor_of: Callable[[Floats], float]) -> Light:
    """Return the light of the picture `frame` (rows, cols), light per second in any unit, in slots
    of lengths `slot_us` (microseconds). `factor_of`: as in `spread`."""
    seconds = np.array(slot_us, np.float64) * 1e-6
    factor = factor_of(frame.astype(np.float64) * float(seconds.sum()))
    return Light.of_still(frame, seconds * factor, factor)


def with_motion(
    light: Light, seconds: Floats | None = None, fps: float = 1.0, edges: Edges = None
) -> Light:
    """Return a clip of samples with its `motion`: linear interpolation between frames.

    Frame k is the light at the start of its time. Each entry of the light's matrix covers `seconds`
    of its frame; entries follow each other without a gap. A frame lasts 1 / `fps`, or with `edges`
    (starts of frames and the end) from one to the next in units of 1 / `fps`. If `seconds` is None,
    each entry is its whole frame. Within the last frame the light is constant."""
    entries = len(light.frame_index)
    begin, end = np.zeros(entries), np.ones(entries)
    if seconds is not None:
        frame_edges = np.arange(len(light.frames) + 1) if edges is None else np.array(edges, float)
        length = np.diff(frame_edges)[light.frame_index]
        stop = (np.cumsum(seconds) * fps - frame_edges[light.frame_index]) / length
        begin, end = np.clip(stop - seconds * fps / length, 0.0, 1.0), np.clip(stop, 0.0, 1.0)
    after = np.minimum(light.frame_index + 1, len(light.frames) - 1).astype(np.int32)
    # The mean of a straight line over an entry is its value in the middle: the next frame's share.
    later = light.weight * (begin + end) / 2
    moving = replace(
        light,
        # Every entry becomes two, of its frame and of the next.
        row_start=2 * light.row_start,
        frame_index=np.stack([light.frame_index, after], axis=1).reshape(-1),
        weight=np.stack([light.weight - later, later], axis=1).reshape(-1),
        motion=None,
    )
    return replace(light, motion=moving)


def check_fps(fps: float) -> Fraction:
    """Return the frame rate `fps` as the exact fraction of its decimals. Raises Rejected (NS0739)
    outside 1e-6 .. 1e9."""
    if 1e-6 <= fps <= 1e9:
        return Fraction(repr(float(fps)))
    raise rejected(
        "NS0739",
        f"invalid frame rate --fps {fps:g}",
        notes=("--fps F: frames per second, from 1e-6 to 1e9",),
        helps=("for instance --fps 60",),
    )


def too_short(
    name: Path_or_name, have: int, need: int, slots: int, fps: float | None, first: int = 0
) -> Rejected:
    """Return the error NS0735 that the clip `name` has `have` frames from frame number `first` on,
    but `need` are needed.

    `slots` is the number of slots, and `fps` the frame rate; None for one frame per slot. Both give
    the reason in a note."""
    if fps is None:
        why = f"{slots} slots need one frame each"
        ways = "a program with fewer slots, or give the clip's frame rate: --fps F"
    else:
        why = f"the {slots} slots last {need} frames at {fps:g} frames per second"
        ways = "a lower --fps, or a program with a shorter frame"
    earlier = "a smaller --first, " if first else ""
    return rejected(
        "NS0735",
        f"the clip '{name}' has "
        f"{have} frame{'' if have == 1 else 's'}{f' from frame {first} on' if first else ''}, "
        f"but {need} are needed",
        notes=(why,),
        helps=(f"use {earlier}a longer clip, {ways}",),
        data={"frames": have, "needed": need},
    )


def only_frame(name: Path_or_name, stored: Iterator[Any], first: int) -> Any:
    """Return frame number `first` (from 0) of a clip. `stored` yields its frames, and `name` is the
    clip in messages. Raises Rejected (NS0735) if it has no such frame."""
    have = 0
    for have, picture in enumerate(stored, 1):
        if have > first:
            return picture
    raise rejected(
        "NS0735",
        f"the clip '{name}' has {have} frame{'' if have == 1 else 's'}, so frame "
        f"{first} does not exist",
        notes=("frames are counted from 0",),
        helps=("give a smaller --first" if have else "use a clip that has frames",),
        data={"frames": have, "needed": first + 1},
    )
