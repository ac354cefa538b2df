"""Draw a frame: the codes, and the light estimated from them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.merge import BucketReadout, light_estimate
from nscc_runtime.pictures.images import Image, image_sheet
from nscc_runtime.scenes.shapes import Field

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def tone_mapped(light: Field, usable: NDArray[np.bool_]) -> NDArray[np.uint8]:
    """Return light (rows, cols) as 8-bit grey on a logarithmic curve, with the median as middle
    grey.

    `usable`: mask of the pixels that determine the curve. If they have no light, the result is
    black."""
    white = float(np.percentile(light[usable], 99.8)) if usable.any() else 0.0
    if white <= 0:
        return np.zeros(light.shape, np.uint8)
    middle = min(float(np.median(light[usable])) / white, 1.0)
    low, high = 0.0, 30.0
    for _ in range(40):
        bend = (low + high) / 2
        grey = np.log1p(2.0**bend * middle) / np.log1p(2.0**bend)
        low, high = (bend, high) if grey < 0.45 else (low, bend)
    curve: Field = np.log1p(2.0**low * np.clip(light / white, 0.0, 1.0)) / np.log1p(2.0**low)
    grey_levels: NDArray[np.uint8] = np.rint(255.0 * curve).astype(np.uint8)
    return grey_levels


def frame_sheet(readouts: Sequence[BucketReadout], title: str) -> Figure:
    """Draw, for every bucket, the frame as read out and the tone-mapped light."""
    rows = []
    for readout in readouts:
        light, usable = light_estimate(readout)
        window = f"{readout.window[0]} x {readout.window[1]}"
        around = "each pixel" if window == "1 x 1" else f"unsaturated pixels in {window}"
        saturated = np.count_nonzero(readout.saturated) / readout.saturated.size
        readout_texts = f"{readout.name}: as read out", f"8 bit, {saturated:.1%} saturated"
        light_texts = (
            f"{readout.name}: light a second",
            f"electrons / open time of {around}, log scale",
        )
        rows.append(
            (Image(readout.frame, *readout_texts), Image(tone_mapped(light, usable), *light_texts))
        )
    return image_sheet(rows, title)
