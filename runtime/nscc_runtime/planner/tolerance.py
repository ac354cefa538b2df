"""Tolerances: electrons, or codes of the ADC."""

from __future__ import annotations

import math
import re

from nscc.diagnostics.rejection import rejected
from nscc_runtime.effects.sensor import Sensor

_TOLERANCE = re.compile(r"\s*((?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)\s*(e|lsb)\s*")


def tolerance_e(text: str | float, sensor: Sensor) -> float:
    """Electrons before the ADC: of `5e`, of `0.1lsb`, or of a number of electrons.

    Raises Rejected (NS0746, status 2) for anything else, and for what is not above 0 and finite.
    """
    value = math.nan if isinstance(text, str) else float(text)
    if isinstance(text, str) and (match := _TOLERANCE.fullmatch(text)):
        value = float(match[1]) * (1.0 if match[2] == "e" else sensor.electrons_per_lsb)
    if not (0 < value < math.inf):
        shown = f"'{text[:40]}'" if isinstance(text, str) else str(text)
        raise rejected(
            "NS0746",
            f"a tolerance is a number above 0 with its unit, not {shown}",
            notes=("e: electrons before the ADC; lsb: codes of the ADC",),
            helps=("write --tolerance 5e, or --tolerance 0.1lsb",),
        )
    return value
