"""Errors of the words that spread exposures over all converter codes."""

from __future__ import annotations

from collections.abc import Mapping

from nscc.chips.target import Target
from nscc.words.readout import SPREADING_ERRORS
from nscc_runtime.effects.adc import ELECTRONS_PER_LSB
from nscc_runtime.effects.effect import CHIP, Effect, parameter
from nscc_runtime.effects.parts import Converter


def _of_words(target: Target, values: Mapping[str, float]) -> float:
    """Return the noise of spreading in converter codes, which follows from the noise of words; 0 on
    chips that do not spread."""
    spreads = target.spread_level is not None
    word_e = values["analog_noise_lsb"] * values["analog_lsb_e"]
    return word_e / values["electrons_per_lsb"] * SPREADING_ERRORS**0.5 if spreads else 0.0


SIGMA = parameter(
    "spread_noise_lsb",
    "readout",
    _of_words,
    "lsb",
    0,
    1e6,
    "random error of the words that make 2 x exposure - full well before readout",
    f"{CHIP}: three additions, on twice the exposure; nothing where the target does not spread",
    place=1,
)

SPREADING = Effect(
    name="spreading",
    stream=19,
    kind="after",
    title="errors of the words that spread exposures over all codes",
    model="A code is rounded from exposure / electrons_per_lsb + sigma z, sigma in codes; the "
    "exposure itself does not have it. What the mean errors and the gain of these words do to all "
    "codes is part of adc_offset_lsb and electrons_per_lsb.",
    cost="none: it is drawn together with adc_noise",
    applied="to `frame` before rounding",
    absent="exposures are converted as they are, or their words make no error",
    parameters=(SIGMA, ELECTRONS_PER_LSB),
    reference={"converter": SIGMA},
    size="rms = sigma electrons_per_lsb, in `frame` only",
    sums=(Converter(SIGMA),),
)
