"""A camera that rotates inside a panorama: high-speed video with known radiance.

Rotation causes neither parallax nor occlusion, so additional objects cross the picture."""

from __future__ import annotations

import numpy as np

from nscc.arrays import Floats, Floats32

FIELD_OF_VIEW = 90.0
"""The camera's field of view in degrees: 256 of 1024 pixels of a panorama."""
_TURNS = (0.1, 4.0)
"""Slowest and fastest rotation in degrees per frame, drawn uniformly in the logarithm."""
_FLIGHTS = (0.2, 16.0)
"""Slowest and fastest speed of objects in pixels per frame."""


def turned(panorama: Floats32, generator: np.random.Generator, frames: int, size: int) -> Floats32:
    """Return a clip (frames, size, size) of linear light from an equirectangular panorama (rows,
    cols).

    The camera starts near the horizon and rotates uniformly, mostly sideways. One to three objects,
    elliptical pieces of other parts of the panorama, cross the picture."""
    import cv2

    def somewhere() -> tuple[float, float]:
        """Return a random direction in radians: longitude, and latitude within 15 degrees of the
        horizon."""
        return np.radians(generator.uniform(0, 360)), np.radians(generator.uniform(-15, 15))

    yaw, pitch = somewhere()
    # Yaw and pitch; the rotation is mostly sideways, so the rate of pitch is reduced.
    turn = np.radians(_velocity(generator, _TURNS) * (0.3, 1.0))[::-1]
    views = [view(panorama, yaw + turn[0] * k, pitch + turn[1] * k, size) for k in range(frames)]
    clip = np.stack(views)
    level = float(np.median(clip))
    rows, cols = np.mgrid[:size, :size]
    for _ in range(int(generator.integers(1, 4))):
        texture = view(panorama, *somewhere(), size)
        light = level / max(float(np.median(texture)), 1e-30) * np.exp(generator.uniform(-1.5, 1.5))
        position, speed = generator.uniform(0, size, 2), _velocity(generator, _FLIGHTS)
        height, width = generator.uniform(0.04, 0.2, 2) * size
        for k in range(frames):
            y, x = position + speed * k
            outside = np.hypot((rows - y) / height, (cols - x) / width) - 1
            # The border of an object is about one pixel wide.
            cover = np.clip(0.5 - outside * min(height, width), 0, 1)
            shift = np.array([[1, 0, x - position[1]], [0, 1, y - position[0]]])
            moved = cv2.warpAffine(texture, shift, (size, size), borderMode=cv2.BORDER_REFLECT)
            clip[k] += ((moved * light - clip[k]) * cover).astype(np.float32)
    return clip


def _velocity(generator: np.random.Generator, limits: tuple[float, float]) -> Floats:
    """Return a random velocity (down, right) in any direction. Its magnitude is uniform in the
    logarithm between the `limits`."""
    size = np.exp(generator.uniform(*np.log(limits)))
    angle = generator.uniform(0, 2 * np.pi)
    return np.asarray(size * np.array([np.sin(angle), np.cos(angle)]))


def view(panorama: Floats32, yaw: float, pitch: float, size: int) -> Floats32:
    """Return the view (size, size) of a camera that looks in direction `yaw` (sideways) and `pitch`
    (upwards), both in radians, inside an equirectangular panorama."""
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
    # One more column on either side closes the seam.
    wide = np.concatenate([panorama[:, -1:], panorama, panorama[:, :1]], axis=1)
    picture = cv2.remap(
        wide,
        (x + 1).astype(np.float32),
        y.astype(np.float32),
        cv2.INTER_LINEAR,
        borderMode=cv2.BORDER_REPLICATE,
    )
    return np.asarray(picture, np.float32)
