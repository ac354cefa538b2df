"""The ADC: quantisation and clipping, and the temporal noise of the readout."""

from __future__ import annotations

from collections.abc import Mapping

from nscc.arrays import Bytes, Floats
from nscc.chips.target import Target
from nscc_runtime.effects.effect import CHIP, MOST_E, TARGET, Effect, Mark, parameter
from nscc_runtime.effects.parts import Codes, Converter
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.readout_loop import ReadoutErrors, codes_and_errors


def _of_all_codes(target: Target, values: Mapping[str, float]) -> float:
    """Return the electrons of one converter code if a full well takes all codes."""
    return values["full_well_e"] * target.wells_read / ((1 << target.adc_bits) - 1)


def _zero(target: Target, _values: Mapping[str, float]) -> float:
    """Return the converter code of a pixel without charge."""
    return target.zero_lsb


ELECTRONS_PER_LSB = parameter(
    "electrons_per_lsb",
    "readout",
    _of_all_codes,
    "e/lsb",
    0,
    MOST_E,
    "electrons a code of the ADC",
    "full_well_e over the top code",
    low_excluded=True,
)
OFFSET = parameter(
    "adc_offset_lsb",
    "readout",
    _zero,
    "lsb",
    -65536,
    65536,
    "code of a register that holds nothing",
    TARGET,
)
NOISE = parameter(
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


def _codes(
    sensor: Sensor, exposure: Floats, noise: ReadoutErrors | Floats | float, top: int
) -> Bytes:
    """Return converter codes 0..`top`, at most 255, of exposures in electrons; 0 for NaN. `noise`:
    codes added before rounding, an array like `exposure` or one number, or errors to be drawn for
    exposures (buckets, rows, cols)."""
    scale = ELECTRONS_PER_LSB(sensor), OFFSET(sensor), top
    return codes_and_errors(exposure, noise, scale)[0]


ADC = Effect(
    name="adc",
    stream=16,
    kind="after",
    title="quantisation and clipping of the ADC",
    model="code = clip(round half to even(exposure / electrons_per_lsb) + offset, 0, top code); "
    "what is no number reads 0 and is not valid.",
    cost="one rounding a pixel and bucket",
    applied="to `frame`, always",
    absent="it is always there",
    parameters=(ELECTRONS_PER_LSB, OFFSET),
    reference={"codes": _codes},
    size="rms = electrons_per_lsb / sqrt(12) where the noise before it is 0.5 codes or more; "
    "in `frame` only",
    sums=(Codes(ELECTRONS_PER_LSB),),
    always=True,
    marks={"codes": Mark(bit=4, name="converter")},
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
    parameters=(NOISE, ELECTRONS_PER_LSB),
    reference={"converter": NOISE},
    size="rms = sigma electrons_per_lsb, in `frame` only",
    sums=(Converter(NOISE),),
)
