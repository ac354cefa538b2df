"""What a chip makes of steady light: the sensor's figures, through a program's words.

As long as nothing saturates, an exposure is in the mean `zero_e` + `gain` x the light that falls
while the pixel is open, with a variance that the light does not change and that of the photons.
All four follow from the words (`nscc_runtime.reference.weights`) and the sensor file, which
`nscc calibrate` measures. What frames tell of light, decode tables, calibration and the codes of
full pixels are computed from them:

    response = response_of(program, sensor, taken.plan.kept)
    electrons = response.electrons(taken.frame)     # that fell while pixels were open
    light = electrons / response.open_s             # electrons a second, of steady light
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Rejected
from nscc.words.container import Container
from nscc_runtime.container_cache import OfContainer
from nscc_runtime.effects import Selection, everything
from nscc_runtime.effects.parts import CountedDark, WordGain
from nscc_runtime.effects.parts import Response as PixelGain
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.reference.trace import analog_words, retention_us
from nscc_runtime.reference.weights import Backward, WeightModel, backward

Values = NDArray[np.float64]

_PIXELS = np.arange(4096, dtype=np.int64)
"""Of a chip, for the mean and the spread of what differs from pixel to pixel."""


@dataclass(frozen=True, eq=False)
class ShutterResponse:
    """Of the shutters of a program on a sensor; each float64 (shutters, buckets).

    `seen_s`: for how long the light reaches the exposure, weighted by how much of it does. In the
    mean an exposure in electrons is `bias_e` + `seen_s` x the light a second, and its variance
    `variance_e2` and that of the photons.
    """

    seen_s: Values
    bias_e: Values
    variance_e2: Values

    @classmethod
    def of_weights(
        cls, weights: Backward, slot_s: Values, sensor: Sensor, effects: Selection
    ) -> ShutterResponse:
        """Of the words that have these weights."""
        seen_s = np.einsum("n,nlb->lb", slot_s, weights.slots)
        dark_e = mean_dark_e_per_s(sensor, effects) * seen_s
        bias_e, variance_e2 = dark_e, np.maximum(dark_e, 0.0)
        words = effects.find_part(WordGain)
        if words is not None:
            bias_e = bias_e + words.mean_e(sensor) * weights.error_sum
            variance_e2 = variance_e2 + (words.spread_e(sensor) * weights.error_sum) ** 2
        for _, errors in effects.errors():
            variance_e2 = variance_e2 + errors.sigma_e(sensor) ** 2 * weights.squared(errors.at)
        return cls(seen_s, bias_e, variance_e2)

    def gain(self, open_s: Values) -> Values:
        """How much of the light that falls while shutters are open (shutters, buckets) reaches
        the exposure; 1 for those that never are."""
        return np.divide(self.seen_s, open_s, out=np.ones(open_s.shape), where=open_s > 0)


def _shutter_response(container: Container, sensor: Sensor, effects: Selection) -> ShutterResponse:
    kept_us = retention_us(effects, sensor)
    words = () if container.target.streamed else analog_words(container, kept_us)
    weights = backward(container, words, WeightModel.of(effects, sensor))
    return ShutterResponse.of_weights(weights, container.slot_s, sensor, effects)


shutter_response = OfContainer(_shutter_response)
"""The response of every shutter of a program whose pixels do not look, by (container, sensor,
effects). Raises Rejected (NS0442) for words that open no shutters."""


def open_shutters(container: Container) -> NDArray[np.bool_]:
    """The shutters (shutters, buckets, N) of a program, of its table or of its words.

    Raises Rejected (NS0442) for words that open none.
    """
    if container.has_table:
        return container.table.shutters
    return backward(container, analog_words(container)).open().transpose(1, 2, 0)


@lru_cache
def mean_dark_e_per_s(sensor: Sensor, effects: Selection) -> float:
    """The mean dark current of the pixels, electrons a second."""
    dark = effects.find_part(CountedDark)
    return 0.0 if dark is None else float(dark.per_s(sensor, 0, _PIXELS).mean())


@lru_cache
def gain_spread(sensor: Sensor, effects: Selection) -> float:
    """The relative standard deviation, over the pixels, of what they make of light."""
    gain = effects.find_part(PixelGain)
    return 0.0 if gain is None else float(gain.factor(sensor, 0, _PIXELS).std())


def converter_e2(sensor: Sensor, effects: Selection) -> float:
    """The variance that the converter adds by rounding and by noise, square electrons."""
    noise_lsb = effects.converter_lsb(sensor)
    return float(sensor.electrons_per_lsb**2 * (noise_lsb**2 + 1.0 / 12.0))


@dataclass(frozen=True, eq=False)
class Response:
    """Of the pixels of a program on a sensor; each float64 (buckets, rows, cols).

    `open_s`: how long pixels are open, 0 for those that never are. As long as nothing saturates, an
    exposure in electrons is in the mean `zero_e` + `gain` x the light that falls meanwhile.
    """

    open_s: Values
    gain: Values
    zero_e: Values
    sensor: Sensor

    def electrons(self, frame: NDArray[np.integer]) -> Values:
        """The light (.., buckets, rows, cols) that fell while pixels were open, from codes of the
        converter. What is saturated had more."""
        read_e = (frame - self.sensor.adc_offset_lsb) * self.sensor.electrons_per_lsb
        return np.asarray((read_e - self.zero_e) / self.gain)


def response_of(container: Container, sensor: Sensor, effects: Selection | None = None) -> Response:
    """The response of a program with pixels, under `effects` (default: all, as a chip has them).

    Of pixels that look, the open time hangs on the light: `open_s` is NaN, `gain` 1 and `zero_e` 0;
    what their frames tell of light is `nscc_runtime.looked_light`'s. ValueError for a container
    without pixels.
    """
    if container.pixel_codes is None:
        raise ValueError("a container without pixels has no response")
    effects = everything() if effects is None else effects
    lanes = container.table.shutter_of_code[container.pixel_codes]
    open_s = container.table.shutters @ container.slot_s
    by_pixel = open_s[lanes].transpose(2, 0, 1)
    plain = Response(by_pixel, np.ones(by_pixel.shape), np.zeros(by_pixel.shape), sensor)
    if container.machine is not None:
        return replace(plain, open_s=np.full(by_pixel.shape, np.nan))
    try:
        response = shutter_response(container, sensor, effects)
    except Rejected:  # NS0442: its words open no shutters
        return plain
    # Nothing is told of light that never reaches the exposure.
    gain = np.where(response.seen_s > 0, response.gain(open_s), 1.0)
    gain, zero_e = (values[lanes].transpose(2, 0, 1) for values in (gain, response.bias_e))
    return replace(plain, gain=gain, zero_e=zero_e)
