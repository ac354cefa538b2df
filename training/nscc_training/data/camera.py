"""A camera turned inside a panorama: high-speed video with true radiance.

Rotation only: no parallax and no occlusion, which is why things are made to cross the picture.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Picture = NDArray[np.float32]
FIELD_OF_VIEW = 90.0
"""Degrees: 256 pixels of a panorama of 1024."""
_FASTEST = 2.0
"""Degrees a frame."""


def turned(
    panorama: Picture, generator: np.random.Generator, frames: int, size: int
) -> NDArray[np.float32]:
    """A clip (frames, size, size) of linear light from an equirectangular panorama (rows, cols).

    The camera starts anywhere near the horizon and turns evenly; two or three bright or dark things
    fly across.
    """
    yaw = np.radians(generator.uniform(0, 360))
    pitch = np.radians(generator.uniform(-15, 15))
    turn = np.radians(generator.uniform(-_FASTEST, _FASTEST, 2) * (1.0, 0.3))
    views = [view(panorama, yaw + turn[0] * k, pitch + turn[1] * k, size) for k in range(frames)]
    found = np.stack(views)
    level = float(np.median(found))
    rows, cols = np.mgrid[:size, :size]
    for _ in range(int(generator.integers(2, 4))):
        place, speed = generator.uniform(0, size, 2), generator.uniform(-4, 4, 2)
        radius = generator.uniform(0.03, 0.12) * size
        light = level * np.exp(generator.uniform(-2, 3))
        for k in range(frames):
            y, x = place + speed * k
            cover = np.clip(radius - np.hypot(rows - y, cols - x) + 0.5, 0, 1)
            shade = light * (0.6 + 0.4 * np.sin((rows - y) * 9 / radius))
            found[k] += ((shade - found[k]) * cover).astype(np.float32)
    return found


def view(panorama: Picture, yaw: float, pitch: float, size: int) -> Picture:
    """What a camera sees that looks along `yaw` and `pitch` (radians), (size, size)."""
    import cv2

    half = np.tan(np.radians(FIELD_OF_VIEW) / 2)
    step = (np.arange(size) + 0.5) / size * 2 - 1
    right, down = np.meshgrid(step * half, step * half)
    forward = np.cos(pitch) + down * np.sin(pitch)
    below = down * np.cos(pitch) - np.sin(pitch)
    longitude = yaw + np.arctan2(right, forward)
    latitude = np.arctan2(below, np.hypot(right, forward))
    rows, cols = panorama.shape
    x = (longitude / (2 * np.pi) % 1.0) * cols - 0.5
    y = (latitude / np.pi + 0.5) * rows - 0.5
    # The seam: one column more on either side.
    wide = np.concatenate([panorama[:, -1:], panorama, panorama[:, :1]], axis=1)
    found = cv2.remap(
        wide, (x + 1).astype(np.float32), y.astype(np.float32), cv2.INTER_LINEAR,
        borderMode=cv2.BORDER_REPLICATE,
    )  # fmt: skip
    return np.asarray(found, np.float32)
