"""From stored pictures to luminance: full scale, transfer curve, weights of the colours."""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

Transfer = Literal["linear", "srgb"]

LUMINANCE = (0.2126, 0.7152, 0.0722)
"""Weights of linear red, green and blue (Rec. 709 primaries)."""

_STRIP_SAMPLES = 1 << 22


def linear(values: NDArray[Any], transfer: Transfer) -> NDArray[np.float64]:
    """Stored samples as linear light, float64.

    Integers are fractions of their type's largest value; floats are taken as they are. `srgb`
    undoes the curve of IEC 61966-2-1, continued beyond 0..1 by its own formulas.
    """
    if values.dtype.kind in "ui":
        scale = float(np.iinfo(values.dtype).max)
        if transfer == "srgb" and values.dtype.itemsize == 1:
            table = srgb_to_linear(np.arange(256, dtype=np.float64) / scale)
            decoded: NDArray[np.float64] = table[values.view(np.uint8)]
            return decoded
        fractions: NDArray[np.float64] = values.astype(np.float64) / scale
    else:
        fractions = values.astype(np.float64)
    return srgb_to_linear(fractions) if transfer == "srgb" else fractions


def srgb_to_linear(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """The sRGB curve undone: 0 to 0, 1 to 1; below 0.04045 (and below 0) a straight line."""
    curve = ((np.maximum(values, 0.04045) + 0.055) / 1.055) ** 2.4
    return np.where(values <= 0.04045, values / 12.92, curve)


def luminance(rgb: NDArray[np.float64]) -> NDArray[np.float64]:
    """Luminance (rows, cols) of linear colours (rows, cols, 3) in the order red, green, blue."""
    red, green, blue = LUMINANCE
    return red * rgb[..., 0] + green * rgb[..., 1] + blue * rgb[..., 2]


def grey(stored: NDArray[Any], transfer: Transfer, channel: int | None) -> NDArray[np.float64]:
    """The luminance (rows, cols) of a stored picture, or the light of one of its colours."""
    if stored.ndim == 3 and channel is not None:
        stored = stored[..., channel]
    light = np.empty(stored.shape[:2])
    step = max(1, _STRIP_SAMPLES // max(1, stored[:1].size))
    for first in range(0, len(stored), step):  # colours in float64 take eight times a picture
        strip = linear(np.ascontiguousarray(stored[first : first + step]), transfer)
        light[first : first + step] = luminance(strip) if strip.ndim == 3 else strip
    return light
