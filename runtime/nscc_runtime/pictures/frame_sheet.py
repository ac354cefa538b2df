"""Draw a frame: the codes, and the light estimated from them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from nscc_runtime.merge import BucketReadout, light_estimate
from nscc_runtime.pictures.images import Image, image_sheet
from nscc_runtime.pictures.tone import fitted

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def frame_sheet(readouts: Sequence[BucketReadout], title: str) -> Figure:
    """Draw, for every bucket, the frame as read out and the tone-mapped light."""
    rows = []
    for readout in readouts:
        light, usable = light_estimate(readout)
        tone = fitted("log", light[usable])
        window = f"{readout.window[0]} x {readout.window[1]}"
        around = "each pixel" if window == "1 x 1" else f"unsaturated pixels in {window}"
        saturated = np.count_nonzero(readout.saturated) / readout.saturated.size
        readout_texts = f"{readout.name}: as read out", f"8 bit, {saturated:.1%} saturated"
        light_texts = (
            f"{readout.name}: light a second",
            f"electrons / open time of {around}, log scale",
        )
        rows.append((Image(readout.frame, *readout_texts), Image(tone(light), *light_texts)))
    return image_sheet(rows, title)
