"""Errors of a readout, in converter codes before rounding: noise, fixed pattern and level."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import hypot

import numpy as np

from nscc.arrays import Floats
from nscc_runtime.effects.selection import Selection
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.noise import keys
from nscc_runtime.readout_loop import WEIGHTS, ReadoutErrors, codes_and_errors


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
    @lru_cache(8)
    def of(
        cls, sensor: Sensor, effects: Selection, device_seed: int, shape: tuple[int, int]
    ) -> ReadoutNoise:
        """Return the errors that `effects` cause in a readout of an array of `shape` (rows, cols)
        on the chip with the seed `device_seed`; the last eight results are cached."""
        noisy, common = effects.acting("converter"), effects.acting("common")
        weights = np.eye(1, WEIGHTS)[0]
        for shared in effects.at("columns"):
            weights = shared(sensor)
        sigma_lsb, pattern = hypot(*(sigma(sensor) for _, sigma in noisy)), np.zeros(shape)
        for fixed in effects.at("pattern"):
            pattern += fixed(sensor, device_seed, shape)
        # One draw with the first effect's stream: the sum of normal errors is normal.
        streams = (noisy[0][0].stream if noisy else 0, common[0][0].stream if common else 0)
        return cls(
            sigma_lsb * weights if sigma_lsb else np.empty(0),
            pattern,
            np.array([hypot(*(sigma(sensor) for _, sigma in common))]),
            streams,
        )

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
