"""The parts that the fast paths know: what sums over slots can be made of.

A sum over slots weighs the light of every slot by the pixel's code, draws counts for groups of
slots, and the errors of all words at once. An effect takes part in it by these. One effect has each
of them, but for `Errors`, of which there may be any number.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects.field import OnDevice
from nscc_runtime.effects.sensor import Sensor

OfSensor = Callable[[Sensor], float]
Values = NDArray[np.float64]


class Part:
    """A part of an effect. `fused`: the loop that does a simple plan in one go has it too."""

    fused: ClassVar[bool] = False


@dataclass(frozen=True)
class Moving(Part):
    """Light is that with motion inside slots, where a scene has any."""

    fused: ClassVar[bool] = True


@dataclass(frozen=True)
class Echo(Part):
    """A part of the light of the frame before, the same scene, comes again."""

    fraction: OfSensor
    fused: ClassVar[bool] = True


@dataclass(frozen=True)
class Response(Part):
    """A factor of each pixel on its light."""

    factor: OnDevice
    fused: ClassVar[bool] = True


@dataclass(frozen=True)
class Counted(Part):
    """Charge is counted in whole electrons."""


@dataclass(frozen=True)
class CountedLight(Counted):
    """Of light."""

    fused: ClassVar[bool] = True


@dataclass(frozen=True)
class CountedDark(Counted):
    """Of charge that falls without light, `per_s` electrons a second in the mean."""

    per_s: OnDevice


@dataclass(frozen=True)
class Exchange(Part):
    """A part of the charge of a pixel goes to each of its four neighbours: `smeared(charge (..,
    rows, cols), fraction)` is what there is afterwards."""

    fraction: OfSensor
    smeared: Callable[[Values, float], Values]


@dataclass(frozen=True)
class Saturates(Part):
    """Something holds no more than so much; pixels that come near run through their words."""

    fused: ClassVar[bool] = True


@dataclass(frozen=True)
class Well(Saturates):
    """PIX holds `full_e`, exactly: sums of one read may be clipped."""

    full_e: OfSensor


@dataclass(frozen=True)
class Soft(Saturates):
    """Registers are linear up to `linear_e`; of a value of this size they lose `lost_e`."""

    linear_e: OfSensor
    lost_e: Callable[[Sensor, Values], Values]


@dataclass(frozen=True)
class Errors(Part):
    """Many small errors that are one draw a bucket: `sigma_e` at every read or reset of PIX, or
    at every word."""

    at: Literal["reads", "resets", "words"]
    sigma_e: OfSensor
    fused: ClassVar[bool] = True


@dataclass(frozen=True)
class WordGain(Part):
    """A word multiplies with `gain` and adds a fixed error: of mean `mean_e` and standard deviation
    `spread_e` over the pixels."""

    gain: OfSensor
    error_e: OnDevice
    mean_e: OfSensor
    spread_e: OfSensor


@dataclass(frozen=True)
class Leak(Part):
    """Registers lose their values at a rate in 1/s of each pixel: 1 / `tau_s` in the mean,
    lognormal, `spread` its relative standard deviation."""

    per_s: OnDevice
    tau_s: OfSensor
    spread: OfSensor


@dataclass(frozen=True)
class SlowWords(Part):
    """Light falls while words run."""


@dataclass(frozen=True)
class Fading(Part):
    """Digital registers lose their values after a while."""


@dataclass(frozen=True)
class Converter(Part):
    """The converter is off by `sigma_lsb` codes, drawn for every pixel and bucket."""

    sigma_lsb: OfSensor
    fused: ClassVar[bool] = True


@dataclass(frozen=True)
class Codes(Part):
    """The converter's codes: electrons a code, and the code of no electrons."""

    electrons: OfSensor
    offset: OfSensor
    fused: ClassVar[bool] = True
