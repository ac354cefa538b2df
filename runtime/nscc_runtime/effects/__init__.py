"""The effects of the sensor: models, parameters, predictions and what the reference applies.

Noise that reaches an exposure in many small parts (reads, resets, analog words) is drawn so that
its sum is one keyed draw: with e_i independent normal numbers and c_i their coefficients in the
exposures, sum c_i e_i is L z, L L^T = sum c_i^2 sigma_i^2, z keyed by (seed, effect, frame,
bucket). A plan that adds the sum alone has the same numbers as the reference, which spreads it.
The c_i are those of the sensor's analog gain and mean leakage, whether these effects are on or not:
leaving one out changes no draw.
"""

from __future__ import annotations

from nscc_runtime.effects.effect import Contribution, Effect, Statistics
from nscc_runtime.effects.registry import (
    BY_NAME,
    EFFECTS,
    OPTIONAL,
    Selection,
    effects_json,
    selected,
)

__all__ = [
    "BY_NAME",
    "EFFECTS",
    "OPTIONAL",
    "Contribution",
    "Effect",
    "Selection",
    "Statistics",
    "effects_json",
    "selected",
]
