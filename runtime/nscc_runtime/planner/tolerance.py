"""Tolerances: electrons, codes of the ADC, or a part of the scene's own signal."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected
from nscc_runtime.effects import everything
from nscc_runtime.effects.parameters import MOST_E
from nscc_runtime.effects.parts import Well
from nscc_runtime.effects.sensor import Sensor

LEAST_E = 1e-9
"""Electrons; the promise is checked with sums of float64 numbers, which tell no less apart."""

_TOLERANCE = re.compile(r"\s*((?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)\s*(e|lsb|%)\s*")


@dataclass(frozen=True)
class Tolerance:
    """What was asked, as text, and the electrons before the ADC that it means.

    `signal_e`: the mean signal that it is a part of; None where it does not follow the scene.
    """

    text: str
    electrons: float
    signal_e: float | None = None

    @property
    def name(self) -> str:
        """What tells it from others, on any scene: its electrons, or its part of the signal."""
        return f"{self.electrons:g}e" if self.signal_e is None else self.text


Given = str | float | Tolerance
"""How a tolerance is asked for: text, a number of electrons, or one that is found already."""


def tolerance_of(given: Given, sensor: Sensor, signal_e: Callable[[], float]) -> Tolerance:
    """Of `5e`, of `0.1lsb`, of `1%` of what `signal_e` finds, or of a number of electrons; one that
    is found already stays what it is.

    `signal_e` is asked for percentages only: see `mean_signal_e`. Raises Rejected (NS0746, status
    2) for anything else, for electrons beyond LEAST_E..MOST_E, and for a part of no signal.
    """
    if isinstance(given, Tolerance):
        return given
    if not isinstance(given, str):
        text = f"{float(given)!r}".removesuffix(".0") + "e"
        return _within(Tolerance(text, float(given)), str(given))
    match = _TOLERANCE.fullmatch(given)
    if match is None:
        raise _malformed(f"'{given[:40]}'")
    value, unit = float(match[1]), match[2]
    text = f"{match[1]}{unit}"
    if unit != "%":
        electrons = value * (1.0 if unit == "e" else sensor.electrons_per_lsb)
        return _within(Tolerance(text, electrons), f"'{given[:40]}'")
    if not 0 < value < math.inf:
        raise _malformed(f"'{given[:40]}'")
    signal = signal_e()
    if not signal > 0:
        raise rejected(
            "NS0746",
            f"{text[:40]} of this scene is nothing: its mean signal is 0 electrons",
            notes=("a part of the signal is a part of the mean exposure, without effects",),
            helps=("say it in electrons, --tolerance 5e, or in codes, --tolerance 0.1lsb",),
        )
    found = Tolerance(text, value / 100 * signal, signal)
    return _within(found, f"{text[:40]} of a mean signal of {signal:.3g} electrons")


def mean_signal_e(exposure_e: NDArray[np.float64], sensor: Sensor) -> float:
    """The mean of exposures without effects over pixels and buckets, in electrons: of their sizes,
    each at most the full well. What is no number does not count."""
    sizes = np.abs(exposure_e[~np.isnan(exposure_e)])
    most_e = everything().the(Well).full_e(sensor)
    return float(np.minimum(sizes, most_e).mean()) if sizes.size else 0.0


def _within(found: Tolerance, shown: str) -> Tolerance:
    if not LEAST_E <= found.electrons <= MOST_E:
        raise _malformed(shown)
    return found


def _malformed(shown: str) -> Rejected:
    return rejected(
        "NS0746",
        f"a tolerance is a number above 0 with its unit, not {shown}",
        notes=(
            "e: electrons before the ADC; lsb: codes of the ADC; %: of the scene's mean signal",
            f"it lies between {LEAST_E:g} and {MOST_E:g} electrons",
        ),
        helps=("write --tolerance 5e, --tolerance 0.1lsb or --tolerance 1%",),
    )
