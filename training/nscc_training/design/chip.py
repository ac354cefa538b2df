"""Noise of a chip: the error of one exposure, and the uncertainty of a comparison."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Literal, get_args

import numpy as np

from nscc.arrays import Floats, Ints
from nscc.chips.target import Target
from nscc_runtime.effects import Selection
from nscc_runtime.effects.parts import CountedLight, Soft, WordGain
from nscc_runtime.effects.selection import everything
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.response import converter_e2, gain_spread
from nscc_training.curves import MU, mu_law

Curve = Literal["mu", "linear", "log"]
"""Name of the scale on which errors of light are measured; `on_curve` computes the scales."""
CURVES: tuple[Curve, ...] = get_args(Curve)
PERCENTILE = 99.9
"""Percentile of a scene's light that counts as its peak, as in protocol hdr-v1."""

_POINTS, _REACH = 37, 4.5
"""Number of points of the sum over noise, and its range in standard deviations.

A Gauss-Hermite rule with few points would be wrong by 1 %, because clipping has a kink."""
_READS, _ADDITIONS, _MOVES = 2, 1, 3
"""Reads, additions and moves of an exposure: PIX is moved by a word, and the next adds its reset
level, which two words have moved. If shutters open again, both words add."""
_COPIES = 2
"""Copies that a look compares: PIX, and its reset level."""


@dataclass(frozen=True, eq=False)
class DesignChip:
    """A target (the description of a chip) with its sensor and the effects that act on the sensor.
    It computes the errors from which designs are made."""

    target: Target
    sensor: Sensor
    effects: Selection

    @classmethod
    def of(cls, target: Target, sensor: Sensor) -> DesignChip:
        """Return the chip with all effects of the emulator switched on."""
        return cls(target, sensor, everything())

    @property
    def code_e(self) -> float:
        """Electrons of one converter code. A pixel that receives less over a whole frame counts as
        dark."""
        return self.sensor.electrons_per_lsb

    @cached_property
    def gain(self) -> float:
        """The gain of the two words that bring an exposure into its register, a move and an
        addition: below 1 if copies lose charge."""
        words = self.effects.find_part(WordGain)
        if words is None:
            return 1.0
        return words.gain(self.sensor) * words.move_gain(self.sensor)

    @cached_property
    def full_e(self) -> float:
        """The largest exposure, in electrons, that is measured without clipping or compression: the
        smallest limit of full well, converter and registers."""
        codes = self.target.top_code - self.sensor.adc_offset_lsb
        most = min(float(self.sensor.full_well_e), float(codes * self.code_e / self.gain))
        soft = self.effects.find_part(Soft)
        return most if soft is None else min(most, float(soft.linear_e(self.sensor) / self.gain))

    def exposed_sd_e(self, electrons: Floats) -> Floats:
        """Return the standard deviation of the measured value of exposures of `electrons`, in
        electrons of the photodiode and in their shape. It includes readout, words, photons and
        differences between pixels."""
        sensor, effects = self.sensor, self.effects
        fixed_e2 = converter_e2(sensor, effects)
        fixed_e2 += self._words_e2(_READS, _ADDITIONS, _MOVES)
        photons_e2 = electrons if effects.find_part(CountedLight) is not None else 0.0
        unequal_e2 = (gain_spread(sensor, effects) * electrons) ** 2
        return np.asarray(np.sqrt(fixed_e2 / self.gain**2 + photons_e2 + unequal_e2))

    def _words_e2(self, reads: int, additions: int, moves: int) -> float:
        """Return the variance, in square electrons, that a pixel's words add. `reads`, `additions`
        and `moves` are the numbers of reads of PIX (the photodiode), of additions and of moves."""
        words = self.effects.find_part(WordGain)
        move_noise = 1.0 if words is None else words.move_noise(self.sensor)
        times = {"reads": reads, "words": additions + moves * move_noise**2, "resets": 0.0}
        return sum(
            times[errors.at] * errors.sigma_e(self.sensor) ** 2
            for _, errors in self.effects.errors()
        )

    def errors(self, light_e: Floats, peak_e: Floats, share: Floats, curve: Curve) -> Floats:
        """Return the mean square error (groups, shares) on `curve` of light that is estimated from
        one exposure.

        `light_e` and `peak_e` (groups,) are the true light and the peak of its scene, in electrons
        over the frame. `share` (shares,) is the fraction of the frame for which the pixel is open,
        above 0. The expectation over normal noise is a sum over `_POINTS` values."""
        truth = on_curve(light_e[:, None], peak_e[:, None], curve, self.code_e)
        exposed = light_e[:, None] * share
        sd = self.exposed_sd_e(exposed)
        deviations = np.linspace(-_REACH, _REACH, _POINTS)
        weights = np.exp(-(deviations**2) / 2)
        weights /= weights.sum()
        mean_square_error = np.zeros(exposed.shape)
        for deviation, weight in zip(deviations, weights, strict=True):
            measured_e = np.clip(exposed + sd * deviation, 0.0, self.full_e) / share
            measured_on_curve = on_curve(measured_e, peak_e[:, None], curve, self.code_e)
            mean_square_error += weight * (measured_on_curve - truth) ** 2
        return mean_square_error

    @cached_property
    def offset_e(self) -> float:
        """The standard deviation over pixels of the comparator offset, in electrons."""
        return self.sensor.comparator_offset_fraction * self.sensor.full_well_e

    def compared_sd_e(self, electrons: Floats) -> Floats:
        """Return the standard deviation of one comparison with an exposure of `electrons`, in
        electrons: photons, comparator noise and copies. The comparator's fixed offset is not
        included. `electrons` are 0 or more, of any shape, which the result has."""
        noise_e = self.sensor.comparator_noise_fraction * self.sensor.full_well_e
        copies_e2 = self._words_e2(_COPIES, 0, _COPIES)
        return np.sqrt(noise_e**2 + copies_e2 + electrons)

    @cached_property
    def levels(self) -> Ints:
        """The levels to try, int64, in steps of IN (the level sent to all pixels), increasing from
        1: at most `_MOST_LEVELS`, evenly spaced."""
        most = most_steps(self.target, self.sensor.full_well_e)
        return np.unique(np.linspace(1, most, _MOST_LEVELS).round().astype(np.int64))


def most_steps(target: Target, well_e: float) -> int:
    """Return the largest level of a look in steps of IN: below a full well (`well_e`) and the
    largest value of a register; at least 1. IN is the level sent to all pixels."""
    full_e = min(target.full_well_e, target.register_max_e, well_e)
    below = math.ceil(full_e / target.electrons_per_step) - 1
    return max(1, min(target.in_high, below))


_MOST_LEVELS = 64
"""Most levels that are tried; comparators have a noise of 1 % of a full well or more."""


def on_curve(light_e: Floats, peak_e: Floats, curve: Curve, dark_e: float) -> Floats:
    """Return light on the curve on which errors are measured: relative to the peak and clipped to
    0..1, on a linear or mu-law scale; or for "log" the natural logarithm of light, at least
    `dark_e`. `light_e` and `peak_e` (above 0) are in electrons and broadcast."""
    if curve == "log":
        return np.log(np.maximum(light_e, dark_e))
    relative_light = np.clip(light_e / peak_e, 0.0, 1.0)
    return mu_law(relative_light, MU) if curve == "mu" else relative_light
