"""The arguments that the reference passes to an effect's functions: the scene, the slots of pixels,
and pixels while words run."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from typing import Protocol

import numpy as np

from nscc.arrays import Floats, Ints
from nscc_runtime.caches import remembered
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.light import BRIGHTEST_E, Light
from nscc_runtime.noise import RATE_CAP, key, poisson

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
class Slots(Where):
    """Slots, or intervals of slots, of complete rows of pixels, for effects on charge before it
    falls on PIX (the photodiode). Arrays are (intervals, rows, cols), in electrons.

    `rows`: these rows. `starts`: the first slot of each interval. An interval ends where the next
    begins."""

    scene: Scene
    rows: slice
    starts: Sequence[int]

    def fixed(self, make: OnDevice) -> Floats:
        """Return the fixed pattern of the chip that `make` computes, for these rows, (rows,
        cols)."""
        return super().fixed(make).reshape(-1, self.scene.light.shape[1])

    @remembered
    def electrons(self, light: Light) -> Floats:
        """Return the electrons that `light` gives in each interval of slots, (intervals, rows,
        cols); remembered for each light. Callers do not change the result.

        A slot of light that is NaN counts as 0, so that neighbours of its pixel stay valid."""
        shape = len(self.starts), len(self.places) // light.shape[1], light.shape[1]
        out = np.zeros(shape)
        for interval, (start, stop) in enumerate(pairwise([*self.starts, light.slots])):
            for n in range(start, stop):
                slot_e = light.slot(n, self.rows)
                out[interval] += np.where(np.isnan(slot_e), 0.0, slot_e)
        return out

    def counted(self, stream: int, source: int, rates: Floats) -> Floats:
        """Return Poisson counts with the means `rates`, both float64 (intervals, rows, cols).

        Rates below 0 count as 0. For rates above `RATE_CAP` the count is the rate, at most
        `BRIGHTEST_E`, and for NaN 0. `stream` (of the effect) and `source` (LIGHT or WITHOUT_LIGHT)
        select the random numbers."""
        places, counted = self.places.reshape(rates.shape[1:]), np.empty(rates.shape)
        for n, slot_rates in enumerate(rates):
            of_slot = key(self.seed, stream, source, self.frame, n)
            drawn, _ = poisson(of_slot, places, slot_rates)
            counted[n] = np.where(slot_rates > RATE_CAP, slot_rates.clip(max=BRIGHTEST_E), drawn)
        return counted


class Pixels(Where, ABC):
    """Pixels while their words run, for effects of words, registers and readout. Arrays are
    (pixels,), as are fixed patterns."""

    @abstractmethod
    def error(self, name: str, word: Word, destination: int = 0) -> Floats:
        """Return standard normal numbers (pixels,) for the effect called `name` at `word`. For an
        effect of what words write, they differ for each `destination`, its index in the word."""
