"""The audit: a plan's frames beside the reference's, with the same draws.

Where the reference would take too long it exposes bands of rows only, spread evenly, and the band
of the brightest pixel. A band's rows are those of the whole frame, crosstalk's neighbours included.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.light import Light
from nscc_runtime.planning.plan import Plan
from nscc_runtime.planning.plan_parts import MOST_OTHER_STATES
from nscc_runtime.planning.tail import largest

Values = NDArray[np.float64]

SLACK = 1.1
"""A promise holds while the measured error is at most this times the tolerance."""

_BAND = 4
_MOST_CELLS = 1 << 23
"""Slots x pixels of a frame that the reference exposes whole; beyond it, bands of as many."""
_FEWEST_FRAMES, _MOST_FRAMES = 2, 8
_POOLED = 65536
"""Frames smaller than this are pooled until there are as many samples."""
_NO_NOISE_E2 = 1e-12
"""Variance that rounding alone may leave of frames that are alike."""


@dataclass(frozen=True)
class Audit:
    """Measured against predicted, for the worst frame and bucket (frames of few pixels pooled).

    `measured_rms_e`: root mean square of plan - reference; `mc_error_e`: its standard error.
    `measured_p999_e`, `measured_max_e`: the size that one pixel in a thousand passes, and the
    largest.
    `bias_e`: mean of plan - reference over everything, `bias_mc_error_e` its standard error.
    `std_ratio`: standard deviation over the frames of the plan's pixels by that of the reference's
    (root mean squares over the pixels; None where the reference's do not change), with
    `std_ratio_mc_error`. `samples`: pixels x buckets x frames compared. `frames`: how many.
    `other_states`: of a program that looks, the part of the pixels that end in other states than
    the reference's, with its standard error; errors are those of the other pixels.
    """

    measured_rms_e: float
    mc_error_e: float
    bias_e: float
    bias_mc_error_e: float
    std_ratio: float | None
    std_ratio_mc_error: float | None
    samples: int
    frames: int
    holds: bool
    other_states: float | None = None
    other_states_mc_error: float | None = None
    measured_p999_e: float = 0.0
    measured_max_e: float = 0.0

    def __str__(self) -> str:
        verdict = "the promise holds" if self.holds else "THE PROMISE IS BROKEN"
        ratio = "" if self.std_ratio is None else (
            f", std ratio {self.std_ratio:.4f} +- {self.std_ratio_mc_error:.4f}"
        )  # fmt: skip
        if self.other_states is not None:
            ratio += (
                f"; {self.other_states:.2%} +- {self.other_states_mc_error:.2%} of the pixels end "
                "in other states"
            )
        return (
            f"audit: measured {self.measured_rms_e:.3g} +- {self.mc_error_e:.2g} e, bias "
            f"{self.bias_e:+.2g} +- {self.bias_mc_error_e:.2g} e{ratio}; 99.9 % within "
            f"{self.measured_p999_e:.3g} e, worst {self.measured_max_e:.3g} e; {self.samples} "
            f"samples in {self.frames} frames: {verdict}"
        )

    def breach(self, plan: Plan) -> str | None:
        """What of the plan's promise was found broken, in words."""
        most_e, tolerance_e = plan.tolerance_max_e, plan.tolerance_e or 0.0
        if plan.tolerance_e is not None and self.measured_rms_e > SLACK * tolerance_e:
            return (
                f"the audit measured an error of {self.measured_rms_e:.3g} e, more than {SLACK} "
                f"times the tolerance of {plan.tolerance_e:.4g} e"
            )
        if most_e is not None and self.measured_max_e > SLACK * most_e:
            return (
                f"the audit found a pixel with an error of {self.measured_max_e:.3g} e, "
                f"more than {SLACK} times the {most_e:.4g} e of --tolerance-max"
            )
        if self.other_states is not None and self.other_states > MOST_OTHER_STATES:
            return (
                f"the audit found {self.other_states:.2%} of the pixels in other states, more than "
                f"{MOST_OTHER_STATES:.1%}"
            )
        return None


class Compared(NamedTuple):
    """Exposures (buckets, rows, cols) of a plan and of the reference on the rows compared; `same`
    (rows, cols): where both end in the same states, None where there are none."""

    planned_e: Values
    full_e: Values
    same: NDArray[np.bool_] | None = None


def audit(
    compare: Callable[[int, Sequence[range]], Compared],
    light: Light,
    slots: int,
    plan: Plan,
    frames: int,
) -> Audit:
    """Compare frames 0, 1, .. of a plan with the reference's.

    `compare` exposes a frame on bands of rows both ways; it is called frame after frame. `slots` of
    a pixel are made by the reference. `frames` is how many were asked for: at least 2 and at most 8
    are compared, more where a frame has few pixels.
    """
    rows = compared_rows(slots, light.total_e())
    count, pooled = compared_frames(frames, light.shape)
    runs, mine, full, others = [*bands(rows)], [], [], []
    for frame in range(count):
        each = compare(frame, runs)
        same = np.ones(each.full_e.shape[1:], np.bool_) if each.same is None else each.same
        mine.append(np.where(same, each.planned_e, np.nan))
        full.append(np.where(same, each.full_e, np.nan))
        if each.same is not None:
            others.append(1.0 - float(same.mean()))
    weight = row_weights(rows, light.shape[0])
    found = compared(np.stack(mine), np.stack(full), weight, pooled, plan)
    if not others:
        return found
    other, pixels = float(np.mean(others)), found.samples / len(mine[0])
    error = math.sqrt(other * (1.0 - other) / pixels)
    found = replace(found, other_states=other, other_states_mc_error=error)
    return replace(found, holds=found.breach(plan) is None)


def compared_frames(frames: int, shape: tuple[int, int]) -> tuple[int, int]:
    """How many frames of pixels (rows, cols) are compared where `frames` were asked for, and how
    many are pooled."""
    pooled = min(max(1, math.ceil(_POOLED / max(1, shape[0] * shape[1]))), 64)
    return max(_FEWEST_FRAMES, min(frames, _MOST_FRAMES)) * pooled, pooled


def compared(mine: Values, full: Values, weight: Values, pooled: int, plan: Plan) -> Audit:
    """The audit of a plan's exposures (frames, buckets, rows, cols), NaN where they are not
    compared.

    `weight` (rows,): the part of the frame that each row stands for.
    """
    error, buckets = mine - full, mine.shape[1]
    there = np.isfinite(error)
    error = np.where(there, error, 0.0)
    part = weight[:, None] * there
    part = part / np.maximum(part.sum(axis=(2, 3), keepdims=True), 1e-300)
    square = (error**2 * part).sum(axis=(2, 3)).reshape(-1, pooled, buckets).mean(axis=1)
    worst = math.sqrt(float(square.max()))
    # Rows are the independent parts: pixels of a row share its light.
    many = np.maximum(there.sum(axis=3), 1)
    by_row, means = (error**2).sum(axis=3) / many, error.sum(axis=3) / many
    spread = float(by_row.std() / math.sqrt(by_row.size))
    ratio, ratio_error = _std_ratio(mine, full, np.all(there, axis=0))
    pools = (values.reshape(-1, pooled, *values.shape[1:]) for values in (np.abs(error), part))
    sizes, weights = (values.swapaxes(1, 2).reshape(square.size, -1) for values in pools)
    largest_e = [largest(*each) for each in zip(sizes, weights, strict=True)]
    found = Audit(
        worst,
        spread / (2 * worst) if worst > 0 else 0.0,
        float((error * part).sum(axis=(2, 3)).mean()),
        float(means.std() / math.sqrt(means.size)),
        ratio,
        ratio_error,
        error.size,
        len(error),
        True,
        measured_p999_e=max(each.p999_e for each in largest_e),
        measured_max_e=max(each.max_e for each in largest_e),
    )
    return replace(found, holds=found.breach(plan) is None)


def compared_rows(slots: int, total_e: Values, cells: int | None = None) -> NDArray[np.intp]:
    """The rows to compare where so many slots of a pixel are made: all, or bands of `_BAND` with
    that of the brightest pixel, of so many `cells` (slots x pixels; None: _MOST_CELLS). `total_e`
    (rows, cols): all the light of each pixel."""
    height, cols = total_e.shape
    wanted = (cells or _MOST_CELLS) // (slots * cols) // _BAND
    bands = -(-height // _BAND)
    if wanted >= bands:
        return np.arange(height)
    chosen = {int(i * bands / max(1, wanted)) for i in range(max(1, wanted))}
    chosen.add(int(np.argmax(total_e) // cols) // _BAND)
    rows = [row for band in sorted(chosen) for row in range(band * _BAND, (band + 1) * _BAND)]
    return np.array([row for row in rows if row < height])


def row_weights(rows: NDArray[np.intp], height: int) -> Values:
    """The part of the frame that each row stands for: half-way to the next ones."""
    edges = np.concatenate(([0.0], (rows[1:] + rows[:-1] + 1) / 2, [float(height)]))
    return np.diff(edges) / height


def bands(rows: NDArray[np.intp]) -> Iterator[range]:
    """Runs of consecutive rows."""
    for run in np.split(rows, np.flatnonzero(np.diff(rows) > 1) + 1):
        yield range(int(run[0]), int(run[-1]) + 1)


def _std_ratio(
    plan: Values, full: Values, known: NDArray[np.bool_]
) -> tuple[float | None, float | None]:
    """Ratio of the root mean square standard deviations over the frames (axis 0) of the pixels that
    are known in all of them, and its error."""
    mine, theirs = (values[:, known].var(axis=0, ddof=1) for values in (plan, full))
    if not (theirs.size and theirs.mean() > _NO_NOISE_E2):
        return None, None
    ratio = math.sqrt(float(mine.mean() / theirs.mean()))
    # Path-wise coupling makes the pixels' differences much smaller than their spread.
    difference = (mine - ratio**2 * theirs).std() / math.sqrt(len(mine))
    return ratio, float(difference / (2 * ratio * theirs.mean())) if ratio > 0 else 0.0
