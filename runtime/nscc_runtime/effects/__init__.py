"""The effects of the sensor, one file each, with everything that the emulator needs to simulate
them.

Code outside of this package names no effect; it iterates over the registered effects. `effect`
defines a declaration, `parts` the components that the fast paths support.

Errors of words (reads, resets, analog words) add up in an exposure with coefficients that follow
from the words: their sum has the covariance sum over words of c c^T sigma^2, c the coefficients in
the buckets. Simulators that do not run the words draw one normal number a bucket with it."""

from __future__ import annotations

from nscc_runtime.effects.effect import (
    CannotHave,
    Effect,
    InLoop,
    Mark,
    parameter,
)
from nscc_runtime.effects.registry import effects_json, marks, optional, register, registered
from nscc_runtime.effects.selection import Selection, everything, named, selected
from nscc_runtime.effects.sensor import Sensor

__all__ = [
    "CannotHave",
    "Effect",
    "InLoop",
    "Mark",
    "Selection",
    "Sensor",
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
