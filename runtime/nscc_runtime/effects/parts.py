"""The parts of effects that the fast paths support.

A sum over slots weights the light of every slot by the pixel's code, draws counts for groups of
slots, and draws the errors of all words at once. Effects contribute to it by these parts. Each part
belongs to one effect, except `Errors` and `Converter`, of which there may be several.
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
    """A part of an effect, standing for its function at a `stage` of the reference."""

    stage: ClassVar[str] = ""

    def __init_subclass__(cls, stage: str = "") -> None:
        cls.stage = stage


@dataclass(frozen=True)
class Moving(Part, stage="scene"):
    """The light moves inside slots, if the scene has motion."""


@dataclass(frozen=True)
class Echo(Part, stage="light"):
    """A fraction of the light of the previous frame, of the same scene, is added."""

    fraction: OfSensor


@dataclass(frozen=True)
class Response(Part, stage="response"):
    """Each pixel has a factor on its light."""

    factor: OnDevice


class Counted(Part):
    """Charge is counted in whole electrons."""


@dataclass(frozen=True)
class CountedLight(Counted, stage="count"):
    """Light is counted."""


@dataclass(frozen=True)
class CountedDark(Counted, stage="charge"):
    """Dark charge is counted, `per_s` electrons per second on average."""

    per_s: OnDevice


@dataclass(frozen=True)
class Exchange(Part, stage="neighbours"):
    """A fraction of a pixel's charge goes to each of its four neighbours. `smeared(charge (..,
    rows, cols), fraction)` returns the charge afterwards."""

    fraction: OfSensor
    smeared: Callable[[Values, float], Values]


class Saturates(Part):
    """A storage saturates; pixels near saturation run through their words."""


@dataclass(frozen=True)
class Well(Saturates, stage="well"):
    """PIX saturates at exactly `full_e`: sums of one read may be clipped."""

    full_e: OfSensor


@dataclass(frozen=True)
class Soft(Saturates, stage="registers"):
    """Registers are linear up to `linear_e`; at that value they lose `lost_e`."""

    linear_e: OfSensor
    lost_e: Callable[[Sensor, Values], Values]


@dataclass(frozen=True)
class Errors(Part):
    """Many small errors, drawn as one per bucket: `sigma_e` `at` every read or reset of PIX, or
    every word."""

    at: Literal["reads", "resets", "words"]
    sigma_e: OfSensor


@dataclass(frozen=True)
class WordGain(Part, stage="words"):
    """A word multiplies by `gain` and adds a fixed error of mean `mean_e` and standard deviation
    `spread_e` over the pixels."""

    gain: OfSensor
    error_e: OnDevice
    mean_e: OfSensor
    spread_e: OfSensor


@dataclass(frozen=True)
class Leak(Part, stage="hold"):
    """Registers decay at a rate in 1/s of each pixel: 1 / `tau_s` on average, lognormal with
    relative standard deviation `spread`."""

    per_s: OnDevice
    tau_s: OfSensor
    spread: OfSensor


@dataclass(frozen=True)
class SlowWords(Part, stage="time"):
    """Light falls while words run."""


@dataclass(frozen=True)
class LitLevel(Part, stage="level"):
    """Light that falls while words run is included in the level of a reset."""


@dataclass(frozen=True)
class Fading(Part, stage="digital"):
    """Digital registers lose their values after a time."""


@dataclass(frozen=True)
class Converter(Part, stage="converter"):
    """The converter has an error of `sigma_lsb` codes, drawn per pixel and bucket, once for all
    effects with this part."""

    sigma_lsb: OfSensor


@dataclass(frozen=True)
class Codes(Part, stage="codes"):
    """The converter's codes: electrons per code, and the code of zero electrons."""

    electrons: OfSensor
    offset: OfSensor
