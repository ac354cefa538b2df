"""Estimators of the noise of a chip's output, for codes of frames or for sums of such codes.

The frames hold a square with out_i * x + out_h * h, two kernels of 5 x 5 signs on bits, and a
region whose register was loaded with 0. Without the bits of h, the noise follows from the spectrum
of the square: the kernels shape the spectra of x and h, and what is left is white.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter
from scipy.optimize import least_squares, nnls

Array = NDArray[np.float64]

SIGNS_X = np.array(
    [[1, 1, -1, 1, -1], [-1, 1, -1, 1, -1], [-1, 1, 1, 1, -1], [1, 1, 1, -1, 1], [1, -1, 1, -1, 1]]
)
SIGNS_H = np.array(
    [[1, -1, -1, 1, -1], [1, 1, 1, 1, 1], [1, 1, -1, 1, -1], [1, -1, -1, 1, -1], [1, 1, 1, 1, -1]]
)
ORDER = np.array([[(4 - row) * 5 + col for col in range(5)] for row in range(5)])
"""The place of each tap in the order of execution: the last row of a kernel comes first."""
SIDE = 64
_INNER = slice(8, SIDE - 8)
_WINDOW = np.outer(np.hanning(SIDE - 4), np.hanning(SIDE - 4))
_RADIUS = np.hypot(np.fft.fftfreq(SIDE)[:, None], np.fft.rfftfreq(SIDE)[None])
_BAND = (_RADIUS > 0.22) & (_RADIUS < 0.6)
_LAGS = 6
_RESAMPLES = 200


def square_sums(square: Array, bits: Array) -> dict[str, Array]:
    """Return the sums that `figures` needs of the codes of a square (frames, 64, 64).

    `bits` (frames, 64, 64): x of the same frames, -1 or 1."""
    bits = bits - bits.mean(0)
    taps = np.stack(
        [np.roll(bits, (-y, -x), (1, 2)) for y in range(-2, 3) for x in range(-2, 3)], -1
    )[:, _INNER, _INNER].reshape(len(square), -1, ORDER.size)
    moving = square - square.mean(0)
    codes = moving[:, _INNER, _INNER].reshape(len(square), -1)
    windowed = moving[:, 2:-2, 2:-2]
    windowed = (windowed - windowed.mean((1, 2), keepdims=True)) * _WINDOW
    power = np.abs(np.fft.rfft2(windowed, s=(SIDE, SIDE))) ** 2
    counts = np.bincount(square[:, _INNER, _INNER].astype(int).ravel(), minlength=256)
    return {
        "gram": np.einsum("npi,npj->nij", taps, taps),
        "cross": np.einsum("npi,np->ni", taps, codes),
        "spectrum": power.mean(0) / (_WINDOW**2).sum(),
        "codes_of_square": counts,
    }


def zero_figures(zero: Array) -> dict[str, Array]:
    """Return the figures of a register loaded with 0, from its codes (frames, rows, cols)."""
    mean = zero.mean(0)
    moving = zero - mean
    moving -= moving.mean((1, 2), keepdims=True)
    pixels = (mean - gaussian_filter(mean, 8))[8:-8, 8:-8]
    lags = [1.0, *((moving[:, k:] * moving[:, :-k]).mean() for k in range(1, _LAGS))]
    return {
        "zero_temporal_std": moving.std(),
        "zero_fixed_pixel_std": pixels.std(),
        "zero_fixed_total_std": mean.std(),
        "row_temporal_std": moving.mean(2).std(),
        "column_temporal_std": moving.mean(1).std(),
        "vertical_lags": np.array(lags) / np.array([1.0, *[moving.var()] * (_LAGS - 1)]),
        "zero_frame_level_std": zero.mean((1, 2)).std(ddof=1),
    }


def _kernel_power(signs: NDArray[np.int64], gain: float) -> Array:
    """Return the power spectrum of a kernel whose taps lose `gain` at each later tap."""
    kernel = np.zeros((SIDE, SIDE))
    kernel[:5, :5] = signs * gain ** (ORDER.size - 1 - ORDER)
    return np.asarray(np.abs(np.fft.rfft2(kernel)) ** 2)


def white_part(spectrum: Array) -> tuple[float, float]:
    """Return the white part of a spectrum in square codes, and the growth a step that fits best."""
    codes, fits = spectrum[_BAND], []
    for gain in np.arange(0.94, 1.0101, 0.0025):
        powers = [_kernel_power(signs, gain)[_BAND] for signs in (SIGNS_X, SIGNS_H)]
        shapes = np.stack([*powers, np.ones(len(codes))], 1)
        amounts, error = nnls(shapes / codes[:, None], np.ones(len(codes)))
        fits.append((error, amounts[2], gain))
    _, white, gain = min(fits)
    return float(white), float(1 / gain - 1)


def tap_growth(gram: Array, cross: Array) -> tuple[float, float, float]:
    """Return the last step in codes, the growth a step in the order of execution, and an offset
    that all taps have in common, by generalised least squares."""
    total = gram.sum(0)
    taps, root = np.linalg.solve(total, cross.sum(0)), np.linalg.cholesky(total).T

    def misfit(values: Array) -> Array:
        last, slope, offset = values
        model = SIGNS_X * last * np.exp(slope * (ORDER.size - 1 - ORDER)) + offset
        return np.asarray(root @ (model.ravel() - taps))

    last, slope, offset = least_squares(misfit, (6.0, -0.02, 0.3)).x
    return float(last), float(np.exp(-slope) - 1), float(offset)


def figures(sums: dict[str, Array]) -> dict[str, tuple[float, float]]:
    """Return each figure with its standard error; 0 where the sums do not give one."""
    gram, cross, codes = (np.asarray(sums[name]) for name in ("gram", "cross", "codes_of_square"))
    draw = np.random.default_rng(0).integers(0, len(gram), (_RESAMPLES, len(gram)))
    errors = np.std([tap_growth(gram[chosen], cross[chosen]) for chosen in draw], axis=0)
    regression = zip(tap_growth(gram, cross), errors, strict=True)
    names = "last step, codes", "growth a step, regression", "common offset, codes"
    white, growth = white_part(np.asarray(sums["spectrum"]))
    temporal = float(sums["zero_temporal_std"])
    plain = {
        "growth a step, spectrum": growth,
        "white part, codes^2": white,
        "clipped low": codes[0] / codes.sum(),
        "clipped high": codes[-1] / codes.sum(),
        "mean of the square, codes": codes @ np.arange(256) / codes.sum(),
        "temporal std at zero, codes": max(temporal**2 - 1 / 12, 0.0) ** 0.5,
        "fixed pattern of pixels, codes": float(sums["zero_fixed_pixel_std"]),
        "fixed pattern in all, codes": float(sums["zero_fixed_total_std"]),
        "temporal std of rows, codes": float(sums["row_temporal_std"]),
        "temporal std of columns, codes": float(sums["column_temporal_std"]),
        "frame level, codes": float(sums["zero_frame_level_std"]),
    }
    lags = np.asarray(sums["vertical_lags"])
    plain |= {f"correlation down columns, lag {k}": float(lags[k]) for k in range(1, _LAGS)}
    return dict(zip(names, regression, strict=True)) | {
        name: (value, 0.0) for name, value in plain.items()
    }
