"""Errors of analog words.

A word adds if it reads two sources or more; it moves if it reads one, or loads a constant. Frames
of a chip show that additions and moves differ (docs/silicon.md)."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from nscc.arrays import Floats
from nscc.chips.target import Target
from nscc_runtime.effects.effect import (
    CHIP,
    MOST_E,
    PUBLISHED,
    Effect,
    InLoop,
    Parameter,
    parameter,
)
from nscc_runtime.effects.parts import Errors, OfSensor, WordGain
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Pixels, Places, Word
from nscc_runtime.noise import key, normals


def _full_range_code(_target: Target, values: Mapping[str, float]) -> float:
    """Return the electrons of one step (lsb) in which errors of analog words are stated; 255 steps
    span two full wells."""
    return 2.0 * values["full_well_e"] / 255.0


GAIN = parameter("analog_gain", "analog", 0.977, "1/word", 0.5, 1.5, "gain of an addition", CHIP)
MOVE_LOSS = parameter(
    "analog_move_loss",
    "analog",
    lambda target, _values: target.analog_move_loss,
    "1",
    0,
    1,
    "1 - gain of a move, as a part of 1 - gain of an addition",
    CHIP,
)
NOISE = parameter(
    "analog_noise_lsb",
    "analog",
    1.75,
    "lsb/sqrt(word)",
    0,
    1e6,
    "random error of an addition",
    CHIP,
)
MOVE_NOISE = parameter(
    "analog_move_noise",
    "analog",
    lambda target, _values: target.analog_move_noise,
    "1",
    0,
    1,
    "random error of a move, as a part of that of an addition",
    f"{CHIP}; two moves and the readout have 0.65 codes, which adc_noise_lsb holds",
)
PATTERN = parameter(
    "analog_pattern_lsb",
    "analog",
    0.030,
    "lsb/word",
    0,
    1e6,
    "standard deviation over the pixels of an addition's fixed error",
    f"{PUBLISHED}fit to the errors of a 9-word kernel measured by Guillard 2019",
)
BIAS = parameter(
    "analog_bias_lsb", "analog", 0.2, "lsb/word", -1e6, 1e6, "mean error of an addition", CHIP
)
WORD_LSB = parameter(
    "analog_lsb_e",
    "analog",
    _full_range_code,
    "e/lsb",
    0,
    MOST_E,
    "electrons of a code in which these errors are given, whatever the readout",
    "two full wells over 255 codes, in which the errors were measured",
    low_excluded=True,
)


def _in_electrons(codes: Parameter) -> OfSensor:
    """Return a function that converts a parameter in steps (lsb) of analog words, `analog_lsb_e`
    electrons each, into electrons."""
    return lambda sensor: codes(sensor) * WORD_LSB(sensor)


def _move_gain(sensor: Sensor) -> float:
    """Return the gain of a move, which loses a part of what an addition loses."""
    return 1.0 - MOVE_LOSS(sensor) * (1.0 - GAIN(sensor))


_noise, _spread, _bias = map(_in_electrons, (NOISE, PATTERN, BIAS))


def pattern_e(sensor: Sensor, device_seed: int, pixels: Places) -> Floats:
    """Return the fixed error of an addition in electrons, including the bias, (pixels,). `pixels`:
    places on the chip with the seed `device_seed`."""
    z = normals(key(device_seed, ANALOG.stream), pixels)
    return np.asarray(_bias(sensor) + _spread(sensor) * z)


def _written(pixels: Pixels, value: Floats, word: Word, destination: int, sign: float) -> Floats:
    """Return what an analog word writes to a destination instead of its exact result `value`, both
    (pixels,) in electrons.

    An addition has a gain, a fixed pattern and a random error; a move has its own gain, less noise
    and no fixed pattern. `destination`: its index in the word, which selects the random numbers.
    `sign`: -1 if its register holds inverted values, else 1."""
    sensor, sigma = pixels.sensor, _noise(pixels.sensor)
    sigma = sigma if word.adds else MOVE_NOISE(sensor) * sigma
    random = sigma * pixels.error("analog", word, destination) if sigma else 0.0
    if word.adds:
        return GAIN(sensor) * value + sign * (pixels.fixed(pattern_e) + random)
    return _move_gain(sensor) * value + sign * random


ANALOG = Effect(
    name="analog",
    stream=7,
    kind="both",
    title="errors of analog words",
    model="An addition (two sources or more) with the exact result r leaves g r + e, e = bias + "
    "pattern z_pixel + sigma z. A move has a gain and a random error of its own, and no fixed "
    "error: inversion cancels it in pairs. "
    "Sign: e is added after undoing the inversion, so a word that writes the scratch register, "
    "which holds inverted values, leaves g r - e; constant offsets of a pair of additions add up. "
    "Errors are in codes of the full range (analog_lsb_e): no word depends on a later readout.",
    cost="a table for each code, one normal number a pixel and bucket for all words; one a word "
    "near saturation",
    applied="to every bus word, before the register saturates",
    absent="this sensor has none",
    parameters=(GAIN, MOVE_LOSS, NOISE, MOVE_NOISE, PATTERN, BIAS, WORD_LSB),
    reference={"words": _written},
    size="bias = mean of (b + pattern) sum c - gain loss, rms = sqrt(mean of its square + "
    "sigma^2 sum c^2), c the additions' signed coefficients",
    sums=(
        WordGain(GAIN, _move_gain, MOVE_NOISE, pattern_e, _bias, _spread),
        Errors("words", _noise),
    ),
    words=InLoop(
        "word_errors",
        {
            "gain": GAIN,
            "move_gain": _move_gain,
            "word_error": _noise,
            "move_error": lambda sensor: MOVE_NOISE(sensor) * _noise(sensor),
        },
        {"error_e": pattern_e},
    ),
    cost_ns=3.0,
)
