"""Temporal noise of the readout."""

from __future__ import annotations

from nscc_runtime.effects.adc import ELECTRONS_PER_LSB
from nscc_runtime.effects.effect import CHIP, Effect, InLoop, parameter
from nscc_runtime.effects.parts import Converter

SIGMA = parameter(
    "adc_noise_lsb",
    "readout",
    0.65,
    "lsb",
    0,
    1e6,
    "temporal noise of the readout",
    f"{CHIP}; the scamp5c project's noise model has the same",
    place=1,
)


ADC_NOISE = Effect(
    name="adc_noise",
    stream=15,
    kind="after",
    title="temporal noise of the readout",
    model="A code is rounded from exposure / electrons_per_lsb + sigma z, sigma in codes; the "
    "exposure itself does not have it.",
    cost="one normal number a pixel and bucket",
    applied="to `frame` before rounding",
    absent="this sensor has none",
    parameters=(SIGMA, ELECTRONS_PER_LSB),
    reference={"converter": SIGMA},
    size="rms = sigma electrons_per_lsb, in `frame` only",
    sums=(Converter(SIGMA),),
    words=InLoop(),
)
