"""Errors of a readout, in converter codes before rounding: noise, fixed pattern and level."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import hypot

import numpy as np

from nscc.arrays import Floats
from nscc_runtime.effects.selection import Selection
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.noise import key, normals

WEIGHTS = 6
"""Number of weights of the noise of a pixel and of those below it, which the loop adds up."""


@dataclass(frozen=True, eq=False)
class ReadoutNoise:
    """The errors of a chip's readout under some effects.

    All are in converter codes. `sigma_lsb`: standard deviation of a code's noise. `weights` (6,):
    those of the noise of a pixel and of the five pixels below it, whose squares add up to 1.
    `pattern_lsb` (rows, cols): fixed errors. `common_lsb`: standard deviation of an error that all
    codes of a bucket share. Numbers are 0 for effects that are off. `streams`: random streams of
    noise and of the common error."""

    sigma_lsb: float
    weights: Floats
    pattern_lsb: Floats
    common_lsb: float
    streams: tuple[int, int]

    @classmethod
    def of(
        cls, sensor: Sensor, effects: Selection, device_seed: int, shape: tuple[int, int]
    ) -> ReadoutNoise:
        """Return the errors that `effects` cause in a readout of an array of `shape` (rows, cols)
        on the chip with the seed `device_seed`; the last eight results are cached."""
        return _readout_noise(sensor, effects, device_seed, shape)

    def codes(self, seed: int, frame: int, buckets: int) -> Floats:
        """Return the errors of frame number `frame`, in converter codes before rounding, shape
        (buckets, rows, cols). `seed`: of the noise. Buckets are independent but for the pattern."""
        from nscc_runtime.readout_loop import NoiseSizes, add_noise

        errors = np.empty((buckets, *self.pattern_lsb.shape))
        for bucket, errors_of_bucket in enumerate(errors):
            noise, shared = (key(seed, s, frame=frame, group=bucket) for s in self.streams)
            common = 0.0
            if self.common_lsb:
                common = self.common_lsb * float(normals(shared, np.zeros(1, np.int64))[0])
            if self.sigma_lsb:
                rows, cols = self.pattern_lsb.shape
                add_noise(
                    sizes=NoiseSizes(
                        rows=rows, cols=cols, weights=WEIGHTS, key=noise, common=common
                    ),
                    weights=self.sigma_lsb * self.weights,
                    pattern=self.pattern_lsb,
                    drawn=np.empty((WEIGHTS, cols)),
                    out=errors_of_bucket,
                )
            else:
                errors_of_bucket[:] = self.pattern_lsb + common
        return errors


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
    pattern = np.zeros(shape)
    for fixed in effects.at("pattern"):
        pattern += fixed(sensor, device_seed, shape)
    # One draw with the first effect's stream: the sum of normal errors is normal.
    streams = (noisy[0][0].stream if noisy else 0, common[0][0].stream if common else 0)
    return ReadoutNoise(
        hypot(*(sigma(sensor) for _, sigma in noisy)),
        weights,
        pattern,
        hypot(*(sigma(sensor) for _, sigma in common)),
        streams,
    )
