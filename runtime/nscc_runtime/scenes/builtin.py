"""Scenes without files: `builtin:hdr`, `builtin:motion[:PART]`, `builtin:flat:E`,
`builtin:dark`."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress

import numpy as np

from nscc.arrays import Floats, Floats32
from nscc.diagnostics.diagnostic import rejected
from nscc.diagnostics.suggest import closest, did_you_mean
from nscc_runtime.light import Light
from nscc_runtime.scenes.exposure import BUILTIN, ExposureLevel, scale
from nscc_runtime.scenes.shapes import fractal, noise, smooth
from nscc_runtime.scenes.timing import still

_SUN = (0.66, 0.37)
"""Position of the sun, in fractions of width and height."""
_SUN_LEVEL = 6000.0
"""Luminance of the sun, where the darkest shadow is 0.03."""
_DARKEST = 0.03
"""Luminance of the deepest shadow. Pictures of any size range from it to `_SUN_LEVEL`."""
_SHORE = 0.63
"""Position of the shore, in fractions of the height."""
_TREES = ((0.045, 0.36), (0.125, 0.47), (0.2, 0.57), (0.93, 0.5), (0.985, 0.42))
"""Position of the stem and of the tip of each pine, in fractions of width and height."""


def landscape(rows: int, cols: int) -> Floats32:
    """Return relative luminance (rows, cols) from 0.03 to 6000, equal on every machine.

    The functions below draw its parts from back to front. They use coordinates x to the right and
    y downwards, both from 0 to 1 over the picture. Their sizes and luminances were chosen by eye.
    """
    x = (np.arange(cols) + 0.5) / cols
    y = (np.arange(rows) + 0.5) / rows
    pixel = 1.0 / rows
    picture = _sky(x, y)
    # Three ridges, from far to near: row of the outline, its variation, and luminance.
    for number, (height, roughness, level) in enumerate(
        ((0.46, 0.20, 3.0), (0.53, 0.15, 0.9), (0.585, 0.08, 0.28))
    ):
        _ridge(picture, x, y, (height, roughness, level), 20 + 7 * number, pixel)
    _lake(picture, x, y)
    _bank(picture, x, y, pixel)
    # At any size, one pixel is the sun, and one of the bank is the deepest shadow.
    picture[np.argmin(np.abs(y - _SUN[1])), np.argmin(np.abs(x - _SUN[0]))] = _SUN_LEVEL
    if picture.size > 1:
        picture[-1, 0] = _DARKEST
    return picture.astype(np.float32)


def _sky(x: Floats, y: Floats) -> Floats:
    """Return the luminance of the sky with a sun and clouds, (rows, cols); `x` and `y` are
    coordinates 0..1."""
    distance2 = ((x - _SUN[0]) ** 2)[None, :] + ((y - _SUN[1]) ** 2)[:, None]
    clouds = smooth(0.42, 0.75, fractal(x * 3.0, y * 11.0, seed=3, octaves=4))
    glow = 420.0 / (1.0 + distance2 / 0.0016) + 34.0 / (1.0 + distance2 / 0.04)
    air = (4.0 + 16.0 * y * y)[:, None]
    # Clouds catch the light near the sun and hide the sky away from it.
    veiled = (air + glow) * (1.0 - 0.55 * clouds) + clouds * glow * 0.8
    return veiled + _SUN_LEVEL * (1.0 - smooth(0.0009, 0.0013, distance2))


def _ridge(
    picture: Floats,
    x: Floats,
    y: Floats,
    shape: tuple[float, float, float],
    seed: int,
    pixel: float,
) -> None:
    """Draw a mountain ridge into `picture` (rows, cols), in place.

    `x` and `y` are the coordinates (0..1) of columns and rows. `shape` is the y of its mean
    outline, the variation of the outline, and the luminance. `seed` numbers the random outline.
    `pixel` is the size of a pixel, over which the edge is smoothed."""
    height, roughness, level = shape
    outline = height + roughness * (
        0.55 - fractal(x * 3.2 + seed, np.array([seed + 0.5]), seed=seed, octaves=6)
    )
    land = smooth(-0.5 * pixel, 0.5 * pixel, y[:, None] - outline)
    slopes = 0.55 + 0.9 * fractal(x * 14.0, y * 20.0, seed=seed + 3, octaves=4)
    haze = 1.0 + 1.6 / (1.0 + ((x - _SUN[0]) / 0.18) ** 2)
    picture += (level * slopes * haze - picture) * land


def _lake(picture: Floats, x: Floats, y: Floats) -> None:
    """Draw the lake below the shore into `picture` (rows, cols), in place; it mirrors the scene
    above, broken by waves. `x` and `y` are the coordinates (0..1) of columns and rows. A picture
    that ends above the shore, or begins below it, is unchanged."""
    below = np.flatnonzero(y >= _SHORE)
    if len(below) == 0 or below[0] == 0:
        return  # the picture ends above the shore, or shows nothing that could be mirrored
    depth = y[below] - _SHORE
    waves = fractal(x * 7.0, 3.0 / (depth + 0.03), seed=61, octaves=3)
    rows = len(y)
    mirrored = _SHORE - depth[:, None] * 1.25 + (waves - 0.5) * (0.02 + 0.22 * depth[:, None])
    source = np.clip((mirrored * rows).astype(np.int64), 0, int(below[0]) - 1)
    mirror = picture[source, np.arange(len(x))[None, :]]
    width = 0.012 + 0.13 * depth[:, None]
    path = 1.0 / (1.0 + ((x - _SUN[0]) / width) ** 2)
    glitter = smooth(
        0.56, 0.78, noise(x * 60.0, 9.0 / (depth + 0.045), seed=71) * 0.6 + waves * 0.4
    )
    shade = 0.12 + 0.2 * waves
    picture[below] = np.minimum(mirror, 300.0) * shade + 0.05 + 900.0 * path * path * glitter


def _bank(picture: Floats, x: Floats, y: Floats, pixel: float) -> None:
    """Draw the near bank with pines and a hut with a lit window into `picture` (rows, cols), in
    place. `x` and `y` are the coordinates (0..1) of columns and rows, and `pixel` is the size of a
    pixel."""
    edge = (
        0.91
        + 0.06 * fractal(x * 5.0, np.array([0.5]), seed=81, octaves=5)
        - 0.1 * smooth(0.7, 1.0, x)
    )
    bank = smooth(-0.5 * pixel, 0.5 * pixel, y[:, None] - edge)
    for stem, tip in _TREES:
        bank = np.maximum(bank, _pine(x, y, stem, tip, pixel))
    bank = np.maximum(bank, _hut(x, y, pixel))
    ground = _DARKEST * (1.0 + 4.0 * fractal(x * 30.0, y * 30.0, seed=91, octaves=3))
    picture += (ground - picture) * bank
    lit = _box(x, y, (0.80, 0.825, 0.812, 0.84), pixel)
    picture += (70.0 - picture) * lit


def _pine(x: Floats, y: Floats, stem: float, tip: float, pixel: float) -> Floats:
    """Return how much of each pixel a pine tree covers, 0..1, (rows, cols).

    All arguments are in fractions of the picture's size: `x` and `y` of columns and rows, `stem`
    the x of the stem, `tip` the y of its top, and `pixel` the size of a pixel."""
    height = 0.97 - tip
    along = (y - tip) / height
    boughs = along * 9.0
    reach = 0.17 * height * along * (0.45 + 0.55 * (boughs - np.floor(boughs)))
    inside = np.where(along > 0.0, reach, -pixel)[:, None] - np.abs(x - stem)[None, :]
    return smooth(-0.5 * pixel, 0.5 * pixel, inside)


def _hut(x: Floats, y: Floats, pixel: float) -> Floats:
    """Return how much of each pixel a hut with a roof covers, 0..1, (rows, cols). `x`, `y`:
    positions of columns and rows, 0..1; `pixel`: the width of a pixel."""
    roof = np.abs(x - 0.81)[None, :] * 0.7 + 0.755 - y[:, None]
    walls = _box(x, y, (0.765, 0.855, 0.78, 0.9), pixel)
    eaves = _box(x, y, (0.745, 0.875, 0.74, 0.80), pixel)
    return np.maximum(walls, eaves * smooth(-0.5 * pixel, 0.5 * pixel, -roof))


def _box(x: Floats, y: Floats, sides: tuple[float, float, float, float], pixel: float) -> Floats:
    """Return how much of each pixel a rectangle covers, 0..1, (rows, cols).

    All arguments are in fractions of the picture's size: `x` and `y` of columns and rows, `sides`
    left, right, top and bottom, and `pixel` the size of a pixel."""
    x0, x1, y0, y1 = sides
    across = smooth(-0.5 * pixel, 0.5 * pixel, np.minimum(x - x0, x1 - x))
    down = smooth(-0.5 * pixel, 0.5 * pixel, np.minimum(y - y0, y1 - y))
    return across[None, :] * down[:, None]


_ARGUMENTS = {"hdr": (0,), "motion": (0, 1), "flat": (1,), "dark": (0,)}
"""How many arguments may follow the name of each scene, as in `builtin:flat:10000`."""


def load_builtin(
    spec: str,
    *,
    slot_us: Sequence[float],
    rows: int,
    cols: int,
    exposure: ExposureLevel | None = None,
) -> Light:
    """Return the light of the scene `spec`, such as `builtin:hdr`, on an array of `rows` x `cols`
    pixels, in slots of `slot_us` microseconds.

    Without `exposure`, hdr and motion have 30000 electrons at percentile 99, and flat has its own
    number of electrons over the frame, divided by slot length. Raises Rejected: NS0731 for an
    unknown name or an invalid argument, NS0738 for an `exposure` of a dark scene or beyond
    float32."""
    _, name, *arguments = spec.split(":")
    if len(arguments) not in _ARGUMENTS.get(name, ()):
        suggestion = name if name in _ARGUMENTS else closest(name, [*_ARGUMENTS])
        written = f"builtin:{suggestion}" + (":10000" if suggestion == "flat" else "")
        raise rejected(
            "NS0731",
            f"unknown scene '{spec[:80]}'",
            notes=("builtin scenes: builtin:hdr, builtin:motion, builtin:flat:E, builtin:dark",),
            helps=(did_you_mean(written) if suggestion else "choose one of these, or name a file",),
        )
    match name:
        case "motion":
            from nscc_runtime.scenes.builtin_motion import motion

            share = 1.0
            if arguments:
                share = _number(
                    arguments[0],
                    lambda share: 0.0 <= share <= 1.0,
                    f"'{arguments[0][:60]}' in '{spec[:80]}' is not a fraction from 0 to 1",
                    "builtin:motion:PART shows this fraction of the clip, from its middle, in slow "
                    "motion",
                    "builtin:motion:0.2",
                )
            return motion(slot_us, rows, cols, exposure or BUILTIN, spec, share)
        case "hdr":
            frame = landscape(rows, cols)
            level: ExposureLevel | None = exposure or BUILTIN
        case "flat":
            electrons = _number(
                arguments[0],
                lambda electrons: 0.0 <= electrons < 1e38,  # near the end of float32
                f"invalid number of electrons '{arguments[0][:60]}' in '{spec[:80]}'",
                "builtin:flat:E gives every pixel E electrons over the whole frame, 0 or more",
                "builtin:flat:10000",
            )
            frame = np.full((rows, cols), 1.0 if electrons else 0.0, np.float32)
            level = exposure or (ExposureLevel(electrons) if electrons else None)
        case _:
            frame = np.zeros((rows, cols), np.float32)
            level = exposure
    return still(frame, slot_us, lambda open_sum: scale(open_sum, level, spec) if level else 1.0)


def _number(text: str, within: Callable[[float], bool], message: str, *help_texts: str) -> float:
    """Return the argument `text` of a scene as a number. Raises Rejected (NS0731) with `message` if
    it is no number or not `within` its limits. `help_texts` are two: a note, and an example."""
    with suppress(ValueError):
        if within(float(text)):
            return float(text)
    note, example = help_texts
    raise rejected("NS0731", message, notes=(note,), helps=(f"for instance {example}",))
