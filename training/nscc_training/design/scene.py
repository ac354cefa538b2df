"""Statistics of scenes for a design: histograms of light."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from nscc.arrays import Floats, Ints
from nscc.diagnostics.diagnostic import rejected
from nscc_training.design.chip import PERCENTILE, Curve, DesignChip

_GROUPS = 256
"""Number of histogram groups for all scenes together: a tenth of a stop each, over 25 stops."""
_FEWEST = 24
"""Fewest groups for one scene."""


class Histogram(NamedTuple):
    """The pixels of scenes, joined to groups of nearly equal light; arrays are (groups,).

    `light_e` is the light of the group in electrons over the frame, `peak_e` the light that counts
    as white in its scene, `weight` its fraction of all pixels, with equal weight for every scene.
    `scene` is the index of its scene."""

    light_e: Floats
    peak_e: Floats
    weight: Floats
    scene: Ints

    def weighed(self, by: Floats) -> Histogram:
        """Return the histogram in which the weights of each scene are multiplied by its factor in
        `by` (scenes,). The sum of all weights is 1."""
        weight = self.weight * by[self.scene]
        return self._replace(weight=weight / weight.sum())


def histogram(scenes: Sequence[NDArray[np.floating]]) -> Histogram:
    """Return the pixels of the scenes, each (rows, cols) in electrons over the frame, in groups of
    nearly equal light, whose widths are equal in the logarithm.

    Groups without pixels are left out; those of a later scene follow. There is at least one scene.
    Raise Rejected (NS0824) for a scene without light."""
    count = max(_FEWEST, _GROUPS // max(1, len(scenes)))
    histograms = []
    for number, scene in enumerate(scenes):
        light = np.asarray(scene, np.float64).reshape(-1)
        peak = peak_of(light, number)
        # Light below a billionth of the peak cannot be measured with any shutter.
        logs = np.log(np.maximum(light, 1e-9 * peak))
        low, high = float(logs.min()), float(logs.max())
        bin_index = np.minimum(
            ((logs - low) / max(high - low, 1e-12) * count).astype(np.intp), count - 1
        )
        pixel_counts = np.bincount(bin_index, minlength=count)
        is_filled = pixel_counts > 0
        mean = np.bincount(bin_index, light, count)[is_filled] / pixel_counts[is_filled]
        weight = pixel_counts[is_filled] / (len(light) * len(scenes))
        histograms.append((mean, np.full(len(mean), peak), weight, np.full(len(mean), number)))
    return Histogram(*(np.concatenate(arrays) for arrays in zip(*histograms, strict=True)))


def best_stop(chip: DesignChip, light_e: NDArray[np.floating], slots: int, curve: Curve) -> int:
    """Return the exposure time, in slots, that an ordinary camera would choose for all pixels.

    Of the times from one slot to all slots in ratios of about the square root of 2 (`stops_tried`),
    it has the smallest expected error of the light after the tone curve `curve` ("mu", "linear" or
    "log"). `light_e` (rows, cols) is in electrons over all slots. Of equal errors the shortest time
    counts. Raises Rejected (NS0824) for a scene without light."""
    light = histogram([light_e])
    stops = stops_tried(slots)
    errors = chip.errors(light.light_e, light.peak_e, np.array(stops) / slots, curve)
    return stops[int((light.weight[:, None] * errors).sum(axis=0).argmin())]


def stops_tried(slots: int) -> list[int]:
    """Return exposure times in whole slots, from one slot to all slots, with ratios of about the
    square root of 2. They increase."""
    count = int(2 * np.log2(slots)) + 1
    return sorted({slots, *(round(2 ** (k / 2)) for k in range(count))})


def peak_of(light: Floats, number: int = 0) -> float:
    """Return the light that counts as white: the percentile `PERCENTILE`, or if that is dark, the
    maximum.

    Raises Rejected (NS0824) for a scene without light, which the message calls by its `number` plus
    1."""
    peak = float(np.percentile(light, PERCENTILE))
    if peak <= 0:
        peak = float(light.max())
    if peak <= 0:
        raise rejected(
            "NS0824",
            f"scene {number + 1} has no light, so no shutters can be designed for it",
            helps=("use a scene with light; --exposure sets how much light a frame receives",),
        )
    return peak
