"""Estimate the quantities of EMVA 1288 from frames by photon transfer."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import sqrt
from typing import Literal

import numpy as np

from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import rejected
from nscc_runtime.calibrate.frame_stacks import Stack, grouped, load_stack
from nscc_runtime.calibrate.levels import QUIET, LevelMoments, Mask, level_of, moments
from nscc_runtime.calibrate.line_fit import propagated, root, shared_variance
from nscc_runtime.calibrate.pixels import (
    DarkFit,
    dark_of,
    good_pixels,
    linearity,
    refuse_uneven,
    response_variance,
    valid_pixels,
)
from nscc_runtime.calibrate.transfer import Transfer, kept_variance, transfer
from nscc_runtime.progress import Progress, unseen

ROUNDING = 1 / 12
"""Variance of rounding by the ADC, in squared codes."""
_SURE = 4.0
"""Smallest dark current, in standard errors, whose spread is estimated."""
_MOST_PRNU = 0.2
"""Largest spread of the pixels' response, relative to its mean, of frames that count as flat."""
_CUT_OFF = "the codes of every dark reach the end of the ADC's scale: raise its offset"

Known = Literal["measured", "at least", "at most", "given", "unknown"]


@dataclass(frozen=True)
class Quantity:
    """A measured quantity, or the reason why it is unknown.

    `title`: its name in tables. `unit`: "1" for a plain number. `value`: None if unknown. `se`:
    standard error, None if not measured. `known`: "measured", a bound ("at least", "at most"),
    "given" by the user, or "unknown". `remark`: explains the value or why it is missing."""

    title: str
    unit: str
    value: float | None
    se: float | None = None
    known: Known = "measured"
    remark: str = ""


# The title and the unit of each quantity.
_FIGURES = {
    "system_gain": ("system gain K", "DN/e"),
    "conversion_gain": ("conversion gain 1/K", "e/DN"),
    "crosstalk": ("crosstalk to each neighbour", "1"),
    "dark_noise_lsb": ("temporal dark noise", "DN"),
    "dark_noise_e": ("temporal dark noise", "e"),
    "offset": ("code without charge", "DN"),
    "dsnu_lsb": ("DSNU, pattern of the code without charge", "DN"),
    "dsnu_e": ("DSNU, pattern of the code without charge", "e"),
    "dark_current": ("dark current", "e/s"),
    "dark_spread": ("its standard deviation over the pixels", "1"),
    "prnu": ("PRNU", "1"),
    "saturation_lsb": ("saturation", "DN"),
    "full_well": ("full well", "e"),
    "linearity_error": ("linearity error", "%"),
}


def _quantities(
    remark: str, known: Known = "measured", **values: tuple[float, float | None]
) -> dict[str, Quantity]:
    """Return quantities by name, with a common `remark` and a common kind `known`.

    `values`: for a name of `_FIGURES` the pair (value, standard error or None)."""
    return {
        name: Quantity(*_FIGURES[name], *value, known, remark) for name, value in values.items()
    }


def _unknown(why: str, *names: str) -> dict[str, Quantity]:
    """Return the quantities `names` of `_FIGURES`, by name, without a value; `why` is the
    reason."""
    return {name: Quantity(*_FIGURES[name], None, known="unknown", remark=why) for name in names}


@dataclass(frozen=True, eq=False)
class Calibration:
    """The result of a calibration.

    `quantities`: by the names of `_FIGURES`. `curve`: the photon transfer curve. `flats`, `darks`:
    moments of the levels, in the order given. `pixels`, `defects`: number of used and of excluded
    pixels of the `shape` (rows, cols)."""

    quantities: dict[str, Quantity]
    curve: Transfer
    flats: tuple[LevelMoments, ...]
    darks: tuple[LevelMoments, ...]
    pixels: int
    defects: int
    shape: tuple[int, int]

    @property
    def frames(self) -> int:
        """Number of frames, flats and darks together."""
        return sum(level.frames for level in (*self.flats, *self.darks))


def calibrate_files(
    flats: Sequence[str],
    darks: Sequence[str],
    target: Target,
    crosstalk: float | None = None,
    progress: Progress = unseen,
) -> Calibration:
    """Calibrate from files and folders of flats and of darks, each PATH or PATH@TIME (such as 2ms)
    and one level.

    `target` gives the largest converter code. `crosstalk`: a known value, None to measure it.
    `progress` counts the files. Raises Rejected (status 2) like `load_stack` for unreadable frames,
    and like `calibrated` for unsuitable ones."""
    top = target.top_code
    named = [*flats, *darks]
    stacks = [load_stack(name, top) for name in progress(named, "reading frames", len(named))]
    split = len(flats)
    return calibrated(grouped(stacks[:split]), grouped(stacks[split:]), top, crosstalk)


def calibrated(
    flats: Sequence[Stack], darks: Sequence[Stack], top_code: int, crosstalk: float | None = None
) -> Calibration:
    """Calibrate from flats (evenly lit frames) and darks (frames without light) with converter
    codes 0..`top_code`. A stack has the frames of one light and exposure time.

    `crosstalk`: a known value, or None to measure it; EMVA 1288 assumes 0. Raises Rejected (status
    2): NS0757 for frames that do not fit together, NS0758 for too few frames or levels, NS0759 for
    frames that are not flats and darks."""
    light = [level_of(stack, top_code) for stack in flats]
    dim = [level_of(stack, top_code) for stack in darks]
    good_mask = good_pixels(light, dim)
    flat_moments = [moments(level, good_mask) for level in light]
    dark_moments = [moments(level, good_mask) for level in dim]
    brightest = max(level.mean for level in flat_moments)
    darkest = min(level.mean for level in dark_moments)
    if brightest <= darkest:
        raise rejected(
            "NS0759",
            f"the darks (mean {darkest:.4g}) are not darker than the flats (mean {brightest:.4g})",
            helps=("give flats first, and darks after --dark",),
        )
    dark = dark_of(dim, dark_moments, good_mask)
    offset = None if dark is None else (dark.offset, dark.offset_se)
    curve = transfer(flat_moments, dark_moments, offset, top_code, crosstalk)
    used = [i for i, flat in enumerate(flat_moments) if flat in curve.used]
    chosen = [light[i] for i in used]
    # Only the levels of the fit must be flat: brighter ones may saturate in part.
    refuse_uneven(chosen, good_mask, 0.0 if dark is None else dark.offset, dim)

    spread = response_variance(chosen, [flat_moments[i] for i in used], dark, good_mask)
    # Without a saturated flat, the end of the ADC's scale limits the range.
    full = curve.saturation.mean if curve.saturation else float(top_code)
    quantities = {
        **_gain(curve, crosstalk),
        **_noise(curve, dark_moments, dark),
        **_dark(curve, dark, good_mask),
        **_prnu(spread, curve, _fits(dark, flat_moments)),
        **_range(curve, flat_moments, top_code),
    }
    line = linearity(flat_moments, dark, full)
    quantities |= (
        _unknown(line, "linearity_error")
        if isinstance(line, str)
        else _quantities(
            f"mean absolute deviation of {line.levels} levels from the line over time",
            linearity_error=(line.error_percent, line.error_se),
        )
    )
    count = int(np.count_nonzero(good_mask))
    return Calibration(
        quantities,
        curve,
        flats=tuple(flat_moments),
        darks=tuple(dark_moments),
        pixels=count,
        defects=int(np.count_nonzero(valid_pixels((*light, *dim)))) - count,
        shape=(good_mask.shape[0], good_mask.shape[1]),
    )


def _gain(curve: Transfer, known_crosstalk: float | None) -> dict[str, Quantity]:
    """Return system gain (codes per electron), conversion gain (its inverse) and crosstalk as
    quantities by name, with errors.

    `curve` is the fitted photon transfer curve. `known_crosstalk` is used as given; if it is None,
    the curve has measured it from the covariance of neighbours, and a negative value counts as
    0."""
    remark = f"slope of variance over mean through {len(curve.used)} levels, " + (
        "neighbours' covariance included"
        if known_crosstalk is None
        else f"crosstalk {known_crosstalk:g} taken as known"
    )
    inverse = propagated(lambda v: 1 / v[0], [curve.gain], curve.covariance[:1, :1])
    quantities = _quantities(
        remark, system_gain=(curve.gain, curve.gain_se), conversion_gain=inverse
    )
    crosstalk, crosstalk_se = max(curve.crosstalk, 0.0), sqrt(float(curve.covariance[2, 2]))
    if known_crosstalk is not None:
        return quantities | _quantities("--crosstalk", "given", crosstalk=(crosstalk, None))
    why = "covariance of the shot noise of neighbours"
    return quantities | _quantities(why, crosstalk=(crosstalk, crosstalk_se))


def _noise(
    curve: Transfer, darks: Sequence[LevelMoments], dark: DarkFit | None
) -> dict[str, Quantity]:
    """Return the noise without light in converter codes and in electrons, as quantities by name.
    The variance of rounding is subtracted.

    If rounding hides the noise, the result is an upper limit. The noise is unknown if `dark` is
    None, because all darks (frames without light) are then clipped at an end of the scale. `curve`
    is the fitted photon transfer curve, `darks` are the moments of the darks."""

    if dark is None:
        return _unknown(_CUT_OFF, "dark_noise_lsb", "dark_noise_e")
    most, why = 0.0, ""
    if not any(level in curve.used for level in darks):
        # `transfer` leaves out darks whose variance is below `QUIET`.
        most = sqrt(QUIET)
        why = f"the noise of the darks is below {most:.2f} codes, so rounding hides it"
    elif curve.noise <= ROUNDING:
        # Two standard errors above the fitted value.
        error = sqrt(float(curve.covariance[1, 1]))
        most = sqrt(max(curve.noise - ROUNDING, 0.0) + 2 * error)
        why = "the line of variance over mean leaves no noise without charge"
    if why:
        in_electrons = most / curve.gain, None
        return _quantities(why, "at most", dark_noise_lsb=(most, None), dark_noise_e=in_electrons)
    remark = "of a frame without charge, rounding taken away"
    if dark.current is None:
        remark = "of the darks, shot noise of their dark charge included; rounding taken away"
    errors, values = curve.covariance[:2, :2], [curve.gain, curve.noise]
    in_codes = propagated(lambda v: sqrt(max(v[1] - ROUNDING, 0.0)), values, errors)
    electrons = propagated(lambda v: sqrt(max(v[1] - ROUNDING, 0.0)) / v[0], values, errors)
    return _quantities(remark, dark_noise_lsb=in_codes, dark_noise_e=electrons)


def _dark(curve: Transfer, dark: DarkFit | None, good_mask: Mask) -> dict[str, Quantity]:
    """Return offset, dark-signal non-uniformity, dark current and its spread over the pixels, as
    quantities by name, with errors.

    All are unknown if `dark`, the fit of the darks, is None. The currents are unknown without darks
    of several exposure times, and the spread if the current is below four standard errors. `curve`
    gives gain and crosstalk; `good_mask` (rows, cols) marks the pixels that are not defects."""
    if dark is None:
        return _unknown(_CUT_OFF, "offset", "dsnu_lsb", "dsnu_e", "dark_current", "dark_spread")
    if dark.currents is None:
        times = ", ".join(f"{1e3 * t:.6g} ms" for t in dark.times_s) or "an unknown time"
        remark = f"of darks of {times}"
    else:
        remark = f"darks of {len(dark.times_s)} times, extrapolated to no time"
    pattern, pattern_se = root(*shared_variance(dark.offsets, good_mask))
    # Relative errors of the gain carry over to everything that is converted to electrons.
    gain_share = curve.gain_se / curve.gain
    in_electrons = pattern / curve.gain
    electrons_se = sqrt((pattern_se / curve.gain) ** 2 + (in_electrons * gain_share) ** 2)
    quantities = _quantities(
        remark,
        offset=(dark.offset, dark.offset_spread_se),
        dsnu_lsb=(pattern, pattern_se),
        dsnu_e=(in_electrons, electrons_se),
    )
    if dark.currents is None or dark.current is None or dark.current_se is None:
        why = "requires darks with two or more exposure times"
        return quantities | _unknown(why, "dark_current", "dark_spread")
    current = max(dark.current, 0.0) / curve.gain
    current_se = sqrt((dark.current_se / curve.gain) ** 2 + (current * gain_share) ** 2)
    slope = f"slope of the darks of {len(dark.times_s)} times"
    quantities |= _quantities(slope, dark_current=(current, current_se))
    # A spread relative to a current that may be 0 would be meaningless.
    if dark.current < _SURE * dark.current_se:
        return quantities | _unknown(
            "the dark current is too small to measure its spread", "dark_spread"
        )
    sigma, sigma_se = root(*_unsmeared(shared_variance(dark.currents, good_mask), curve))
    spread = sigma / dark.current
    spread_se = sqrt(
        (sigma_se / dark.current) ** 2 + (spread * dark.current_se / dark.current) ** 2
    )
    return quantities | _quantities("relative to the mean", dark_spread=(spread, spread_se))


def _unsmeared(variance: tuple[float, float], curve: Transfer) -> tuple[float, float]:
    """Return a variance over the pixels before crosstalk smoothed it, and its standard error.
    `variance` is the measured variance with its standard error, `curve` gives the crosstalk."""
    errors = np.diag([variance[1] ** 2, float(curve.covariance[2, 2])])
    return propagated(lambda v: v[0] / kept_variance(v[1]), [variance[0], curve.crosstalk], errors)


def _fits(dark: DarkFit | None, flats: Sequence[LevelMoments]) -> bool:
    """Return whether the fit of the darks gives the dark charge of every flat: by its exposure
    time, or because flats and darks last equally long."""
    if dark is None:
        return False
    if dark.currents is not None:
        return all(level.exposure_s is not None for level in flats)
    return bool(dark.times_s) and all(level.exposure_s == dark.times_s[0] for level in flats)


def _prnu(spread: tuple[float, float], curve: Transfer, freed: bool) -> dict[str, Quantity]:
    """Return the PRNU as a quantity by name: the relative spread of the pixels' response to light.

    `spread`: its variance over the pixels with standard error, `curve` gives the crosstalk.
    `freed`: whether the spread of the dark charge has been subtracted; if not, the result is an
    upper limit. Raises Rejected (NS0759) above 20 %: the frames are not flat."""
    value, error = root(*_unsmeared(spread, curve))
    if value > _MOST_PRNU:
        raise rejected(
            "NS0759",
            f"the pixels' response differs by {value:.0%}: the frames are not flat",
            notes=("photon transfer requires flats: an evenly lit surface",),
            helps=("take flats of an evenly lit white surface, out of focus",),
        )
    if not freed:
        why = (
            "there are no darks with the exposure time of the flats: the spread of their dark "
            "charge is included"
        )
        return _quantities(why, "at most", prnu=(value, None))
    return _quantities("about a smooth surface", prnu=(value, error))


def _range(curve: Transfer, flats: Sequence[LevelMoments], top_code: int) -> dict[str, Quantity]:
    """Return the saturation in converter codes and in electrons (full well), as quantities by name.
    They are lower limits if no flat is saturated, or if the ADC saturates before the pixels, and
    unknown without a dark.

    `curve` is the fitted photon transfer curve, `flats` are the moments of the flats, and
    `top_code` is the largest converter code."""
    if curve.offset is None:
        return _unknown("no dark measures the code without charge", "saturation_lsb", "full_well")
    zero = curve.offset
    limit = curve.saturation
    if limit is not None and limit.of_pixel:
        remark = "mean code of flats that rise no more, less the code without charge"
        height, height_se = limit.mean - zero, sqrt(limit.mean_se**2 + curve.offset_se**2)
        errors = np.diag([curve.gain_se**2, height_se**2])
        electrons = propagated(lambda v: v[1] / v[0], [curve.gain, height], errors)
        return _quantities(remark, saturation_lsb=(height, height_se), full_well=electrons)
    highest = max(level.mean for level in flats) - zero
    if limit is None:
        remark = "no flat is saturated"
    elif max(level.share_at_top for level in flats) > 0:
        remark = f"the ADC saturates (code {top_code}) before the pixels do"
    else:
        remark = "the brightest flat saturates in part"
    in_electrons = (highest / curve.gain, None)
    return _quantities(remark, "at least", saturation_lsb=(highest, None), full_well=in_electrons)
