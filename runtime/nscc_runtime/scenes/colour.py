"""Convert stored pictures to luminance: white level, transfer curve, weights of colours."""

from __future__ import annotations

from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray

Transfer = Literal["linear", "srgb", "pq", "hlg"]
TRANSFERS: tuple[Transfer, ...] = get_args(Transfer)
CURVES = {"linear": "no curve", "srgb": "the sRGB curve", "pq": "the PQ curve (SMPTE ST 2084)",
          "hlg": "the HLG curve (ITU-R BT.2100)"}  # fmt: skip
"""Descriptions of the transfer curves in messages."""

LUMINANCE = (0.2126, 0.7152, 0.0722)
"""Weights of linear red, green and blue (Rec. 709 primaries)."""

_STRIP_SAMPLES = 1 << 22


def white_of(dtype: np.dtype[Any]) -> float:
    """Return the default white level: the largest integer, or 1 for floats."""
    return float(np.iinfo(dtype).max) if dtype.kind in "ui" else 1.0


def linear(
    values: NDArray[Any], transfer: Transfer, white: float | None = None
) -> NDArray[np.float64]:
    """Convert stored samples to linear light, float64; white becomes 1.

    Samples are fractions of `white` (None: `white_of` their type). The curves are those of IEC
    61966-2-1 (`srgb`), SMPTE ST 2084 (`pq`) and ITU-R BT.2100 (`hlg`, the light of the scene). sRGB
    is continued beyond 0..1 by its own formulas."""
    scale = white or white_of(values.dtype)
    if values.dtype.kind in "ui" and transfer != "linear" and values.dtype.itemsize == 1:
        table = _INVERSES[transfer](np.arange(256, dtype=np.float64) / scale)
        decoded: NDArray[np.float64] = table[values.view(np.uint8)]
        return decoded
    fractions: NDArray[np.float64] = values.astype(np.float64)
    if scale != 1:
        fractions /= scale
    return fractions if transfer == "linear" else _INVERSES[transfer](fractions)


def pq_to_linear(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Convert PQ signals (0..1) to linear light (0..1, where 1 is 10 000 cd/m2)."""
    m1, m2 = 2610 / 16384, 2523 / 4096 * 128
    c1, c2, c3 = 3424 / 4096, 2413 / 4096 * 32, 2392 / 4096 * 32
    power = np.clip(values, 0, 1) ** (1 / m2)
    return np.asarray((np.maximum(power - c1, 0) / (c2 - c3 * power)) ** (1 / m1))


def hlg_to_linear(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Convert HLG signals to the linear light of the scene; 0 stays 0, 1 stays 1."""
    a, b, c = 0.17883277, 0.28466892, 0.55991073
    signal = np.maximum(values, 0)
    bright = (np.exp((np.maximum(signal, 0.5) - c) / a) + b) / 12
    return np.where(signal <= 0.5, signal**2 / 3, bright)


def srgb_to_linear(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Convert sRGB signals to linear light; 0 stays 0, 1 stays 1. Below 0.04045, also below 0, the
    curve is a straight line."""
    curve = ((np.maximum(values, 0.04045) + 0.055) / 1.055) ** 2.4
    return np.where(values <= 0.04045, values / 12.92, curve)


_INVERSES = {"srgb": srgb_to_linear, "pq": pq_to_linear, "hlg": hlg_to_linear}


def luminance(rgb: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the luminance (rows, cols) of linear red, green, blue (rows, cols, 3)."""
    red, green, blue = LUMINANCE
    return red * rgb[..., 0] + green * rgb[..., 1] + blue * rgb[..., 2]


def grey(
    stored: NDArray[Any], transfer: Transfer, channel: int | None, white: float | None = None
) -> NDArray[np.float64]:
    """Return the luminance (rows, cols) of a stored picture, or of its colour `channel`."""
    if stored.ndim == 3 and channel is not None:
        stored = stored[..., channel]
    light = np.empty(stored.shape[:2])
    step = max(1, _STRIP_SAMPLES // max(1, stored[:1].size))
    for first in range(0, len(stored), step):  # colours in float64 take eight times a picture
        strip = linear(np.ascontiguousarray(stored[first : first + step]), transfer, white)
        light[first : first + step] = luminance(strip) if strip.ndim == 3 else strip
    return light
