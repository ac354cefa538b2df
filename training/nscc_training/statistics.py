"""Means, spreads and intervals of scores, computed without cancellation."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

RESAMPLES = 2000


class Moments:
    """Count, mean and variance of values that arrive in blocks of any size.

    Blocks are merged as by Chan, Golub and LeVeque; within a block the variance takes two passes.
    """

    def __init__(self) -> None:
        self.count = 0
        self.mean = 0.0
        self._squares = 0.0

    def add(self, values: ArrayLike) -> None:
        block = np.asarray(values, np.float64).ravel()
        if block.size == 0:
            return
        mean = float(block.mean())
        squares = float(np.square(block - mean).sum())
        total = self.count + block.size
        apart = mean - self.mean
        self._squares += squares + apart * apart * self.count * block.size / total
        self.mean += apart * block.size / total
        self.count = total

    @property
    def variance(self) -> float:
        """The unbiased variance; 0 for fewer than two values."""
        return self._squares / (self.count - 1) if self.count > 1 else 0.0


def summary(values: Sequence[float], groups: Sequence[str], seed: int = 0) -> dict[str, Any]:
    """Return `mean`, `sd` and `ci95` of scores; infinite scores are excluded and counted in
    `infinite`.

    `groups` names the scene of each value. The interval is a bootstrap over scenes, because crops
    of one scene are not independent. It is None for a single scene; all three are None without
    finite values. Raises ValueError for NaN."""
    if any(np.isnan(value) for value in values):
        raise ValueError("NaN is not a score")
    finite = [(v, g) for v, g in zip(values, groups, strict=True) if np.isfinite(v)]
    moments = Moments()
    moments.add([v for v, _ in finite])
    interval = None
    if len({g for _, g in finite}) > 1:
        interval = bootstrap([v for v, _ in finite], [g for _, g in finite], seed)
    return {
        "mean": moments.mean if finite else None,
        "sd": moments.variance**0.5 if finite else None,
        "ci95": list(interval) if interval else None,
        "infinite": len(values) - len(finite),
    }


def bootstrap(values: Sequence[float], groups: Sequence[str], seed: int = 0) -> tuple[float, float]:
    """Return the 95 % interval of the mean of values, from a bootstrap over groups."""
    names, of_value = np.unique(np.asarray(groups, np.str_), return_inverse=True)
    sums = np.bincount(of_value, weights=np.asarray(values, np.float64), minlength=len(names))
    counts = np.bincount(of_value, minlength=len(names)).astype(np.float64)
    draws = np.random.default_rng(seed).integers(len(names), size=(RESAMPLES, len(names)))
    means = sums[draws].sum(axis=1) / counts[draws].sum(axis=1)
    low, high = np.percentile(means, (2.5, 97.5))
    return float(low), float(high)


def paired(
    first: Mapping[str, float], second: Mapping[str, float], scene_of: Mapping[str, str]
) -> dict[str, Any]:
    """Return the gain of second scores over first scores on their common items, matched by name.

    Infinite scores are excluded and counted. `ci95` is a bootstrap over scenes."""
    common = sorted(set(first) & set(second))
    if any(np.isnan(score) for score in (*first.values(), *second.values())):
        raise ValueError("NaN is not a score")
    gains = [
        second[k] - first[k] if np.isfinite(first[k]) and np.isfinite(second[k]) else np.inf
        for k in common
    ]
    gain_summary = summary(gains, [scene_of[k] for k in common])
    return {
        "items": len(common),
        "scenes": len({scene_of[k] for k in common}),
        "only_first": len(set(first) - set(second)),
        "only_second": len(set(second) - set(first)),
        "gain_db": gain_summary.pop("mean"),
        **gain_summary,
    }
