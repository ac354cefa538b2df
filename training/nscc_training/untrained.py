"""Reconstruction of frames of any program without a network, in numpy: merging and GAP-TV."""

from __future__ import annotations

from importlib.util import find_spec
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from nscc_training.baselines.gap_tv import gap_tv_of
from nscc_training.baselines.hdr import merge_neighbours
from nscc_training.measured import Measured

Method = Literal["network", "merge", "gap-tv"]
_ITERATIONS = 40
_WHITE = 0.995


def method_for(still: bool, method: Method | None = None) -> Method:
    """Return the given method, or the network, or without torch merging or GAP-TV."""
    if method is None and find_spec("torch") is None:
        return "merge" if still else "gap-tv"
    return method or "network"


def gap_tv_clip(measured: Measured[NDArray[Any]]) -> NDArray[np.float32]:
    """Return the clip (N, rows, cols) that GAP-TV reconstructs from a batch of one, in its unit.

    The weight of total variation assumes that white is 1. The 99.5 % quantile of the light of
    opened pixels counts as white."""
    opened = np.broadcast_to(measured.mask.sum(axis=(1, 2)) > 0, measured.mean().shape)
    light = measured.mean()[opened]
    white = np.quantile(light, _WHITE).clip(min=1e-6) if light.size else 1.0
    clip, _ = gap_tv_of(measured.over(np.array([white], np.float32)), _ITERATIONS)
    return np.asarray(clip[0].clip(min=0) * white, np.float32)


def merged_still(measured: Measured[NDArray[Any]]) -> NDArray[np.float32]:
    """Return the light (rows, cols) of a batch of one, merged over neighbourhoods."""
    value, mask = measured.value[0].astype(np.float64), measured.mask[0, :, 0]
    opened, full = mask > 0, measured.saturated[0]
    light = np.where(opened, value / np.where(opened, mask, 1), 0)
    variance = measured.variance[0].clip(min=1e-12).astype(np.float64)
    precision = np.where(opened & ~full, mask**2 / variance, 0)
    total = precision.sum(axis=0)
    mean = (precision * light).sum(axis=0) / np.where(total > 0, total, 1)
    least = np.where(opened & full, light, 0).max(axis=0)
    return merge_neighbours(mean, total, least).astype(np.float32)
