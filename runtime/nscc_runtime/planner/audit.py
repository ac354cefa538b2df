"""The audit: a plan's frames beside the reference's, with the same draws.

Where the reference would take too long it exposes bands of rows only, spread evenly, and the band
of the brightest pixel. A band's rows are those of the whole frame, crosstalk's neighbours included.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import Selection, everything
from nscc_runtime.planner.capture import Planned
from nscc_runtime.planner.program import Program
from nscc_runtime.reference.capture import Reference, scene_of

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
    `bias_e`: mean of plan - reference over everything, `bias_mc_error_e` its standard error.
    `std_ratio`: standard deviation over the frames of the plan's pixels by that of the reference's
    (root mean squares over the pixels; None where the reference's do not change), with
    `std_ratio_mc_error`. `samples`: pixels x buckets x frames compared. `frames`: how many.
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

    def __str__(self) -> str:
        verdict = "the promise holds" if self.holds else "THE PROMISE IS BROKEN"
        ratio = "" if self.std_ratio is None else (
            f", std ratio {self.std_ratio:.4f} +- {self.std_ratio_mc_error:.4f}"
        )  # fmt: skip
        return (
            f"audit: measured {self.measured_rms_e:.3g} +- {self.mc_error_e:.2g} e, bias "
            f"{self.bias_e:+.2g} +- {self.bias_mc_error_e:.2g} e{ratio}; {self.samples} "
            f"samples in {self.frames} frames: {verdict}"
        )


def audit(
    planned: Planned, seed: int = 0, frames: int = 1, effects: Selection | None = None
) -> Audit:
    """Expose frames 0, 1, .. by plan and by reference, and compare.

    `frames` is how many were asked for: at least 2 and at most 8 are compared, more where a frame
    has few pixels. `effects` are the reference's, by default all.
    """
    program, light = planned.program, planned.light
    rows = _rows(program, light.total_e())
    pixels = len(rows) * light.shape[1]
    pooled = max(1, math.ceil(_POOLED / max(1, light.shape[0] * light.shape[1])))
    count = max(_FEWEST_FRAMES, min(frames, _MOST_FRAMES)) * min(pooled, 64)
    reference = Reference.of(program.container, program.sensor, effects or everything())
    scene = scene_of(program.container, light)
    weight = _weights(rows, light.shape[0])
    plans, fulls = [], []
    for frame in range(count):
        plans.append(planned.expose(seed, frame).exposure_e[:, rows])
        parts = [
            reference.expose_rows(scene, band, seed, planned.device_seed, frame).exposure_e
            for band in _bands(rows)
        ]
        fulls.append(np.concatenate(parts, axis=1))
    plan, full = np.stack(plans), np.stack(fulls)
    error = plan - full
    square = (np.nanmean(error**2, axis=3) * weight).sum(axis=2)
    per_frame = square.reshape(-1, min(pooled, 64), square.shape[1]).mean(axis=1)
    worst = math.sqrt(float(per_frame.max()))
    # Rows are the independent parts: pixels of a row share its light.
    by_row = np.nanmean(error**2, axis=3).reshape(-1, len(rows))
    spread = float(by_row.std() / math.sqrt(by_row.size))
    means = np.nanmean(error, axis=3).reshape(-1, len(rows))
    ratio, ratio_error = _std_ratio(plan, full)
    return Audit(
        worst,
        spread / (2 * worst) if worst > 0 else 0.0,
        float((means * weight).sum(axis=1).mean()),
        float(means.std() / math.sqrt(means.size)),
        ratio,
        ratio_error,
        pixels * error.shape[1] * count,
        count,
        len(rows),
        worst <= SLACK * planned.plan.tolerance_e,
    )


def _rows(program: Program, total_e: NDArray[np.float64]) -> NDArray[np.intp]:
    """The rows to compare: all, or bands of `_BAND` with that of the brightest pixel."""
    height, cols = total_e.shape
    wanted = _MOST_CELLS // (program.container.slots * cols) // _BAND
    bands = -(-height // _BAND)
    if wanted >= bands:
        return np.arange(height)
    chosen = {int(i * bands / max(1, wanted)) for i in range(max(1, wanted))}
    chosen.add(int(np.argmax(total_e) // cols) // _BAND)
    rows = [row for band in sorted(chosen) for row in range(band * _BAND, (band + 1) * _BAND)]
    return np.array([row for row in rows if row < height])


def _weights(rows: NDArray[np.intp], height: int) -> NDArray[np.float64]:
    """The part of the frame that each row stands for: half-way to the next ones."""
    edges = np.concatenate(([0.0], (rows[1:] + rows[:-1] + 1) / 2, [float(height)]))
    return np.diff(edges) / height


def _bands(rows: NDArray[np.intp]) -> Iterator[range]:
    """Runs of consecutive rows."""
    for run in np.split(rows, np.flatnonzero(np.diff(rows) > 1) + 1):
        yield range(int(run[0]), int(run[-1]) + 1)


def _std_ratio(
    plan: NDArray[np.float64], full: NDArray[np.float64]
) -> tuple[float | None, float | None]:
    """Ratio of the root mean square standard deviations over the frames (axis 0), its error."""
    mine, theirs = (np.nanvar(values, axis=0, ddof=1).reshape(-1) for values in (plan, full))
    if not theirs.mean() > _NO_NOISE_E2:
        return None, None
    ratio = math.sqrt(float(mine.mean() / theirs.mean()))
    # Path-wise coupling makes the pixels' differences much smaller than their spread.
    difference = (mine - ratio**2 * theirs).std() / math.sqrt(len(mine))
    return ratio, float(difference / (2 * ratio * theirs.mean())) if ratio > 0 else 0.0
