"""Errors of analog words."""

from __future__ import annotations

import numpy as np

from nscc_runtime.effects.adc import ELECTRONS_PER_LSB
from nscc_runtime.effects.effect import Effect, InLoop
from nscc_runtime.effects.parameters import Parameter, parameter
from nscc_runtime.effects.parts import Errors, OfSensor, WordGain
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Pixels, Places, Values, Word
from nscc_runtime.noise import key, normals

_MEASURED = "fit to the errors of a 9-word kernel measured by Guillard 2019"
GAIN = parameter(
    "analog_gain", "analog", 0.996, "1/word", 0.5, 1.5, "gain of one analog word", _MEASURED
)
NOISE = parameter(
    "analog_noise_lsb", "analog", 0.75, "lsb/sqrt(word)", 0, 1e6, "random error of one analog word",
    _MEASURED,
)  # fmt: skip
PATTERN = parameter(
    "analog_pattern_lsb", "analog", 0.030, "lsb/word", 0, 1e6,
    "standard deviation over the pixels of a word's fixed error", _MEASURED,
)  # fmt: skip
BIAS = parameter(
    "analog_bias_lsb", "analog", 0.42, "lsb/word", -1e6, 1e6, "mean error of one analog word",
    "3.75 codes a 9-word kernel, Guillard 2019",
)  # fmt: skip


def _in_electrons(codes: Parameter) -> OfSensor:
    return lambda sensor: codes(sensor) * ELECTRONS_PER_LSB(sensor)


_noise, _spread, _bias = map(_in_electrons, (NOISE, PATTERN, BIAS))


def pattern_e(sensor: Sensor, device_seed: int, pixels: Places) -> Values:
    """Return the fixed error (pixels,) of an analog word in electrons, including the bias."""
    z = normals(key(device_seed, ANALOG.stream), pixels)
    return np.asarray(_bias(sensor) + _spread(sensor) * z)


def _written(pixels: Pixels, value: Values, word: Word, destination: int, sign: float) -> Values:
    random = _noise(pixels.sensor) * pixels.error("analog", word, destination)
    return GAIN(pixels.sensor) * value + sign * (pixels.fixed(pattern_e) + random)


ANALOG = Effect(
    name="analog",
    stream=7,
    kind="both",
    title="errors of analog words",
    model="A word with the exact result r leaves g r + e, e = bias + pattern z_pixel + sigma z. "
    "Sign: e is added after undoing the inversion, so a word that writes the scratch register, "
    "which holds inverted values, leaves g r - e; constant offsets of a pair of words add up.",
    cost="a table for each code, one normal number a pixel and bucket for all words; one a word "
    "near saturation",
    applied="to every bus word, before the register saturates",
    absent="this sensor has none",
    parameters=(GAIN, NOISE, PATTERN, BIAS, ELECTRONS_PER_LSB),
    reference={"words": _written},
    size="bias = mean of (b + pattern) sum c - gain loss, rms = sqrt(mean of its square + "
    "sigma^2 sum c^2), c the words' signed coefficients",
    sums=(WordGain(GAIN, pattern_e, _bias, _spread), Errors("words", _noise)),
    words=InLoop(
        "word_errors",
        {"gain": GAIN, "word_error": _noise},
        {"error_e": pattern_e},
    ),
    cost_ns=3.0,
)
