"""Means, spreads and intervals of scores, computed without cancellation."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

RESAMPLES = 2000
"""Number of samples of a bootstrap."""


def summary(values: Sequence[float], groups: Sequence[str], seed: int = 0) -> dict[str, Any]:
    """Return the statistics of scores by name: `mean`, `sd` (standard deviation), `ci95` (95 %
    interval of the mean), and `infinite`, the number of infinite scores, which are left out.

    `groups`, as long as `values`, names the scene of each value. `sd` is the sample standard
    deviation, 0 for a single finite value. The interval is a bootstrap over scenes, because crops
    of one scene are not independent; `seed` is that of its samples. It is None for a single scene;
    all three are None without finite values. Raises ValueError for NaN."""
    if any(np.isnan(value) for value in values):
        raise ValueError("NaN is not a score")
    finite = [(v, g) for v, g in zip(values, groups, strict=True) if np.isfinite(v)]
    scores = np.array([v for v, _ in finite], np.float64)
    interval = None
    if len({g for _, g in finite}) > 1:
        interval = bootstrap(scores, [g for _, g in finite], seed)
    variance = float(scores.var(ddof=1)) if len(scores) > 1 else 0.0
    return {
        "mean": float(scores.mean()) if finite else None,
        "sd": variance**0.5 if finite else None,
        "ci95": list(interval) if interval else None,
        "infinite": len(values) - len(finite),
    }


def bootstrap(values: ArrayLike, groups: Sequence[str], seed: int = 0) -> tuple[float, float]:
    """Return the limits of the 95 % interval of the mean of values, from a bootstrap over groups.

    `groups`, as long as `values`, names the group of each value; values of one group are drawn
    together. `RESAMPLES` samples are drawn with `seed`. Values must be finite; with a single group
    both limits are the mean."""
    names, of_value = np.unique(np.asarray(groups, np.str_), return_inverse=True)
    sums = np.bincount(of_value, weights=np.asarray(values, np.float64), minlength=len(names))
    counts = np.bincount(of_value, minlength=len(names)).astype(np.float64)
    draws = np.random.default_rng(seed).integers(len(names), size=(RESAMPLES, len(names)))
    means = sums[draws].sum(axis=1) / counts[draws].sum(axis=1)
    low, high = np.percentile(means, (2.5, 97.5))
    return float(low), float(high)


def paired(
    first: Mapping[str, float], second: Mapping[str, float], scene_names: Mapping[str, str]
) -> dict[str, Any]:
    """Return the statistics of the gain, second minus first score, on the items that both have.

    Scores are by the name of the item, and `scene_names` names its scene. `items` and `scenes` are
    counts, `only_first` and `only_second` count items without a partner, and `gain_db` is the mean
    gain. `sd` is the standard deviation of the gains, `ci95` the 95 % interval of their mean (None
    for a single scene), and `infinite` the number of infinite gains, which are left out of the
    others; a gain counts as infinite if either score is. Without common items `gain_db`, `sd` and
    `ci95` are None. Raises ValueError for NaN."""
    common = sorted(set(first) & set(second))
    if any(np.isnan(score) for score in (*first.values(), *second.values())):
        raise ValueError("NaN is not a score")
    gains = [
        second[k] - first[k] if np.isfinite(first[k]) and np.isfinite(second[k]) else np.inf
        for k in common
    ]
    gain_summary = summary(gains, [scene_names[k] for k in common])
    return {
        "items": len(common),
        "scenes": len({scene_names[k] for k in common}),
        "only_first": len(set(first) - set(second)),
        "only_second": len(set(second) - set(first)),
        "gain_db": gain_summary.pop("mean"),
        **gain_summary,
    }
