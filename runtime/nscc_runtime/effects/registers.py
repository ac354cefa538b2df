"""Analog registers: errors of words, soft saturation, leakage."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects.dark import spread
from nscc_runtime.effects.effect import Contribution, Effect, Statistics, quadrature
from nscc_runtime.noise import key, normals
from nscc_runtime.sensor.sensor import Sensor


def _analog(scene: Statistics, sensor: Sensor) -> Contribution:
    bias = sensor.analog_bias_e * scene.word_sum - scene.mean_gain_loss_e
    rms = quadrature(
        scene.rms_gain_loss_e,
        sensor.analog_bias_e * scene.word_sum_rms,
        sensor.analog_pattern_e * scene.word_sum_rms,
        sensor.analog_noise_e * scene.words**0.5,
    )
    return Contribution(rms, bias)


ANALOG = Effect(
    name="analog",
    stream=7,
    kind="both",
    title="errors of analog words",
    model="A word with the exact result r leaves g r + e, e = bias + pattern z_pixel + sigma z. "
    "Sign: e is added after undoing the inversion, so a word that writes the scratch register, "
    "which holds inverted values, leaves g r - e; constant offsets of a pair of words add up.",
    contribution="bias = b sum c - gain loss; rms = sqrt(gain loss^2 + (b sum c)^2 + "
    "(pattern sum c)^2 + sigma^2 sum c^2), c the words' signed coefficients",
    parameters=(
        "analog_gain",
        "analog_noise_lsb",
        "analog_pattern_lsb",
        "analog_bias_lsb",
        "electrons_per_lsb",
    ),
    cost="a table for each code, one normal number a pixel and bucket; the reference adds one a "
    "word",
    applied="to every bus word, before the register saturates",
    predict=_analog,
)

REGISTER = Effect(
    name="register",
    stream=8,
    kind="fixed",
    title="soft saturation of analog registers",
    model="A register is linear up to k M and holds M (k + (1 - k) tanh((v / M - k) / (1 - k))) "
    "beyond, M its largest value; the same below 0.",
    contribution="rms and mean of what is lost by the largest partial sums",
    parameters=("register_min_e", "register_max_e", "register_knee_fraction"),
    cost="none where no partial sum passes the knee; else a slot loop",
    applied="to every result of a bus word",
    predict=lambda scene, sensor: Contribution(
        scene.rms_register_loss_e, -scene.mean_register_loss_e
    ),
)

LEAKAGE = Effect(
    name="leakage",
    stream=9,
    kind="fixed",
    title="leakage of analog registers",
    model="A register loses its value as exp(-age / tau) towards 0; 1 / tau has a lognormal "
    "spread over the device. Age runs from the write to the readout: bucket k is read k "
    "readouts after the frame.",
    contribution="rms and mean of sum S E (1 - exp(-age / tau))",
    parameters=("leakage_tau_s", "leakage_spread_fraction"),
    cost="weights of age for each code; none a slot",
    applied="to every analog register at the end of each slot and before its readout",
    predict=lambda scene, sensor: Contribution(scene.rms_leaked_e, -scene.mean_leaked_e),
)


def soft(value: NDArray[np.float64], sensor: Sensor) -> NDArray[np.float64]:
    """What a register holds when `value` is written to it; exactly `value` up to the knee."""
    knee = sensor.register_knee_fraction
    limit = np.where(value < 0, -sensor.register_min_e, sensor.register_max_e)
    size = np.abs(value)
    if knee == 1.0:
        return np.asarray(np.where(size > limit, np.copysign(limit, value), value))
    room = (1.0 - knee) * limit
    bent = knee * limit + room * np.tanh(np.maximum(size - knee * limit, 0.0) / room)
    return np.asarray(np.where(size > knee * limit, np.copysign(bent, value), value))


def pattern_e(sensor: Sensor, device_seed: int, pixels: NDArray[np.int64]) -> NDArray[np.float64]:
    """The fixed error of one analog word at each pixel, bias included."""
    z = normals(key(device_seed, ANALOG.stream), pixels)
    return np.asarray(sensor.analog_bias_e + sensor.analog_pattern_e * z)


def leak_per_s(sensor: Sensor, device_seed: int, pixels: NDArray[np.int64]) -> NDArray[np.float64]:
    """1 / tau of each pixel."""
    z = normals(key(device_seed, LEAKAGE.stream), pixels)
    return np.asarray(spread(sensor.leakage_spread_fraction, z) / sensor.leakage_tau_s)
