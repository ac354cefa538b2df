"""The photon transfer curve: usable levels, system gain, saturation.

Mean and variance of a count of electrons are equal. One electron is K converter codes, so the
variance of a level increases with its mean with slope K. Without charge, the variance is that of
the noise. Charge that a pixel shares with its neighbours reduces the variance and appears in the
covariance of neighbours (EMVA 1288 assumes no crosstalk)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import sqrt

import numpy as np

from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc_runtime.calibrate.levels import QUIET, LevelMoments
from nscc_runtime.calibrate.line_fit import Line, Vector, line

LINEAR_PART = 0.7
"""The gain is fitted up to this fraction of the range up to saturation (EMVA 1288)."""
_DROP = 0.2
"""A relative drop of the variance of this size beyond its maximum indicates saturation."""
_STILL = 0.1
"""All saturated pixels are at their limit if less than this fraction of the shot noise remains."""


@dataclass(frozen=True)
class Saturation:
    """The mean converter code of the brightest flat, which is saturated, and its standard error.
    `of_pixel`: whether pixels saturate before the ADC."""

    mean: float
    mean_se: float
    of_pixel: bool


@dataclass(frozen=True, eq=False)
class Transfer:
    """The fitted photon transfer curve.

    `offset`: converter code without charge, None without darks; `offset_se` is its standard error.
    `gain`: K in codes per electron. `noise`: variance of codes without charge including rounding,
    meaningless if `offset` is None. `crosstalk`: the fraction of its charge that a pixel gives to
    each neighbour. `covariance` (3, 3): of (gain, noise, crosstalk). `fit`: the line of variance
    over mean. `used`: the levels of the fit. `left_out`: the other levels with the reasons.
    `saturation`: None if no flat is saturated."""

    offset: float | None
    offset_se: float
    gain: float
    noise: float
    crosstalk: float
    covariance: Vector
    fit: Line
    used: tuple[LevelMoments, ...]
    left_out: tuple[tuple[LevelMoments, str], ...]
    saturation: Saturation | None

    @property
    def gain_se(self) -> float:
        """Standard error of the gain."""
        return sqrt(float(self.covariance[0, 0]))


def transfer(
    flats: Sequence[LevelMoments],
    darks: Sequence[LevelMoments],
    offset: tuple[float, float] | None,
    top_code: int,
    crosstalk: float | None = None,
) -> Transfer:
    """Fit the photon transfer curve to the moments of `flats` and `darks`, each of one light and
    exposure time (a level), whose largest possible code is `top_code`.

    `offset`: converter code without charge with its standard error; if None, darks are not used.
    `crosstalk`: a known value, or None to measure it. Raises Rejected: NS0758 for fewer than two
    usable levels of light, NS0759 if the variance does not increase with the mean."""
    zero = offset[0] if offset else 0.0
    peak = max(flats, key=lambda level: level.variance)
    highest = max(flats, key=lambda level: level.mean)
    fallen = highest.mean > peak.mean and highest.variance < (1 - _DROP) * peak.variance
    full = highest.mean if fallen or highest.cut_at_top else float(top_code)
    limit = zero + LINEAR_PART * (full - zero)
    judged = [(level, _unfit(level, limit)) for level in flats]
    # Levels whose means differ by less than a code are one point of the line.
    if len({round(level.mean) for level, reason in judged if not reason}) < 2:
        raise _too_few(judged, limit)
    if offset is not None:
        judged += [(level, _unfit(level, limit)) for level in darks]
    curve = _fitted([level for level, reason in judged if not reason], offset, crosstalk)
    curve = replace(curve, left_out=tuple(judgement for judgement in judged if judgement[1]))
    if not (fallen or highest.cut_at_top):
        return curve
    excess = highest.variance - curve.noise
    still = excess < _STILL * curve.gain * (highest.mean - zero)
    of_pixel = offset is not None and still and not highest.cut_at_top
    return replace(curve, saturation=Saturation(highest.mean, highest.mean_se, of_pixel))


def _unfit(level: LevelMoments, limit: float) -> str:
    """Return the reason why `level` is excluded from the fit; "" if it is used. `limit`: the
    largest mean converter code of a level that is used."""
    if level.cut_at_top:
        return f"{100 * level.share_at_top:.3g} % of its codes are at the top"
    if level.cut_at_zero:
        return f"{100 * level.share_at_zero:.3g} % of its codes are 0"
    if level.variance < QUIET:
        return f"its noise is below half a code (variance {level.variance:.2g})"
    if level.mean > limit:
        return f"its mean is above {LINEAR_PART:.0%} of saturation (code {limit:.4g})"
    return ""


def _fitted(
    used: Sequence[LevelMoments], offset: tuple[float, float] | None, known: float | None
) -> Transfer:
    """Return the photon transfer line of variance over mean through the `used` levels, with the
    covariance of neighbours; without saturation and levels left out.

    `offset` is the converter code without charge and its standard error, None if unknown. `known`
    is a known crosstalk, None to measure it. Raises Rejected (NS0759) if the variance does not
    increase with the mean. Errors are propagated with a numerical Jacobian."""
    zero, zero_se = offset or (0.0, 0.0)
    x = np.array([level.mean - zero for level in used])
    variance = np.array([level.variance for level in used])
    neighbours = np.array([level.neighbours for level in used])
    # Degrees of freedom of the sample variance, and samples of the covariance of 2 N pairs.
    degrees = np.array([(level.frames - 1) * level.pixels for level in used], np.float64)
    samples = np.array([level.frames * level.pixels for level in used], np.float64)
    # Darks of nearly equal means have the same rounding error: they count as one.
    alike = np.array(
        [sum(abs(level.mean - other_level.mean) < 0.5 for other_level in used) for level in used]
    )
    rounding = np.array([level.rounding for level in used]) * np.sqrt(alike)
    slope = float(np.ptp(variance) / max(np.ptp(x), 1e-9))

    def standard_errors(fitted: Vector) -> Vector:
        """Return the expected standard errors of the measured variances of the `used` levels, given
        the fitted variances, both in squared converter codes."""
        # A fitted variance near or below 0 must not give a level infinite weight.
        size = np.maximum(fitted, QUIET / 2)
        errors = 2 * size**2 / degrees + slope**2 * size / samples + rounding**2
        return np.asarray(np.sqrt(errors))

    if np.ptp(x) < 1e-6:
        raise _no_transfer("all levels have the same mean")
    fit = line(x, variance, standard_errors)
    across = line(x, neighbours, lambda _: standard_errors(fit.start + fit.slope * x) / 2)
    # A slope within three standard errors of 0 is no increase.
    if fit.slope <= 3 * sqrt(fit.covariance[1, 1]):
        raise _no_transfer(f"from {variance.min():.3g} to {variance.max():.3g} squared codes")

    values = np.array([fit.slope, fit.start, across.slope])
    errors = np.zeros((3, 3))
    # The line's covariance is of (start, slope), `values` begins with the slope.
    errors[:2, :2] = fit.covariance[::-1, ::-1] * fit.excess
    errors[2, 2] = across.covariance[1, 1]
    jacobian = np.zeros((3, 3))
    for column in range(3):
        step = np.zeros(3)
        step[column] = sqrt(errors[column, column]) * 1e-3
        jacobian[:, column] = _solved(values + step, known) - _solved(values, known)
        jacobian[:, column] /= step[column]
    covariance = jacobian @ errors @ jacobian.T
    gain, noise, crosstalk = map(float, _solved(values, known))
    covariance[1, 1] += (gain * zero_se) ** 2
    return Transfer(
        None if offset is None else zero,
        zero_se,
        gain,
        noise,
        crosstalk,
        covariance,
        fit,
        used=tuple(used),
        left_out=(),
        saturation=None,
    )


def _solved(slopes: Vector, known: float | None) -> Vector:
    """Return an array of gain, noise and crosstalk. `slopes`: slope and intercept of the variance
    over the mean, and slope of the covariance of neighbours. `known` is a known crosstalk, None to
    compute it."""
    crosstalk = _crosstalk(float(slopes[0]), float(slopes[2])) if known is None else known
    return np.array([slopes[0] / kept_variance(crosstalk), slopes[1], crosstalk])


def kept_variance(crosstalk: float) -> float:
    """Return the factor by which crosstalk changes the variance of pixels. `crosstalk` is the
    fraction of its charge that a pixel gives to each of its four neighbours."""
    return (1 - 4 * crosstalk) ** 2 + 4 * crosstalk**2


def _crosstalk(variance: float, covariance: float) -> float:
    """Return the crosstalk c that solves covariance / variance = 2 c (1 - 4 c) / ((1 - 4 c)^2 + 4
    c^2): the smaller solution, or the nearest value if there is none. `variance` (above 0) and
    `covariance` of neighbours are slopes over the mean."""
    ratio = covariance / variance
    a, half_b = 20 * ratio + 8, 4 * ratio + 1
    return float((half_b - np.sqrt(max(half_b**2 - a * ratio, 0.0))) / a)


def _too_few(judged: Sequence[tuple[LevelMoments, str]], limit: float) -> Rejected:
    """Return the error (NS0758) that too few levels can be used, with the reason for each unused
    one. `judged` are all flats, each with the reason why it cannot be used or "". `limit` is the
    largest mean converter code of a level that is used."""
    used = [level for level, reason in judged if not reason]
    count = len({round(level.mean) for level in used})
    notes = [f"'{level.name}' (mean {level.mean:.4g}): {why}" for level, why in judged if why]
    if len(used) > count:
        notes.append(
            f"{len(used)} flats have the same mean, {used[0].mean:.4g}: they count as one level"
        )
    return rejected(
        "NS0758",
        f"{count} level{'' if count == 1 else 's'} of light can be used, but photon "
        "transfer needs 2 or more",
        notes=notes[-10:],
        helps=(
            "add flats of other exposure times or other light, with means spread evenly up to "
            f"code {limit:.0f}; each argument is one level",
        ),
        data={"required": 2, "available": count},
    )


def _no_transfer(why: str) -> Rejected:
    """Return the error (NS0759) that noise does not increase with light; `why` completes its
    message."""
    return rejected(
        "NS0759",
        f"the noise of the flats does not increase with their mean: {why}",
        notes=("photon transfer needs frames with shot noise at several levels of light",),
        helps=("check that flats and darks are not exchanged, and that frames are not averaged",),
    )
