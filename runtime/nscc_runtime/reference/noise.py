"""Noise of many words whose sum in each exposure is one keyed draw.

Let e be the standard normal errors of the words, and Q the orthonormal weights of the buckets. Then
e = x + Q (z - Q^T x), where x is drawn for each word and z for each bucket. The errors e are
independent, and Q^T e = z for any words: a plan that needs only the sum draws only z."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.noise import key, normals
from nscc_runtime.reference.weights import Weights

SUM, PART = 0, 1
"""Source numbers in random keys: the draw z of a bucket (SUM), the draw x of a word (PART)."""


@dataclass
class SpreadNoise:
    """The normal errors of one effect in one frame at some pixels. Their weighted sum in each
    bucket is one draw. `weights`: orthonormal weights by draw number. `lanes`, `pixels` (P,): the
    lane and the place of each pixel."""

    seed: int
    stream: int
    frame: int
    weights: Mapping[int, Weights]
    buckets: int
    lanes: NDArray[np.intp]
    pixels: NDArray[np.int64]
    _missing: list[NDArray[np.float64]] = field(init=False)

    def __post_init__(self) -> None:
        """Draw z for each bucket, and subtract the contribution Q^T x of the words' draws."""
        self._missing = [
            normals(self._key(SUM, bucket), self.pixels) for bucket in range(self.buckets)
        ]
        for number, weight in self.weights.items():
            lane_weights = weight[self.lanes]
            word_draw = normals(self._key(PART, number), self.pixels)
            for bucket, missing in enumerate(self._missing):
                missing -= lane_weights[:, bucket] * word_draw

    def draw(self, number: int) -> NDArray[np.float64]:
        """Return the standard normal error (P,) of draw `number`."""
        error = normals(self._key(PART, number), self.pixels)
        weight = self.weights.get(number)
        if weight is not None:
            lane_weights = weight[self.lanes]
            for bucket, missing in enumerate(self._missing):
                error = error + lane_weights[:, bucket] * missing
        return error

    def _key(self, source: int, group: int) -> np.uint64:
        return key(self.seed, self.stream, source, self.frame, group)
