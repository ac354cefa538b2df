"""Errors of a readout, in converter codes before rounding: noise, fixed pattern and level."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import hypot, prod

import numpy as np

from nscc.arrays import Bytes, Floats
from nscc_runtime.effects.selection import Selection
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.noise import keys
from nscc_runtime.readout_loop import WEIGHTS, Converting, ReadoutErrors, convert


@dataclass(frozen=True, eq=False)
class ReadoutNoise:
    """The errors of a chip's readout under some effects.

    All are in converter codes. `weights_lsb` (6,): standard deviations of the parts of a code's
    noise that the pixel and each of the five pixels below it draw; empty without noise.
    `pattern_lsb` (rows, cols): fixed errors. `common_lsb` (1,): standard deviation of an error that
    all codes of a bucket share. Numbers are 0 for effects that are off. `streams`: random streams
    of noise and of the common error."""

    weights_lsb: Floats
    pattern_lsb: Floats
    common_lsb: Floats
    streams: tuple[int, int]

    @classmethod
    def of(
        cls, sensor: Sensor, effects: Selection, device_seed: int, shape: tuple[int, int]
    ) -> ReadoutNoise:
        """Return the errors that `effects` cause in a readout of an array of `shape` (rows, cols)
        on the chip with the seed `device_seed`; the last eight results are cached."""
        return _readout_noise(sensor, effects, device_seed, shape)

    def drawn(self, seed: int, frame: int, buckets: int) -> ReadoutErrors:
        """Return what the errors of frame number `frame` are computed from. `seed`: of the noise.
        Buckets are independent but for the pattern."""
        noise_keys, common_keys = (keys(seed, each, 0, frame, buckets) for each in self.streams)
        return ReadoutErrors(
            self.pattern_lsb, self.common_lsb, self.weights_lsb, common_keys, noise_keys
        )

    def codes(self, seed: int, frame: int, buckets: int) -> Floats:
        """Return the errors of frame number `frame`, in converter codes before rounding, shape
        (buckets, rows, cols). `seed`: of the noise."""
        nothing = np.zeros((buckets, *self.pattern_lsb.shape))
        errors = self.drawn(seed, frame, buckets)
        return codes_and_errors(nothing, errors, (1.0, 0.0, 255), True)[1]


def codes_and_errors(
    exposure: Floats,
    errors: ReadoutErrors | Floats | float,
    scale: tuple[float, float, int],
    keeps_errors: bool = False,
) -> tuple[Bytes, Floats]:
    """Return the converter codes of exposures in electrons, and with `keeps_errors` their errors
    before rounding, in arrays like `exposure`.

    `errors`: those of each code, one for all, or what they are drawn from, for exposures (buckets,
    rows, cols). `scale`: the electrons of a code, the code of 0 e, and the largest code."""
    *ahead, cols = exposure.shape
    buckets, rows = 1, prod(ahead)
    if isinstance(errors, ReadoutErrors):
        buckets, rows = ahead
    else:
        pattern = np.ascontiguousarray(np.broadcast_to(errors, exposure.shape), np.float64)
        pattern, no_key = pattern.reshape(rows, cols), np.zeros(1, np.uint64)
        errors = ReadoutErrors(pattern, np.zeros(1), np.empty(0), no_key, no_key)
    codes = np.empty(exposure.shape, np.uint8)
    kept = np.empty(exposure.shape if keeps_errors else cols)
    convert(
        converting=Converting(
            buckets=buckets,
            rows=rows,
            cols=cols,
            pattern_rows=len(errors.pattern),
            weights=len(errors.weights),
            keeps_errors=keeps_errors,
            electrons_per_lsb=scale[0],
            offset=scale[1],
            top=scale[2],
        ),
        of=errors,
        exposure=np.ascontiguousarray(exposure, np.float64),
        drawn=np.empty(WEIGHTS * cols),
        errors=kept,
        codes=codes,
    )
    return codes, kept


@lru_cache(8)
def _readout_noise(
    sensor: Sensor, effects: Selection, device_seed: int, shape: tuple[int, int]
) -> ReadoutNoise:
    """Return the errors that `effects` cause in a readout of an array of `shape` (rows, cols) on
    the chip with the seed `device_seed`; cached."""
    noisy, common = effects.acting("converter"), effects.acting("common")
    weights = np.eye(1, WEIGHTS)[0]
    for shared in effects.at("columns"):
        weights = shared(sensor)
    sigma_lsb, pattern = hypot(*(sigma(sensor) for _, sigma in noisy)), np.zeros(shape)
    for fixed in effects.at("pattern"):
        pattern += fixed(sensor, device_seed, shape)
    # One draw with the first effect's stream: the sum of normal errors is normal.
    streams = (noisy[0][0].stream if noisy else 0, common[0][0].stream if common else 0)
    return ReadoutNoise(
        sigma_lsb * weights if sigma_lsb else np.empty(0),
        pattern,
        np.array([hypot(*(sigma(sensor) for _, sigma in common))]),
        streams,
    )
