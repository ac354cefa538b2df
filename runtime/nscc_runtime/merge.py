"""Light from one coded frame without a decoder: what neighbours saw, each for its own time.

response = response_of(program, sensor, taken.plan.kept)
(readout,) = readouts(program, taken, response)   # a bucket each
light, known = light_estimate(readout)            # electrons a second (rows, cols)
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.frame_file import Frame
from nscc_runtime.looked_light import LIGHT, open_us_of
from nscc_runtime.response import Response

Field = NDArray[np.float64]

_LARGEST_TILE = 16
"""Codes that repeat over more pixels than this a side are taken as not repeating."""


@dataclass(frozen=True, eq=False)
class Readout:
    """One bucket as it was read out; arrays are (rows, cols).

    `frame` uint8; `saturated` bool; `light_e`, the electrons that fell while each pixel was open,
    as far as its code tells, and `most_e` those of the last code; `open_s`, how long it was;
    `window` (rows, cols), the neighbourhood that holds pixels of every code.
    """

    name: str
    frame: NDArray[np.uint8]
    saturated: NDArray[np.bool_]
    light_e: Field
    most_e: Field
    open_s: Field
    window: tuple[int, int]


def readouts(container: Container, frame: Frame, response: Response) -> list[Readout]:
    """The buckets of one frame of a container with pixels."""
    if container.pixel_codes is None:
        raise ValueError("a container without pixels has no frame")
    if container.machine is not None:
        return _looked(container, frame, response)
    window = tile_of(container.table.shutter_of_code[container.pixel_codes])
    if max(window) > _LARGEST_TILE:
        window = (3, 3)
    light_e = response.electrons(frame.frame)
    most_e = response.electrons(np.full_like(frame.frame, 2**container.target.adc_bits - 1))
    return [
        Readout(
            name, frame.frame[b], frame.saturated[b], light_e[b], most_e[b], response.open_s[b],
            window,
        )
        for b, name in enumerate(container.buckets)
    ]  # fmt: skip


def _looked(container: Container, frame: Frame, response: Response) -> list[Readout]:
    """The same where pixels looked: each knows how long it was open, and asks no neighbour."""
    open_s = np.maximum(open_us_of(container, frame.told), 0.0) * 1e-6
    light_e = np.nan_to_num(frame.told[LIGHT]) * open_s
    most_e = response.electrons(np.full_like(frame.frame, 2**container.target.adc_bits - 1))
    return [
        Readout(
            name, frame.frame[b], frame.saturated[b], light_e[b], most_e[b], open_s[b], (1, 1)
        )
        for b, name in enumerate(container.buckets)
    ]  # fmt: skip


def tile_of(codes: NDArray[Any]) -> tuple[int, int]:
    """The smallest tile (rows, cols) that repeats over the array; the array's size if none does."""
    return _period(codes), _period(codes.T)


def _period(codes: NDArray[Any]) -> int:
    """The smallest p for which row r equals row r + p everywhere."""
    rows = len(codes)
    return next((p for p in range(1, rows) if np.array_equal(codes[p:], codes[:-p])), rows)


def light_estimate(readout: Readout) -> tuple[Field, NDArray[np.bool_]]:
    """Electrons a second (rows, cols) from the unsaturated pixels around each pixel, and where any
    is.

    Summed electrons over summed open time: with shot noise alone, the best estimate that there is.
    Pixels whose open neighbours are all saturated get the largest value that the frame can tell;
    where no pixel asks its neighbours, the least that it can have seen itself.
    """
    opened = readout.open_s > 0
    good = opened & ~readout.saturated
    time = _box(np.where(good, readout.open_s, 0.0), readout.window)
    known = _box(good, readout.window) > 0.5
    light_e = _box(np.where(good, readout.light_e, 0.0), readout.window)
    # Noise may take a dark pixel below nothing.
    light = np.divide(np.maximum(light_e, 0.0), time, out=np.zeros(time.shape), where=known)
    if readout.window == (1, 1):
        np.divide(readout.light_e, readout.open_s, out=light, where=opened & ~known)
        known |= opened
    elif opened.any():
        brightest = (readout.most_e[opened] / readout.open_s[opened]).max()
        blind = ~known & (_box(opened, readout.window) > 0.5)
        light[blind] = max(float(brightest), float(light.max()))
        known |= blind
    return light, known


def _box(values: NDArray[Any], window: tuple[int, int]) -> Field:
    """Sums over the window around every pixel; the picture is continued by its mirror image."""
    total = np.asarray(values, np.float64)
    for axis, width in enumerate(window):
        before = width // 2
        pad = [(0, 0), (0, 0)]
        pad[axis] = (before + 1, width - 1 - before)
        sums = np.cumsum(np.pad(total, pad, mode="symmetric"), axis=axis)
        # The pad's first row only serves the difference of the running sums.
        length = total.shape[axis]
        ends = np.take(sums, range(width, width + length), axis)
        total = ends - np.take(sums, range(length), axis)
    return total
