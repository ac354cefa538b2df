"""Tolerances in electrons, in converter codes, or as a fraction of the scene's signal or noise."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from functools import lru_cache
from typing import Protocol

import numpy as np

from nscc.arrays import Floats
from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc_runtime.effects import everything
from nscc_runtime.effects.effect import MOST_E
from nscc_runtime.effects.parts import Codes, Well
from nscc_runtime.effects.sensor import Sensor

LEAST_E = 1e-9
"""Smallest tolerance in electrons: smaller differences of float64 sums are rounding errors."""

DEFAULT = "0.15noise"
"""The default tolerance. An error of 0.15 times the noise increases the standard deviation by 1.1
%; frames of 4,000 pixels are needed to detect that."""

_ANY_E = 1e4
"""The signal and noise that relative tolerances refer to if there is no scene."""

_TOLERANCE = re.compile(
    r"\s*((?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)\s*(e|lsb|%|noise)\s*"
)


@dataclass(frozen=True)
class Tolerance:
    """A tolerance as the user entered it (`text`), and in electrons before the ADC.

    `signal_e`, `noise_e`: the mean signal or the noise of the scene that a relative tolerance
    refers to, in electrons; both are None for an absolute tolerance."""

    text: str
    electrons: float
    signal_e: float | None = None
    noise_e: float | None = None

    @property
    def in_electrons(self) -> bool:
        """Whether the tolerance was entered in electrons."""
        return unit_of(self.text) == "e"

    @property
    def name(self) -> str:
        """A text that identifies the tolerance independently of the scene: the electrons, or the
        text of the user if it is in other units."""
        return f"{self.electrons:g}e" if self.in_electrons else self.text

    def __str__(self) -> str:
        """Return the tolerance in electrons, with the text that the user wrote."""
        electrons = f"{self.electrons:.4g} e"
        if self.noise_e is not None:
            return f"{self.text.removesuffix('noise')} of the frame's own noise = {electrons}"
        if self.signal_e is not None:
            return f"{electrons} ({self.text} of the mean signal, {self.signal_e:.4g} e)"
        return electrons if self.in_electrons else f"{electrons} ({self.text})"


ToleranceInput = str | float | Tolerance
"""A tolerance as text, as a number of electrons, or already converted."""


class ToleranceScene(Protocol):
    """A scene that relative tolerances refer to, with its mean signal and noise in electrons."""

    def signal_e(self) -> float: ...

    def noise_e(self) -> float: ...


def tolerance_of(
    requested: ToleranceInput, sensor: Sensor, scene: ToleranceScene | None
) -> Tolerance:
    """Convert `5e`, `0.1lsb`, `1%` of the scene's signal, `0.1noise`, or a number of electrons.

    The signal or noise of the scene is computed only for a relative tolerance; without a `scene`
    it is a large number, so that only the tolerance itself can be wrong. Raises Rejected
    (NS0746, status 2) for any other text, for values outside LEAST_E to MOST_E electrons, and for a
    percentage of a scene without signal."""
    if isinstance(requested, Tolerance):
        return requested
    if not isinstance(requested, str):
        text = f"{float(requested)!r}".removesuffix(".0") + "e"
        return _within(Tolerance(text, float(requested)), str(requested))
    match = _TOLERANCE.fullmatch(requested.lower())
    if match is None:
        raise _malformed(f"'{requested[:40]}'")
    # Electrons and codes are absolute; fractions of the noise or the signal need the scene.
    value, unit = float(match[1]), match[2]
    text = f"{match[1]}{unit}"
    if unit in ("e", "lsb"):
        electrons = value * (1.0 if unit == "e" else sensor.electrons_per_lsb)
        return _within(Tolerance(text, electrons), f"'{requested[:40]}'")
    if not 0 < value < math.inf:
        raise _malformed(f"'{requested[:40]}'")
    if unit == "noise":
        noise = scene.noise_e() if scene else _ANY_E
        tolerance = Tolerance(text, value * noise, noise_e=noise)
        return _within(tolerance, f"{text[:40]}, a frame's own noise of {noise:.3g} electrons")
    signal = scene.signal_e() if scene else _ANY_E
    if not signal > 0:
        raise rejected(
            "NS0746",
            f"{text[:40]} of this scene is 0: its mean signal is 0 electrons",
            notes=("a percentage refers to the mean exposure without effects",),
            helps=("use electrons, --tolerance 5e, or codes, --tolerance 0.1lsb",),
        )
    tolerance = Tolerance(text, value / 100 * signal, signal_e=signal)
    return _within(tolerance, f"{text[:40]} of a mean signal of {signal:.3g} electrons")


def unit_of(tolerance: ToleranceInput) -> str | None:
    """Return the unit of a tolerance given as text: "e", "lsb", "%" or "noise". None for text that
    is no tolerance, for numbers, and for a `Tolerance`."""
    match = _TOLERANCE.fullmatch(tolerance.lower()) if isinstance(tolerance, str) else None
    return match[2] if match else None


@lru_cache(64)
def check_tolerance(tolerance: ToleranceInput, sensor: Sensor) -> None:
    """Raise Rejected (NS0746) if the tolerance is invalid whatever the scene; `sensor` gives the
    electrons of a converter code. The check does not see the scene, so it accepts a percentage also
    for a scene without signal."""
    tolerance_of(tolerance, sensor, None)


def mean_signal_e(exposure_e: Floats, sensor: Sensor) -> float:
    """Return the mean absolute exposure in electrons, each clipped to the full well; NaN is
    ignored. `exposure_e`: exposures without effects, any shape. Returns 0 if all are NaN."""
    sizes = np.abs(exposure_e[~np.isnan(exposure_e)])
    most_e = everything().require_part(Well).full_e(sensor)
    return float(np.minimum(sizes, most_e).mean()) if sizes.size else 0.0


def with_readout_e(noise_e: float, sensor: Sensor) -> float:
    """Return the standard deviation `noise_e` of exposures combined with those of the converter's
    noise and of rounding, all in electrons. The fixed pattern of the readout does not vary over
    frames, so it is left out."""
    all_effects = everything()
    code_e = all_effects.require_part(Codes).electrons(sensor)
    noise_lsb = all_effects.converter_lsb(sensor, fixed=False)
    return math.hypot(noise_e, noise_lsb * code_e, code_e / math.sqrt(12.0))


def _within(tolerance: Tolerance, shown: str) -> Tolerance:
    """Return `tolerance` if it lies within LEAST_E to MOST_E electrons. Raises Rejected (NS0746)
    otherwise, also for NaN. `shown`: the text of it in the message."""
    if not LEAST_E <= tolerance.electrons <= MOST_E:
        raise _malformed(shown)
    return tolerance


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
