"""Frame files of any program to pictures and clips."""

from __future__ import annotations

from pathlib import Path
from time import perf_counter
from typing import Literal

import numpy as np

from nscc_training.any_code.decode import decoded_clip, decoded_still
from nscc_training.any_code.frames import read_coded_frame
from nscc_training.reconstruct import Reconstruction


def reconstruct_any(
    frame: Path, program: Path | None = None, kind: Literal["image", "video"] | None = None
) -> Reconstruction:
    """What the decoder for any code makes of a frame of any program.

    `program` is what exposed it, where the file does not hold its pixels' shutters. As an image or
    a clip; without `kind` an image where all shutters open with the frame (class b), else a clip.
    Raises Rejected as `read_coded_frame`.
    """
    coded = read_coded_frame(frame, program)
    still = (kind or ("image" if coded.is_still else "video")) == "image"
    begin = perf_counter()
    if still:
        light = decoded_still(coded.still())[0].numpy()
    else:
        slots = (coded.slot_us / coded.slot_us.mean()).astype(np.float32)
        light = decoded_clip(coded.clip())[0].numpy() * slots[:, None, None]
    return Reconstruction(light, still, False, (), perf_counter() - begin)
