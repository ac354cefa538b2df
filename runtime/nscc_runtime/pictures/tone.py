"""Tone curves from light to display values, fitted to one picture and shared with pictures beside
it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from nscc.arrays import Array, Bytes, Floats
from nscc.diagnostics.diagnostic import unknown_name

WHITE_PERCENTILE = 99.8
"""Percentile of light shown as white: a few bright lights must not darken the picture."""
_MIDDLE = 0.45
"""Grey level of the median under a logarithmic curve."""
_KEY = 0.18
"""Reinhard's middle grey."""


@dataclass(frozen=True)
class Tone:
    """A fitted tone curve. `curve` maps light divided by `white` to 0..1. `name` describes it. A
    `white` of 0 makes all light black."""

    name: str
    white: float
    curve: Callable[[Floats], Floats]

    def __call__(self, light: Array) -> Bytes:
        """Map light of any shape to 0..255 (uint8). Negative values and NaN are black, values above
        `white` are white."""
        if not self.white > 0:
            return np.zeros(light.shape, np.uint8)
        shown = np.clip(np.nan_to_num(np.asarray(light, np.float64)), 0.0, self.white)
        relative = shown / self.white
        return np.rint(255.0 * np.clip(self.curve(relative), 0.0, 1.0)).astype(np.uint8)


def check_tone(tone: str) -> None:
    """Raise Rejected (NS0739) for a name that is not in `TONES`."""
    if tone not in TONES:
        raise unknown_name("NS0739", "unknown tone curve '{}'", tone, [*TONES], "the curves are {}")


def fitted(tone: str, light: Array, white: float | None = None) -> Tone:
    """Fit the tone curve named `tone` to light (.., rows, cols), or (.., rows, cols, 3) in colours.

    `white`: the light shown as white; None for the percentile `WHITE_PERCENTILE`, or the brightest
    light if that is 0. Values that are not finite are ignored; without light the curve is black.
    Raises Rejected like `check_tone`."""
    check_tone(tone)
    values = np.asarray(light, np.float64).ravel()
    values = np.maximum(values[np.isfinite(values)], 0.0)
    if white is None:
        white = float(np.percentile(values, WHITE_PERCENTILE)) if values.size else 0.0
        white = white or (float(values.max()) if values.size else 0.0)
    if not white > 0:
        return Tone(f"{tone} curve", white=0.0, curve=lambda relative: relative)
    return Tone(f"{tone} curve", white=white, curve=TONES[tone](values / white))


def srgb_of_linear(values: Floats) -> Floats:
    """Return `values`, linear light on 0..1 and above, mapped by the sRGB curve of IEC 61966-2-1.
    Negative values continue its straight part."""
    power = 1.055 * np.maximum(values, 0.0031308) ** (1 / 2.4) - 0.055
    return np.where(values > 0.0031308, power, 12.92 * values)


def _logarithmic(relative: Floats) -> Callable[[Floats], Floats]:
    """Return the curve log(1 + b x) / log(1 + b), with b such that the median of `relative` light
    becomes a middle grey. b is limited to 1 .. 2^30 for a median that is too bright or too dark."""
    middle = min(float(np.median(relative)), 1.0)
    # Bisection of the power of two of b: 40 halvings leave errors far below a grey level.
    low, high = 0.0, 30.0
    for _ in range(40):
        bend = (low + high) / 2
        grey = np.log1p(2.0**bend * middle) / np.log1p(2.0**bend)
        low, high = (bend, high) if grey < _MIDDLE else (low, bend)
    factor = 2.0**low
    return lambda light: np.log1p(factor * np.minimum(light, 1.0)) / np.log1p(factor)


def _reinhard(relative: Floats) -> Callable[[Floats], Floats]:
    """Return Reinhard's global operator (SIGGRAPH 2002) with a white point, for an sRGB screen. The
    geometric mean of `relative` light, without zeros, becomes a middle grey."""
    lit = relative[relative > 0]
    scale = _KEY / float(np.exp(np.mean(np.log(lit)))) if lit.size else 1.0

    def curve(light: Floats) -> Floats:
        """Return light divided by white on the screen's scale, with highlights compressed (Reinhard
        et al. 2002)."""
        bright = light * scale
        return srgb_of_linear(bright * (1.0 + bright / scale**2) / (1.0 + bright))

    return curve


def _mu_law(_relative: Floats) -> Callable[[Floats], Floats]:
    """Return log(1 + 5000 x) / log 5001, the curve of PSNR-mu."""
    return lambda light: np.log1p(5000.0 * np.minimum(light, 1.0)) / np.log1p(5000.0)


TONES: dict[str, Callable[[Floats], Callable[[Floats], Floats]]] = {
    "log": _logarithmic,
    "reinhard": _reinhard,
    "mu-law": _mu_law,
    "srgb": lambda _relative: srgb_of_linear,
    "linear": lambda _relative: lambda light: light,
}
"""Functions by name that fit a curve to light divided by white."""
