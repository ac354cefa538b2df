"""The mean response of a chip to steady light, from the sensor's values and a program's words.

Without saturation, a mean exposure is `zero_e` + `gain` x the light while the pixel is open. Its
variance is a constant plus the variance of the photons. All follow from the words
(`nscc_runtime.reference.weights`) and the sensor file, which `nscc calibrate` measures. Light
estimates, decode tables, calibration and the codes of full pixels are computed from them:

    response = response_of(program, sensor, taken.plan.kept)
    electrons = response.electrons(taken.frame)     # collected while pixels were open
    light = electrons / response.open_s             # electrons per second, for steady light"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from math import sqrt
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.arrays import Array, Floats
from nscc.diagnostics.diagnostic import Rejected
from nscc.words.container import Container
from nscc.words.readout import converter_of
from nscc_runtime.caches import OfContainer
from nscc_runtime.effects import Selection, everything
from nscc_runtime.effects.parts import (
    Converter,
    CountedDark,
    CountedLight,
    Errors,
    Leak,
    LitLevel,
    Part,
    SlowWords,
    WordGain,
)
from nscc_runtime.effects.parts import Response as PixelGain
from nscc_runtime.frame_file import FrameFile
from nscc_runtime.reference.trace import analog_words, retention_us
from nscc_runtime.reference.weights import Backward, WeightModel, backward
from nscc_runtime.run_kinds import KINDS
from nscc_runtime.sensor import Sensor, default_sensor

_PIXELS = np.arange(4096, dtype=np.int64)
"""Places of a chip from which means and spreads over pixels are computed."""


@dataclass(frozen=True, eq=False)
class ShutterResponse:
    """The response of the shutters of a program on a sensor; each field is float64 (shutters,
    buckets).

    `seen_s`: open time in seconds, weighted by the fraction of the light that reaches the exposure.
    The mean exposure in electrons is `bias_e` + `seen_s` x the light per second. Its variance is
    `variance_e2` plus the variance of the photons."""

    seen_s: Floats
    bias_e: Floats
    variance_e2: Floats

    @classmethod
    def of_weights(
        cls, weights: Backward, slot_s: Floats, sensor: Sensor, effects: Selection
    ) -> ShutterResponse:
        """Return the response that `weights` of slots and words cause; its rows are their lanes
        (the pixels of one distinct shutter each). `slot_s` (N,): slot lengths in seconds. Errors of
        `effects` that are off are 0."""
        seen_s = np.einsum("n,nlb->lb", slot_s, weights.slots)
        dark = effects.find_part(CountedDark)
        dark_e = seen_s * (0.0 if dark is None else float(dark.per_s(sensor, 0, _PIXELS).mean()))
        bias_e, variance_e2 = dark_e, np.maximum(dark_e, 0.0)
        words = effects.find_part(WordGain)
        if words is not None:
            bias_e = bias_e + words.mean_e(sensor) * weights.error_sum
            variance_e2 = variance_e2 + (words.spread_e(sensor) * weights.error_sum) ** 2
        for _, errors in effects.errors():
            variance_e2 = variance_e2 + errors.sigma_e(sensor) ** 2 * weights.variance(errors.at)
        return cls(seen_s, bias_e, variance_e2)

    def gain(self, open_s: Floats) -> Floats:
        """Return the fraction of the light, collected while shutters are open, that reaches the
        exposure.

        `open_s` (shutters, buckets): open times in seconds. The gain, of the same shape, is 1 for
        shutters that never open."""
        return np.divide(self.seen_s, open_s, out=np.ones(open_s.shape), where=open_s > 0)


@OfContainer
def shutter_response(container: Container, sensor: Sensor, effects: Selection) -> ShutterResponse:
    """Return the response of a program whose pixels do not look, one row for each lane (the pixels
    of one distinct shutter); cached for its arguments. Raises Rejected (NS0442) if FLAG depends on
    the light. FLAG is the bit that lets a pixel act."""
    kept_us = retention_us(effects, sensor)
    words = analog_words(container, kept_us)
    weights = backward(container, words, WeightModel.of(effects, sensor))
    return ShutterResponse.of_weights(weights, container.slot_s, sensor, effects)


@lru_cache
def gain_spread(sensor: Sensor, effects: Selection) -> float:
    """Return the standard deviation, over the pixels, of the factor of their response to light,
    whose mean is 1; 0 if the effect is off. Measured on 4096 pixels of a chip."""
    gain = effects.find_part(PixelGain)
    return 0.0 if gain is None else float(gain.factor(sensor, 0, _PIXELS).std())


def converter_e2(sensor: Sensor, effects: Selection) -> float:
    """Return the variance that the converter adds, in square electrons: by rounding, and by the
    errors of converter codes in `effects`, including fixed errors."""
    noise_lsb = effects.converter_lsb(sensor)
    # 1/12: the variance of rounding to whole codes.
    return float(sensor.electrons_per_lsb**2 * (noise_lsb**2 + 1.0 / 12.0))


@dataclass(frozen=True, eq=False)
class Response:
    """The response of the pixels of a program on a sensor; each array is float64 (buckets, rows,
    cols).

    `open_s`: open time in seconds. Without saturation, a mean exposure in electrons is `zero_e` +
    `gain` x the light collected during this time."""

    open_s: Floats
    gain: Floats
    zero_e: Floats
    sensor: Sensor

    def electrons(self, frame: NDArray[np.integer]) -> Floats:
        """Return the electrons collected while pixels were open, from converter codes `frame`, both
        (.., buckets, rows, cols). For saturated pixels this is a lower bound; noise may make it
        negative."""
        read_e = (frame - self.sensor.adc_offset_lsb) * self.sensor.electrons_per_lsb
        return np.asarray((read_e - self.zero_e) / self.gain)


def response_of(container: Container, sensor: Sensor, effects: Selection | None = None) -> Response:
    """Return the response of a program with pixels, under `effects` (None: all, like a chip).

    For pixels that look, the open time depends on the light: `open_s` is NaN, `gain` 1 and `zero_e`
    0; see `nscc_runtime.looked_light` instead. If the words open no shutters, `gain` is 1 and
    `zero_e` 0, too. Raises ValueError for a container (a compiled program) without pixels."""
    if container.pixel_codes is None:
        raise ValueError("a program without pixel codes has no response: add a `pixels` statement")
    effects = everything() if effects is None else effects
    lanes = container.table.shutter_of_code[container.pixel_codes]
    open_s = container.table.shutters @ container.slot_s
    by_pixel = open_s[lanes].transpose(2, 0, 1)
    plain = Response(by_pixel, np.ones(by_pixel.shape), np.zeros(by_pixel.shape), sensor)
    if not KINDS.of(container).open_times_known:
        return replace(plain, open_s=np.full(by_pixel.shape, np.nan))
    try:
        response = shutter_response(container, sensor, effects)
    except Rejected:  # NS0442: its words open no shutters
        return plain
    # The gain of light that never reaches the exposure is undefined: use 1.
    gain = np.where(response.seen_s > 0, response.gain(open_s), 1.0)
    gain, zero_e = (values[lanes].transpose(2, 0, 1) for values in (gain, response.bias_e))
    return replace(plain, gain=gain, zero_e=zero_e)


_KNOWN: tuple[type[Part], ...] = (
    Converter,
    CountedDark,
    CountedLight,
    Errors,
    Leak,
    LitLevel,
    SlowWords,
    WordGain,
)
"""Kinds of effects whose variance follows from the words, or is known to the reader. The plan
states the size of other effects."""


def with_decode_arrays(file: FrameFile, container: Container) -> FrameFile:
    """Return `file` with the arrays `decode_..` that decoders need, for the sensor and the plan
    (the effects that are simulated) of its meta; unchanged where `decode_arrays` returns none."""
    arrays = decode_arrays(container, Sensor(file.meta["sensor"]), plan=file.meta["plan"])
    return replace(file, kept_arrays={**file.kept_arrays, **arrays})


def decode_arrays(
    container: Container, sensor: Sensor, plan: Mapping[str, Any] | None
) -> dict[str, Array]:
    """Return the arrays that decoders need, by their keys in a frame file. Without saturation, an
    exposure is bias + sum over slots of gain * shutter * light, and noise. All three depend only on
    the pixel's shutter and follow from the words.

    They are empty if pixels have no codes, if pixels look, or if the words open no shutters.
    `decode_row` (rows, cols): the shutter of each pixel, as a row of the other arrays.
    `decode_shutter` uint8 (shutters, buckets, ceil(N / 8)): packed along N, the first slot in the
    lowest bit. `decode_slot_us` float64 (N,): slot lengths. `decode_gain`, `decode_bias_e`,
    `decode_variance_e2` float32 (shutters, buckets): an exposure is bias + gain * (sum of the light
    of open slots), with this variance plus the variance of photon counts. `plan`: the plan (the
    effects that are simulated) in a frame's meta; None for frames of a chip, which has every
    effect."""
    if container.pixel_codes is None or not KINDS.of(container).open_times_known:
        return {}
    kept_effects = everything()
    if plan is not None:
        names = frozenset(row["name"] for row in plan["effects"] if row["decision"] == "kept")
        kept_effects = Selection(names & kept_effects.on, frozenset())
    try:
        shutters = container.table.shutters
        if not container.has_table:
            shutters = backward(container, analog_words(container)).open().transpose(1, 2, 0)
        response = shutter_response(container, sensor, kept_effects)
    except Rejected:
        return {}
    lanes = container.table.shutter_of_code[container.pixel_codes]
    used, row = np.unique(lanes, return_inverse=True)
    small = next(t for t in (np.uint8, np.uint16, np.uint32) if len(used) - 1 <= np.iinfo(t).max)
    gain = response.gain(shutters @ container.slot_s)
    variance_e2 = (
        response.variance_e2 + converter_e2(sensor, kept_effects) + _planned_e2(kept_effects, plan)
    )
    # Beyond float32 a variance is infinite: such a code says nothing about the light.
    with np.errstate(over="ignore"):
        tables = [
            values[used].astype(np.float32) for values in (gain, response.bias_e, variance_e2)
        ]
    return {
        "decode_row": row.reshape(lanes.shape).astype(small),
        "decode_shutter": np.packbits(shutters[used], axis=-1, bitorder="little"),
        "decode_slot_us": np.array(container.slot_us, np.float64),
        "decode_gain": tables[0],
        "decode_bias_e": tables[1],
        "decode_variance_e2": tables[2],
    }


def _planned_e2(kept_effects: Selection, plan: Mapping[str, Any] | None) -> float:
    """Return the variance of those kept effects whose size only `plan`, the entry of a meta,
    states, in square electrons; 0 without a plan. Effects after the exposure are counted with the
    converter."""
    known = set().union(*(kept_effects.names(kind) for kind in _KNOWN))
    plan_effects = [] if plan is None else plan["effects"]
    return sum(
        (row["predicted_rms_e"] or 0.0) ** 2
        for row in plan_effects
        if row["decision"] == "kept" and row["name"] not in known and row["kind"] != "after"
    )


def expected_noise(
    container: Container, sensor: Sensor | None = None
) -> tuple[float, float] | None:
    """Return the RMS noise in electrons, over pixels and buckets: in the dark, and at half a full
    well.

    It includes photons, dark current, resets, reads, analog words and the converter, with the
    values of `sensor` (None: the target's defaults). It is relative to the light that a pixel
    collects while it is open. Returns None for a program without pixels, or whose shutters depend
    on more than codes."""
    sensor = sensor or default_sensor(converter_of(container))
    arrays = decode_arrays(container, sensor, plan=None)
    if not arrays:
        return None
    row = arrays["decode_row"]
    used = np.bincount(row.reshape(-1), minlength=len(arrays["decode_gain"]))
    # Only pixels that ever open count, each shutter as often as pixels have it.
    opened = np.unpackbits(arrays["decode_shutter"], axis=-1).any(axis=-1)
    weight = opened * used[:, None]
    if not weight.any():
        return None
    gain = arrays["decode_gain"].astype(np.float64)
    dark_e2 = float(np.average(arrays["decode_variance_e2"] / gain**2, weights=weight))
    return sqrt(dark_e2), sqrt(dark_e2 + sensor.full_well_e / 2)
