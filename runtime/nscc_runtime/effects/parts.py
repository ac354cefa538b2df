"""The parts that the fast paths know: what sums over slots can be made of.

A sum over slots weighs the light of every slot by the pixel's code, draws counts for groups of
slots, and the errors of all words at once. An effect takes part in it by these. One effect has each
of them, but for `Errors` and `Converter`, of which there may be any number.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import OnDevice

OfSensor = Callable[[Sensor], float]
Values = NDArray[np.float64]


class Part:
    """A part of an effect, for what it does at a `stage` of the reference."""

    stage: ClassVar[str] = ""

    def __init_subclass__(cls, stage: str = "") -> None:
        cls.stage = stage


@dataclass(frozen=True)
class Moving(Part, stage="scene"):
    """Light is that with motion inside slots, where a scene has any."""


@dataclass(frozen=True)
class Echo(Part, stage="light"):
    """A part of the light of the frame before, the same scene, comes again."""

    fraction: OfSensor


@dataclass(frozen=True)
class Response(Part, stage="response"):
    """A factor of each pixel on its light."""

    factor: OnDevice


class Counted(Part):
    """Charge is counted in whole electrons."""


@dataclass(frozen=True)
class CountedLight(Counted, stage="count"):
    """Of light."""


@dataclass(frozen=True)
class CountedDark(Counted, stage="charge"):
    """Of charge that falls without light, `per_s` electrons a second in the mean."""

    per_s: OnDevice


@dataclass(frozen=True)
class Exchange(Part, stage="neighbours"):
    """A part of the charge of a pixel goes to each of its four neighbours: `smeared(charge (..,
    rows, cols), fraction)` is what there is afterwards."""

    fraction: OfSensor
    smeared: Callable[[Values, float], Values]


class Saturates(Part):
    """Something holds no more than so much; pixels that come near run through their words."""


@dataclass(frozen=True)
class Well(Saturates, stage="well"):
    """PIX holds `full_e`, exactly: sums of one read may be clipped."""

    full_e: OfSensor


@dataclass(frozen=True)
class Soft(Saturates, stage="registers"):
    """Registers are linear up to `linear_e`; of a value of this size they lose `lost_e`."""

    linear_e: OfSensor
    lost_e: Callable[[Sensor, Values], Values]


@dataclass(frozen=True)
class Errors(Part):
    """Many small errors that are one draw a bucket: `sigma_e` `at` every read or reset of PIX, or
    at every word."""

    at: Literal["reads", "resets", "words"]
    sigma_e: OfSensor


@dataclass(frozen=True)
class WordGain(Part, stage="words"):
    """A word multiplies with `gain` and adds a fixed error: of mean `mean_e` and standard deviation
    `spread_e` over the pixels."""

    gain: OfSensor
    error_e: OnDevice
    mean_e: OfSensor
    spread_e: OfSensor


@dataclass(frozen=True)
class Leak(Part, stage="hold"):
    """Registers lose their values at a rate in 1/s of each pixel: 1 / `tau_s` in the mean,
    lognormal, `spread` its relative standard deviation."""

    per_s: OnDevice
    tau_s: OfSensor
    spread: OfSensor


@dataclass(frozen=True)
class SlowWords(Part, stage="time"):
    """Light falls while words run."""


@dataclass(frozen=True)
class LitLevel(Part, stage="level"):
    """Where light falls while words run, the level of a reset is read with what fell since."""


@dataclass(frozen=True)
class Fading(Part, stage="digital"):
    """Digital registers lose their values after a while."""


@dataclass(frozen=True)
class Converter(Part, stage="converter"):
    """The converter is off by `sigma_lsb` codes, drawn for every pixel and bucket, once for all
    effects with such a part."""

    sigma_lsb: OfSensor


@dataclass(frozen=True)
class Codes(Part, stage="codes"):
    """The converter's codes: electrons a code, and the code of no electrons."""

    electrons: OfSensor
    offset: OfSensor
