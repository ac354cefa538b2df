"""Total variation denoising of clips, in one thread, by a compiled loop."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_training.baselines.tv_loop import Volume, denoise

Clip = NDArray[np.float32]


def tv_denoise(clip: Clip, weight: float, iterations: int, time: float = 1.0) -> Clip:
    """Denoise a clip (T, rows, cols) by Chambolle's method, isotropic in space and time.

    `time` weights differences between frames relative to those between pixels; 0 denoises every
    frame alone. The dual field starts at 0. Raises ValueError for an array that is not a clip and
    for a weight of 0 or less."""
    if clip.ndim != 3 or 0 in clip.shape:
        raise ValueError(f"a clip of the shape {clip.shape}")
    if not weight > 0 or iterations < 0 or not time >= 0:
        raise ValueError(f"weight {weight}, {iterations} iterations, time {time}")
    return np.asarray(tv_denoised_arrays(clip[None], weight, iterations, time)[0])


def tv_denoised_arrays(clips: NDArray[Any], weight: float, iterations: int, time: float) -> Clip:
    """Return clips (batch, T, rows, cols), each denoised as `tv_denoise` does."""
    image = np.ascontiguousarray(clips, np.float32)
    field = np.zeros((3, *image.shape), np.float32)
    out = np.empty_like(image)
    batch, frames, rows, cols = image.shape
    volume = Volume(
        clips=batch, frames=frames, rows=rows, cols=cols, iterations=iterations, weight=weight,
        time=time,
    )  # fmt: skip
    denoise(volume=volume, image=image, later=field[0], down=field[1], right=field[2], out=out)
    return out
