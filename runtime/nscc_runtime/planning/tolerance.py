"""Tolerances in electrons, in converter codes, or as a fraction of the scene's signal or noise."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from nscc.arrays import Floats
from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc_runtime.effects import everything
from nscc_runtime.effects.effect import MOST_E
from nscc_runtime.effects.parts import Well
from nscc_runtime.effects.sensor import Sensor

LEAST_E = 1e-9
"""Smallest tolerance in electrons: smaller differences of float64 sums are rounding errors."""

DEFAULT = "0.15noise"
"""The default tolerance. An error of 0.15 times the noise increases the standard deviation by 1.1
%; frames of 4,000 pixels are needed to detect that."""

_TOLERANCE = re.compile(
    r"\s*((?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)\s*(e|lsb|%|noise)\s*"
)


@dataclass(frozen=True)
class Tolerance:
    """A tolerance as the user entered it (`text`), and in electrons before the ADC."""

    text: str
    electrons: float

    @property
    def name(self) -> str:
        """A text that identifies the tolerance independently of the scene: the electrons, or the
        text of the user if it is in other units."""
        return f"{self.electrons:g}e" if unit_of(self.text) == "e" else self.text

    def __str__(self) -> str:
        """Return the tolerance in electrons, with the text that the user wrote."""
        electrons, (value, unit) = f"{self.electrons:.4g} e", _parsed(self.text) or (1.0, "")
        if unit == "noise":
            return f"{self.text.removesuffix('noise')} of the frame's own noise = {electrons}"
        if unit == "%":
            signal_e = 100 * self.electrons / value
            return f"{electrons} ({self.text} of the mean signal, {signal_e:.4g} e)"
        return electrons if unit == "e" else f"{electrons} ({self.text})"


ToleranceInput = str | float | Tolerance
"""A tolerance as text, as a number of electrons, or already converted."""


def _any_e() -> float:
    """Return the signal and noise that relative tolerances refer to if there is no scene."""
    return 1e4


def tolerance_of(
    requested: ToleranceInput,
    sensor: Sensor,
    signal_e: Callable[[], float] = _any_e,
    noise_e: Callable[[], float] = _any_e,
) -> Tolerance:
    """Convert `5e`, `0.1lsb`, `1%` of the scene's signal, `0.1noise`, or a number of electrons.

    `signal_e`, `noise_e`: compute the mean signal and the noise of the scene in electrons. They are
    called only for a relative tolerance; by default they return a large number, so that only the
    tolerance itself can be wrong. Raises Rejected (NS0746, status 2) for any other text, for values
    outside LEAST_E to MOST_E electrons, and for a percentage of a scene without signal."""
    if isinstance(requested, Tolerance):
        return requested
    if isinstance(requested, str):
        text, shown = requested, f"'{requested[:40]}'"
    else:
        text, shown = f"{float(requested)!r}".removesuffix(".0") + "e", str(requested)
    parsed = _parsed(text)
    if parsed is None:
        raise _malformed(shown)
    (value, unit), text = parsed, "".join(text.lower().split())
    if unit in ("e", "lsb"):
        unit_e = 1.0 if unit == "e" else sensor.electrons_per_lsb
    else:
        unit_e = noise_e() if unit == "noise" else signal_e() / 100
    if unit == "%" and not unit_e > 0:
        raise rejected(
            "NS0746",
            f"{text[:40]} of this scene is 0: its mean signal is 0 electrons",
            notes=("a percentage refers to the mean exposure without effects",),
            helps=("use electrons, --tolerance 5e, or codes, --tolerance 0.1lsb",),
        )
    electrons = value * unit_e
    if not LEAST_E <= electrons <= MOST_E:  # also NaN
        raise _malformed(f"{shown}, {electrons:.3g} electrons")
    return Tolerance(text, electrons)


def unit_of(tolerance: ToleranceInput) -> str | None:
    """Return the unit of a tolerance given as text: "e", "lsb", "%" or "noise". None for text that
    is no tolerance, for numbers, and for a `Tolerance`."""
    parsed = _parsed(tolerance) if isinstance(tolerance, str) else None
    return parsed[1] if parsed else None


@lru_cache(64)
def check_tolerance(tolerance: ToleranceInput, sensor: Sensor) -> None:
    """Raise Rejected (NS0746) if the tolerance is invalid whatever the scene; `sensor` gives the
    electrons of a converter code. The check does not see the scene, so it accepts a percentage also
    for a scene without signal."""
    tolerance_of(tolerance, sensor)


def mean_signal_e(exposure_e: Floats, sensor: Sensor) -> float:
    """Return the mean absolute exposure in electrons, each clipped to the full well; NaN is
    ignored. `exposure_e`: exposures without effects, any shape. Returns 0 if all are NaN."""
    sizes = np.abs(exposure_e[~np.isnan(exposure_e)])
    most_e = everything().require_part(Well).full_e(sensor)
    return float(np.minimum(sizes, most_e).mean()) if sizes.size else 0.0


def _parsed(text: str) -> tuple[float, str] | None:
    """Return the number and the unit of a tolerance; None for text that is no tolerance, and for
    numbers that are 0 or too large."""
    match = _TOLERANCE.fullmatch(text.lower())
    return (float(match[1]), match[2]) if match and 0 < float(match[1]) < math.inf else None


def _malformed(shown: str) -> Rejected:
    """Return the error NS0746, for the caller to raise, for a tolerance that is not a number with a
    unit, or outside its limits. `shown`: its text in the message."""
    return rejected(
        "NS0746",
        f"a tolerance must be a number above 0 with its unit, not {shown}",
        notes=(
            "e: electrons before the ADC; lsb: codes of the ADC; %: of the scene's mean "
            "signal; noise: a fraction of the frame's own noise",
            f"it must be between {LEAST_E:g} and {MOST_E:g} electrons",
        ),
        helps=(f"write --tolerance 5e, 0.1lsb, 1% or {DEFAULT}, or leave it out",),
    )
