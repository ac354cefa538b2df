"""The audit: compare frames under a plan with frames of the reference, with the same random
numbers.

Of large frames, the reference exposes only some bands of rows: evenly spaced bands, and the band of
the brightest pixel. The exposures of a band equal those of the whole frame, including crosstalk
from rows outside the band."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.light import Light
from nscc_runtime.planning.differences import largest
from nscc_runtime.planning.plan import Plan
from nscc_runtime.planning.plan_parts import MOST_OTHER_STATES

Values = NDArray[np.float64]

SLACK = 1.1
"""The audit passes if the measured error is at most this multiple of the tolerance."""

_BAND = 4
_MOST_CELLS = 1 << 23
"""Largest slots x pixels that the reference exposes. Of larger frames it exposes bands."""
_FEWEST_FRAMES, _MOST_FRAMES = 2, 8
_POOLED = 65536
"""Errors of small frames are averaged until they have this number of pixels together."""
_NO_NOISE_E2 = 1e-12
"""A variance over frames below this value, in square electrons, counts as rounding."""


@dataclass(frozen=True)
class Audit:
    """The measured error of a plan, for the worst frame and bucket (small frames are pooled).

    The error of a pixel is its exposure with the plan minus its exposure with the reference, in
    electrons. `measured_rms_e`: root mean square error, with standard error `mc_error_e`.
    `measured_p999_e`, `measured_max_e`: 99.9 % quantile and maximum of the absolute error.
    `bias_e`: mean error of all samples, with standard error `bias_mc_error_e`. `std_ratio`:
    standard deviation over frames with the plan divided by that with the reference (root mean
    squares over pixels), with standard error `std_ratio_mc_error`; both are None if the reference
    has no noise. `samples`: pixels x buckets x frames. `holds`: whether every error is within its
    tolerance. `other_states`: the fraction of pixels that end in other states than in the
    reference, with standard error `other_states_mc_error`; both are None for programs without
    states. Errors are those of the remaining pixels."""

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
        """Return a sentence about the first measured error that exceeds its limit in `plan`; None
        if all errors are within their limits."""
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
    """One frame, exposed with the plan and with the reference.

    `planned_e`, `full_e`: exposures in electrons, shape (buckets, rows, cols). `same`: where a
    pixel ends in the same states in both, shape (rows, cols); None for programs without states."""

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
    """Compare frames 0, 1, .. of a plan with the reference and return the measured errors.

    `compare(frame, row_ranges)` exposes these rows of one frame with the plan and with the
    reference. It is called in the order of frames. `slots`: number of slots or intervals that the
    reference simulates. `frames`: requested number of frames; at least 2 and at most 8 are
    compared, more if frames have few pixels."""
    rows = compared_rows(slots, light.total_e())
    pooled = min(max(1, math.ceil(_POOLED / max(1, light.shape[0] * light.shape[1]))), 64)
    count = max(_FEWEST_FRAMES, min(frames, _MOST_FRAMES)) * pooled
    runs, mine, full, other_states_by_frame = [*bands(rows)], [], [], []
    for frame in range(count):
        frame_pair = compare(frame, runs)
        same = np.True_ if frame_pair.same is None else frame_pair.same
        mine.append(np.where(same, frame_pair.planned_e, np.nan))
        full.append(np.where(same, frame_pair.full_e, np.nan))
        if frame_pair.same is not None:
            other_states_by_frame.append(1.0 - float(same.mean()))
    weight = row_weights(rows, light.shape[0])
    report = compared(np.stack(mine), np.stack(full), weight, pooled, plan)
    if not other_states_by_frame:
        return report
    other_states, pixels = float(np.mean(other_states_by_frame)), report.samples / len(mine[0])
    error = math.sqrt(other_states * (1.0 - other_states) / pixels)
    report = replace(report, other_states=other_states, other_states_mc_error=error)
    return replace(report, holds=report.breach(plan) is None)


def compared(mine: Values, full: Values, weight: Values, pooled: int, plan: Plan) -> Audit:
    """Compute the audit from exposures (frames, buckets, rows, cols) with the plan and the
    reference.

    NaN marks pixels to leave out. `weight` (rows,): the fraction of the frame that each row
    represents. `pooled`: number of consecutive frames whose errors are averaged."""
    error, buckets = mine - full, mine.shape[1]
    is_compared = np.isfinite(error)
    error = np.where(is_compared, error, 0.0)
    pixel_weight = weight[:, None] * is_compared
    pixel_weight = pixel_weight / np.maximum(pixel_weight.sum(axis=(2, 3), keepdims=True), 1e-300)
    square = (error**2 * pixel_weight).sum(axis=(2, 3)).reshape(-1, pooled, buckets).mean(axis=1)
    worst = math.sqrt(float(square.max()))
    # Rows are the independent parts: pixels of a row share its light.
    row_pixels = np.maximum(is_compared.sum(axis=3), 1)
    by_row, means = (error**2).sum(axis=3) / row_pixels, error.sum(axis=3) / row_pixels
    spread = float(by_row.std() / math.sqrt(by_row.size))
    ratio, ratio_error = _std_ratio(mine, full, np.all(is_compared, axis=0))
    pools = (
        values.reshape(-1, pooled, *values.shape[1:]) for values in (np.abs(error), pixel_weight)
    )
    sizes, weights = (values.swapaxes(1, 2).reshape(square.size, -1) for values in pools)
    largest_e = [largest(*size_and_weight) for size_and_weight in zip(sizes, weights, strict=True)]
    report = Audit(
        worst,
        spread / (2 * worst) if worst > 0 else 0.0,
        float((error * pixel_weight).sum(axis=(2, 3)).mean()),
        float(means.std() / math.sqrt(means.size)),
        ratio,
        ratio_error,
        error.size,
        len(error),
        True,
        measured_p999_e=max(size_and_weight.p999_e for size_and_weight in largest_e),
        measured_max_e=max(size_and_weight.max_e for size_and_weight in largest_e),
    )
    return replace(report, holds=report.breach(plan) is None)


def compared_rows(slots: int, total_e: Values, cells: int | None = None) -> NDArray[np.intp]:
    """Return the numbers of the rows to compare, in ascending order.

    These are all rows if slots x pixels is at most `cells` (None: `_MOST_CELLS`). Otherwise they
    are bands of `_BAND` rows, including the band of the brightest pixel of `total_e` (rows, cols).
    """
    height, cols = total_e.shape
    band_count = (cells or _MOST_CELLS) // (slots * cols) // _BAND
    bands = -(-height // _BAND)
    if band_count >= bands:
        return np.arange(height)
    chosen = {int(i * bands / max(1, band_count)) for i in range(max(1, band_count))}
    chosen.add(int(np.argmax(total_e) // cols) // _BAND)
    rows = [row for band in sorted(chosen) for row in range(band * _BAND, (band + 1) * _BAND)]
    return np.array([row for row in rows if row < height])


def row_weights(rows: NDArray[np.intp], height: int) -> Values:
    """Return the fraction (rows,) of a frame that each row represents, half-way to the next."""
    edges = np.concatenate(([0.0], (rows[1:] + rows[:-1] + 1) / 2, [float(height)]))
    return np.diff(edges) / height


def bands(rows: NDArray[np.intp]) -> Iterator[range]:
    """Yield a range for each run of consecutive row numbers."""
    for run in np.split(rows, np.flatnonzero(np.diff(rows) > 1) + 1):
        yield range(int(run[0]), int(run[-1]) + 1)


def _std_ratio(
    plan: Values, full: Values, known: NDArray[np.bool_]
) -> tuple[float | None, float | None]:
    """Return the ratio of the standard deviations over frames (axis 0) and its standard error.

    Variances are averaged over the `known` pixels. Both results are None if the reference has no
    noise."""
    mine, theirs = (values[:, known].var(axis=0, ddof=1) for values in (plan, full))
    if not (theirs.size and theirs.mean() > _NO_NOISE_E2):
        return None, None
    ratio = math.sqrt(float(mine.mean() / theirs.mean()))
    # Path-wise coupling makes the pixels' differences much smaller than their spread.
    difference = (mine - ratio**2 * theirs).std() / math.sqrt(len(mine))
    return ratio, float(difference / (2 * ratio * theirs.mean())) if ratio > 0 else 0.0
