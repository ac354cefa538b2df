"""Frame files of any program to pictures and clips."""

from __future__ import annotations

from pathlib import Path
from time import perf_counter
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Diagnostic
from nscc_training.any_code.decode import decoded_clip, decoded_still
from nscc_training.any_code.frames import CodedFrame, read_coded_frames
from nscc_training.reconstruct import Reconstruction, overexposed


def reconstruct_any(
    frame: Path, program: Path | None = None, kind: Literal["image", "video"] | None = None,
    dark: Path | None = None,
) -> Reconstruction:  # fmt: skip
    """What the decoder for any code makes of a frame of any program.

    `program` is what exposed it, where the file does not hold its pixels' shutters; `dark` a frame
    file of it without light, of many repeats. As an image or a clip; without `kind` an image where
    all shutters open with the frame (class b), else a clip. Colours are decoded one by one. Raises
    Rejected as `read_coded_frames`.
    """
    doubts: list[Diagnostic] = []
    coded_frames = read_coded_frames(frame, program, dark, doubts.append)
    still = (kind or ("image" if coded_frames[0].is_still else "video")) == "image"
    begin = perf_counter()
    lights = [_light(coded, still) for coded in coded_frames]
    light = np.stack(lights, axis=-1) if len(lights) > 1 else lights[0]
    full = np.stack([coded.saturated for coded in coded_frames])
    messages = (*doubts, *overexposed(str(frame), full))
    return Reconstruction(light, still, len(lights) > 1, messages, perf_counter() - begin)


def _light(coded: CodedFrame, still: bool) -> NDArray[np.float32]:
    """Electrons over the frame (rows, cols), or a slot (N, rows, cols)."""
    if still:
        return np.asarray(decoded_still(coded.still())[0].numpy())
    slots = (coded.slot_us / coded.slot_us.mean()).astype(np.float32)
    return np.asarray(decoded_clip(coded.clip())[0].numpy() * slots[:, None, None])
