"""Protocol video-v1: windows of sixteen frames, at the source's own rate, cut from the centre."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_training import curves, metrics
from nscc_training.evaluation.results import Item, Scene, Unusable
from nscc_training.measures import decibels
from nscc_training.metrics import mean_square_error
from nscc_training.protocols import Protocol
from nscc_training.scene_files import CLIPS, frames_in, light_in, protocol_files

Clip = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Window(Scene):
    """A scene of the protocol: `light_e` (16, rows, cols), electrons a slot.

    `scale_e` electrons a slot are 1 in the source's light; `srgb` says how it is encoded.
    """

    file: Path
    first: int
    light_e: Clip
    scale_e: float
    srgb: bool

    def item(self, result_e: Clip) -> Item:
        return Item(self.file.name, None, self.first, self.scores(result_e))

    def scores(self, result_e: Clip) -> dict[str, Any]:
        truth, result = (encoded(x / self.scale_e, self.srgb) for x in (self.light_e, result_e))
        errors = [mean_square_error(a, b) for a, b in zip(truth, result, strict=True)]
        found = metrics.frame_scores(errors, 1.0)
        return {
            "psnr_db": decibels(found.mean),
            "psnr_of_mean_mse_db": decibels(found.of_mean_mse),
            "infinite_frames": found.infinite,
            "ssim": metrics.ssim(truth, result, 1.0),
            "temporal_error": metrics.temporal_error(truth, result, 1.0),
        }


def clips_of(folder: Path) -> list[Path]:
    """The clips of a folder by name; Rejected (NS0811) where there are none."""
    return protocol_files(folder, CLIPS, "video-v1", "clips end in", "clips of at least 256 x 256")


def windows(files: list[Path], protocol: Protocol) -> Iterator[Window | Unusable]:
    """The windows of clips, in order; what cannot be used as `Unusable`."""
    size, count, start = int(protocol["size"]), int(protocol["frames"]), {"first": 0}
    for path in files:
        known = protocol["transfer"]
        srgb = known.get(path.suffix.lower().lstrip("."), known["other"]) == "srgb"
        held: list[Clip] = []
        number = -1
        for number, frame in enumerate(frames_in(path)):
            rows, cols = frame.shape[:2]
            if min(rows, cols) < size:
                yield Unusable(path.name, start, f"{rows} x {cols} is smaller than {size} x {size}")
                break
            top, left = (rows - size) // 2, (cols - size) // 2
            part = frame[top : top + size, left : left + size]
            held.append(light_in(part, "srgb" if srgb else "linear"))
            if len(held) == count:
                yield exposed_window(path, number + 1 - count, np.stack(held), srgb, protocol)
                held = []
        else:
            if number + 1 < count:
                yield Unusable(path.name, start, f"it has {number + 1} frames, a window {count}")


def exposed_window(
    path: Path, first: int, light: Clip, srgb: bool, protocol: Protocol
) -> Window | Unusable:
    """The window scaled so that the percentile of its all-open sum is a full well."""
    level = float(np.percentile(light.sum(axis=0), protocol["full_well_percentile"]))
    if level <= 0:
        return Unusable(path.name, {"first": first}, "it is dark where it should fill a well")
    scale = float(protocol["full_well_e"]) / level
    return Window(path, first, light * scale, scale, srgb)


def encoded(light: Clip, srgb: bool) -> Clip:
    """Light in the source's encoding, clipped to 0..1."""
    clipped = np.clip(light, 0.0, 1.0)
    return curves.srgb(clipped) if srgb else clipped
