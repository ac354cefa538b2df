"""Photon shot noise, and the pixels' unequal response to light."""

from __future__ import annotations

from math import sqrt

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects.effect import Contribution, Effect
from nscc_runtime.noise import key, normals
from nscc_runtime.sensor.sensor import Sensor

LIGHT, DARK = 0, 1
"""Sources of charge, in the keys of counts."""
THINNED = 2
"""Added to a source: the key with which its counts are spread over the slots of a group."""

SHOT = Effect(
    name="shot",
    stream=1,
    kind="random",
    title="photon shot noise",
    model="The light of a slot is counted in whole electrons: count ~ Poisson(rate), rate the "
    "slot's electrons. One count a pixel, source and group of slots (those open in the same "
    "buckets), Poisson(sum of rates), is spread over the group's slots by binomial thinning.",
    contribution="rms = sqrt(mean L)",
    parameters=(),
    cost="one Poisson number a pixel and group of slots; the reference adds one binomial a slot",
    applied="when the charge of the slots is drawn, before it falls on PIX",
    predict=lambda scene, sensor: Contribution(sqrt(scene.mean_e)),
)

PRNU = Effect(
    name="prnu",
    stream=2,
    kind="fixed",
    title="photo-response non-uniformity",
    model="Each pixel turns light into electrons with a factor of its own: max(0, 1 + p z), z a "
    "standard normal number of the device.",
    contribution="rms = p rms(L)",
    parameters=("prnu_fraction",),
    cost="one product a pixel",
    applied="to the light of every slot, before it is counted",
    predict=lambda scene, sensor: Contribution(sensor.prnu_fraction * scene.rms_e),
)


def response(sensor: Sensor, device_seed: int, pixels: NDArray[np.int64]) -> NDArray[np.float64]:
    """The factor of each pixel."""
    z = normals(key(device_seed, PRNU.stream), pixels)
    return np.asarray(np.maximum(1.0 + sensor.prnu_fraction * z, 0.0))


def count_key(seed: int, effect: Effect, source: int, frame: int, group: int) -> np.uint64:
    """The key of the counts of a group of slots."""
    return key(seed, effect.stream, source, frame, group)


def thinning_key(seed: int, effect: Effect, source: int, frame: int, group: int) -> np.uint64:
    """The key with which these counts are spread over the slots of the group."""
    return key(seed, effect.stream, THINNED + source, frame, group)
