"""How well a chip tells light: what one exposure is worth, and how sure an answer is."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from nscc.chips.target import Target
from nscc_runtime.effects import Selection
from nscc_runtime.effects.parts import CountedLight, Errors, Soft, WordGain
from nscc_runtime.effects.selection import everything
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.response import converter_e2, gain_spread
from nscc_training.curves import MU, mu_law

Values = NDArray[np.float64]
Curve = Literal["mu", "linear", "log"]
CURVES: tuple[Curve, ...] = get_args(Curve)
PERCENTILE = 99.9
"""Light is measured in this percentile of its scene's, as hdr-v1 does."""

_POINTS, _REACH = 37, 4.5
"""Of the sum over noise, and how many standard deviations it goes: what is clipped has a kink, at
which a rule of few points that is exact for polynomials is off by a percent."""
_READS, _WORDS = 2, 3
"""An exposure is PIX less its reset level: each is read once, and three words bring them together,
four where shutters open again."""
_COPIES = 2
"""Words that a look's light goes through: PIX, and its reset level, come as one copy each."""


@dataclass(frozen=True, eq=False)
class DesignChip:
    """A target with its sensor, and the effects that act on it."""

    target: Target
    sensor: Sensor
    effects: Selection

    @classmethod
    def of(cls, target: Target, sensor: Sensor) -> DesignChip:
        """With every effect that there is."""
        return cls(target, sensor, everything())

    @property
    def code_e(self) -> float:
        """Electrons of one code of the converter: less light than that over a whole frame is as
        good as none."""
        return self.sensor.electrons_per_lsb

    @cached_property
    def gain(self) -> float:
        """What two words leave of an exposure."""
        words = self.effects.find_part(WordGain)
        return 1.0 if words is None else words.gain(self.sensor) ** 2

    @cached_property
    def full_e(self) -> float:
        """The most electrons that an exposure tells: of a well, of the converter's codes, or of a
        register that is still linear."""
        codes = self.target.top_code - self.sensor.adc_offset_lsb
        most = min(float(self.sensor.full_well_e), float(codes * self.code_e / self.gain))
        soft = self.effects.find_part(Soft)
        return most if soft is None else min(most, float(soft.linear_e(self.sensor) / self.gain))

    def exposed_sd_e(self, electrons: Values) -> Values:
        """The standard deviation of an exposure's estimate, in electrons on PIX."""
        sensor, effects = self.sensor, self.effects
        fixed_e2 = converter_e2(sensor, effects)
        times = {"reads": _READS, "words": _WORDS, "resets": 0}
        for _, errors in effects.errors():
            fixed_e2 += times[errors.at] * errors.sigma_e(sensor) ** 2
        photons_e2 = electrons if effects.find_part(CountedLight) is not None else 0.0
        unequal_e2 = (gain_spread(sensor, effects) * electrons) ** 2
        return np.asarray(np.sqrt(fixed_e2 / self.gain**2 + photons_e2 + unequal_e2))

    def errors(self, light_e: Values, peak_e: Values, share: Values, curve: Curve) -> Values:
        """The mean square error (groups, shares) of light (groups,), electrons over the frame,
        that is told by an exposure of these shares of it, on a curve of light."""
        truth = on_curve(light_e[:, None], peak_e[:, None], curve, self.code_e)
        exposed = light_e[:, None] * share
        sd = self.exposed_sd_e(exposed)
        places = np.linspace(-_REACH, _REACH, _POINTS)
        weights = np.exp(-(places**2) / 2)
        weights /= weights.sum()
        mean_square_error = np.zeros(exposed.shape)
        for place, weight in zip(places, weights, strict=True):
            measured_e = np.clip(exposed + sd * place, 0.0, self.full_e) / share
            measured_on_curve = on_curve(measured_e, peak_e[:, None], curve, self.code_e)
            mean_square_error += weight * (measured_on_curve - truth) ** 2
        return mean_square_error

    @cached_property
    def offset_e(self) -> float:
        """The standard deviation over the pixels of what a comparison is off by, for good."""
        return self.sensor.comparator_offset_fraction * self.sensor.full_well_e

    def compared_sd_e(self, electrons: Values) -> Values:
        """The standard deviation of what is compared in one look: comparator, copies, counts."""
        noise_e = self.sensor.comparator_noise_fraction * self.sensor.full_well_e
        copies = sum(_COPIES * errors.sigma_e(self.sensor) ** 2 for errors in self._small())
        return np.sqrt(noise_e**2 + copies + electrons)

    def _small(self) -> list[Errors]:
        return [errors for _, errors in self.effects.errors() if errors.at != "resets"]

    @cached_property
    def levels(self) -> NDArray[np.int64]:
        """The steps of IN that a look may compare with."""
        most = most_steps(self.target, self.sensor.full_well_e)
        return np.unique(np.linspace(1, most, _MOST_LEVELS).round().astype(np.int64))


def most_steps(target: Target, well_e: float) -> int:
    """The largest step of IN that a look may compare with: below a full well and register."""
    full_e = min(target.full_well_e, target.register_max_e, well_e)
    below = math.ceil(full_e / target.electrons_per_step) - 1
    return max(1, min(target.in_high, below))


_MOST_LEVELS = 64
"""Finer than comparators tell apart, whose noise is a percent and more of a well."""


def on_curve(light_e: Values, peak_e: Values, curve: Curve, dark_e: float) -> Values:
    """Light on the curve on which it is compared: mu-law or linear over the peak, clipped to 0..1;
    or its natural logarithm, what is below `dark_e` as that."""
    if curve == "log":
        return np.log(np.maximum(light_e, dark_e))
    relative_light = np.clip(light_e / peak_e, 0.0, 1.0)
    return mu_law(relative_light, MU) if curve == "mu" else relative_light


def hermite(points: int) -> tuple[Values, Values]:
    """Places and weights of the Gauss-Hermite rule for a standard normal number."""
    places, weights = np.polynomial.hermite_e.hermegauss(points)
    return places, weights / weights.sum()
