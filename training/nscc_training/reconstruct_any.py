"""Reconstruction of pictures and clips from frame files of any program, also without a network."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Diagnostic, Severity
from nscc_runtime.formats import Content
from nscc_runtime.machine_code import working_s
from nscc_training.any_code.frames import CodedFrame, read_coded_frames
from nscc_training.baselines.gap_tv import gap_tv_of
from nscc_training.baselines.hdr import merge_neighbours
from nscc_training.measured import Measured

_OVEREXPOSED = 0.25
"""Fraction of saturated pixels above which a warning is given."""


@dataclass(frozen=True, eq=False)
class Reconstruction:
    """A reconstructed picture or clip.

    `light` is float32, a picture (rows, cols) in electrons over the frame, or a clip (T, rows,
    cols) in electrons per slot; with `colour` the last axis is red, green, blue. `messages` are
    warnings about the frame. `decode_s` is the decoding time in seconds. `method` names the method
    of the decoder for any code, else it is empty."""

    light: NDArray[np.float32]
    still: bool
    colour: bool
    messages: tuple[Diagnostic, ...]
    decode_s: float
    method: str = ""

    @property
    def content(self) -> Content:
        """The reconstruction in the form for all output formats."""
        arrays = {"image" if self.still else "video": self.light}
        if self.method:
            arrays["method"] = np.array(self.method)
        # Time is the last axis of clips in MATLAB.
        turned = arrays if self.still else arrays | {"video": np.moveaxis(self.light, 0, -1)}
        return Content(
            arrays, self.light, not self.still, self.colour, benchmark=lambda: turned,
            usual="log" if self.still else "srgb",
        )  # fmt: skip


def overexposed(name: str, saturated: NDArray[np.bool_]) -> Iterator[Diagnostic]:
    """Yield a warning (NS0844) if too many pixels of a frame are saturated."""
    share = float(saturated.mean()) if saturated.size else 0.0
    if share > _OVEREXPOSED:
        yield Diagnostic(
            "NS0844",
            f"{100 * share:.3g} % of the pixels of '{name}' are saturated",
            severity=Severity.WARNING,
            notes=("a saturated pixel gives the decoder only a lower limit of the light",),
            helps=("expose the scene with less light, or use shutters that close early",),
        )  # fmt: skip


Method = Literal["network", "merge", "gap-tv"]
_ITERATIONS = 40
_WHITE = 0.995


def method_for(still: bool, method: Method | None = None) -> Method:
    """Return the given method, or the network, or without torch merging or GAP-TV."""
    if method is None and find_spec("torch") is None:
        return "merge" if still else "gap-tv"
    return method or "network"


def gap_tv_clip(measured: Measured[NDArray[Any]]) -> NDArray[np.float32]:
    """Return the clip (N, rows, cols) that GAP-TV reconstructs from a batch of one, in its unit.

    The weight of total variation assumes that white is 1. The 99.5 % quantile of the light of
    opened pixels counts as white."""
    opened = np.broadcast_to(measured.mask.sum(axis=(1, 2)) > 0, measured.mean().shape)
    light = measured.mean()[opened]
    white = np.quantile(light, _WHITE).clip(min=1e-6) if light.size else 1.0
    clip, _ = gap_tv_of(measured.over(np.array([white], np.float32)), _ITERATIONS)
    return np.asarray(clip[0].clip(min=0) * white, np.float32)


def merged_still(measured: Measured[NDArray[Any]]) -> NDArray[np.float32]:
    """Return the light (rows, cols) of a batch of one, merged over neighbourhoods."""
    value, mask = measured.value[0].astype(np.float64), measured.mask[0, :, 0]
    opened, full = mask > 0, measured.saturated[0]
    light = np.where(opened, value / np.where(opened, mask, 1), 0)
    variance = measured.variance[0].clip(min=1e-12).astype(np.float64)
    precision = np.where(opened & ~full, mask**2 / variance, 0)
    total = precision.sum(axis=0)
    mean = (precision * light).sum(axis=0) / np.where(total > 0, total, 1)
    least = np.where(opened & full, light, 0).max(axis=0)
    return merge_neighbours(mean, total, least).astype(np.float32)


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
