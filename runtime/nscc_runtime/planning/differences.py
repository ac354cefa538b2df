"""How far exposures are from the truth, told from the measured pixels of a scene."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.planning.tail import Worst, worst_measured

Values = NDArray[np.float64]

_SIGMAS = 3.0
"""Standard errors within which a mean may be none."""
_NO_NUMBER_E = 1e30
"""The error of an exposure that is no number."""


@dataclass(frozen=True, eq=False)
class WeightedPixels:
    """Pixels that stand for a scene.

    Attributes
    ----------
    weight : float64, shape (pixels,)
        How many of the `scene_pixels` each stands for.
    cluster : int64, shape (pixels,)
        Pixels of one cluster, which lie one after the other, were drawn together.
    """

    weight: Values
    cluster: NDArray[np.int64]
    scene_pixels: int

    def mean(self, values: Values) -> Values:
        """The mean over the scene of values (.., pixels)."""
        return np.asarray((values * self.weight).sum(axis=-1) / max(self.weight.sum(), 1e-300))

    def standard_error(self, values: Values) -> Values:
        """The standard error of such a mean: a sample is not the scene. A pixel that was sure to be
        drawn stands for itself alone; one that stands for less was exposed several times."""
        if not values.size:
            return np.zeros(values.shape[:-1])
        not_sampled = np.sqrt(1.0 - 1.0 / np.maximum(self.weight, 1.0))
        by_chance = self.weight * np.where(self.weight < 1.0, 1.0, not_sampled)
        deviation = (values - self.mean(values)[..., None]) * by_chance
        cluster_sums = np.add.reduceat(deviation, self.cluster_starts, axis=-1)
        return np.asarray(np.sqrt((cluster_sums**2).sum(axis=-1)) / max(self.weight.sum(), 1e-300))

    @cached_property
    def cluster_starts(self) -> NDArray[np.intp]:
        """The first pixel of each cluster."""
        return np.flatnonzero(np.diff(self.cluster, prepend=-1))


@dataclass(frozen=True, eq=False)
class Errors:
    """Exposures less the truth.

    `size_e` (outputs, pixels) in electrons, an output being a bucket, or one of a frame of a film;
    `compared` (outputs, pixels): False where a pixel ended in other states than the truth, or one
    of them is no number; `states`: whether pixels end in states.
    """

    size_e: Values
    compared: NDArray[np.bool_]
    states: bool = False

    @classmethod
    def of(cls, exposure_e: Values, truth_e: Values) -> Errors:
        """Of exposures (outputs, pixels) that end in no states, compared where the truth is a
        number."""
        compared = np.isfinite(truth_e)
        with np.errstate(invalid="ignore"):
            away_e = np.where(np.isfinite(exposure_e), exposure_e - truth_e, _NO_NUMBER_E)
        return cls(np.where(compared, away_e, 0.0), compared)


@dataclass(frozen=True, eq=False)
class Difference:
    """What errors of measured pixels amount to over the scene."""

    errors: Errors
    sample: WeightedPixels

    @cached_property
    def _compared(self) -> Values:
        """The part of the scene (outputs,) that is compared."""
        return np.maximum(self.sample.mean(self.errors.compared.astype(np.float64)), 1e-12)

    @cached_property
    def square_e2(self) -> Values:
        """Mean square (outputs,) in square electrons."""
        return self.sample.mean(self.errors.size_e**2) / self._compared

    @cached_property
    def unsure_e2(self) -> Values:
        """The standard error (outputs,) of the mean square."""
        return self.sample.standard_error(self.errors.size_e**2)

    @property
    def changes(self) -> bool:
        """Whether any exposure differs."""
        return bool(self.square_e2.any()) or self.other_states > 0

    @property
    def rms_e(self) -> float:
        """Root mean square of the worst output."""
        return float(np.sqrt(self.square_e2.max(initial=0.0)))

    @property
    def bias_e(self) -> float:
        """The mean of that output, 0 where it is within three standard errors of it."""
        size_e = self.errors.size_e[int(np.argmax(self.square_e2))]
        mean_e = float(self.sample.mean(size_e))
        return mean_e if abs(mean_e) > _SIGMAS * float(self.sample.standard_error(size_e)) else 0.0

    def likely_e2(self, errors: float) -> float:
        """The mean square of the worst output with so many standard errors."""
        return float((self.square_e2 + errors * self.unsure_e2).max(initial=0.0))

    @cached_property
    def other_states(self) -> float:
        """The part of the pixels that end in other states."""
        return float(1.0 - self._compared.min(initial=1.0)) if self.errors.states else 0.0

    @cached_property
    def worst(self) -> Worst:
        """The largest errors of the pixels that are compared."""
        is_compared = self.errors.compared.all(axis=0)
        weight = self.sample.weight[is_compared]
        fraction = weight / max(float(weight.sum()), 1e-300)
        return worst_measured(
            self.errors.size_e[:, is_compared], fraction, self.sample.scene_pixels
        )
