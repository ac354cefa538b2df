"""Dark current, its spread over the pixels and its shot noise."""

from __future__ import annotations

from math import sqrt

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects.effect import Contribution, Effect, Statistics, quadrature
from nscc_runtime.noise import key, normals
from nscc_runtime.sensor.sensor import Sensor


def _predict(scene: Statistics, sensor: Sensor) -> Contribution:
    current, spread = sensor.dark_current_e_per_s, sensor.dark_spread_fraction
    rms = quadrature(
        current * scene.rms_open_s,
        spread * current * scene.rms_open_s,
        sqrt(current * scene.open_s),
    )
    return Contribution(rms, current * scene.open_s)


DARK = Effect(
    name="dark",
    stream=3,
    kind="both",
    title="dark current, its spread and its shot noise",
    model="Charge falls on PIX without light, D electrons a second in the mean. Each pixel has "
    "D exp(s z - s^2/2), s^2 = ln(1 + d^2), z a standard normal number of the device: "
    "lognormal with mean D and standard deviation d D. It is counted as light is, in counts "
    "of its own.",
    contribution="bias = D T; rms = sqrt((D T)^2 + (d D T)^2 + D T), T the open time",
    parameters=("dark_current_e_per_s", "dark_spread_fraction"),
    cost="one Poisson number a pixel and group of slots",
    applied="with the light of every slot, open or not",
    predict=_predict,
)


def current_e_per_s(
    sensor: Sensor, device_seed: int, pixels: NDArray[np.int64]
) -> NDArray[np.float64]:
    """The dark current of each pixel."""
    return sensor.dark_current_e_per_s * spread(
        sensor.dark_spread_fraction, normals(key(device_seed, DARK.stream), pixels)
    )


def spread(fraction: float, z: NDArray[np.float64]) -> NDArray[np.float64]:
    """Positive factors with mean 1 and standard deviation `fraction` from normal numbers."""
    variance = np.log1p(fraction * fraction)
    return np.asarray(np.exp(np.sqrt(variance) * z - variance / 2))
