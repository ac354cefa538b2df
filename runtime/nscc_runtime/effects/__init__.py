"""The effects of the sensor, one file each, with everything that the emulator needs to simulate
them.

Code outside of this package names no effect; it iterates over the registered effects. `effect`
defines a declaration, `parts` the components that the fast paths support.

Noise of many small errors (reads, resets, analog words) is drawn so that its sum is one keyed draw.
Let e_i be independent normal errors and c_i their coefficients in the exposures. Then sum c_i e_i
is L z with L L^T = sum c_i^2 sigma_i^2, and z is keyed by (seed, effect, frame, bucket). A plan
that adds only the sum has the same numbers as the reference, which distributes it. The c_i use the
sensor's analog gain and mean leakage even if these effects are off, so leaving one out changes no
draw."""

from __future__ import annotations

from nscc_runtime.effects.effect import (
    CannotHave,
    Effect,
    InLoop,
    Mark,
)
from nscc_runtime.effects.parameters import parameter
from nscc_runtime.effects.registry import effects_json, marks, optional, register, registered
from nscc_runtime.effects.selection import Selection, everything, named, selected

__all__ = [
    "CannotHave",
    "Effect",
    "InLoop",
    "Mark",
    "Selection",
    "effects_json",
    "everything",
    "marks",
    "named",
    "optional",
    "parameter",
    "register",
    "registered",
    "selected",
]
