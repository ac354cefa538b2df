"""Tolerances: electrons, or codes of the ADC."""

from __future__ import annotations

import math
import re

from nscc.diagnostics.rejection import rejected
from nscc_runtime.effects.parameters import MOST_E
from nscc_runtime.effects.sensor import Sensor

LEAST_E = 1e-9
"""Electrons; the promise is checked with sums of float64 numbers, which tell no less apart."""

_TOLERANCE = re.compile(r"\s*((?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)\s*(e|lsb)\s*")


def tolerance_e(text: str | float, sensor: Sensor) -> float:
    """Electrons before the ADC: of `5e`, of `0.1lsb`, or of a number of electrons.

    Raises Rejected (NS0746, status 2) for anything else, and for electrons beyond LEAST_E..MOST_E.
    """
    value = math.nan if isinstance(text, str) else float(text)
    if isinstance(text, str) and (match := _TOLERANCE.fullmatch(text)):
        value = float(match[1]) * (1.0 if match[2] == "e" else sensor.electrons_per_lsb)
    if not LEAST_E <= value <= MOST_E:
        shown = f"'{text[:40]}'" if isinstance(text, str) else str(text)
        raise rejected(
            "NS0746",
            f"a tolerance is a number above 0 with its unit, not {shown}",
            notes=(
                "e: electrons before the ADC; lsb: codes of the ADC",
                f"it lies between {LEAST_E:g} and {MOST_E:g} electrons",
            ),
            helps=("write --tolerance 5e, or --tolerance 0.1lsb",),
        )
    return value
