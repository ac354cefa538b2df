"""The arguments that the reference passes to an effect's functions: the scene, the slots of pixels,
and pixels while words run."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import Protocol

import numpy as np

from nscc.arrays import Floats, Ints
from nscc_runtime.caches import remembered
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.light import Light

LIGHT, WITHOUT_LIGHT = 0, 1
"""Numbers of the sources of charge."""

Places = Ints
OnDevice = Callable[[Sensor, int, Places], Floats]
"""A function of sensor, device seed and places that returns a chip's fixed pattern."""


@dataclass(frozen=True, eq=False)
class Scene:
    """The light of a frame and of the previous frame. `slot_s` (N,): slot lengths in seconds."""

    light: Light
    previous: Light
    slot_s: Floats


@dataclass(eq=False, kw_only=True)
class Device:
    """Some pixels of a chip. `device_seed`: seed of its fixed patterns. `places` int64 (pixels,):
    row * cols + col of each pixel."""

    sensor: Sensor
    device_seed: int
    places: Places

    @remembered
    def fixed(self, make: OnDevice) -> Floats:
        """Return the fixed pattern of the chip that `make` computes from sensor, device seed and
        places, (pixels,); cached. Callers do not change it."""
        return make(self.sensor, self.device_seed, self.places)


@lru_cache(2)
def whole_device(sensor: Sensor, device_seed: int, pixels: int) -> Device:
    """Return all `pixels` pixels of the chip with the seed `device_seed`, in the order of places.
    The last two results are cached with their fixed patterns."""
    return Device(sensor=sensor, device_seed=device_seed, places=np.arange(pixels))


@dataclass(eq=False, kw_only=True)
class Where(Device):
    """Some pixels of a chip in frame number `frame`, with noise from `seed`."""

    seed: int
    frame: int


class Word(Protocol):
    """A word during execution. `number`: its number among the analog words of a frame. `after_us`:
    its end in microseconds after its boundary. `adds`: whether it has two sources or more."""

    @property
    def number(self) -> int: ...
    @property
    def after_us(self) -> float: ...
    @property
    def adds(self) -> bool: ...


@dataclass(eq=False, kw_only=True)
class Slots(Where, ABC):
    """All slots, or intervals of slots, of complete rows of pixels, for effects on charge before it
    falls on PIX (the photodiode). Arrays are (N, rows, cols), in electrons; fixed patterns are
    (rows, cols)."""

    scene: Scene

    @abstractmethod
    def electrons(self, light: Light) -> Floats:
        """Return the electrons of `light` in every slot, (N, rows, cols)."""

    @abstractmethod
    def counted(self, stream: int, source: int, rates: Floats) -> Floats:
        """Return Poisson counts with the means `rates`, both (N, rows, cols). `stream`: random
        stream of the effect. `source`: LIGHT or WITHOUT_LIGHT; counts of different sources are
        independent."""


class Pixels(Where, ABC):
    """Pixels while their words run, for effects of words, registers and readout. Arrays are
    (pixels,), as are fixed patterns."""

    @abstractmethod
    def error(self, name: str, word: Word, destination: int = 0) -> Floats:
        """Return standard normal numbers (pixels,) for the effect called `name` at `word`. For an
        effect of what words write, they differ for each `destination`, its index in the word."""
