"""The parts of effects that the fast paths support.

A sum over slots weights the light of every slot by the pixel's code, draws counts for groups of
slots, and draws the errors of all words at once. Effects contribute to it by these parts. Each part
belongs to one effect, except `Errors` and `Converter`, which several effects may have."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

from nscc.arrays import Floats
from nscc.record import Record
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import OnDevice

OfSensor = Callable[[Sensor], float]


class Part(Record):
    """A part of an effect, which fast paths use instead of the effect's function at a `stage`."""

    stage = ""

    def __init_subclass__(cls, stage: str = "") -> None:
        """Store the stage of a frame to which a kind of part belongs."""
        super().__init_subclass__()
        cls.stage = stage


class Moving(Part, stage="scene"):
    """Declares that light moves inside slots, if the scene has motion."""


class Echo(Part, stage="light"):
    """Declares that a fraction of the light of the previous frame is added."""

    fraction: OfSensor


class Response(Part, stage="response"):
    """Declares that the light of each pixel is multiplied by a fixed factor."""

    factor: OnDevice


class Counted(Part):
    """Declares that charge is drawn as Poisson counts of electrons."""


class CountedLight(Counted, stage="count"):
    """Declares that photon counts are Poisson numbers."""


class CountedDark(Counted, stage="charge"):
    """Declares a dark charge: a Poisson number with mean `per_s` electrons per second."""

    per_s: OnDevice


class Exchange(Part, stage="neighbours"):
    """Declares that a fraction of a pixel's charge moves to each of its four neighbours.
    `smeared(charge (.., rows, cols), fraction)` returns the charge afterwards."""

    fraction: OfSensor
    smeared: Callable[[Floats, float], Floats]


class Saturates(Part):
    """Declares that PIX (the photodiode) or registers saturate. Pixels near saturation run through
    their words."""


class Well(Saturates, stage="well"):
    """Declares that PIX (the photodiode) is clipped at `full_e` electrons."""

    full_e: OfSensor


class Soft(Saturates, stage="registers"):
    """Declares that registers are linear up to `linear_e` and lose `lost_e` of larger values."""

    linear_e: OfSensor
    lost_e: Callable[[Sensor, Floats], Floats]


class Errors(Part):
    """Declares normal errors with standard deviation `sigma_e` at every read or reset of PIX (the
    photodiode), or at every word. Their sum in a bucket is one draw."""

    at: Literal["reads", "resets", "words"]
    sigma_e: OfSensor


class WordGain(Part, stage="words"):
    """Declares that an addition multiplies by `gain` and adds a fixed error, with mean `mean_e` and
    standard deviation `spread_e` over the pixels. A move multiplies by `move_gain`. Its random
    error is the part `move_noise` of the `Errors` of words."""

    gain: OfSensor
    move_gain: OfSensor
    move_noise: OfSensor
    error_e: OnDevice
    mean_e: OfSensor
    spread_e: OfSensor


class Leak(Part, stage="hold"):
    """Declares that registers decay exponentially at a rate `per_s` in 1/s that differs between
    pixels. The rates are lognormal with mean 1 / `tau_s` and relative standard deviation `spread`.
    """

    per_s: OnDevice
    tau_s: OfSensor
    spread: OfSensor


class SlowWords(Part, stage="time"):
    """Declares that light is collected while words run."""


class LitLevel(Part, stage="level"):
    """Declares that light collected while words run is included in the reset level."""


class Fading(Part, stage="digital"):
    """Declares that digital registers lose their values after a time."""


class CodeErrors(Part):
    """Declares errors of converter codes before rounding, with standard deviation `sigma_lsb`, in
    codes."""

    sigma_lsb: OfSensor


class Converter(CodeErrors, stage="converter"):
    """Declares converter noise with standard deviation `sigma_lsb`, in converter codes. All effects
    with this part share one draw (a random number of every pixel)."""


class FixedCodes(CodeErrors, stage="pattern"):
    """Declares an error of each converter code that is fixed for a chip, with standard deviation
    `sigma_lsb` over the pixels, in codes."""


class CommonCode(CodeErrors, stage="common"):
    """Declares an error that all converter codes of a bucket share, with standard deviation
    `sigma_lsb`, in codes."""


class InColumns(Part, stage="columns"):
    """Declares that converter noise is a weighted sum of the noise of a pixel and of those below
    it."""


class Codes(Part, stage="codes"):
    """Declares the converter's scale: `electrons` per converter code."""

    electrons: OfSensor
