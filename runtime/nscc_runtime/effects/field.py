"""What an effect does to exposures, and what a planner knows of a scene to say so.

Arrays are (buckets, pixels of a sample), in electrons. Fixed effects are fields: the signed change
of each exposure when the effect joins all others, nothing saturated. Random ones are variances.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects.sensor import Sensor

Values = NDArray[np.float64]
Places = NDArray[np.int64]
OnDevice = Callable[[Sensor, int, Places], Values]
"""What is fixed on a chip: of a sensor, the device's seed and places row * cols + col."""


@dataclass(frozen=True, eq=False)
class Field:
    """`fixed`: the signed change; `variance` of the random part; None: nothing. `shift`: electrons
    by which it changes whole counts. `behind_well`: the part of `fixed` that does not shrink with
    what the full well takes away; None: the well takes all of the effect, its noise included.
    `noise`: by how much the effect makes the variance over frames larger; None: `variance`.
    """

    fixed: Values | None = None
    variance: Values | None = None
    shift: Values | None = None
    behind_well: Values | float | None = None
    noise: Values | None = None


class Sampled(Protocol):
    """A sample of a scene's pixels under a program, every effect on; (buckets, pixels) each.

    Light is that with motion inside slots. `light`: what of it reaches the exposures, each slot
    with its weight. `base`: that times `echo`, which is the light that comes again; `charge`: that
    and what falls without light. `alone`, `alike` and `still` are `base` without the neighbours'
    light, with all pixels responding alike, and without motion (None where the scene has none).
    `pattern`: the sum of the words' fixed errors. `dark_s`, `dark_2_s`: seconds, by weight and by
    squared weight; `dark`, `spilt` (pixels,): electrons a second that fall without light, and what
    neighbours add to them; `dark_e`: what of both reaches the exposures.
    """

    sensor: Sensor
    places: Places
    shape: tuple[int, int]
    echo: float

    @property
    def light(self) -> Values: ...
    @property
    def base(self) -> Values: ...
    @property
    def charge(self) -> Values: ...
    @property
    def alone(self) -> Values: ...
    @property
    def alike(self) -> Values: ...
    @property
    def still(self) -> Values | None: ...
    @property
    def pattern(self) -> Values: ...
    @property
    def dark_s(self) -> Values: ...
    @property
    def dark_2_s(self) -> Values: ...
    @property
    def dark(self) -> Values: ...
    @property
    def spilt(self) -> Values: ...
    @property
    def dark_e(self) -> Values: ...
    def on_device(self, make: OnDevice) -> Values:
        """What is fixed on the chip (pixels,)."""

    def without(self, name: str) -> Values:
        """`charge` as the words would weigh it without an effect."""

    def moved(self, name: str) -> Values:
        """The variance of the counts by what an effect, leakage or dead time, changes of their
        weights."""

    def by_words(self, name: str) -> Values:
        """What an effect that changes what words do changes in one frame, noise included: pixels
        run through their words with it and without."""

    def by_rate(self, pattern: bool = False) -> Values:
        """What the pixels' own rates of leakage add to `charge`, or to `pattern`."""

    def counted(self, moved: bool = False) -> Values:
        """The variance of the counts of light, or of what neighbours exchange of them, that by the
        square of the fraction."""

    def counted_alone(self) -> Values:
        """The variance of the counts of light if neighbours exchanged nothing."""

    def errors(self, at: str, sigma_e: float) -> Values:
        """The variance of many small errors (`nscc_runtime.effects.parts.Errors`)."""
