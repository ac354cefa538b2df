"""Total variation denoising of clips, in one thread, by a compiled loop."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nscc_training.baselines.tv_loop import Volume, denoise

Clip = NDArray[np.float32]


def tv_denoise(clip: Clip, weight: float, iterations: int, time: float = 1.0) -> Clip:
    """Chambolle's denoising of a clip (T, rows, cols), isotropic in space and time.

    `time` weighs differences from frame to frame against those from pixel to pixel; 0 takes every
    frame by itself. As many `iterations` as asked for, from a dual field of 0. ValueError for
    anything but a clip and a weight above 0.
    """
    if clip.ndim != 3 or 0 in clip.shape:
        raise ValueError(f"a clip of the shape {clip.shape}")
    if not weight > 0 or iterations < 0 or not time >= 0:
        raise ValueError(f"weight {weight}, {iterations} iterations, time {time}")
    image = np.ascontiguousarray(clip, np.float32)[None]
    field = np.zeros((3, *image.shape), np.float32)
    out = np.empty_like(image)
    _, frames, rows, cols = image.shape
    volume = Volume(
        clips=1, frames=frames, rows=rows, cols=cols, iterations=iterations, weight=weight,
        time=time,
    )  # fmt: skip
    denoise(volume=volume, image=image, later=field[0], down=field[1], right=field[2], out=out)
    return np.asarray(out[0])
