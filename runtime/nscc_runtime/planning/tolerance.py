"""Tolerances: electrons, codes of the ADC, or a part of the scene's own signal or noise."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected
from nscc_runtime.effects import everything
from nscc_runtime.effects.parameters import MOST_E
from nscc_runtime.effects.parts import Codes, Well
from nscc_runtime.effects.sensor import Sensor

LEAST_E = 1e-9
"""Electrons; the promise is checked with sums of float64 numbers, which tell no less apart."""

DEFAULT = "0.15noise"
"""What is allowed where nobody says: errors of 0.15 of the noise, which add in quadrature, make its
standard deviation 1.1 % larger. To tell that apart takes frames of 4,000 pixels."""

_TOLERANCE = re.compile(
    r"\s*((?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)\s*(e|lsb|%|noise)\s*"
)


@dataclass(frozen=True)
class Tolerance:
    """What was asked, as text, and the electrons before the ADC that it means.

    `signal_e`: the mean signal that it is a part of, or `noise_e`, the frame's own noise; both None
    where it does not follow the scene.
    """

    text: str
    electrons: float
    signal_e: float | None = None
    noise_e: float | None = None

    @property
    def follows(self) -> bool:
        """Whether it means other electrons on other scenes."""
        return self.signal_e is not None or self.noise_e is not None

    @property
    def in_electrons(self) -> bool:
        """Whether it was asked for in electrons."""
        return not self.follows and not self.text.endswith("lsb")

    @property
    def noise_part(self) -> float | None:
        """Which part of the noise it is."""
        return None if self.noise_e is None else self.electrons / self.noise_e

    @property
    def name(self) -> str:
        """What tells it from others, on any scene: its electrons, or its codes, or its part of the
        scene, as they were asked for."""
        return f"{self.electrons:g}e" if self.in_electrons else self.text

    def __str__(self) -> str:
        electrons = f"{self.electrons:.4g} e"
        if self.noise_e is not None:
            return f"{self.text.removesuffix('noise')} of the frame's own noise = {electrons}"
        if self.signal_e is not None:
            return f"{electrons} ({self.text} of the mean signal, {self.signal_e:.4g} e)"
        return electrons if self.in_electrons else f"{electrons} ({self.text})"


Given = str | float | Tolerance
"""How a tolerance is asked for: text, a number of electrons, or one that is found already."""


class Follows(Protocol):
    """What a tolerance may be a part of, of one scene: its mean signal, or its frame's own
    noise."""

    def signal_e(self) -> float: ...

    def noise_e(self) -> float: ...


OPTION, OPTION_MAX = "--tolerance", "--tolerance-max"


def tolerance_of(given: Given, sensor: Sensor, scene: Follows, option: str = OPTION) -> Tolerance:
    """Of `5e`, of `0.1lsb`, of `1%` of the scene's signal, of `0.1noise`, of a number of electrons;
    one that is found already stays what it is.

    The scene is asked for its signal or its noise only where a tolerance is a part of it. Raises
    Rejected (NS0746, status 2), which names the `option`, for anything else, for electrons beyond
    LEAST_E..MOST_E, and for a part of no signal.
    """
    if isinstance(given, Tolerance):
        return given
    if not isinstance(given, str):
        text = f"{float(given)!r}".removesuffix(".0") + "e"
        return _within(Tolerance(text, float(given)), str(given), option)
    match = _TOLERANCE.fullmatch(given.lower())
    if match is None:
        raise _malformed(f"'{given[:40]}'", option)
    value, unit = float(match[1]), match[2]
    text = f"{match[1]}{unit}"
    if unit in ("e", "lsb"):
        electrons = value * (1.0 if unit == "e" else sensor.electrons_per_lsb)
        return _within(Tolerance(text, electrons), f"'{given[:40]}'", option)
    if not 0 < value < math.inf:
        raise _malformed(f"'{given[:40]}'", option)
    if unit == "noise":
        noise = scene.noise_e()
        found = Tolerance(text, value * noise, noise_e=noise)
        return _within(found, f"{text[:40]}, a frame's own noise of {noise:.3g} electrons", option)
    signal = scene.signal_e()
    if not signal > 0:
        raise rejected(
            "NS0746",
            f"{text[:40]} of this scene is 0: its mean signal is 0 electrons",
            notes=("a percentage refers to the mean exposure without effects",),
            helps=(f"use electrons, {option} 5e, or codes, {option} 0.1lsb",),
        )
    found = Tolerance(text, value / 100 * signal, signal_e=signal)
    return _within(found, f"{text[:40]} of a mean signal of {signal:.3g} electrons", option)


def noise_part(text: str) -> float | None:
    """Which part of the frame's own noise a text asks for; None where it asks for something
    else."""
    match = _TOLERANCE.fullmatch(text.lower())
    return float(match[1]) if match is not None and match[2] == "noise" else None


def check_tolerance(given: Given, sensor: Sensor, option: str = OPTION) -> None:
    """Where nothing is approximated: Rejected (NS0746) for what is no tolerance of any scene."""

    class Bright:
        """A scene of which every part is something."""

        def signal_e(self) -> float:
            return 1e4

        noise_e = signal_e

    tolerance_of(given, sensor, Bright(), option)


def mean_signal_e(exposure_e: NDArray[np.float64], sensor: Sensor) -> float:
    """The mean of exposures without effects over pixels and buckets, in electrons: of their sizes,
    each at most the full well. What is no number does not count."""
    sizes = np.abs(exposure_e[~np.isnan(exposure_e)])
    most_e = everything().the(Well).full_e(sensor)
    return float(np.minimum(sizes, most_e).mean()) if sizes.size else 0.0


def with_readout_e(noise_e: float, sensor: Sensor) -> float:
    """The noise of frames whose exposures have that noise: with that of the converter and of
    rounding to codes."""
    every = everything()
    code_e = every.the(Codes).electrons(sensor)
    return math.hypot(noise_e, every.converter_lsb(sensor) * code_e, code_e / math.sqrt(12.0))


def _within(found: Tolerance, shown: str, option: str) -> Tolerance:
    if not LEAST_E <= found.electrons <= MOST_E:
        raise _malformed(shown, option)
    return found


def _malformed(shown: str, option: str) -> Rejected:
    what = "a tolerance" if option == OPTION else f"the tolerance of {option}"
    return rejected(
        "NS0746",
        f"{what} must be a number above 0 with its unit, not {shown}",
        notes=(
            "e: electrons before the ADC; lsb: codes of the ADC; %: of the scene's mean "
            "signal; noise: a fraction of the frame's own noise",
            f"it must be between {LEAST_E:g} and {MOST_E:g} electrons",
        ),
        helps=(
            f"write {option} 5e, {option} 0.1lsb, {option} 1%, {option} {DEFAULT} or leave it out",
        ),
    )
