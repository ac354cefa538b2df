"""Errors of exposures, estimated from a sample of the pixels of a scene."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.planning.tail import Worst, worst_measured

Values = NDArray[np.float64]

_SIGMAS = 3.0
"""A mean within this number of standard errors of 0 counts as 0."""
_NO_NUMBER_E = 1e30
"""The error that an exposure of NaN or infinity counts as."""


@dataclass(frozen=True, eq=False)
class WeightedPixels:
    """A weighted sample of the pixels of a scene.

    Attributes
    ----------
    weight : float64, shape (pixels,)
        Number of the `scene_pixels` that each represents.
    cluster : int64, shape (pixels,)
        Cluster number. Pixels of a cluster are adjacent and were drawn together.
    """

    weight: Values
    cluster: NDArray[np.int64]
    scene_pixels: int

    def mean(self, values: Values) -> Values:
        """Return the weighted mean of values (.., pixels)."""
        return np.asarray((values * self.weight).sum(axis=-1) / max(self.weight.sum(), 1e-300))

    def standard_error(self, values: Values) -> Values:
        """Return the standard error of `mean(values)`.

        A pixel of weight 1 was certain to be drawn and adds no sampling error.
        """
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
class ExposureErrors:
    """Differences between exposures and the truth.

    `size_e` (outputs, pixels): electrons; an output is a bucket of one frame. `compared` (outputs,
    pixels): False if the pixel ended in other states than in the truth, or a value is not finite.
    `states`: whether the program has states.
    """

    size_e: Values
    compared: NDArray[np.bool_]
    states: bool = False

    @classmethod
    def of(cls, exposure_e: Values, truth_e: Values) -> ExposureErrors:
        """Return the errors of exposures (outputs, pixels) of a program without states."""
        compared = np.isfinite(truth_e)
        with np.errstate(invalid="ignore"):
            away_e = np.where(np.isfinite(exposure_e), exposure_e - truth_e, _NO_NUMBER_E)
        return cls(np.where(compared, away_e, 0.0), compared)


@dataclass(frozen=True, eq=False)
class Difference:
    """Statistics of the errors of sampled pixels, as estimates for the whole scene."""

    errors: ExposureErrors
    sample: WeightedPixels

    @cached_property
    def _compared(self) -> Values:
        """The fraction of the scene (outputs,) that is compared."""
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
        """Mean of the worst output; 0 if it is within three standard errors of 0."""
        size_e = self.errors.size_e[int(np.argmax(self.square_e2))]
        mean_e = float(self.sample.mean(size_e))
        return mean_e if abs(mean_e) > _SIGMAS * float(self.sample.standard_error(size_e)) else 0.0

    def likely_e2(self, errors: float) -> float:
        """Return the mean square of the worst output plus a number of standard `errors`."""
        return float((self.square_e2 + errors * self.unsure_e2).max(initial=0.0))

    @cached_property
    def other_states(self) -> float:
        """Fraction of the pixels that end in other states."""
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
