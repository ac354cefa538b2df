"""What becomes of the errors of words where an effect is off for good.

A plan by sums that leaves leakage out by choice still takes the words' errors as with it. Where all
pixels run through their words without an effect, or where the user has forced it off, errors reach
the exposures with other weights: the more, the longer they have leaked.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import everything
from nscc_runtime.effects.parts import Errors, Leak, WordGain
from nscc_runtime.planner.sampled import SampledScene

Values = NDArray[np.float64]


def without(name: str, errors: str) -> str:
    """What an account calls the errors of one effect that lack another."""
    return f"{errors} without {name}"


def off_for_good(off: frozenset[str], dropped: frozenset[str]) -> frozenset[str]:
    """The names of all errors that are left and that lack one of the effects in `off`."""
    every = everything()
    weighing = (every.names(Leak) | every.names(WordGain)) & off
    return frozenset(
        without(name, errors) for name in weighing for errors in every.names(Errors) - dropped
    )


@dataclass(frozen=True, eq=False)
class Reweighed:
    """Of a sample, (buckets, pixels) each, by `without`: what `fixed` errors change by, the
    `variance` of what random ones change by, and by how much their own is larger (`noise`)."""

    fixed: dict[str, Values]
    variance: dict[str, Values]
    noise: dict[str, Values]

    @classmethod
    def of(cls, scene: SampledScene) -> Reweighed:
        """With every effect that errors are weighed by."""
        every, found = everything(), cls({}, {}, {})
        (gain,) = every.names(WordGain)
        for name in sorted(every.names(Leak) | every.names(WordGain)):
            if name != gain:
                found.fixed[without(name, gain)] = scene.pattern_without(name)
            for effect, part in every.errors():
                parts = scene.reweighed(name, part.at, part.sigma_e(scene.sensor))
                key = without(name, effect.name)
                found.variance[key], found.noise[key] = parts
        return found
