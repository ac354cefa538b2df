"""Protocol video-v1: windows of sixteen frames, cut from the centre of clips."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np

from nscc.arrays import Array, Floats
from nscc_training import curves, metrics
from nscc_training.measures import decibels
from nscc_training.metrics import mean_square_error
from nscc_training.protocol_scenes.protocol_scene import ProtocolScene, Unusable
from nscc_training.protocols import Protocol
from nscc_training.scene_files import centre_of, frames_in, light_in

Clip = Floats


@dataclass(frozen=True, eq=False)
class ClipWindow(ProtocolScene):
    """A window of a clip. `scale_e` is the source's white in electrons per slot. With `srgb`,
    errors are measured in display encoding."""

    scale_e: float
    srgb: bool

    @property
    def peak_e(self) -> float:
        """The light that is white in the file."""
        return self.scale_e

    def scores(self, result_e: Clip) -> dict[str, Any]:
        """Return PSNR and SSIM over the frames, and the RMS error of differences between frames, as
        JSON values.

        `result_e` (N, rows, cols) is in electrons per slot. Frames without any error have infinite
        dB and are only counted."""
        truth, result = (encoded(x / self.scale_e, self.srgb) for x in (self.light_e, result_e))
        errors = [mean_square_error(a, b) for a, b in zip(truth, result, strict=True)]
        frame_summary = metrics.frame_scores(errors, 1.0)
        return {
            "psnr_db": decibels(frame_summary.mean),
            "psnr_of_mean_mse_db": decibels(frame_summary.of_mean_mse),
            "infinite_frames": frame_summary.infinite,
            "ssim": metrics.ssim(truth, result, data_range=1.0),
            "temporal_error": metrics.temporal_error(truth, result, data_range=1.0),
        }


def windows(path: Path, protocol: Protocol) -> Iterator[ClipWindow | Unusable]:
    """Yield the windows of the clip in the file `path`, in order and cut to its centre, at most as
    many as the protocol says; `Unusable` for windows that cannot be exposed."""
    known = protocol["transfer"]
    srgb = known.get(path.suffix.lower().lstrip("."), known["other"]) == "srgb"
    size = int(protocol["size"])
    frames: Iterable[Array] = frames_in(path)
    # A frame that is too small stays whole, because the reason names its size.
    cut = (centre_of(f, size) if min(f.shape[:2]) >= size else f for f in frames)
    lights = (light_in(frame, "srgb" if srgb else "linear") for frame in cut)
    clip_windows = windows_of(path, lights, srgb, protocol)
    yield from islice(clip_windows, protocol.values.get("windows"))


def windows_of(
    path: Path, lights: Iterable[Array], srgb: bool, protocol: Protocol
) -> Iterator[ClipWindow | Unusable]:
    """Yield the windows of one clip from the light of its frames, each (rows, cols). A window
    begins where the one before ends.

    `path` names the clip. With `srgb`, errors are measured in display encoding. A clip that is too
    small or too short gives one `Unusable`; frames after the last whole window are left out."""
    size, count, start = int(protocol["size"]), int(protocol["frames"]), {"frame": 0}
    window: list[Array] = []
    number = -1
    for number, light in enumerate(lights):
        rows, cols = light.shape
        if min(rows, cols) < size:
            yield Unusable(path, start, f"{rows} x {cols} is smaller than {size} x {size}")
            return
        window.append(centre_of(light, size))
        if len(window) == count:
            clip = np.stack(window).astype(np.float64)
            yield exposed_window(path, number + 1 - count, clip, srgb, protocol)
            window = []
    if number + 1 < count:
        yield Unusable(path, start, f"it has {number + 1} frames, but a window has {count}")


def exposed_window(
    path: Path, first: int, light: Clip, srgb: bool, protocol: Protocol
) -> ClipWindow | Unusable:
    """Return a window as a scene: its light is scaled so that a percentile of its light over the
    frame fills a well, or the protocol's part of a well.

    `first` is the number of its first frame in the clip `path`, and `light` (N, rows, cols) is 1
    for white. Returns Unusable for a window that is dark at this percentile."""
    level = float(np.percentile(light.sum(axis=0), protocol["full_well_percentile"]))
    if level <= 0:
        return Unusable(
            path, {"frame": first}, "it is dark at the percentile that should fill a well"
        )
    # In a film of several coded frames, each frame fills a well on average.
    scale_e = float(protocol["full_well_e"]) / level * int(protocol.values.get("film", 1))
    scale_e *= protocol.light
    return ClipWindow(path, None, first, light * scale_e, protocol, scale_e, srgb)


def encoded(light: Clip, srgb: bool) -> Clip:
    """Return light, clipped to 0..1, in the encoding in which errors are measured: sRGB with
    `srgb`, else linear. `light` is relative to white, of any shape."""
    clipped = np.clip(light, 0.0, 1.0)
    return curves.srgb(clipped) if srgb else clipped
