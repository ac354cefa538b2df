"""Leakage of analog registers."""

from __future__ import annotations

import numpy as np

from nscc.arrays import Floats
from nscc_runtime.effects.effect import TARGET, Effect, InLoop, parameter
from nscc_runtime.effects.parts import Leak
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.spread import log_normal
from nscc_runtime.effects.views import Places
from nscc_runtime.noise import key, normals

TAU = parameter(
    "leakage_tau_s",
    "memory",
    lambda target, _values: target.leakage_tau_s,
    "s",
    0,
    1e9,
    "time constant with which an analog register loses its value",
    f"{TARGET}: not public",
    low_excluded=True,
)
SPREAD = parameter(
    "leakage_spread_fraction",
    "memory",
    0.1,
    "1",
    0,
    10,
    "standard deviation over the pixels of 1/tau, relative to the mean",
)


def leak_per_s(sensor: Sensor, device_seed: int, pixels: Places) -> Floats:
    """Return the leakage rate 1 / tau of each pixel in 1/s, (pixels,). `pixels`: places on the chip
    with the seed `device_seed`."""
    z = normals(key(device_seed, LEAKAGE.stream), pixels)
    return np.asarray(log_normal(SPREAD(sensor), z) / TAU(sensor))


LEAKAGE = Effect(
    name="leakage",
    stream=9,
    kind="fixed",
    title="leakage of analog registers",
    model="A register loses its value as exp(-age / tau) towards 0; 1 / tau has a lognormal "
    "spread over the device. Age runs from the write to the readout: bucket k is read k "
    "readouts after the frame.",
    cost="weights of age for each code; none a slot",
    applied="to every analog register at the end of each slot and before its readout",
    parameters=(TAU, SPREAD),
    reference={"hold": lambda pixels, seconds: np.exp(-pixels.fixed(leak_per_s) * seconds)},
    size="rms and mean of sum S E (1 - exp(-age / tau)), tau of each pixel, and of its counts",
    sums=(Leak(leak_per_s, TAU, SPREAD),),
    words=InLoop("leaks", patterns={"leak_per_s": leak_per_s}),
    cost_ns=5.0,
    light_ns=0.4,
)
