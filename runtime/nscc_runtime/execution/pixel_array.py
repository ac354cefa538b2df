"""Pixels laid out as rows and columns: all pixels of a chip, or tiles of them side by side."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Device
from nscc_runtime.light import Light
from nscc_runtime.method_cache import Recent

Places = NDArray[np.int64]

_RECENT = 24
"""Arrays of pixels that are kept for some models; of large arrays fewer."""
_LARGE = 1 << 14


@dataclass(frozen=True, eq=False)
class PixelArray:
    """The lanes and the places of some pixels.

    Attributes
    ----------
    lanes : int32, shape (rows, cols)
        The lane of each pixel: which of the program's shutters it has.
    places : int64, shape (rows * cols,)
        Where each pixel lies on the chip, row * columns + column. Random numbers and fixed patterns
        are keyed by the place, so a tile draws what the whole array draws there.
    """

    lanes: NDArray[np.int32]
    places: Places

    @classmethod
    def of_chip(cls, lanes: NDArray[np.integer]) -> PixelArray:
        """All pixels of a chip with these lanes (rows, cols)."""
        lanes_32 = np.require(lanes, np.int32, ["C", "A"])
        return cls(lanes_32, np.arange(lanes_32.size, dtype=np.int64))

    @property
    def shape(self) -> tuple[int, int]:
        """(rows, cols)."""
        rows, cols = self.lanes.shape
        return rows, cols

    @cached_property
    def flat_lanes(self) -> NDArray[np.int32]:
        """The lane of every pixel, flat."""
        return self.lanes.reshape(-1)

    def at(self, places: Places) -> PixelArray:
        """The pixels at `places` (rows, cols) of this chip."""
        return PixelArray(
            np.ascontiguousarray(self.flat_lanes[places]), np.ascontiguousarray(places.reshape(-1))
        )

    def device(self, sensor: Sensor, device_seed: int) -> Device:
        """What is fixed on the chip at these pixels; the last one asked for is kept."""
        key = sensor, device_seed
        if key not in self._devices:
            self._devices.clear()
            self._devices[key] = Device(sensor=sensor, device_seed=device_seed, places=self.places)
        return self._devices[key]

    @cached_property
    def recent(self) -> Recent:
        """What was last computed of these pixels for some models."""
        return Recent(_RECENT if self.lanes.size <= _LARGE else _RECENT // 4)

    @cached_property
    def _devices(self) -> dict[tuple[Sensor, int], Device]:
        return {}


def tile_places(corners: Places, side: int, shape: tuple[int, int]) -> Places:
    """The places (side, tiles * side) of square tiles that lie side by side.

    `corners` (tiles, 2): row and column of the upper left pixel of each, on a chip of `shape`
    (rows, cols). Beyond its border lie the pixels of the border again: to exchange charge with
    oneself is to have no neighbour.
    """
    steps = np.arange(side)
    row = np.clip(corners[:, 0][None, :, None] + steps[:, None, None], 0, shape[0] - 1)
    col = np.clip(corners[:, 1][None, :, None] + steps[None, None, :], 0, shape[1] - 1)
    return np.ascontiguousarray((row * shape[1] + col).reshape(side, -1))


def light_at(light: Light, places: Places) -> Light:
    """The light that falls on the pixels at `places` (rows, cols), as a scene of its own."""
    flat = light.frames.reshape(len(light.frames), -1)
    frames = flat[:, places.reshape(-1)].reshape(len(flat), *places.shape)
    motion = None if light.motion is None else replace(light.motion, frames=frames)
    return replace(light, frames=frames, motion=motion)
