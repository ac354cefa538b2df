"""What noise alone takes beyond the full well, and beyond the linear range of registers.

Pixels that the mean light leaves in range pass it in a few frames, and lose much then: the one
frame that a plan is made of may show none of that.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.special import ndtr, ndtri

from nscc_runtime.effects.parts import Soft, Well, WordGain
from nscc_runtime.planner.sampled import SampledScene
from nscc_runtime.planner.worst import FRAMES

Values = NDArray[np.float64]

_SIGMAS = 8
_PRECISE = 1e-4


@dataclass(frozen=True, eq=False)
class Rarely:
    """Of pixels (buckets, pixels): the mean `square_e2` of what they lose over frames, and the loss
    `most_e` that one of them passes in one frame of `FRAMES`; each pixel stands for as many as its
    `weight` (pixels,)."""

    square_e2: Values
    most_e: float
    weight: Values

    def but_for(self, seen_e2: Values) -> Rarely:
        """What is not seen in a frame where losses of these squares were, some of them by noise."""
        shown, every = (
            float(np.max(np.where(self.square_e2 > 0, each, 0.0) @ self.weight))
            for each in (seen_e2, self.square_e2)
        )
        part = max(0.0, 1.0 - shown / every) if every > 0 else 0.0
        return replace(self, square_e2=self.square_e2 * part)


def beyond_well(scene: SampledScene, linear: NDArray[np.bool_]) -> Rarely:
    """Of those pixels of a sample that are near saturation: what they lose where PIX passes the
    full well though its mean charge does not, as a normal count has it; nothing of those that are
    not `linear` (pixels near saturation,)."""
    near = scene.sample.near
    lanes, weight = scene.lanes[near], scene.sample.weight[near]
    mean = scene.held_near
    short = scene.all.the(Well).full_e(scene.sensor) - mean
    sigma = np.sqrt(np.maximum(mean, 1e-300))
    z = np.where(linear & (short > 0), short / sigma, np.inf)
    here = z < _SIGMAS
    square, density = np.zeros(z.shape), np.exp(-(z[here] ** 2) / 2) / math.sqrt(2 * math.pi)
    square[here] = (1 + z[here] ** 2) * ndtr(-z[here]) - z[here] * density
    square *= sigma**2
    gain = scene.by_lane.most[:, lanes]
    part = np.broadcast_to(weight, z.shape)[here]
    most_e = _passed(z[here], sigma[here], part)
    return Rarely(square.sum(axis=0) * gain**2, most_e * float(gain.max(initial=0.0)), weight)


def beyond_registers(scene: SampledScene, expected_e: Values) -> Rarely:
    """Of those pixels of a sample that are near saturation: what they lose of `expected_e`
    (buckets, pixels) where noise takes registers beyond their linear range."""
    near = scene.sample.near
    reach, soft = scene.program.reach, scene.all.the(Soft)
    lanes, weight = scene.lanes[near], scene.sample.weight[near]
    # What a register held at most of light, before words and leakage took their part of it, and
    # the errors of these pixels' own words.
    gain = scene.by_lane.most[:, lanes]
    held_e = np.abs(expected_e - scene.pattern[:, near]) / np.where(gain > 0, gain, 1.0)
    error_e = np.abs(scene.on_device(scene.all.the(WordGain).error_e)[near])
    size = held_e + reach.offset_e[lanes] * (error_e / max(reach.word_e, 1e-300))
    sigma = np.sqrt(reach.sigma_e[lanes] ** 2 + np.abs(expected_e))
    square = np.zeros(size.shape)
    far = soft.lost_e(scene.sensor, size + _SIGMAS * sigma) > 0
    if not far.any():
        return Rarely(square, 0.0, weight)
    size, sigma = size[far], sigma[far]
    z = np.linspace(-_SIGMAS, _SIGMAS, 16 * _SIGMAS + 1)
    density = np.exp(-z * z / 2)
    lost = soft.lost_e(scene.sensor, size + np.multiply.outer(z, sigma)) ** 2
    # Of many pixels the one that goes farthest may carry all of it.
    count = max(2.0, weight.sum())
    farthest = np.argmin(np.abs(z - (math.sqrt(2 * math.log(count)) + 1.0)))
    square[far] = np.maximum(density @ lost / density.sum(), lost[farthest] / count)
    rare = -ndtri(1.0 / (FRAMES * count))
    return Rarely(square, float(soft.lost_e(scene.sensor, size + rare * sigma).max()), weight)


def _passed(z: Values, sigma: Values, weight: Values) -> float:
    """The loss that one of so many pixels passes in one frame of `FRAMES`; their limits are `z`
    standard deviations `sigma` above their means."""
    low, high = 0.0, float((_SIGMAS * sigma).max(initial=0.0))
    if not len(z) or weight @ ndtr(-z) <= 1.0 / FRAMES:
        return 0.0
    while high - low > _PRECISE * max(high, 1.0):
        middle = (low + high) / 2
        more = weight @ ndtr(-z - middle / sigma) > 1.0 / FRAMES
        low, high = (middle, high) if more else (low, middle)
    return high
