"""Noise of the photodiode's reads and resets, and its full well."""

from __future__ import annotations

from math import sqrt

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects.effect import Contribution, Effect

READ = Effect(
    name="read",
    stream=4,
    kind="random",
    title="read noise of PIX",
    model="Every word that reads PIX finds it off by sigma z. The reads of a frame are normal "
    "numbers whose weighted sum in each bucket is one keyed draw (see the package's notes).",
    contribution="rms = sigma sqrt(reads), reads weighted with their squared coefficients: a "
    "reset level that is subtracted k times counts k^2",
    parameters=("read_noise_e",),
    cost="one normal number a pixel and bucket; the reference adds one a read",
    applied="to PIX as a source of an analog word",
    predict=lambda scene, sensor: Contribution(sensor.read_noise_e * sqrt(scene.reads)),
)

RESET = Effect(
    name="reset",
    stream=5,
    kind="random",
    title="reset (kTC) noise of PIX",
    model="Every reset leaves PIX off by sigma z until the next one. What is read twice without "
    "a reset in between and subtracted is free of it.",
    contribution="rms = sigma sqrt(resets), resets weighted with their squared coefficients",
    parameters=("reset_noise_e",),
    cost="one normal number a pixel and bucket; the reference adds one a reset",
    applied="to PIX by every rpix",
    predict=lambda scene, sensor: Contribution(sensor.reset_noise_e * sqrt(scene.resets)),
)

FULL_WELL = Effect(
    name="full_well",
    stream=6,
    kind="fixed",
    title="saturation of PIX",
    model="PIX holds min(charge since the last reset, full well), whether the shutter is open or "
    "not, dark charge included.",
    contribution="rms and mean of the charge that is lost",
    parameters=("full_well_e",),
    cost="none where the whole frame's charge stays below the well; else a slot loop",
    applied="to PIX whenever charge falls on it",
    predict=lambda scene, sensor: Contribution(scene.rms_well_loss_e, -scene.mean_well_loss_e),
)


def held(charge: NDArray[np.float64], full_well_e: float) -> NDArray[np.float64]:
    """What PIX holds of a charge; NaN stays NaN."""
    return np.asarray(np.minimum(charge, full_well_e))
