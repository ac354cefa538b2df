"""Errors of exposures, estimated from a sample of the pixels of a scene."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

Values = NDArray[np.float64]

_SIGMAS = 3.0
"""A mean within this number of standard errors of 0 counts as 0."""
_NO_NUMBER_E = 1e30
"""Error in electrons that is assigned to an exposure of NaN or infinity."""


@dataclass(frozen=True, eq=False)
class WeightedPixels:
    """A weighted sample of the pixels of a scene.

    Attributes
    ----------
    weight : float64, shape (pixels,)
        Number of pixels of the scene that each sampled pixel represents.
    cluster : int64, shape (pixels,)
        Cluster number, ascending. Pixels of a cluster are adjacent and were drawn together.
    scene_pixels : int
        Number of pixels of the scene.
    """

    weight: Values
    cluster: NDArray[np.int64]
    scene_pixels: int

    def mean(self, values: Values) -> Values:
        """Return the weighted mean over the last axis of `values`, shape (.., pixels)."""
        return np.asarray((values * self.weight).sum(axis=-1) / max(self.weight.sum(), 1e-300))

    def standard_error(self, values: Values) -> Values:
        """Return the standard error of `mean(values)`; 0 without pixels. A pixel of weight 1 was
        certain to be drawn and adds no sampling error."""
        if not values.size:
            return np.zeros(values.shape[:-1])
        not_sampled = np.sqrt(1.0 - 1.0 / np.maximum(self.weight, 1.0))
        by_chance = self.weight * np.where(self.weight < 1.0, 1.0, not_sampled)
        deviation = (values - self.mean(values)[..., None]) * by_chance
        cluster_sums = np.add.reduceat(deviation, self.cluster_starts, axis=-1)
        return np.asarray(np.sqrt((cluster_sums**2).sum(axis=-1)) / max(self.weight.sum(), 1e-300))

    @cached_property
    def cluster_starts(self) -> NDArray[np.intp]:
        """Index (clusters,) of the first pixel of each cluster."""
        return np.flatnonzero(np.diff(self.cluster, prepend=-1))


@dataclass(frozen=True, eq=False)
class ExposureErrors:
    """Differences between exposures and true exposures, for sampled pixels.

    `size_e` (outputs, pixels): error in electrons, 0 where not compared; an output is a bucket of
    one frame. `compared` (outputs, pixels): False where the pixel ended in another state than in
    the true exposure, or where a value is not finite. `states`: whether the program has states."""

    size_e: Values
    compared: NDArray[np.bool_]
    states: bool = False

    @classmethod
    def of(cls, exposure_e: Values, truth_e: Values) -> ExposureErrors:
        """Return the errors of exposures (outputs, pixels) of a program without states. Pixels
        whose true exposure is not finite are not compared."""
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
        """The fraction of the scene that is compared, for each output."""
        return np.maximum(self.sample.mean(self.errors.compared.astype(np.float64)), 1e-12)

    @cached_property
    def square_e2(self) -> Values:
        """Mean square error (outputs,) in square electrons."""
        return self.sample.mean(self.errors.size_e**2) / self._compared

    @cached_property
    def unsure_e2(self) -> Values:
        """Standard error (outputs,) of the mean square error, in square electrons."""
        return self.sample.standard_error(self.errors.size_e**2)

    @property
    def changes(self) -> bool:
        """Whether any sampled exposure differs from the true one."""
        return bool(self.square_e2.any()) or self.other_states > 0

    @property
    def rms_e(self) -> float:
        """Root mean square error of the worst output, in electrons."""
        return float(np.sqrt(self.square_e2.max(initial=0.0)))

    @property
    def bias_e(self) -> float:
        """Mean error of the worst output in electrons; 0 if within three standard errors of 0."""
        size_e = self.errors.size_e[int(np.argmax(self.square_e2))]
        mean_e = float(self.sample.mean(size_e))
        return mean_e if abs(mean_e) > _SIGMAS * float(self.sample.standard_error(size_e)) else 0.0

    def likely_e2(self, errors: float) -> float:
        """Return the largest mean square error of an output plus `errors` standard errors."""
        return float((self.square_e2 + errors * self.unsure_e2).max(initial=0.0))

    @cached_property
    def other_states(self) -> float:
        """Fraction of the pixels that end in other states; 0 for programs without states."""
        return float(1.0 - self._compared.min(initial=1.0)) if self.errors.states else 0.0

    @cached_property
    def worst(self) -> Worst:
        """99.9 % quantile and maximum of the error, estimated from the compared pixels."""
        is_compared = self.errors.compared.all(axis=0)
        weight = self.sample.weight[is_compared]
        fraction = weight / max(float(weight.sum()), 1e-300)
        return worst_measured(
            self.errors.size_e[:, is_compared], fraction, self.sample.scene_pixels
        )


ONE_IN = 1000
"""One pixel in this number has an error above the 99.9 % quantile."""
FRAMES = 100
"""In one frame of this number, some pixel exceeds the estimated largest error."""
_TAIL = 10
"""Number of errors from which one tail parameter is estimated."""


@dataclass(frozen=True)
class Worst:
    """The 99.9 % quantile and the maximum of the error in the worst bucket, in electrons."""

    p999_e: float
    max_e: float


def worst_measured(errors: Values, weights: Values, pixels: int) -> Worst:
    """Estimate the largest errors of a frame from `errors` (buckets, sampled pixels).

    `weights` (sampled pixels,): the fraction of the `pixels` of a frame that each sampled pixel
    represents. An exponential tail is fitted beyond the sample: losses near saturation are large
    for a few pixels, so a normal tail is too short."""
    sizes = np.abs(errors)
    rare = min(1.0 / ONE_IN, 1.0 / (FRAMES * pixels * len(sizes)))
    p999_e, max_e = (
        max(_exceeded_by(share, bucket_sizes, weights) for bucket_sizes in sizes)
        for share in (1.0 / ONE_IN, rare)
    )
    return Worst(p999_e, max(max_e, float(sizes.max(initial=0.0))))


def _exceeded_by(share: float, sizes: Values, weights: Values) -> float:
    """Return the size that a fraction `share` of the frame exceeds, extrapolated beyond the sample
    if necessary; 0 if a small sample contains no such size."""
    order = np.argsort(-sizes, kind="stable")
    falling, upto, count = sizes[order], np.cumsum(weights[order]), len(sizes)
    if count < 2 * _TAIL or upto[0] <= share:
        at = int(np.searchsorted(upto, share, side="right"))
        return float(falling[at]) if at < count else 0.0
    ranks = np.arange(1, count // _TAIL) if count >= 4 * _TAIL else np.array([count // 4])
    beyond = np.cumsum(falling * weights[order])[ranks - 1] / upto[ranks - 1]
    excess = beyond - falling[ranks]
    return float(np.max(falling[ranks] + excess * np.log(upto[ranks] / share)))


def largest(sizes: Values, weight: Values) -> Worst:
    """Return the 99.9 % quantile and the maximum of weighted `sizes` (pixels,)."""
    order = np.argsort(sizes)
    above = np.cumsum(weight[order][::-1])[::-1]
    beyond = np.flatnonzero(above <= weight.sum() / ONE_IN)
    at = int(beyond[0]) if len(beyond) else len(sizes) - 1
    return Worst(float(sizes[order[at]]), float(sizes[order[-1]]))
