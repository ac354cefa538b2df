"""Draw a weighted sample of the pixels of a scene, and estimate errors of the scene from it.

Errors grow with light, with its differences between neighbours and with its motion, and a few lamps
may cause most of the error. Therefore pixels are drawn partly evenly and partly in proportion to
these (`drawing_chances`). Pixels near saturation are a stratum of their own, ordered by charge."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise

import numpy as np

from nscc.arrays import Bools, Floats, Floats32, Ints
from nscc_runtime.caches import Recent
from nscc_runtime.effects import everything
from nscc_runtime.effects.parts import CountedDark, Leak
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import whole_device
from nscc_runtime.execution.near_saturation import NearSaturation
from nscc_runtime.light import Light

Places = Ints

_NEAR_FRACTION = 0.5
"""Largest fraction of a sample that is drawn from the pixels near saturation."""
_EXTREMES = 8
"""Of the pixels near saturation, this number of the brightest, of the darkest, and of those nearest
to a full well is always in the sample."""
_SURE = 2.0
"""A pixel with at least this expected number of draws is always in the sample."""
_GOLDEN = 0.6180339887498949
"""Fractional part of the golden ratio: its multiples fill the unit interval most evenly."""
_UNSEEN = 3.0
"""A kind of pixels with this expected number of draws is missed by one sample in twenty."""
_SIGMAS = 3.0
"""A mean within this number of standard errors of 0 is shown as 0."""
_MOST_E = 1e15
"""More light than this counts as this, in electrons."""
_HEAVY = 6.0
"""If the mean fourth power of a fixed pattern is more than this times its squared mean square, a
sample of even draws knows its mean square to about a tenth at most."""
_MOST_MEANS = 64
"""Number of sets of means of a sample's light that are cached: one for each set of effects that
changes them."""
_NOT_FINITE_E = 1e30
"""Error, in electrons, of an exposure that is NaN or infinite."""


@dataclass(frozen=True, eq=False)
class Sample:
    """A weighted sample of the pixels of a scene.

    Attributes
    ----------
    places : int64, shape (pixels,)
        Index of each sampled pixel in the flattened scene, ascending.
    weight : float64, shape (pixels,)
        Number of pixels of the scene that each sampled pixel represents.
    near : bool, shape (pixels,)
        Which pixels are near saturation.
    known_means : Recent
        Cache of means of the light of the sampled pixels, for
        `nscc_runtime.execution.block_scene.prepare_pixels`.
    """

    places: Places
    weight: Floats
    near: Bools
    known_means: Recent = field(default_factory=lambda: Recent(_MOST_MEANS))

    @cached_property
    def near_only(self) -> Sample:
        """The sampled pixels that are near saturation, with means of their own."""
        near = self.near
        return Sample(self.places[near], self.weight[near], near[near])

    @property
    def unseen_share(self) -> float:
        """Fraction of the scene whose pixels near saturation may all be of a kind that the sample
        does not contain; 0 if the sample contains every pixel near saturation."""
        drawn = self.weight[self.near & (self.weight > 1.0)]
        if not len(drawn):
            return 0.0
        return float(drawn.sum() / self.weight.sum()) * min(1.0, _UNSEEN / len(drawn))


@dataclass(frozen=True, eq=False)
class SampledErrors:
    """Differences of the exposures of sampled pixels from their true exposures, in electrons.

    `size_e` (series, frames, buckets, pixels): the differences, 0 where not compared. The next two
    have a value for each bucket of each frame of a series: `mean_e2`, the mean square error over
    repeated `frames` and pixels, and its standard error `chance_e2`. `bias_e`: the mean error where
    the mean square is largest; 0 if within three standard errors of 0. `other_states`: the largest
    fraction of pixels that ended in other states, or whose true exposure is not finite."""

    size_e: Floats
    mean_e2: Floats
    chance_e2: Floats
    bias_e: float
    other_states: float

    def square_e2(self, standard_errors: float = 0.0) -> float:
        """Return the mean square error, in square electrons, of the bucket in which it is largest.
        This number of its `standard_errors` is added first."""
        return float((self.mean_e2 + standard_errors * self.chance_e2).max(initial=0.0))

    @property
    def rms_e(self) -> float:
        """Root mean square error of the worst bucket, in electrons."""
        return math.sqrt(self.square_e2())

    @property
    def worst_e(self) -> float:
        """Largest measured error of a pixel, in electrons."""
        return float(np.abs(self.size_e).max(initial=0.0))


def sampled_errors(exposed_e: Floats, true_e: Floats, same: Bools, weight: Floats) -> SampledErrors:
    """Return the errors of `exposed_e` against `true_e`, electrons (series, frames, buckets,
    pixels).

    Pixels that ended in other states (`same`, of a shape that broadcasts to theirs, is False) and
    true exposures that are not finite are not compared. An exposure that is not finite where the
    true one is counts as an error of 1e30 e. `weight` (pixels,): number of pixels of the scene that
    each sampled pixel represents."""
    compared = same & np.isfinite(true_e)
    with np.errstate(invalid="ignore"):
        size_e = np.where(np.isfinite(exposed_e), exposed_e - true_e, _NOT_FINITE_E)
    size_e = np.where(compared, size_e, 0.0)
    share = weight / max(float(weight.sum()), 1e-300)

    def mean(values: Floats | Bools) -> tuple[Floats, Floats]:
        """Return the mean over frames and, weighted, over pixels, and its standard error: other
        pixels could have been drawn, and the noise of the drawn ones differs."""
        of_pixels = values.mean(axis=1)
        means = (of_pixels * share).sum(axis=-1)
        return means, np.linalg.norm((of_pixels - means[..., None]) * share, axis=-1)

    (square_e2, chance_e2), (bias_e, bias_chance_e) = mean(size_e**2), mean(size_e)
    part = mean(compared)[0]
    worst = np.unravel_index(square_e2.argmax(), square_e2.shape)
    return SampledErrors(
        size_e,
        square_e2 / np.maximum(part, 1e-12),
        chance_e2,
        float(bias_e[worst]) if abs(bias_e[worst]) > _SIGMAS * bias_chance_e[worst] else 0.0,
        0.0 if compared.all() else float(1.0 - part.min()),
    )


def draw_sample(near: NearSaturation, full_well_e: float, count: int, chance: Floats) -> Sample:
    """Draw about `count` pixels of a scene, deterministically; all pixels of a scene with at most
    `count`. A pixel that would be drawn several times is in the sample once.

    `near`: the pixels near saturation. `full_well_e`: full well in electrons. `chance` (rows *
    cols,): relative probabilities of `drawing_chances`."""
    pixels, is_near = chance.size, np.zeros(chance.size, np.bool_)
    is_near[near.places] = True
    if pixels <= count:
        return Sample(np.arange(pixels), np.ones(pixels), is_near)
    # Room that the pixels far from saturation do not need goes to those near it.
    far = np.flatnonzero(~is_near)
    far_count = min(len(far), int((1.0 - _NEAR_FRACTION) * count))
    near_count = min(len(near.places), count - far_count)
    sure = np.arange(len(near.places))
    if near_count < len(sure):
        sizes = near.most_e, -near.most_e, -np.abs(near.most_e - full_well_e)
        sure = np.unique([np.argpartition(size, -_EXTREMES)[-_EXTREMES:] for size in sizes])
    weights = np.zeros(pixels)
    weights[near.places[sure]] = 1.0
    ordered = np.setdiff1d(np.arange(len(near.places)), sure)
    ordered = near.places[ordered[np.argsort(near.most_e[ordered], kind="stable")]]
    for places, number in ((far, count - near_count), (ordered, near_count - len(sure))):
        drawn, weight = _drawn(chance[places], number)
        weights[places[drawn]] = weight
    places = np.flatnonzero(weights)
    return Sample(places, weights[places], is_near[places])


def _drawn(chance: Floats, count: int) -> tuple[Places, Floats]:
    """Draw distinct indices of `chance` with probabilities proportional to its values,
    deterministically.

    One point is drawn in each of `count` equal strata, by an additive recurrence, so that the
    points do not align with tiles of codes; points at the same index count once. Return the
    indices, ascending, and their weights, whose sum is the number of `chance`: 1 for indices that
    are certain to be drawn. Both are empty if `count` or all of `chance` is 0."""
    total = np.cumsum(chance)
    if count <= 0 or not total[-1] > 0:
        return np.empty(0, np.int64), np.empty(0)
    points = np.arange(count) + (np.arange(count) * _GOLDEN) % 1.0
    found = np.searchsorted(total, points * (total[-1] / count), side="right")
    drawn, times = np.unique(np.minimum(found, len(chance) - 1), return_counts=True)
    expected = chance[drawn] * (count / total[-1])
    sure = expected >= _SURE
    weight = np.where(sure, 1.0, times / np.maximum(expected, 1e-300))
    scale = (len(chance) - np.count_nonzero(sure)) / max(float(weight[~sure].sum()), 1e-300)
    return drawn, np.where(sure, 1.0, weight * scale)


def drawing_chances(
    light: Light, near: NearSaturation, sensor: Sensor, device_seed: int, frame_s: float
) -> Floats:
    """Return the relative probability of drawing each pixel of a scene, (rows * cols,), above 0 for
    all; pixels near saturation and the others are drawn apart. `device_seed`: seed of the chip's
    fixed patterns. `frame_s`: length of the frame in seconds.

    Of eight draws, four are even, two are proportional to the contrast of light up to the full
    well, and one to the squared contrast of all light: neighbours of lamps may cause most of the
    mean square error. The last is proportional to the contrast of the change from frame to frame: a
    flash gives its neighbours charge in the slots in which they are open. Dark charge and leakage
    have a share each if few pixels of the chip have most of it."""
    source = light.motion or light
    total_e = np.minimum(np.nan_to_num(source.sum_e), _MOST_E).astype(np.float32)
    within_well = _contrast(np.minimum(total_e, np.float32(sensor.full_well_e)))
    scores = [
        (4.0, np.ones_like(total_e)),
        (2.0, within_well),
        (1.0, _contrast(total_e) ** 2),
    ]
    if len(source.frames) > 1:
        change = np.zeros_like(total_e)
        for rows, _, strip in source.strips():
            frames = (np.nan_to_num(frame, posinf=_MOST_E) for frame in strip.frames)
            for before, after in pairwise(frames):
                change[rows.start : rows.stop] += np.abs(after - before)
        scores.append((1.0, _contrast(change)))
    device, effects = whole_device(sensor, device_seed, total_e.size), everything()
    dark_e = device.fixed(effects.require_part(CountedDark).per_s) * frame_s
    leaked = device.fixed(effects.require_part(Leak).per_s) * frame_s
    for pattern, charge_e in ((dark_e, dark_e), (leaked, -np.expm1(-leaked) * total_e.reshape(-1))):
        # A spread of a normal distribution needs no draws of its own.
        if ((square := pattern**2) ** 2).mean() > _HEAVY * square.mean() ** 2:
            of_charge = _contrast(charge_e.reshape(total_e.shape).astype(np.float32))
            scores.append((1.0, of_charge**2))
    chance = np.zeros(total_e.size)
    for share, score in scores:
        # Each stratum has its own sum: lamps that saturate must not hide the pixels beside them.
        far, near_score = score.reshape(-1), score.reshape(-1)[near.places].astype(np.float64)
        far[near.places] = 0.0
        chance += far * (share / max(float(far.sum(dtype=np.float64)), 1e-30))
        chance[near.places] += near_score * (share / max(float(near_score.sum()), 1e-30))
    return chance


def _contrast(light_e: Floats32) -> Floats32:
    """Return each pixel's light plus the absolute differences from its four neighbours, in
    electrons, (rows, cols) as `light_e`; beyond the border there is no difference."""
    contrast = light_e.copy()
    for values, differences in ((light_e, contrast), (light_e.T, contrast.T)):
        step = np.abs(values[1:] - values[:-1])
        differences[1:] += step
        differences[:-1] += step
    return contrast
