"""Choose the parameters of a sensor file from a calibration.

Photon transfer measures whole frames instead of the components of the sensor model. Noise of reads,
resets, words and ADC is measured as one (`read_noise_e`), gain of words and ADC as one
(`electrons_per_lsb`). The other components of such a sum are set to 0 so that they do not count
twice."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import sqrt
from typing import Literal

from nscc.chips.target import Target
from nscc.words.container import Container
from nscc_runtime.calibrate.estimate import Calibration, Quantity
from nscc_runtime.sensor import Sensor, completed, schema

Status = Literal["measured", "bound", "given", "contained", "default"]
_NO_PART = 1e-9
"""Factors of `Chain` below this are 0 but for rounding."""

_TAKEN = {
    "electrons_per_lsb": "conversion_gain",
    "crosstalk_fraction": "crosstalk",
    "prnu_fraction": "prnu",
    "dark_current_e_per_s": "dark_current",
    "dark_spread_fraction": "dark_spread",
}
"""The measured quantity that equals each of these parameters."""
_SOURCES = _TAKEN | {
    "read_noise_e": "dark_noise_e",
    "adc_pattern_lsb": "dsnu_lsb",
    "analog_bias_lsb": "offset",
    "adc_offset_lsb": "offset",
    "analog_noise_lsb": "dark_noise_e",
    "adc_noise_lsb": "dark_noise_e",
    "spread_noise_lsb": "dark_noise_e",
    "full_well_e": "full_well",
}
"""The measured quantity to which each parameter is related."""


@dataclass(frozen=True)
class ParameterChoice:
    """The value of a parameter and its source.

    `status`: "measured" with a standard error, from a "bound", "given" by the user, "contained" in
    another parameter, or "default". `remark`: the reason."""

    value: float
    se: float | None
    status: Status
    remark: str


def parameters(
    calibration: Calibration, target: Target, chain: Chain
) -> dict[str, ParameterChoice]:
    """Return a value for every parameter of a sensor file, by name in the order of the schema:
    measured by `calibration`, bounded, or the default of `target`.

    `chain` tells how often a frame reads, resets and runs words, so that noise of frames can be
    attributed to them."""
    quantity = calibration.quantities
    chosen: dict[str, ParameterChoice] = {}
    _contain(chosen, "analog_gain", 1.0, "electrons_per_lsb")
    for name, source in _TAKEN.items():
        _take(chosen, name, quantity[source])
    if "electrons_per_lsb" in chosen:  # frames give errors of words in codes of their converter
        chosen["analog_lsb_e"] = chosen["electrons_per_lsb"]
    _noise(chosen, quantity["dark_noise_e"], chain)
    _pattern(chosen, quantity, chain)
    _range(chosen, quantity["full_well"], target)

    plain = completed({name: choice.value for name, choice in chosen.items()}, target)
    for name, row in schema().by_path.items():
        if name not in chosen:
            reason = _unknown(name, quantity)
            remark = f"not measured: {reason}; {row.source}"
            chosen[name] = ParameterChoice(getattr(plain, name), None, "default", remark)
    return {name: _rounded(chosen[name]) for name in schema().by_path}


def sensor_of(chosen: Mapping[str, ParameterChoice]) -> Sensor:
    """Return the sensor with the `chosen` parameters, which must be all, by name."""
    return Sensor({name: choice.value for name, choice in chosen.items()})


def _take(chosen: dict[str, ParameterChoice], name: str, quantity: Quantity) -> None:
    """Store `quantity` in `chosen`, by parameter, as the parameter `name` if it was measured, given
    or bounded above. Change nothing if it is unknown or bounded below."""
    kinds: dict[str, Status] = {"measured": "measured", "at most": "bound", "given": "given"}
    if quantity.value is not None and quantity.known in kinds:
        prefix = "" if quantity.known == "measured" else f"{quantity.known}: "
        remark = prefix + quantity.remark
        chosen[name] = ParameterChoice(quantity.value, quantity.se, kinds[quantity.known], remark)


def _contain(
    chosen: dict[str, ParameterChoice], name: str, value: float, sum_parameter: str
) -> None:
    """Set the parameter `name` in `chosen`, in place, to `value`. Frames show its effect only
    together with others, in the parameter `sum_parameter`, which the remark names."""
    remark = f"part of {sum_parameter}: frames show only the sum"
    chosen[name] = ParameterChoice(value, None, "contained", remark)


def _noise(chosen: dict[str, ParameterChoice], noise: Quantity, chain: Chain) -> None:
    """Set the noise of one read in `chosen`, in place, from `noise`, the temporal noise of dark
    frames in electrons, which contains that of `chain.reads` reads. Other noises that dark frames
    contain become 0, because frames show only the sum.

    Change nothing if the noise is unknown or `chain.reads` is about 0."""
    if noise.value is None or chain.reads < _NO_PART:
        return
    read_factor = sqrt(chain.reads)
    value = noise.value / read_factor
    text = noise.remark if chain.reads == 1 else f"{noise.remark}; {chain.reads:.4g} reads a frame"
    if noise.known == "measured" and noise.se is not None:
        choice = ParameterChoice(value, noise.se / read_factor, "measured", text)
    else:
        choice = ParameterChoice(value, None, "bound", f"at most: {text}")
    chosen["read_noise_e"] = choice
    # A program without resets shows no noise of them: it keeps the default.
    if chain.resets > _NO_PART:
        _contain(chosen, "reset_noise_e", 0.0, "read_noise_e")
    for name in ("analog_noise_lsb", "adc_noise_lsb", "spread_noise_lsb"):
        _contain(chosen, name, 0.0, "read_noise_e")


def _pattern(
    chosen: dict[str, ParameterChoice], quantities: Mapping[str, Quantity], chain: Chain
) -> None:
    """Set the parameters of the converter code without charge and of the pixels' fixed pattern in
    `chosen`, in place. Change nothing if `offset` or `dsnu_lsb` of `quantities` (by name) is
    unknown.

    The code `offset`, rounded to a whole code, becomes the ADC's offset, which is added after
    rounding. The remainder, divided by `chain.word_sum`, becomes the error of each word. If
    `chain.word_sum` is about 0, the words cancel their errors: then all of `offset` becomes the
    ADC's offset. The pattern `dsnu_lsb` becomes the pattern of the readout."""
    offset, pattern = quantities["offset"], quantities["dsnu_lsb"]
    if offset.value is None or pattern.value is None:
        return
    # The measured pattern is the sum of several parameters; one gets all of it, the others 0.
    _take(chosen, "adc_pattern_lsb", pattern)
    for name in ("analog_pattern_lsb", "adc_smooth_lsb", "adc_level_lsb"):
        _contain(chosen, name, 0.0, "adc_pattern_lsb")
    words = abs(chain.word_sum)
    text = "" if words == 1 else f"; words that add up to {chain.word_sum:.4g}"
    # If the words cancel the offset, no part of it can come from the analog side.
    if words < _NO_PART:
        remark = f"{offset.remark}; the program's words cancel what is not whole codes"
        chosen["adc_offset_lsb"] = ParameterChoice(offset.value, offset.se, "measured", remark)
        return
    # The converter's part is whole codes; the remainder is a bias of the words before it.
    whole_codes = float(round(offset.value))
    remark = f"whole codes of {_shown(offset)}, {offset.remark}"
    chosen["adc_offset_lsb"] = ParameterChoice(whole_codes, None, "measured", remark)
    se = None if offset.se is None else offset.se / words
    bias = (offset.value - whole_codes) / chain.word_sum
    remark = f"what adc_offset_lsb leaves of {_shown(offset)}{text}"
    chosen["analog_bias_lsb"] = ParameterChoice(bias, se, "measured", remark)


def _range(chosen: dict[str, ParameterChoice], full: Quantity, target: Target) -> None:
    """Set the full well in `chosen`, in place, from `full`, in electrons. If `full` is only a lower
    limit, it is used if it is above the full well of `target`. Change nothing if it is unknown.

    The range of registers is enlarged if necessary, because words move the charge through
    registers."""
    if full.value is None:
        return
    if full.known == "measured":
        _take(chosen, "full_well_e", full)
    elif full.value > target.full_well_e:
        chosen["full_well_e"] = ParameterChoice(
            full.value, None, "bound", f"at least: {full.remark}"
        )
    for name, value in (("register_max_e", full.value), ("register_min_e", -full.value)):
        if full.value > abs(getattr(target, name)):
            remark = "at least: frames hold as much"
            chosen[name] = ParameterChoice(value, None, "bound", remark)


def _unknown(name: str, quantities: Mapping[str, Quantity]) -> str:
    """Return why the parameter `name` has no measured value, as text: the reason of the quantity
    that would give it. `quantities` are those of the calibration, by name."""
    quantity = quantities.get(_SOURCES.get(name, ""))
    if quantity is None:
        return "photon transfer does not tell"
    if quantity.known in ("at least", "at most") and quantity.value is not None:
        return f"{quantity.known} {quantity.value:.4g} {quantity.unit}, {quantity.remark}"
    if quantity.known == "measured":
        return "the program's words cancel it"
    return quantity.remark


def _shown(quantity: Quantity) -> str:
    """Return a quantity as text: value, standard error, unit."""
    error = "" if quantity.se is None else f" +- {quantity.se:.2g}"
    return f"{quantity.value:.6g}{error} {quantity.unit}"


def _rounded(choice: ParameterChoice) -> ParameterChoice:
    """Return the choice with the value rounded to six digits and the error to three, which is more
    precise than the error and equal on every machine. A default stays exact."""
    if choice.status == "default":
        return choice
    se = None if choice.se is None else float(f"{choice.se:.3g}")
    return replace(choice, value=float(f"{choice.value:.6g}"), se=se)


@dataclass(frozen=True)
class Chain:
    """The factors with which noise sources of the chip appear in an exposure.

    `reads`, `resets`: numbers of reads and resets of PIX (the photodiode), each weighted with its
    squared coefficient. `word_sum`: signed sum of the coefficients of all analog words, which
    scales errors common to all words. The default is one read and one word: sensor values then
    equal those of a frame."""

    reads: float = 1.0
    resets: float = 1.0
    word_sum: float = 1.0

    @classmethod
    def of(cls, container: Container) -> Chain:
        """Return the factors of the program in `container`, from its words, as the mean over the
        codes in use.

        The program must open all pixels alike. Raises Rejected like
        `nscc_runtime.reference.trace.analog_words`."""
        import numpy as np

        from nscc_runtime.reference.trace import analog_words
        from nscc_runtime.reference.weights import backward

        weights = backward(container, analog_words(container))
        lanes = np.arange(len(container.encoding))
        if container.pixel_codes is not None:
            lanes = np.unique(container.table.shutter_of_code[container.pixel_codes])

        reads, resets = weights.variance("reads"), weights.variance("resets")
        sums = (reads, resets, weights.error_sum)
        return cls(*(float(per_shutter[lanes, 0].mean()) for per_shutter in sums))
