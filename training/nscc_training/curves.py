"""Curves from linear light to the units in which errors are measured: mu-law, log, sRGB, PU21.

Each function takes a numpy array or a torch tensor and returns the same type and precision. It
computes in float64, because a float32 logarithm of 1e8 already has an error of 1e-6. Below their
domain the curves continue as straight lines, so that values and gradients stay finite."""

from __future__ import annotations

import math
from typing import Any, TypeVar, cast

import numpy as np

Array = TypeVar("Array", bound=Any)

MU = 5000.0
"""The usual value of mu in the HDR literature."""

PU21_LOW, PU21_HIGH = 0.005, 10000.0
"""The range of luminances, in cd/m2, to which PU21 was fitted."""

_PU21 = (
    0.353487901,
    0.3734658629,
    8.277049286e-05,
    0.9062562627,
    0.09150303166,
    0.9099517204,
    596.3148142,
)
"""Coefficients of Mantiuk and Azimi, Picture Coding Symposium 2021: the fit with banding
and glare."""


def mu_law(x: Array, mu: float = MU) -> Array:
    """Return log(1 + mu x) / log(1 + mu), for x relative to the data range: 0 at 0, and 1 at 1.
    `mu` is above 0; negative x continue as a straight line."""
    return _as(x, log_curve(_wide(x), 1.0 / mu) / math.log1p(mu))


def log_curve(x: Array, floor: float) -> Array:
    """Return log(1 + x / floor), and x / floor for negative x. `floor` is above 0, in the unit of
    x.

    Differences on this curve are relative errors far above `floor`, and absolute errors far below.
    """
    xp, wide = _library(x), _wide(x)
    scaled = wide / floor
    return _as(x, xp.where(wide >= 0, xp.log1p(xp.clip(scaled, 0.0, None)), scaled))


def log_curve_inverse(y: Array, floor: float) -> Array:
    """Return the x for which log(1 + x / floor) is y; for negative y, floor times y."""
    xp, wide = _library(y), _wide(y)
    return _as(y, floor * xp.where(wide >= 0, xp.expm1(xp.clip(wide, 0.0, None)), wide))


def srgb(x: Array) -> Array:
    """Return the sRGB encoding (IEC 61966-2-1) of linear light, a straight line below 0.0031308.
    White is 1; brighter light is not clipped."""
    xp, wide = _library(x), _wide(x)
    power = 1.055 * xp.clip(wide, 0.0031308, None) ** (1 / 2.4) - 0.055
    return _as(x, xp.where(wide > 0.0031308, power, 12.92 * wide))


def srgb_inverse(y: Array) -> Array:
    """Return the linear light, with white at 1, of sRGB values y on 0..1; others continue the
    curve. Any shape."""
    xp, wide = _library(y), _wide(y)
    power = ((xp.clip(wide, 0.04045, None) + 0.055) / 1.055) ** 2.4
    return _as(y, xp.where(wide > 0.04045, power, wide / 12.92))


def pu21(luminance: Array) -> Array:
    """Return the perceptually uniform encoding (PU21) of a luminance in cd/m2.

    A difference of 1 is about equally visible at every luminance. The value is about 256 at 100
    cd/m2 and 0 at 0.005 cd/m2. Outside `PU21_LOW`..`PU21_HIGH` the curve continues as a straight
    line with the slope at that end."""
    xp, wide = _library(luminance), _wide(luminance)
    inside = xp.clip(wide, PU21_LOW, PU21_HIGH)
    low, high = (_pu21_slope(end) for end in (PU21_LOW, PU21_HIGH))
    below, above = xp.clip(wide - PU21_LOW, None, 0.0), xp.clip(wide - PU21_HIGH, 0.0, None)
    return _as(luminance, _pu21_inside(inside) + below * low + above * high)


def _pu21_inside(luminance: Any) -> Any:
    """Return the PU21 encoding of luminances (array or tensor, float64) in cd/m2.

    They must lie between `PU21_LOW` and `PU21_HIGH`. This is the published formula with the
    coefficients `_PU21`: a ratio of two functions of luminance**d, raised to e, shifted and scaled.
    """
    a, b, c, d, e, f, scale = _PU21
    power = luminance**d
    return scale * (((a + b * power) / (1.0 + c * power)) ** e - f)


def _pu21_slope(luminance: float) -> float:
    """Return the derivative of the PU21 curve at a luminance in cd/m2, with which it continues
    outside its domain."""
    a, b, c, d, e, _f, scale = _PU21
    power = luminance**d
    ratio = (a + b * power) / (1.0 + c * power)
    inner = (b - a * c) / (1.0 + c * power) ** 2 * d * power / luminance
    return float(scale * e * ratio ** (e - 1.0) * inner)


def _library(x: Any) -> Any:
    """Return the module whose functions apply to `x`, without importing torch needlessly: torch for
    its tensors, numpy for everything else."""
    if type(x).__module__.partition(".")[0] == "torch":
        import torch

        return torch
    return np


def _wide(x: Any) -> Any:
    """Return x in float64, as array or tensor."""
    return x.double() if _library(x) is not np else np.asarray(x, np.float64)


def _as(x: Array, y: Any) -> Array:
    """Return y (float64) in the precision of x. If x holds integers, return y as it is."""
    if _library(x) is not np:
        return cast(Array, y.to(x.dtype) if x.is_floating_point() else y)
    kind = np.asarray(x).dtype
    return cast(Array, y.astype(kind) if kind.kind == "f" else y)
