"""Effects of the readout on its codes: a fixed pattern, a level of each frame, and correlation of
noise down columns."""

from __future__ import annotations

from collections.abc import Mapping
from math import hypot

import numpy as np

from nscc.arrays import Floats
from nscc.chips.target import Target
from nscc_runtime.effects.effect import CHIP, Default, Effect, parameter
from nscc_runtime.effects.parts import CommonCode, FixedCodes, InColumns
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.noise import key, normals, uniforms


def _of_scamp(value: float) -> Default:
    """Return a parameter's default, a function of the target: `value` for chips with logic, and 0
    for others, which were not measured."""

    def default(target: Target, _values: Mapping[str, float]) -> float:
        """Return `value` on chips with logic, 0 on others; other parameters do not matter."""
        return value if target.has_logic else 0.0

    return default


PATTERN = parameter(
    "adc_pattern_lsb",
    "readout",
    _of_scamp(1.69),
    "lsb",
    0,
    1e6,
    "standard deviation over pixels of a code's fixed error, without its smooth part",
    CHIP,
    place=2,
)
SMOOTH = parameter(
    "adc_smooth_lsb",
    "readout",
    _of_scamp(2.4),
    "lsb",
    0,
    1e6,
    "standard deviation of the smooth part of this error",
    CHIP,
    place=2,
)
LEVEL = parameter(
    "adc_level_lsb",
    "readout",
    _of_scamp(0.38),
    "lsb",
    0,
    1e6,
    "standard deviation, over readouts, of an error common to all codes",
    CHIP,
    place=2,
)
COLUMNS = parameter(
    "adc_column_strength",
    "readout",
    _of_scamp(1.0),
    "1",
    0,
    1,
    "how much a code shares the noise of the codes below it: 0, not at all; 1, as the chip",
    CHIP,
    place=2,
)

_WAVES, _SHORTEST, _LONGEST = 12, 80.0, 400.0
"""Number of waves that a smooth pattern consists of, and their wavelengths in pixels."""

_SHARED = 0.776, -0.229, 0.256, 0.012, -0.312, 0.426
"""Weights of the noise of a pixel and of the five below it. With them, the codes of a register at
zero have the correlations down columns of the chip's codes: -0.31, 0.10, 0.16, -0.29 and 0.28 at
lags 1 to 5. The noise itself has 1.18 times these: rounding adds white noise to codes."""


def _pattern_lsb(sensor: Sensor, device_seed: int, shape: tuple[int, int]) -> Floats:
    """Return the fixed error of each pixel's code, in converter codes, for a chip of `shape` (rows,
    cols) with the seed `device_seed`: independent errors and smooth waves."""
    rows, cols = (np.arange(size) for size in shape)
    places = rows[:, None] * cols.size + cols
    pattern = PATTERN(sensor) * normals(key(device_seed, READOUT_PATTERN.stream), places)
    waves = np.arange(_WAVES)
    length, angle, phase = (
        uniforms(key(device_seed, READOUT_PATTERN.stream, source=1, group=group), waves)
        for group in range(3)
    )
    rate = 2 * np.pi / (_SHORTEST * (_LONGEST / _SHORTEST) ** length)
    # cos(a + b) = cos a cos b - sin a sin b: waves of an array are products of vectors.
    down = np.outer(rows, rate * np.sin(2 * np.pi * angle)) + 2 * np.pi * phase
    across = np.outer(cols, rate * np.cos(2 * np.pi * angle))
    smooth = np.cos(down) @ np.cos(across).T - np.sin(down) @ np.sin(across).T
    return np.asarray(pattern + SMOOTH(sensor) * (2.0 / _WAVES) ** 0.5 * smooth)


def _pattern_sd_lsb(sensor: Sensor) -> float:
    """Return the standard deviation over pixels of the readout's fixed pattern, in codes."""
    return hypot(PATTERN(sensor), SMOOTH(sensor))


def _weights(sensor: Sensor) -> Floats:
    """Return six weights of readout noise, (6,): of a pixel itself, then of the five pixels below
    it in its column, nearest first. Their squares add up to 1."""
    weights = np.array(_SHARED)
    weights[1:] *= COLUMNS(sensor)
    return np.asarray(weights / np.sqrt(weights @ weights))


READOUT_PATTERN = Effect(
    name="readout_pattern",
    stream=21,
    kind="after",
    title="fixed pattern of the readout",
    model="A code is rounded from exposure / electrons_per_lsb + p, p in codes, fixed for a chip: "
    "a normal number a pixel, and a sum of waves that are longer than 80 pixels.",
    cost="one addition a pixel and bucket",
    applied="to `frame` before rounding",
    absent="this sensor has none",
    parameters=(PATTERN, SMOOTH),
    reference={"pattern": _pattern_lsb},
    size="rms = sqrt(pattern^2 + smooth^2) electrons_per_lsb, in `frame` only",
    sums=(FixedCodes(_pattern_sd_lsb),),
)
READOUT_LEVEL = Effect(
    name="readout_level",
    stream=22,
    kind="after",
    title="level of a readout",
    model="All codes of a bucket are rounded from exposure / electrons_per_lsb + sigma z, with one "
    "z a readout. The chip's level drifts from frame to frame; here levels are independent.",
    cost="one normal number a bucket",
    applied="to `frame` before rounding",
    absent="this sensor has none",
    parameters=(LEVEL,),
    reference={"common": LEVEL},
    size="rms = sigma electrons_per_lsb, in `frame` only",
    sums=(CommonCode(LEVEL),),
)
COLUMN_NOISE = Effect(
    name="column_noise",
    stream=23,
    kind="after",
    title="correlation of readout noise down columns",
    model="The noise of the readout of a pixel is a weighted sum of six normal numbers: its own, "
    "and those of the five pixels below it. Its variance stays that of adc_noise and spreading.",
    cost="six products a pixel and bucket",
    applied="to the noise of `frame` before rounding",
    absent="this sensor has none",
    parameters=(COLUMNS,),
    reference={"columns": _weights},
    size="none for a single pixel: variances stay",
    sums=(InColumns(),),
)
