"""The ADC: temporal noise of the readout, then rounding and clipping."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects.effect import Contribution, Effect
from nscc_runtime.noise import key, normals
from nscc_runtime.sensor.sensor import Sensor

ADC_NOISE = Effect(
    name="adc_noise",
    stream=15,
    kind="after",
    title="temporal noise of the readout",
    model="A code is rounded from exposure / electrons_per_lsb + sigma z, sigma in codes; the "
    "exposure itself does not have it.",
    contribution="rms = sigma electrons_per_lsb, in `frame` only",
    parameters=("adc_noise_lsb", "electrons_per_lsb"),
    cost="one normal number a pixel and bucket",
    applied="to `frame` before rounding",
    predict=lambda scene, sensor: Contribution(sensor.adc_noise_lsb * sensor.electrons_per_lsb),
)

ADC = Effect(
    name="adc",
    stream=16,
    kind="after",
    title="quantisation and clipping of the ADC",
    model="code = clip(round half to even(exposure / electrons_per_lsb) + offset, 0, top code); "
    "what is no number reads 0 and is not valid.",
    contribution="rms = electrons_per_lsb / sqrt(12) where the noise before it is 0.5 codes or "
    "more; in `frame` only",
    parameters=("electrons_per_lsb", "adc_offset_lsb"),
    cost="one rounding a pixel and bucket",
    applied="to `frame`, always",
    predict=lambda scene, sensor: Contribution(sensor.electrons_per_lsb / 12**0.5),
    always=True,
)


def noise_lsb(
    sensor: Sensor, seed: int, frame: int, bucket: int, pixels: NDArray[np.int64]
) -> NDArray[np.float64]:
    """The readout's noise in codes at each pixel."""
    stream = key(seed, ADC_NOISE.stream, frame=frame, group=bucket)
    return sensor.adc_noise_lsb * normals(stream, pixels)
