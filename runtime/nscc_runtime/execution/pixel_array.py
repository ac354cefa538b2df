"""Pixels laid out as rows and columns: all pixels of a chip, or tiles of pixels side by side."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.caches import Recent
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Device
from nscc_runtime.light import Light

Places = NDArray[np.int64]

_RECENT = 24
"""Number of cached results per array of pixels; large arrays cache a quarter."""
_LARGE = 1 << 14


@dataclass(frozen=True, eq=False)
class PixelArray:
    """The lanes and the places of some pixels.

    Attributes
    ----------
    lanes : int32, shape (rows, cols)
        The lane of each pixel: the number of its code, which determines its shutter.
    places : int64, shape (rows * cols,)
        The place of each pixel on the chip, row * columns + column. Random numbers and fixed
        patterns are keyed by place, so a tile has the same random numbers as the whole array.
    """

    lanes: NDArray[np.int32]
    places: Places

    @classmethod
    def of_chip(cls, lanes: NDArray[np.integer]) -> PixelArray:
        """Return all pixels of a chip, given their lanes (rows, cols)."""
        lanes_32 = np.require(lanes, np.int32, ["C", "A"])
        return cls(lanes_32, np.arange(lanes_32.size, dtype=np.int64))

    @property
    def shape(self) -> tuple[int, int]:
        rows, cols = self.lanes.shape
        return rows, cols

    @cached_property
    def flat_lanes(self) -> NDArray[np.int32]:
        """The lane of each pixel, shape (pixels,)."""
        return self.lanes.reshape(-1)

    def at(self, places: Places) -> PixelArray:
        """Return the pixels at `places` (rows, cols) of this chip."""
        return PixelArray(
            np.ascontiguousarray(self.flat_lanes[places]), np.ascontiguousarray(places.reshape(-1))
        )

    def device(self, sensor: Sensor, device_seed: int) -> Device:
        """Return the fixed patterns of these pixels on a chip; the last result is cached."""
        return self._devices.of(
            (sensor, device_seed),
            lambda: Device(sensor=sensor, device_seed=device_seed, places=self.places),
        )

    @cached_property
    def recent(self) -> Recent:
        """Cache of results for some weight models."""
        return Recent(_RECENT if self.lanes.size <= _LARGE else _RECENT // 4)

    @cached_property
    def _devices(self) -> Recent:
        return Recent(1)


def tile_places(corners: Places, side: int, shape: tuple[int, int]) -> Places:
    """Return the places (side, tiles * side) of square tiles that lie side by side.

    `corners` (tiles, 2): row and column of the upper left pixel of each tile, on a chip of `shape`
    (rows, cols). Outside the chip, the border pixel is repeated: exchanging charge with itself has
    no effect."""
    steps = np.arange(side)
    row = np.clip(corners[:, 0][None, :, None] + steps[:, None, None], 0, shape[0] - 1)
    col = np.clip(corners[:, 1][None, :, None] + steps[None, None, :], 0, shape[1] - 1)
    return np.ascontiguousarray((row * shape[1] + col).reshape(side, -1))


def light_at(light: Light, places: Places) -> Light:
    """Return the light on the pixels at `places` (rows, cols) as a separate scene."""
    flat = light.frames.reshape(len(light.frames), -1)
    frames = flat[:, places.reshape(-1)].reshape(len(flat), *places.shape)
    motion = None if light.motion is None else replace(light.motion, frames=frames)
    return replace(light, frames=frames, motion=motion)
