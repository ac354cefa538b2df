"""The scene `builtin:motion`: a ball, a wheel, a train and a spark cross the picture within one
frame."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import partial
from math import ceil

import numpy as np

from nscc.arrays import Floats, Floats32
from nscc_runtime.light import DrawnFrames, Light
from nscc_runtime.scenes import timing
from nscc_runtime.scenes.exposure import ExposureLevel, scale
from nscc_runtime.scenes.shapes import fractal, hashed, turn

Picture = Floats32
Point = tuple[float, float]

_FEWEST, _MOST = 64, 256
"""Numbers of pictures of the clip: fewer would jump, more would take long to draw."""
_MOST_BYTES = 1 << 28
"""Largest clip that is drawn once and held; a larger one is drawn whenever it is read."""


def motion(
    slot_us: Sequence[float],
    rows: int,
    cols: int,
    exposure: ExposureLevel,
    name: str,
    share: float = 1.0,
) -> Light:
    """Return the light of the clip in slots of `slot_us` microseconds on `rows` x `cols` pixels.
    The clip lasts as long as the frame.

    `exposure` sets its electrons, and `name` is the scene in messages. `share` (0 to 1): the
    fraction of the motion that is shown, around its middle, correspondingly slower. The clip has 64
    to 256 pictures: a multiple of the number of slots if that is at most 256, so that equal slots
    contain whole pictures. Each picture is constant for its time."""
    slots = len(slot_us)
    count = slots * ceil(_FEWEST / slots) if slots <= _MOST else _MOST
    length_us = timing.slot_edges_us(slot_us)[-1]
    overlap = timing.overlaps(slot_us, Fraction(count * 1_000_000) / length_us)
    return timing.spread(
        frames(count, rows, cols, share), overlap, lambda open_sum: scale(open_sum, exposure, name)
    )


def frames(count: int, rows: int, cols: int, share: float = 1.0) -> Floats32 | DrawnFrames:
    """Return the middle `share` (0 to 1) of the clip: relative luminance (count, rows, cols) up to
    8. A clip of more than `_MOST_BYTES` is drawn when it is read.

    The functions below draw its parts. They use coordinates from the centre of the picture, x to
    the right and y downwards, in units of its shorter side. Sizes, speeds and luminances were
    chosen by eye."""
    x, y, _, _ = _coordinates(rows, cols)
    wall = _wall(x, y)
    drawn = DrawnFrames((count, rows, cols), partial(_draw, wall, count, share))
    return drawn if wall.nbytes * count > _MOST_BYTES else drawn[:]


def _coordinates(rows: int, cols: int) -> tuple[Floats, Floats, Point, float]:
    """Return the coordinates of columns and of rows from the centre, half the width and half the
    height of a picture, and the size of a pixel, all in units of its shorter side."""
    unit = float(min(rows, cols))
    x = (np.arange(cols, dtype=np.float64) + 0.5 - cols / 2) / unit
    y = (np.arange(rows, dtype=np.float64) + 0.5 - rows / 2) / unit
    return x, y, (cols / 2 / unit, rows / 2 / unit), 1.0 / unit


def _draw(wall: Picture, count: int, share: float, numbers: range, rows: slice) -> Floats32:
    """Draw some rows of the pictures with these numbers, (len(numbers), rows, cols), of the clip of
    `count` pictures that shows the middle `share` of the motion before `wall` (rows, cols)."""
    x, all_y, half, pixel = _coordinates(*wall.shape)
    y = all_y[rows]
    clip = np.empty((len(numbers), len(y), len(x)), np.float32)
    clip[:] = wall[rows]
    draw_wheel = _wheel(x, y, pixel)
    for k, picture in zip(numbers, clip, strict=True):
        phase = (1.0 - share) / 2 + share * ((k + 0.5) / count)
        _train(picture, x, y, phase, half, pixel)
        draw_wheel(picture, phase)
        _ball(picture, x, y, phase, half, pixel)
        _spark(picture, x, y, phase, half)
    return clip


def _wall(x: Floats, y: Floats) -> Picture:
    """Return the luminance of a brick wall lit from one side, (rows, cols), float32. `x`, `y`:
    coordinates of columns and rows from the centre. A unit of them holds 16 courses of bricks and 7
    bricks of a course."""
    course = np.floor(y * 16.0)
    along = x[None, :] * 7.0 + 0.5 * (course % 2)[:, None]
    brick = np.floor(along)
    joint = np.minimum(along - brick, 1.0 - (along - brick)) * (16.0 / 7.0)
    bed = np.minimum(y * 16.0 - course, 1.0 - (y * 16.0 - course))[:, None]
    mortar = np.clip((np.minimum(joint, bed) - 0.04) * 12.0, 0.0, 1.0)
    tone = hashed(brick.astype(np.int64), course.astype(np.int64)[:, None], seed=5)
    grain = fractal(x * 24.0, y * 24.0, seed=11, octaves=3)
    light = 0.24 - 0.12 * x[None, :] - 0.06 * y[:, None]
    colour = (0.45 + 0.55 * mortar * (0.5 + 0.5 * tone)) * (0.7 + 0.6 * grain)
    return (np.maximum(light, 0.03) * colour).astype(np.float32)


def _span(axis: Floats, low: float, high: float) -> slice:
    """Return the slice of the ascending pixel centres `axis` that lie between `low` and `high`,
    both included; empty if there are none."""
    return slice(int(np.searchsorted(axis, low)), int(np.searchsorted(axis, high, side="right")))


def _train(picture: Picture, x: Floats, y: Floats, phase: float, half: Point, pixel: float) -> None:
    """Draw coaches with lit windows, which run along the lower edge from left to right, into
    `picture` (rows, cols), in place.

    `x` and `y` are the coordinates of columns and rows from the centre. `phase` is the time in the
    clip, 0..1. `half` is half the width and half the height of the picture, and `pixel` the size of
    a pixel, in the same unit."""
    rows = _span(y, half[1] - 0.22, half[1] - 0.05)
    if rows.start >= rows.stop:
        return
    u = (x - (phase * 1.5 - 0.75) * (2 * half[0] + 0.6)) * 9.0
    v = ((y[rows] - (half[1] - 0.22)) / 0.17)[:, None]
    on = np.clip(4.5 - np.abs(u) + 0.5, 0.0, 1.0)
    cell = u - np.floor(u)
    edge = 9.0 * pixel
    pane = np.clip((np.minimum(cell - 0.2, 0.8 - cell)) / edge + 0.5, 0.0, 1.0)
    window = pane * np.clip((0.17 - np.abs(v - 0.38)) * 12.0, 0.0, 1.0)
    body = 0.16 + 0.5 * np.clip(0.06 - np.abs(v - 0.72), 0.0, 0.05) * 20.0
    lamp = 5.0 / (1.0 + ((u - 4.3) ** 2 + (v - 0.72) ** 2 * 6.0) * 60.0)
    picture[rows] += ((body + (1.9 - body) * window + lamp) - picture[rows]) * on


def _wheel(x: Floats, y: Floats, pixel: float) -> Callable[[Picture, float], None]:
    """Return a function that draws a wheel of five spokes, turned by `phase` (0..1) x 1.5 turns,
    into `picture` (rows, cols), in place. Its static parts are computed once.

    `x` and `y` are the coordinates of columns and rows from the centre, `pixel` is the size of a
    pixel."""
    centre, radius = (-0.2, -0.05), 0.21
    rows = _span(y, centre[1] - radius - pixel, centre[1] + radius + pixel)
    cols = _span(x, centre[0] - radius - pixel, centre[0] + radius + pixel)
    dx = (x[cols] - centre[0]).astype(np.float32)[None, :]
    dy = (y[rows] - centre[1]).astype(np.float32)[:, None]
    r = np.sqrt(dx * dx + dy * dy)
    still = np.maximum(np.minimum(radius - r, r - 0.84 * radius), 0.2 * radius - r)
    reach = 0.9 * radius - r

    def draw(picture: Picture, phase: float) -> None:
        """Draw the wheel at the time `phase` of the clip."""
        shape = still
        if not shape.size:
            return
        for spoke in range(5):
            c, s = turn(phase * 1.5 + spoke / 5)
            forward = dx * c + dy * s
            aside = np.abs(dy * c - dx * s)
            arm = np.minimum(0.014 + 0.05 * forward - aside, forward)
            shape = np.maximum(shape, np.minimum(arm, reach))
        cover = np.clip(shape / pixel + 0.5, 0.0, 1.0)
        c, s = turn(phase * 1.5)
        glint = 0.55 + (dx * c + dy * s) * (0.35 / radius)
        region = picture[rows, cols]
        region += (glint - region) * cover

    return draw


def _ball(picture: Picture, x: Floats, y: Floats, phase: float, half: Point, pixel: float) -> None:
    """Draw a ball that bounces three times from right to left into `picture` (rows, cols), in
    place.

    `x` and `y` are the coordinates of columns and rows from the centre. `phase` is the time in the
    clip, 0..1. `half` is half the width and half the height of the picture, and `pixel` the size of
    a pixel, in the same unit."""
    radius = 0.075
    bounce = (phase * 3.0) % 1.0
    cx = half[0] + 0.05 - phase * (2 * half[0] + 0.1)
    cy = half[1] - 0.3 - 2.2 * bounce * (1.0 - bounce) * min(half[1], 1.0)
    rows = _span(y, cy - radius - pixel, cy + radius + pixel)
    cols = _span(x, cx - radius - pixel, cx + radius + pixel)
    if rows.start >= rows.stop:
        return
    dx, dy = (x[cols] - cx)[None, :] / radius, (y[rows] - cy)[:, None] / radius
    r2 = dx * dx + dy * dy
    cover = np.clip((1.0 - np.sqrt(r2)) * radius / pixel + 0.5, 0.0, 1.0)
    lit = np.clip(0.75 * np.sqrt(np.maximum(1.0 - r2, 0.0)) - 0.45 * dx - 0.5 * dy, 0.05, None)
    gloss = 1.2 / (1.0 + ((dx + 0.4) ** 2 + (dy + 0.45) ** 2) * 40.0)
    picture[rows, cols] += (lit + gloss - picture[rows, cols]) * cover


def _spark(picture: Picture, x: Floats, y: Floats, phase: float, half: Point) -> None:
    """Add a point of light, at the position `phase` (0..1) of a closed loop, to `picture` (rows,
    cols), in place. `x` and `y` are the coordinates of columns and rows from the centre, `half` is
    half the width and half the height of the picture."""
    cx, cy = 0.75 * half[0] * turn(phase)[0], -0.25 + 0.17 * turn(2.0 * phase)[1]
    rows, cols = _span(y, cy - 0.09, cy + 0.09), _span(x, cx - 0.09, cx + 0.09)
    if rows.start >= rows.stop:
        return
    r2 = (x[cols] - cx)[None, :] ** 2 + (y[rows] - cy)[:, None] ** 2
    picture[rows, cols] += 8.0 * np.clip(1.0 - r2 / 0.0081, 0.0, 1.0) ** 2 / (1.0 + r2 / 0.0001)
