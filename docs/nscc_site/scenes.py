"""The scenes of the gallery that are not built into nscc: drawn here, as files for `--scene`."""

from __future__ import annotations

import io
from collections.abc import Callable

import cv2
import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

SIDE = 256
"""Rows and columns of a scene: those of the array."""
_FINE = 4
"""Subpixels per pixel along each axis, for smooth outlines."""
_FRAMES = 64
"""Frames of a clip: one per slot of the examples."""

Light = NDArray[np.float32]
Shape = tuple[str, tuple[float, ...], float]
"""The kind of a shape, its place in fractions of the side, and its luminance."""


def _drawn(shapes: list[Shape]) -> Light:
    """Return relative luminance (SIDE, SIDE) of shapes, the later ones in front of the others."""
    size = SIDE * _FINE
    picture = Image.new("F", (size, size))
    draw = ImageDraw.Draw(picture)
    for kind, place, level in shapes:
        getattr(draw, kind)([size * each for each in place], fill=level)
    fine = np.asarray(picture).reshape(SIDE, _FINE, SIDE, _FINE)
    return fine.mean(axis=(1, 3), dtype=np.float32)


def _lettered(light: Light, text: str, place: tuple[int, int], height: int, level: float) -> None:
    """Draw text into a scene in place; the left top corner and the height are in pixels."""
    mask = Image.new("L", (SIDE, SIDE))
    font = ImageFont.load_default(height)
    ImageDraw.Draw(mask).text(place, text, fill=255, font=font)
    share = np.asarray(mask, np.float32) / 255
    light += (level - light) * share


def room() -> Light:
    """Return a dark room with a bulb and a window to a sunlit street, over five decades."""
    y, x = (np.mgrid[:SIDE, :SIDE] + 0.5) / SIDE
    light = _drawn(
        [
            ("rectangle", (0, 0, 1, 1), 1.0),
            ("rectangle", (0, 0.78, 1, 1), 0.35),
            ("rectangle", (0.08, 0.1, 0.5, 0.6), 0.15),
            ("rectangle", (0.1, 0.12, 0.48, 0.58), 2500.0),
            ("rectangle", (0.1, 0.34, 0.26, 0.58), 420.0),
            ("rectangle", (0.32, 0.26, 0.48, 0.58), 240.0),
            *[
                ("rectangle", (c, r, c + 0.025, r + 0.05), 60.0)
                for c in (0.34, 0.385, 0.43)
                for r in (0.3, 0.4, 0.5)
            ],
            ("ellipse", (0.14, 0.15, 0.21, 0.22), 60_000.0),
            ("rectangle", (0.285, 0.12, 0.295, 0.58), 0.2),
            ("rectangle", (0.1, 0.335, 0.48, 0.345), 0.2),
            ("rectangle", (0.56, 0.3, 0.93, 0.32), 0.1),
            *[
                (
                    "rectangle",
                    (0.57 + 0.045 * k, 0.14 + 0.03 * (k * 7 % 4), 0.605 + 0.045 * k, 0.3),
                    0.3 + 0.5 * (k * 5 % 4),
                )
                for k in range(8)
            ],
            ("rectangle", (0.6, 0.76, 0.96, 0.79), 0.12),
            ("polygon", (0.72, 0.6, 0.84, 0.6, 0.88, 0.7, 0.68, 0.7), 90.0),
            ("ellipse", (0.755, 0.675, 0.805, 0.725), 9000.0),
            ("rectangle", (0.775, 0.7, 0.785, 0.76), 0.1),
        ]
    )
    lamp = 6.0 / (1.0 + ((x - 0.78) ** 2 + (y - 0.7) ** 2) / 0.01)
    on_floor = 14.0 * ((y > 0.8) & (np.abs(x - 0.75 + 0.5 * y) < 0.14))
    light *= np.where(light < 10, 1.0 + lamp + on_floor, 1.0).astype(np.float32)
    _lettered(light, "nscc", (150, 108), 34, 0.08)
    return light


def stars() -> Light:
    """Return a starry sky above a dark hill."""
    rng = np.random.default_rng(7)
    light = np.full((SIDE, SIDE), 0.4, np.float32)
    y, x = np.mgrid[:SIDE, :SIDE]
    for row, col, size, level in zip(
        rng.uniform(0, 0.72 * SIDE, 60),
        rng.uniform(0, SIDE, 60),
        rng.uniform(0.7, 3.0, 60),
        10 ** rng.uniform(1, 2.5, 60),
        strict=True,
    ):
        light += level * np.exp(-((y - row) ** 2 + (x - col) ** 2) / size**2)
    hill = y > SIDE * (0.78 + 0.05 * np.sin(x / 37) + 0.02 * np.sin(x / 11))
    return np.where(hill, np.float32(0.05), light)


def letters() -> Light:
    """Return a clip (frames, SIDE, SIDE): a word and a ball fly past a turning star."""
    frames = []
    for phase in np.linspace(0, 1, _FRAMES, endpoint=False):
        turned = 2 * np.pi * (np.arange(16) / 16 + phase / 4)
        reach = np.where(np.arange(16) % 2, 0.1, 0.24)
        star = np.stack([0.68 + reach * np.cos(turned), 0.32 + reach * np.sin(turned)], axis=1)
        height = 0.82 - 2.2 * phase * (1 - phase)
        ball = (0.05 + 0.8 * phase, height, 0.15 + 0.8 * phase, height + 0.1)
        light = _drawn(
            [
                ("rectangle", (0, 0, 1, 1), 0.12),
                *[("rectangle", (0, k / 8, 1, k / 8 + 0.01), 0.2) for k in range(8)],
                ("polygon", tuple(star.ravel()), 0.75),
                ("ellipse", ball, 0.5),
            ]
        )
        _lettered(light, "pixel", (round(200 - 230 * phase), 176), 56, 0.95)
        frames.append(light)
    return np.stack(frames)


SCENES: dict[str, Callable[[], Light]] = {
    "room.hdr": room,
    "stars.hdr": stars,
    "letters.gif": letters,
}
"""The scenes by the name of their file: a still of linear light, or a clip for screens."""


def scene_file(name: str) -> bytes:
    """Return the file of a scene."""
    light = SCENES[name]()
    if light.ndim == 2:
        three = np.repeat(light[:, :, None], 3, axis=2)
        return bytes(cv2.imencode(".hdr", three)[1])
    levels = np.round(255 * light.clip(0, 1) ** (1 / 2.2)).astype(np.uint8)
    first, *others = map(Image.fromarray, levels)
    out = io.BytesIO()
    first.save(out, "gif", save_all=True, append_images=others, duration=40, loop=0)
    return out.getvalue()
