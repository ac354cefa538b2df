"""The views that the reference passes to an effect's functions: pixels while charge falls in slots,
and while words run."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.light import Light
from nscc_runtime.method_cache import remembered

Values = NDArray[np.float64]
Places = NDArray[np.int64]
OnDevice = Callable[[Sensor, int, Places], Values]
"""Returns a fixed pattern of a chip from a sensor, the device's seed and places row *
cols + col."""


@dataclass(frozen=True, eq=False)
class Scene:
    """The light of a frame and of the previous frame, and the slot lengths."""

    light: Light
    previous: Light
    slot_s: NDArray[np.float64]


@dataclass(eq=False, kw_only=True)
class Device:
    """Some pixels of a chip: `places` int64 (pixels,) are row * cols + col."""

    sensor: Sensor
    device_seed: int
    places: Places

    @remembered
    def fixed(self, make: OnDevice) -> Values:
        """Return a fixed pattern of the chip (pixels,), computed once."""
        return make(self.sensor, self.device_seed, self.places)


@dataclass(eq=False, kw_only=True)
class Where(Device):
    """Some pixels of a frame."""

    seed: int
    frame: int


class Word(Protocol):
    """A word during execution; the analog words of a frame are numbered."""

    @property
    def number(self) -> int: ...
    @property
    def after_us(self) -> float: ...


@dataclass(eq=False, kw_only=True)
class Slots(Where, ABC):
    """Complete rows of pixels; arrays are (N, rows, cols), those of `fixed` (rows, cols)."""

    scene: Scene

    @abstractmethod
    def electrons(self, light: Light) -> Values:
        """Return the light of every slot."""

    @abstractmethod
    def counted(self, stream: int, source: int, rates: Values) -> Values:
        """Return counts of Poisson processes of these rates; `nscc_runtime.effects.counts` lists
        sources."""


class Pixels(Where, ABC):
    """Pixels during their words; arrays are (pixels,)."""

    @abstractmethod
    def error(self, name: str, word: Word, destination: int = 0) -> Values:
        """Return the unit normal error of an effect's `Errors` at a word."""
