"""Estimate light from one coded frame without a decoder, from neighbouring pixels and their open
times.

    response = response_of(program, sensor, taken.plan.kept)
    (readout,) = readouts(program, taken, response)   # one per bucket
    light, known = light_estimate(readout)            # electrons per second (rows, cols)"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from nscc.arrays import Array, Bools, Bytes, Floats
from nscc.words.container import Container, tile_of
from nscc.words.legality import refuse_pictures
from nscc_runtime.frame_file import Frame
from nscc_runtime.looked_light import LIGHT, open_us_of
from nscc_runtime.response import Response

_LARGEST_TILE = 16
"""A tile of codes larger than this number of pixels per side counts as not repeating."""


@dataclass(frozen=True, eq=False)
class BucketReadout:
    """One bucket as it was read out; arrays are (rows, cols).

    `name`: that of the bucket. `frame` uint8: converter codes. `saturated` bool: True where light
    was lost. `light_e`: electrons that were collected while each pixel was open, estimated from its
    code. `most_e`: the same for the last code. `open_s`: open time in seconds, 0 where never open.
    `window`: numbers of rows and columns of a neighbourhood that contains pixels of every code, at
    most those of the array."""

    name: str
    frame: Bytes
    saturated: Bools
    light_e: Floats
    most_e: Floats
    open_s: Floats
    window: tuple[int, int]


def readouts(container: Container, frame: Frame, response: Response) -> list[BucketReadout]:
    """Return each bucket of a frame, in the container's order, with everything that merging needs.

    `frame`: a single frame, without repeats. `response`: that of the sensor with which it was
    exposed. If pixels looked, their own open times are known, and the window is one pixel. Raises
    Rejected for programs with images or planes, and ValueError for a container (a compiled program)
    without pixels."""
    refuse_pictures(
        container,
        "merging does not apply to a program with images or planes",
        "merging estimates light from neighbours with different open times; images and planes are "
        "results",
        "use the images and planes of the frame as they are, or expose a program without them",
    )
    if container.pixel_codes is None:
        raise ValueError("a program without pixel codes has no frame: add a `pixels` statement")
    most_e = response.electrons(np.full_like(frame.frame, container.target.top_code))
    if LIGHT in frame.told:
        # The open time of pixels that looked is known, so neighbours are not used.
        window = (1, 1)
        # -1 us stands for states in which no pixel can end: such a pixel counts as never open.
        open_s = np.maximum(open_us_of(container, frame.told), 0.0) * 1e-6
        light_e = np.nan_to_num(frame.told[LIGHT]) * open_s
    else:
        window = tile_of(container.table.shutter_of_code[container.pixel_codes])
        if max(window) > _LARGEST_TILE:
            rows, cols = container.pixel_codes.shape
            window = min(3, rows), min(3, cols)
        open_s = response.open_s
        light_e = response.electrons(frame.frame)
    return [
        BucketReadout(
            name, frame.frame[b], frame.saturated[b], light_e[b], most_e[b], open_s[b], window
        )
        for b, name in enumerate(container.buckets)
    ]


def light_estimate(readout: BucketReadout) -> tuple[Floats, Bools]:
    """Return light (rows, cols) in electrons per second from the unsaturated pixels around each
    pixel, and a mask of pixels with a value.

    The estimate is the sum of electrons divided by the sum of open times, which is optimal for pure
    shot noise. If all open neighbours are saturated, it is the largest light that one of them can
    represent. If pixels do not use neighbours (a window of one pixel), it is a lower bound from the
    pixel itself. Without an open pixel around, the mask is False and the light 0.

    Two neighbours that are open for 1 s and 3 s of a frame of four slots of 1 s collect 10 e and 40
    e, which together are 12.5 e/s. If the second is saturated, the first alone counts:

        >>> codes, most_e = np.zeros((1, 2), np.uint8), np.full((1, 2), 200.0)
        >>> light_e, open_s = np.array([[10.0, 40.0]]), np.array([[1.0, 3.0]])
        >>> for second in (False, True):
        ...     full = np.array([[False, second]])
        ...     readout = BucketReadout("", codes, full, light_e, most_e, open_s, window=(1, 2))
        ...     light_estimate(readout)[0].tolist()
        [[12.5, 12.5]]
        [[10.0, 10.0]]
    """
    opened = readout.open_s > 0
    usable = opened & ~readout.saturated
    time = _box(np.where(usable, readout.open_s, 0.0), readout)
    known = _box(usable, readout) > 0.5
    light_e = _box(np.where(usable, readout.light_e, 0.0), readout)
    # Noise may make a dark pixel negative.
    light = np.divide(np.maximum(light_e, 0.0), time, out=np.zeros(time.shape), where=known)
    if readout.window == (1, 1):
        np.divide(readout.light_e, readout.open_s, out=light, where=opened & ~known)
        known |= opened
        return light, known
    blind = ~known & (_box(opened, readout) > 0.5)
    if blind.any():
        most = np.divide(readout.most_e, readout.open_s, out=np.zeros(time.shape), where=opened)
        inside = sliding_window_view(most, readout.window).max(axis=(2, 3))
        light[blind] = _spread(inside, readout)[blind]
        known |= blind
    return light, known


def _box(values: Array, readout: BucketReadout) -> Floats:
    """Return for each pixel the sum of `values` (rows, cols) over the window around it; near the
    border, over the nearest complete window."""
    total = np.asarray(values, np.float64)
    for axis, width in enumerate(readout.window):
        pad = [(0, 0), (0, 0)]
        pad[axis] = (1, 0)
        sums = np.cumsum(np.pad(total, pad), axis=axis)
        length = total.shape[axis]
        ends = np.take(sums, range(width, length + 1), axis)
        total = ends - np.take(sums, range(length + 1 - width), axis)
    return _spread(total, readout)


def _spread(inside: Floats, readout: BucketReadout) -> Floats:
    """Return for each pixel, (rows, cols), the value of the window around it, from the values
    `inside` of all complete windows by their first row and column; pixels at the border use the
    nearest window."""
    for axis, width in enumerate(readout.window):
        first = np.arange(readout.frame.shape[axis]) - width // 2
        inside = np.take(inside, np.clip(first, 0, inside.shape[axis] - 1), axis)
    return inside
