"""Clips with a frame rate: pictures spread over the slots that they last into."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.light import Light
from nscc_runtime.scenes.exposure import Exposure, scale
from nscc_runtime.scenes.timing import Overlaps


def spread(frames: NDArray[np.float32], seconds: Overlaps, wanted: Exposure, name: str) -> Light:
    """A clip of electrons a second, up to a factor, that slots integrate piecewise constant."""
    share = np.bincount(seconds.frame_index, seconds.seconds, len(frames))
    open_sum = np.zeros(frames.shape[1:], np.float64)
    for frame, time_s in zip(frames, share, strict=True):
        open_sum += frame * time_s
    factor = scale(open_sum, wanted, name)
    return Light(
        frames=frames,
        row_start=seconds.row_start,
        frame_index=seconds.frame_index,
        weight=seconds.seconds * factor,
        kind="clip",
        exposure_scale_e=factor,
    )
