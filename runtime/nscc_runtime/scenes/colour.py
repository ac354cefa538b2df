"""Convert stored pictures to luminance: white level, transfer curve, weights of colours."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from nscc.arrays import Array, Floats
from nscc_runtime.scene_settings import Transfer

CURVES = {
    "linear": "no curve",
    "srgb": "the sRGB curve",
    "pq": "the PQ curve (SMPTE ST 2084)",
    "hlg": "the HLG curve (ITU-R BT.2100)",
}
"""Descriptions of the transfer curves in messages."""

Weights = tuple[float, float, float]
LUMINANCE: Weights = (0.2126, 0.7152, 0.0722)
"""Weights of linear red, green and blue (Rec. 709 primaries)."""

_STRIP_SAMPLES = 1 << 22
"""Number of samples that are converted at a time, to limit memory in double precision."""

Curve = Callable[[Floats], Floats]
"""A function from samples as fractions of white to linear light, where white is 1."""


@dataclass(frozen=True, eq=False)
class Colours:
    """What the samples of a picture mean.

    `curves`: one curve, of grey or of all colours, or three, of red, green and blue. `weights`: the
    luminances of linear red, green and blue. `text`: what messages call the curve. `transfer`: the
    name of the standard curve, or None if it is another one."""

    curves: tuple[Curve, ...]
    weights: Weights
    text: str
    transfer: Transfer | None = None

    @classmethod
    def of(cls, transfer: Transfer | Colours, weights: Weights = LUMINANCE) -> Colours:
        """Return the colours of the standard curve named `transfer`, with `weights` of luminance.
        Colours are returned as they are, and `weights` is then ignored."""
        if isinstance(transfer, Colours):
            return transfer
        return cls((_INVERSES[transfer],), weights, CURVES[transfer], transfer)

    def curve_of(self, channel: int) -> Curve:
        """Return the curve of the colour `channel`, 0 to 2 for red, green, blue; the only curve if
        there is one."""
        return self.curves[channel % len(self.curves)]


def luminance_weights(primaries: Sequence[float]) -> Weights:
    """Return the luminances of linear red, green, blue of a display whose white has luminance 1.

    `primaries`: CIE x and y of red, green, blue and white, eight numbers in this order (SMPTE RP
    177). Each y must not be 0. Raises numpy's LinAlgError if the three colours lie on a line."""
    x, y = np.reshape(np.asarray(primaries, np.float64), (4, 2)).T
    xyz = np.stack([x / y, np.ones(4), (1 - x - y) / y])
    red, green, blue = np.linalg.solve(xyz[:, :3], xyz[:, 3])
    return float(red), float(green), float(blue)


def white_of(dtype: np.dtype[Any]) -> float:
    """Return the default white level of samples of type `dtype`: its largest integer, or 1 for
    floats."""
    return float(np.iinfo(dtype).max) if dtype.kind in "ui" else 1.0


def linear(values: Array, colours: Transfer | Colours, white: float | None = None) -> Floats:
    """Convert stored samples of any shape to linear light, float64; white becomes 1.

    Samples are fractions of `white`, a sample above 0 (None: `white_of` their type). With three
    curves the last axis of `values` is red, green, blue. The standard curves are those of IEC
    61966-2-1 (`srgb`), SMPTE ST 2084 (`pq`) and ITU-R BT.2100 (`hlg`, the light of the scene). sRGB
    is continued beyond 0..1 by its own formulas."""
    colours = Colours.of(colours)
    if len(colours.curves) > 1:
        channels = [_on_curve(values[..., k], colours.curve_of(k), white) for k in range(3)]
        return np.stack(channels, axis=-1)
    return _on_curve(values, colours.curves[0], white)


def _on_curve(values: Array, curve: Curve, white: float | None) -> Floats:
    """Return stored `values` as linear light, where the sample `white` is 1; None for the default
    white of their type."""
    scale = white or white_of(values.dtype)
    if values.dtype == np.uint8:
        # 8 bits have 256 values: the curve is computed once for each instead of for each sample.
        table = curve(np.arange(256, dtype=np.float64) / scale)
        return table[values]
    fractions = values.astype(np.float64)
    if scale != 1:
        fractions /= scale
    return curve(fractions)


def pq_to_linear(values: Floats) -> Floats:
    """Convert PQ signals to linear light (0..1, where 1 is 10 000 cd/m2). Signals below 0 count as
    0, those above 1 as 1."""
    # Constants and formula of SMPTE ST 2084.
    m1, m2 = 2610 / 16384, 2523 / 4096 * 128
    c1, c2, c3 = 3424 / 4096, 2413 / 4096 * 32, 2392 / 4096 * 32
    power = np.clip(values, 0, 1) ** (1 / m2)
    return (np.maximum(power - c1, 0) / (c2 - c3 * power)) ** (1 / m1)


def hlg_to_linear(values: Floats) -> Floats:
    """Convert HLG signals to the linear light of the scene; 0 stays 0, 1 stays 1. Negative signals
    count as 0, those above 1 continue the curve."""
    # Constants of ITU-R BT.2100.
    a, b, c = 0.17883277, 0.28466892, 0.55991073
    signal = np.maximum(values, 0)
    # Both branches are computed for all samples: the maximum keeps `exp` in range.
    bright = (np.exp((np.maximum(signal, 0.5) - c) / a) + b) / 12
    return np.where(signal <= 0.5, signal**2 / 3, bright)


def srgb_to_linear(values: Floats) -> Floats:
    """Convert sRGB signals to linear light; 0 stays 0, 1 stays 1. Below 0.04045, also below 0, the
    curve is a straight line."""
    # The maximum keeps the base of the power positive; smaller samples take the straight line.
    curve = ((np.maximum(values, 0.04045) + 0.055) / 1.055) ** 2.4
    return np.where(values <= 0.04045, values / 12.92, curve)


_INVERSES: dict[Transfer, Curve] = {
    "linear": np.asarray,
    "srgb": srgb_to_linear,
    "pq": pq_to_linear,
    "hlg": hlg_to_linear,
}


def luminance(rgb: Floats, weights: Weights = LUMINANCE) -> Floats:
    """Return the luminance (rows, cols) of linear red, green, blue (rows, cols, 3): their sum with
    these `weights`."""
    red, green, blue = weights
    return red * rgb[..., 0] + green * rgb[..., 1] + blue * rgb[..., 2]


def grey(
    stored: Array,
    colours: Transfer | Colours,
    channel: int | None,
    white: float | None = None,
) -> Floats:
    """Return the luminance (rows, cols) of a stored picture as linear light, white = 1, or the
    light of one of its colours.

    `stored` (rows, cols) or (rows, cols, 3) are the samples of the file, `colours` the curve and
    primaries that they have. `channel` is 0, 1 or 2 for red, green or blue, and None for luminance;
    a grey picture is its own luminance and its own colours. `white` is the sample that counts as
    white, by default the largest of its type."""
    colours = Colours.of(colours)
    if stored.ndim == 2 or channel is not None:
        # A grey picture has the curve of green, should its file state three curves.
        channel = 1 if channel is None else channel
        samples = stored if stored.ndim == 2 else stored[..., channel]
        return _on_curve(samples, colours.curve_of(channel), white)
    light = np.empty(stored.shape[:2])
    step = max(1, _STRIP_SAMPLES // max(1, stored[:1].size))
    for first in range(0, len(stored), step):  # colours in float64 take eight times a picture
        strip = np.ascontiguousarray(stored[first : first + step])
        light[first : first + step] = luminance(linear(strip, colours, white), colours.weights)
    return light
