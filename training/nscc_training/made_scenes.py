"""Procedural scenes, determined by a seed, identical on every machine with the same numpy."""

from __future__ import annotations

import numpy as np

from nscc.arrays import Bools, Floats, Floats32

Generator = np.random.Generator

DIRECTIONS = (
    "right",
    "down-right",
    "down",
    "down-left",
    "left",
    "up-left",
    "up",
    "up-right",
)
"""The directions of `moving_texture`, 45 degrees apart."""


def still(generator: Generator, size: int) -> Floats32:
    """Return a picture (size, size) of light, in an arbitrary unit, over four to six decades:
    surfaces, edges, lamps. All draws come from `generator`."""
    surface = _fractal(generator, size, spread=4.0)
    for _ in range(int(generator.integers(6, 14))):
        shape_mask = _shape(generator, size)
        # Logarithms of light: a shape has less texture, and its own brightness.
        surface = np.where(shape_mask, surface * 0.3 + generator.normal(0, 1.2), surface)
    for _ in range(int(generator.integers(1, 5))):
        y, x = generator.random(2) * size
        rows, cols = np.mgrid[:size, :size]
        distance = ((rows - y) ** 2 + (cols - x) ** 2) / (size * generator.uniform(0.01, 0.06)) ** 2
        # A lamp, 7 to 400 times as bright as its place, with a wide halo.
        surface += generator.uniform(2, 6) / (1 + distance**2)
    return np.exp(surface).astype(np.float32)


def clip(generator: Generator, frames: int, size: int) -> Floats32:
    """Return a clip (frames, size, size) of light from 0 to 1, in which two to five textured
    objects cross a panning background. All draws come from `generator`."""
    # More than the background can move: 1.5 pixels per frame at most.
    margin = 3 * frames
    ground = _unit(_fractal(generator, size + 2 * margin, spread=1.0))
    pan = generator.uniform(-1.5, 1.5, 2)
    sprites = [_sprite(generator, size) for _ in range(int(generator.integers(2, 6)))]
    light = np.empty((frames, size, size), np.float32)
    for k in range(frames):
        light[k] = _moved(ground, margin + pan * k, size)
        for texture, mask, corner, speed in sprites:
            _paste(light[k], texture, mask, corner + speed * k)
    return light


def moving_texture(
    generator: Generator, frames: int, size: int, direction: str, speed: float
) -> Floats32:
    """Return a clip (frames, size, size), float32 on 0..1, of a texture that moves by `speed`
    pixels per frame in `direction`, one of `DIRECTIONS`, blurred by its motion during each frame.

    The texture is periodic: what leaves the picture enters it on the opposite side. Its statistics
    are those of its mirror images, so the sum of all frames does not distinguish a direction from
    its opposite."""
    angle = DIRECTIONS.index(direction) * (np.pi / 4)
    down, right = speed * np.sin(angle), speed * np.cos(angle)
    spectrum = np.fft.rfft2(_unit(_fractal(generator, size, spread=1.0)))
    cycles = down * np.fft.fftfreq(size)[:, None] + right * np.fft.rfftfreq(size)[None, :]
    # Cycles per frame of each frequency: its phase advances, and the exposure averages it.
    middles = np.arange(frames)[:, None, None] + 0.5
    moved = spectrum * np.sinc(cycles) * np.exp(-2j * np.pi * cycles * middles)
    clip = np.fft.irfft2(moved, s=(size, size), axes=(1, 2))
    return np.clip(clip, 0, 1).astype(np.float32)


def _fractal(generator: Generator, size: int, spread: float) -> Floats:
    """Return noise (size, size) with mean 0 and the standard deviation `spread` / 2. Its amplitude
    falls with spatial frequency as in natural scenes. It is periodic."""
    frequency = np.hypot(np.fft.fftfreq(size)[:, None], np.fft.rfftfreq(size)[None, :])
    # The mean has the frequency 0, by which nothing can be divided; it is subtracted below.
    frequency[0, 0] = 1.0
    white = np.fft.rfft2(generator.standard_normal((size, size)))
    noise = np.fft.irfft2(white / frequency**1.4, s=(size, size))
    return np.asarray((noise - noise.mean()) / noise.std() * spread * 0.5)


def _unit(values: Floats) -> Floats:
    """Return values scaled so that their 1 % and 99 % quantiles become 0.1 and 0.9; values beyond
    are clipped to this range. The two quantiles must differ."""
    low, high = np.percentile(values, (1, 99))
    return np.asarray(np.clip((values - low) / (high - low), 0, 1) * 0.8 + 0.1)


def _shape(generator: Generator, size: int) -> Bools:
    """Return a mask (size, size), true in a random rotated rectangle or ellipse, part of which may
    lie outside."""
    y, x = generator.random(2) * size
    height, width = generator.uniform(0.05, 0.3, 2) * size
    angle = generator.uniform(0, np.pi)
    rows, cols = np.mgrid[:size, :size]
    u = (rows - y) * np.cos(angle) + (cols - x) * np.sin(angle)
    v = (cols - x) * np.cos(angle) - (rows - y) * np.sin(angle)
    if generator.random() < 0.5:
        return np.asarray((np.abs(u) < height) & (np.abs(v) < width))
    return np.asarray((u / height) ** 2 + (v / width) ** 2 < 1)


def _sprite(generator: Generator, size: int) -> tuple[Floats, ...]:
    """Return a random object for a picture of `size` pixels: texture and mask (side, side),
    position of its corner in pixels, and speed in pixels per frame (down, right)."""
    side = int(size * generator.uniform(0.2, 0.5))
    texture = _unit(_fractal(generator, side, spread=1.0))
    mask = _shape(generator, side) | _shape(generator, side)
    corner = generator.uniform(-0.2, 0.9, 2) * size
    return texture, mask.astype(np.float64), corner, generator.uniform(-3, 3, 2)


def _moved(ground: Floats, corner: Floats, size: int) -> Floats32:
    """Return the window (size, size) of `ground` whose corner (row, column) may lie between pixels,
    by linear interpolation. `ground` must extend one pixel beyond the window."""
    pixel = np.floor(corner).astype(int)
    fraction = corner - pixel
    y, x = pixel
    block = ground[y : y + size + 1, x : x + size + 1]
    down = block[:-1] * (1 - fraction[0]) + block[1:] * fraction[0]
    return np.asarray(down[:, :-1] * (1 - fraction[1]) + down[:, 1:] * fraction[1], np.float32)


def _paste(
    picture: Floats32,
    texture: Floats,
    mask: Floats,
    corner: Floats,
) -> None:
    """Paste an object, `texture` (side, side), into `picture` (rows, cols), in place, where `mask`
    (side, side) is 1. Its corner is at `corner`, rounded to whole pixels; parts outside are cut."""
    side = len(texture)
    y, x = np.rint(corner).astype(int)
    # From (y0, x0) to (y1, x1): the part of the object within the picture.
    y0, x0 = max(y, 0), max(x, 0)
    y1, x1 = min(y + side, picture.shape[0]), min(x + side, picture.shape[1])
    if y0 >= y1 or x0 >= x1:
        return
    inner = (slice(y0 - y, y1 - y), slice(x0 - x, x1 - x))
    region = picture[y0:y1, x0:x1]
    region += ((texture[inner] - region) * mask[inner]).astype(np.float32)
