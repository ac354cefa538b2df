"""Motion inside slots: a clip whose frames are samples changes linearly from each to the next."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.light import Light


def with_motion(
    light: Light, seconds: NDArray[np.float64] | None = None, fps: float = 1.0
) -> Light:
    """`light`, a clip, with its `motion`: frame k is the light at the start of its time.

    Each entry of the matrix spends `seconds` in its frame, of 1 / `fps`, and the entries follow
    each other without a gap; without `seconds` each is the whole of its frame. The light stands
    still in the last frame, which no sample follows.
    """
    entries = len(light.frame_index)
    begin, end = np.zeros(entries), np.ones(entries)
    if seconds is not None:
        stop = np.cumsum(seconds) * fps - light.frame_index
        begin, end = np.clip(stop - seconds * fps, 0.0, 1.0), np.clip(stop, 0.0, 1.0)
    after = np.minimum(light.frame_index + 1, len(light.frames) - 1).astype(np.int32)
    later = light.weight * (begin + end) / 2
    moving = Light(
        frames=light.frames,
        row_start=2 * light.row_start,
        frame_index=np.stack([light.frame_index, after], axis=1).reshape(-1),
        weight=np.stack([light.weight - later, later], axis=1).reshape(-1),
        kind=light.kind,
        exposure_scale_e=light.exposure_scale_e,
    )
    return replace(light, motion=moving)
