"""Reconstruction of pictures and clips from frame files of any program."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Diagnostic
from nscc_runtime.machine_code import working_s
from nscc_training.any_code.frames import CodedFrame, read_coded_frames
from nscc_training.reconstruction import Reconstruction, overexposed
from nscc_training.untrained import Method, gap_tv_clip, merged_still, method_for

_KINDS: dict[str, Literal["image", "video"]] = {"merge": "image", "gap-tv": "video"}
"""The kind of result of each method that does not use the network."""


def reconstruct_any(
    frame: Path, program: Path | None = None, kind: Literal["image", "video"] | None = None,
    dark: Path | None = None, method: Method | None = None,
) -> Reconstruction:  # fmt: skip
    """Reconstruct a frame of any program with the decoder for any code.

    `program` exposed the frame; it is needed if the file does not contain its shutters. `dark` is a
    dark frame file of the program, with many repeats. Without `kind` the result is an image if all
    shutters open at the start of the frame (class b), else a clip. `method` "merge" is for images,
    "gap-tv" for clips; the default is the network if torch is installed. Each colour is decoded
    separately. Raises Rejected as `read_coded_frames` does."""
    kind = kind or _KINDS.get(method or "network")
    doubts: list[Diagnostic] = []
    coded_frames = read_coded_frames(frame, program, dark, doubts.append)
    still = (kind or ("image" if coded_frames[0].is_still else "video")) == "image"
    method = method_for(still, method)
    begin = working_s()
    lights = [_light(coded, still, method) for coded in coded_frames]
    light = np.stack(lights, axis=-1) if len(lights) > 1 else lights[0]
    full = np.stack([coded.saturated for coded in coded_frames])
    messages = (*doubts, *overexposed(str(frame), full))
    return Reconstruction(light, still, len(lights) > 1, messages, working_s() - begin, method)


def _light(coded: CodedFrame, still: bool, method: Method) -> NDArray[np.float32]:
    """Return electrons over the frame (rows, cols), or per slot (N, rows, cols)."""
    measured = coded.still() if still else coded.clip()
    if method != "network":
        light = merged_still(measured) if still else gap_tv_clip(measured)
    else:
        from nscc_training.any_code.decode import decoded_clip, decoded_still

        light = (decoded_still if still else decoded_clip)(measured.tensors())[0].numpy()
    if still:
        return np.asarray(light)
    slots = (coded.slot_us / coded.slot_us.mean()).astype(np.float32)
    return np.asarray(light * slots[:, None, None])
