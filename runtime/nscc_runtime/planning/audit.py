"""The audit of a plan on a whole scene.

First, the compiled loop over words exposes all pixels with the kept effects and with every effect,
with the same random numbers: the root mean square of the difference is the error that the tolerance
limits. Second, the run's own simulation with the kept effects is compared with the loop with every
effect, in distribution. Expected values are those of frames without draws, and therefore without
sampling error; variances are those of several frames."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from nscc.arrays import Floats
from nscc_runtime.effects import everything
from nscc_runtime.planning.plan import MOST_OTHER_STATES, Plan
from nscc_runtime.planning.planned_scene import PlannedScene, trial_of

SLACK = 1.1
"""The audit passes if the measured error is at most this multiple of the tolerance."""
_FRAMES = 8
"""Number of frames whose distribution is compared."""
_POOLED, _MOST_POOLED = 65536, 64
"""Errors of small frames are averaged until they have `_POOLED` pixels, in at most `_MOST_POOLED`
frames."""
_SEED = 1
"""Noise seed of the run's own frames, so that they are independent of those of the loop."""
_NO_NOISE_E2 = 1e-12
"""A variance over frames below this value, in square electrons, counts as rounding."""
_SIGMAS = 3.0
"""An error exceeds a limit if it does so by this number of standard errors."""
_ONE_SIDED_E2 = 1e60
"""Square error, in square electrons, of a pixel that is finite on one side only."""


@dataclass(frozen=True)
class Audit:
    """The measured errors of a plan on a whole scene, in electrons.

    `measured_rms_e`: root mean square of the difference between the loop with the kept effects and
    with every effect, with equal random numbers, in the worst bucket; `mc_error_e`: its standard
    error. `measured_max_e`: the largest difference. `samples`: pixels x buckets x frames.

    The run's own frames, in distribution: `path_e`: the root of the mean squared difference of
    expected values plus the difference of mean variances, each less three standard errors.
    `path_mc_error_e2`: the standard error of its square. `bias_e`: mean difference of the expected
    values. `std_ratio`: noise divided by the noise with every effect; None without noise. For
    pixels that look these are None: the loop itself exposes their frames.

    `other_states`: fraction of pixels that end in other states than with every effect; None for
    programs without states. `holds`: whether the errors are within their limits."""

    measured_rms_e: float
    mc_error_e: float
    measured_max_e: float
    samples: int
    bias_e: float
    std_ratio: float | None = None
    path_e: float | None = None
    path_mc_error_e2: float | None = None
    other_states: float | None = None
    holds: bool = True

    def __str__(self) -> str:
        """Return the measured errors and the verdict as one line; what was not measured is left
        out."""
        verdict = "the promise holds" if self.holds else "THE PROMISE IS BROKEN"
        text = (
            f"audit: measured {self.measured_rms_e:.3g} +- {self.mc_error_e:.2g} e, bias "
            f"{self.bias_e:+.2g} e, worst pixel {self.measured_max_e:.3g} e"
        )
        if self.other_states is not None:
            text += f"; {self.other_states:.2%} of the pixels end in other states"
        if self.path_e is not None and self.path_mc_error_e2 is not None:
            least_e = math.sqrt(_SIGMAS * self.path_mc_error_e2)
            text += f"; own frames differ in distribution by {self.path_e:.3g} e"
            text += f" (beyond up to {least_e:.3g} e of chance)"
        if self.std_ratio is not None:
            text += f", std ratio {self.std_ratio:.4f}"
        return f"{text}; {self.samples} samples: {verdict}"

    def breach(self, plan: Plan) -> str | None:
        """Return a clause about the first measured error that exceeds its limit in `plan`: of the
        loop, of the frames' distribution, or of states. None if all are within their limits.

        Errors are reduced by their uncertainty. A plan (the effects that are simulated) without a
        tolerance in electrons limits only the states."""
        if plan.tolerance_e is not None:
            limit_e = SLACK * plan.tolerance_e
            more_than = f"more than {SLACK} times the tolerance of {plan.tolerance_e:.4g} e"
            if self.measured_rms_e - _SIGMAS * self.mc_error_e > limit_e:
                return f"the audit measured an error of {self.measured_rms_e:.3g} e, {more_than}"
            if (self.path_e or 0.0) > limit_e:
                return f"the frames differ from the loop by {self.path_e:.3g} e, {more_than}"
        if self.other_states is not None and self.other_states > MOST_OTHER_STATES:
            return (
                f"the audit found {self.other_states:.2%} of the pixels in other states, more than "
                f"{MOST_OTHER_STATES:.1%}"
            )
        return None


def audit(scene: PlannedScene, plan: Plan) -> Audit:
    """Measure the errors of `plan` on all pixels of `scene` in the loop over words. Unless pixels
    look, also compare its own frames with those of the loop in distribution. Nothing is raised if a
    limit is exceeded: `holds` is then False."""
    repeats = min(-(-_POOLED // scene.pixels), _MOST_POOLED)
    trial = trial_of(scene, scene.pixels, repeats)
    errors = trial.errors(plan.kept, everything())
    rms_e, square_e2 = errors.rms_e, errors.size_e**2
    spread_e2 = float(square_e2.std(axis=(1, 2)).max()) / math.sqrt(square_e2[0].size)
    report = Audit(
        rms_e,
        spread_e2 / (2 * rms_e) if rms_e > 0 else 0.0,
        errors.worst_e,
        errors.size_e.size,
        errors.bias_e,
        other_states=errors.other_states if scene.looks else None,
    )
    if not scene.looks:
        frames = max(_FRAMES, repeats)
        own_e = np.stack([f.exposure_e for f in scene.frames(plan.kept, _SEED, frames)], axis=1)
        loop_e = trial.frames(frames).exposure_e
        expected_e = scene.expected_e(plan.kept)
        report = in_distribution(report, own_e.reshape(loop_e.shape), loop_e, expected_e)
    return replace(report, holds=report.breach(plan) is None)


def in_distribution(
    report: Audit, own_e: Floats, loop_e: Floats, expected_e: tuple[Floats, Floats] | None = None
) -> Audit:
    """Return `report` with the difference in distribution of two series of independent frames, of
    the bucket in which it is largest.

    `own_e`, `loop_e`: exposures in electrons, (buckets, frames, pixels), at least two frames, of
    the run's own simulation and of the loop over words. `expected_e`: their expected values
    (buckets, pixels); None to estimate these from the frames. Pixels that are not finite count as
    equal if both sides agree in this, else as an error of 1e30 e."""
    own_means_e, loop_means_e = expected_e or (own_e.mean(axis=1), loop_e.mean(axis=1))
    # Both are not finite if a frame is not, or the expected value.
    own_variance, loop_variance = own_e.var(axis=1, ddof=1), loop_e.var(axis=1, ddof=1)
    own_known = np.isfinite(own_means_e + own_variance)
    loop_known = np.isfinite(loop_means_e + loop_variance)
    difference, own_variance, loop_variance = (
        np.where(own_known & loop_known, part, 0.0)
        for part in (own_means_e - loop_means_e, own_variance, loop_variance)
    )
    # Means over frames have noise, whose variance is subtracted.
    noise_e2 = 0.0 if expected_e else (own_variance + loop_variance) / own_e.shape[1]
    parts_e2 = np.array([difference**2 - noise_e2, own_variance - loop_variance])
    # Scatter over pixels tells of distributions that are not normal, frames of few pixels.
    scatter_e2 = np.array([2.0 * difference * np.sqrt(noise_e2), parts_e2[1]]).std(axis=2)
    of_pixel_e2 = np.array(
        [
            np.hypot(2.0 * difference * np.sqrt(noise_e2), math.sqrt(2.0) * noise_e2),
            np.hypot(own_variance, loop_variance) * math.sqrt(2.0 / (own_e.shape[1] - 1)),
        ]
    )
    of_frames_e2 = np.sqrt((of_pixel_e2**2).mean(axis=2))
    errors_e2 = np.maximum(scatter_e2, of_frames_e2) / math.sqrt(difference.shape[1])
    sizes_e2 = np.abs(parts_e2.mean(axis=2))
    path_e2 = np.maximum(sizes_e2 - _SIGMAS * errors_e2, 0.0).sum(axis=0)
    path_e2 += _ONE_SIDED_E2 * (own_known != loop_known).any(axis=1)
    worst = int(path_e2.argmax())
    own_e2, loop_e2 = float(own_variance[worst].mean()), float(loop_variance[worst].mean())
    return replace(
        report,
        path_e=math.sqrt(path_e2[worst]),
        path_mc_error_e2=math.hypot(*errors_e2[:, worst]),
        bias_e=float(difference[worst].mean()),
        std_ratio=math.sqrt(own_e2 / loop_e2) if loop_e2 > _NO_NOISE_E2 else None,
    )
