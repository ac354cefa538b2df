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
from nscc_runtime.execution.block_scene import expose_pixels, prepare_pixels, without_draws
from nscc_runtime.execution.frames import frame_source
from nscc_runtime.planning.plan import MOST_OTHER_STATES, Plan
from nscc_runtime.planning.planned_scene import SEED, PlannedScene, trial_of

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
    expected values plus the difference of mean variances, less three standard errors.
    `path_mc_error_e2`: the standard error of its square. `bias_e`: mean difference of the expected
    values. `std_ratio`: noise divided by the noise with every effect; None without noise. For
    pixels that look, and effects that only the reference has, these are None: frames and loop are
    one simulator.

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
    """Measure the errors of `plan` on all pixels of `scene` in the loop over words. Also compare
    its own frames with those of the loop in distribution, unless pixels look, or only the reference
    has some effect. Nothing is raised if a limit is exceeded: `holds` is then False."""
    repeats, full = min(-(-_POOLED // scene.pixels), _MOST_POOLED), everything()
    trial = trial_of(scene, scene.pixels, repeats)
    errors = trial.errors(plan.kept, full)
    rms_e, square_e2 = errors.rms_e, errors.size_e**2
    spread_e2 = float((square_e2.std(axis=(1, 3)) / math.sqrt(repeats * scene.pixels)).max())
    report = Audit(
        rms_e,
        spread_e2 / (2 * rms_e) if rms_e > 0 else 0.0,
        errors.worst_e,
        errors.size_e.size,
        errors.bias_e,
        other_states=errors.other_states if scene.looks else None,
    )
    if not (scene.looks or scene.needs_reference(full)):
        frames = max(_FRAMES, repeats)
        own_e = np.stack([f.exposure_e for f in scene.frames(plan.kept, _SEED, frames)], axis=1)
        loop_e = trial.frames(frames).exposure_e[0].swapaxes(0, 1)
        # Frames without draws are expected exposures.
        chip, device_seed = (scene.container, scene.sensor, scene.light), scene.device_seed
        source = frame_source(*chip, plan.kept, device_seed, scene.threads).without_draws()
        loop = without_draws(prepare_pixels(*chip, full, np.arange(scene.pixels), device_seed))
        expected_e = source.expose(SEED, 0).exposure_e, expose_pixels(loop, SEED, 0).exposure_e
        report = in_distribution(report, own_e.reshape(loop_e.shape), loop_e, expected_e)
    return replace(report, holds=report.breach(plan) is None)


def in_distribution(
    report: Audit, own_e: Floats, loop_e: Floats, expected_e: tuple[Floats, Floats]
) -> Audit:
    """Return `report` with the difference in distribution of two series of independent frames, of
    the bucket in which it is largest.

    `own_e`, `loop_e`: exposures in electrons, (buckets, frames, pixels), at least two frames, of
    the run's own simulation and of the loop over words. `expected_e`: their expected values, for
    each bucket and pixel. Pixels that are not finite count as equal if both sides agree in this,
    else as an error of 1e30 e."""
    own_mean_e, loop_mean_e = (each.reshape(len(own_e), -1) for each in expected_e)
    own_e2, loop_e2 = own_e.var(axis=1, ddof=1), loop_e.var(axis=1, ddof=1)
    # Both are not finite if a frame is not, or the expected value.
    own_known, loop_known = np.isfinite(own_mean_e + own_e2), np.isfinite(loop_mean_e + loop_e2)
    difference_e, own_e2, loop_e2 = (
        np.where(own_known & loop_known, values, 0.0)
        for values in (own_mean_e - loop_mean_e, own_e2, loop_e2)
    )
    change_e2 = own_e2 - loop_e2
    # A variance over few normal frames has this standard error. Scatter over pixels tells of other
    # distributions, frames of few pixels do not.
    chance_e2 = np.hypot(own_e2, loop_e2) * math.sqrt(2.0 / (own_e.shape[1] - 1))
    chance_e2 = np.maximum(change_e2.std(axis=1), np.sqrt((chance_e2**2).mean(axis=1)))
    chance_e2 /= math.sqrt(change_e2.shape[1])
    path_e2 = np.maximum(np.abs(change_e2.mean(axis=1)) - _SIGMAS * chance_e2, 0.0)
    path_e2 += (difference_e**2).mean(axis=1)
    path_e2 += _ONE_SIDED_E2 * (own_known != loop_known).any(axis=1)
    worst = int(path_e2.argmax())
    noise_e2 = float(loop_e2[worst].mean())
    return replace(
        report,
        path_e=math.sqrt(path_e2[worst]),
        path_mc_error_e2=float(chance_e2[worst]),
        bias_e=float(difference_e[worst].mean()),
        std_ratio=math.sqrt(own_e2[worst].mean() / noise_e2) if noise_e2 > _NO_NOISE_E2 else None,
    )
