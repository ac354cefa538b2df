"""The audit: a plan's frames beside the reference's, with the same draws.

Where the reference would take too long it exposes bands of rows only, spread evenly, and the band
of the brightest pixel. A band's rows are those of the whole frame, crosstalk's neighbours included.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import Selection, everything
from nscc_runtime.planner.capture import Planned
from nscc_runtime.planner.plan import MOST_OTHER_STATES, Plan
from nscc_runtime.planner.worst import Worst, largest
from nscc_runtime.reference.capture import Reference, scene_of

Values = NDArray[np.float64]

SLACK = 1.1
"""A promise holds while the measured error is at most this times the tolerance."""

NOISE_SLACK = 0.02
"""By how much the noise, as a part of that with all effects, may differ from what a plan said."""
_SIGMAS = 3.0

WORST_SLACK = 2.0
"""Of its worst pixels a plan tells from a sample: the worst is at most this times as far off as it
said, and so is one in a thousand, or not further off than it said of the worst; or they are within
the tolerance."""

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
    sampled_rows: int
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
        most_e = plan.tolerance_max_e
        if self.measured_rms_e > SLACK * plan.tolerance_e:
            return (
                f"the audit measured an error of {self.measured_rms_e:.3g} e, more than {SLACK} "
                f"times the tolerance of {plan.tolerance_e:.4g} e"
            )
        if most_e is not None and self.measured_max_e > SLACK * most_e:
            return (
                f"the audit found a pixel that is {self.measured_max_e:.3g} e off, more than "
                f"{SLACK} times the {most_e:.4g} e of --tolerance-max"
            )
        said_e, common_e = plan.predicted_max_e, plan.predicted_p999_e
        if said_e is not None and common_e is not None:
            for which, measured_e, most_e in (
                (
                    "one pixel in a thousand is at least", self.measured_p999_e,
                    max(said_e, WORST_SLACK * common_e),
                ),
                ("a pixel is", self.measured_max_e, WORST_SLACK * said_e),
            ):  # fmt: skip
                if measured_e > max(most_e, plan.tolerance_e):
                    return (
                        f"the audit found that {which} {measured_e:.3g} e off, and the plan said "
                        f"{common_e:.3g} e of one in a thousand and {said_e:.3g} e of the worst"
                    )
        if plan.noise_ratio is not None and self.std_ratio is not None:
            room = NOISE_SLACK + _SIGMAS * (self.std_ratio_mc_error or 0.0)
            if abs(self.std_ratio - plan.noise_ratio) > room:
                return (
                    f"the audit measured {self.std_ratio:.3f} times the noise of all effects, and "
                    f"the plan said {plan.noise_ratio:.3f}"
                )
        if self.other_states is not None and self.other_states > MOST_OTHER_STATES:
            return (
                f"the audit found {self.other_states:.2%} of the pixels in other states, more than "
                f"{MOST_OTHER_STATES:.1%}"
            )
        return None


def audit(
    planned: Planned, seed: int = 0, frames: int = 1, effects: Selection | None = None
) -> Audit:
    """Expose frames 0, 1, .. by plan and by reference, and compare.

    `frames` is how many were asked for: at least 2 and at most 8 are compared, more where a frame
    has few pixels. `effects` are the reference's, by default all.
    """
    program, light = planned.program, planned.light
    rows = compared_rows(program.container.slots, light.total_e())
    count, pooled = compared_frames(frames, light.shape)
    reference = Reference.of(program.container, program.sensor, effects or everything())
    scene = scene_of(program.container, light)
    plans, fulls = [], []
    for frame in range(count):
        plans.append(planned.expose(seed, frame).exposure_e[:, rows])
        parts = [
            reference.expose_rows(
                scene, band, seed, planned.device_seed, frame, planned.threads
            ).exposure_e
            for band in bands(rows)
        ]
        fulls.append(np.concatenate(parts, axis=1))
    weight = row_weights(rows, light.shape[0])
    return compared(np.stack(plans), np.stack(fulls), weight, pooled, planned.plan)


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
    error = mine - full
    with warnings.catch_warnings():
        # Of a row of which nothing is compared there is no mean.
        warnings.simplefilter("ignore", RuntimeWarning)
        by_row, means = np.nanmean(error**2, axis=3), np.nanmean(error, axis=3)
    there = weight * np.isfinite(by_row)
    by_row, means = np.nan_to_num(by_row), np.nan_to_num(means)
    there = there / np.maximum(there.sum(axis=2, keepdims=True), 1e-300)
    square = (by_row * there).sum(axis=2)
    worst = math.sqrt(float(square.reshape(-1, pooled, square.shape[1]).mean(axis=1).max()))
    # Rows are the independent parts: pixels of a row share its light.
    spread = float(by_row.std() / math.sqrt(by_row.size))
    ratio, ratio_error = _std_ratio(mine, full)
    pools = np.abs(error).reshape(-1, pooled, *error.shape[1:])
    by_pixel = np.broadcast_to(weight[:, None], pools.shape[:2] + error.shape[2:])
    each = [
        _largest(pools[p, :, b], by_pixel[p]) for p in range(len(pools))
        for b in range(error.shape[1])
    ]  # fmt: skip
    found = Audit(
        worst,
        spread / (2 * worst) if worst > 0 else 0.0,
        float((means * there).sum(axis=2).mean()),
        float(means.std() / math.sqrt(means.size)),
        ratio,
        ratio_error,
        error.size,
        len(error),
        error.shape[2],
        True,
        measured_p999_e=max(one.p999_e for one in each),
        measured_max_e=max(one.max_e for one in each),
    )
    return replace(found, holds=found.breach(plan) is None)


def _largest(sizes: Values, weight: Values) -> Worst:
    there = np.isfinite(sizes)
    return largest(sizes[there], weight[there]) if there.any() else Worst(0.0, 0.0)


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


def _std_ratio(plan: Values, full: Values) -> tuple[float | None, float | None]:
    """Ratio of the root mean square standard deviations over the frames (axis 0), its error."""
    with warnings.catch_warnings():
        # Pixels that are compared in fewer than two frames have no deviation.
        warnings.simplefilter("ignore", RuntimeWarning)
        mine, theirs = (np.nanvar(values, axis=0, ddof=1).reshape(-1) for values in (plan, full))
    known = np.isfinite(mine) & np.isfinite(theirs)
    mine, theirs = mine[known], theirs[known]
    if not (theirs.size and theirs.mean() > _NO_NOISE_E2):
        return None, None
    ratio = math.sqrt(float(mine.mean() / theirs.mean()))
    # Path-wise coupling makes the pixels' differences much smaller than their spread.
    difference = (mine - ratio**2 * theirs).std() / math.sqrt(len(mine))
    return ratio, float(difference / (2 * ratio * theirs.mean())) if ratio > 0 else 0.0
