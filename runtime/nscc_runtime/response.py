"""What a chip makes of steady light: the sensor's figures, through a program's words.

The words lose a little of the light, add a little of their own, and an exposure that they read is
off by that whatever the scene. Both follow from the sensor file, which `nscc calibrate` measures,
and both can be taken away again:

    response = response_of(program, sensor, taken.plan.kept)
    electrons = response.electrons(taken.frame)     # that fell while pixels were open
    light = electrons / response.open_s             # electrons a second, of steady light
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Rejected
from nscc.words.container import Container
from nscc_runtime.effects import Selection, everything
from nscc_runtime.effects.parts import CountedDark, Leak, SlowWords, WordGain
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.reference.weights import Backward, backward

Values = NDArray[np.float64]

_PIXELS = 4096
"""Of a chip, for the mean of what differs from pixel to pixel."""


@dataclass(frozen=True, eq=False)
class Response:
    """Of a program on a sensor; each float64 (buckets, rows, cols).

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

    What words make of light that they compare is not foretold: there `gain` is 1 and `zero_e` 0,
    as without effects, and `open_s` is NaN, for it hangs on the light. ValueError for a container
    without pixels.
    """
    if container.pixel_codes is None:
        raise ValueError("a container without pixels has no response")
    slot_s = np.array(container.slot_us) * 1e-6
    lanes = container.table.shutter_of_code[container.pixel_codes]
    open_s = (container.table.shutters @ slot_s)[lanes].transpose(2, 0, 1)
    effects = everything() if effects is None else effects
    plain = Response(open_s, np.ones(open_s.shape), np.zeros(open_s.shape), sensor)
    if container.machine is not None:
        return replace(plain, open_s=np.full(open_s.shape, np.nan))
    if container.target.streamed:
        gains = np.array([readout.gain for readout in container.readouts])[:, None, None]
        plain = replace(plain, gain=plain.gain * gains)
    if effects.noiseless:
        return plain
    weights = _weights(container, sensor, effects)
    if weights is None:
        return plain
    seen_s = np.einsum("n,nlb->lb", slot_s, weights.slots)
    zero_e = np.zeros(seen_s.shape)
    words, dark = effects.part(WordGain), effects.part(CountedDark)
    if words is not None:
        zero_e += words.mean_e(sensor) * sum(weights.errors.values(), np.zeros(seen_s.shape))
    if dark is not None:
        current = dark.per_s(sensor, 0, np.arange(_PIXELS, dtype=np.int64)).mean()
        zero_e += current * seen_s
    seen, zero = (each[lanes].transpose(2, 0, 1) for each in (seen_s, zero_e))
    gain = np.divide(seen, open_s, out=np.ones(open_s.shape), where=(open_s > 0) & (seen > 0))
    return Response(open_s, gain, zero, sensor)


def _weights(container: Container, sensor: Sensor, effects: Selection) -> Backward | None:
    """What of each slot's light, and of each word's error, reaches exposures; None for words that
    open no shutters."""
    if container.target.streamed:
        leak = effects.part(Leak)
        rate = 1.0 / leak.tau_s(sensor) if leak else 0.0
        return backward(container, (), 1.0, rate, effects.part(SlowWords) is not None)
    from nscc_runtime.execution.program import analysed

    try:
        program = analysed(container, sensor)
    except Rejected:  # NS0442
        return None
    return program.tables.weights(program.model(effects))
