"""The picture of a frame: what was read out, and beside it the light that it tells of."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.pictures.images import Image, image_sheet
from nscc_runtime.scenes.shapes import Field

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_LARGEST_TILE = 16
"""Codes that repeat over more pixels than this a side are taken as not repeating."""


@dataclass(frozen=True, eq=False)
class Readout:
    """One bucket as it was read out.

    `frame` uint8 (rows, cols); `top` the code at which it is saturated; `open_s` float64 (rows,
    cols), how long each pixel was open; `window` (rows, cols), the neighbourhood that holds
    pixels of every code.
    """

    name: str
    frame: NDArray[np.uint8]
    top: int
    open_s: Field
    window: tuple[int, int]


def readouts(container: Container, frame: NDArray[np.uint8]) -> list[Readout]:
    """The buckets of a frame (buckets, rows, cols) of a container with pixels."""
    if container.pixel_codes is None:
        raise ValueError("a container without pixels has no frame")
    slot_s = np.array(container.slot_us) * 1e-6
    open_s = (container.table.shutters * slot_s).sum(axis=-1)
    shutter = container.table.shutter_of_code[container.pixel_codes]
    window = tile_of(shutter)
    if max(window) > _LARGEST_TILE:
        window = (3, 3)
    top = 2**container.target.adc_bits - 1
    return [
        Readout(name, frame[b], top, open_s[:, b][shutter], window)
        for b, name in enumerate(container.buckets)
    ]


def tile_of(codes: NDArray[Any]) -> tuple[int, int]:
    """The smallest tile (rows, cols) that repeats over the array; the array's size if none does."""
    return _period(codes), _period(codes.T)


def _period(codes: NDArray[Any]) -> int:
    """The smallest p for which row r equals row r + p everywhere."""
    rows = len(codes)
    return next((p for p in range(1, rows) if np.array_equal(codes[p:], codes[:-p])), rows)


def light_estimate(readout: Readout) -> tuple[Field, NDArray[np.bool_]]:
    """Codes a second (rows, cols) from the unsaturated pixels around each pixel, and where any is.

    Summed codes over summed open time: with shot noise alone, the best estimate that there is.
    Pixels whose open neighbours are all saturated get the largest value that the frame can tell.
    """
    opened = readout.open_s > 0
    good = opened & (readout.frame < readout.top)
    codes = np.where(good, readout.frame, 0).astype(np.float64)
    time = _box(np.where(good, readout.open_s, 0.0), readout.window)
    known = _box(good, readout.window) > 0.5
    light = np.divide(_box(codes, readout.window), time, out=np.zeros(time.shape), where=known)
    if opened.any():
        shortest = float(readout.open_s[opened].min())
        blind = ~known & (_box(opened, readout.window) > 0.5)
        light[blind] = max(readout.top / shortest, float(light.max()))
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


def tone_mapped(light: Field, usable: NDArray[np.bool_]) -> NDArray[np.uint8]:
    """Light as 8-bit grey on a logarithmic curve that puts its median at a middle grey."""
    white = float(np.percentile(light[usable], 99.8)) if usable.any() else 0.0
    if white <= 0:
        return np.zeros(light.shape, np.uint8)
    middle = min(float(np.median(light[usable])) / white, 1.0)
    low, high = 0.0, 30.0
    for _ in range(40):
        bend = (low + high) / 2
        grey = np.log1p(2.0**bend * middle) / np.log1p(2.0**bend)
        low, high = (bend, high) if grey < 0.45 else (low, bend)
    curve: Field = np.log1p(2.0**low * np.clip(light / white, 0.0, 1.0)) / np.log1p(2.0**low)
    grey_levels: NDArray[np.uint8] = np.rint(255.0 * curve).astype(np.uint8)
    return grey_levels


def frame_sheet(readouts: Sequence[Readout], title: str) -> Figure:
    """For every bucket the frame as read out, and the light that it tells of, tone mapped."""
    rows = []
    for readout in readouts:
        light, usable = light_estimate(readout)
        window = f"{readout.window[0]} x {readout.window[1]}"
        around = "each pixel" if window == "1 x 1" else f"unsaturated pixels in {window}"
        saturated = np.count_nonzero(readout.frame == readout.top) / readout.frame.size
        read = f"{readout.name}: as read out", f"8 bit, {saturated:.1%} saturated"
        told = f"{readout.name}: light a second", f"codes / open time of {around}, log scale"
        rows.append((Image(readout.frame, *read), Image(tone_mapped(light, usable), *told)))
    return image_sheet(rows, title)
