"""Protocol hdr-v1: crops of panoramas, exposed so that a given part of them saturates."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.scenes.colour import linear
from nscc_runtime.scenes.picture_files import read_picture
from nscc_training import metrics
from nscc_training.evaluation.results import Item, Scene, Unusable
from nscc_training.measures import decibels, frame_scores, number
from nscc_training.metrics import mean_square_error, psnr_of_mse
from nscc_training.protocols import Protocol
from nscc_training.scene_files import protocol_files

Picture = NDArray[np.float64]
ENDINGS = (".hdr", ".exr", ".pfm")


@dataclass(frozen=True, eq=False)
class Crop(Scene):
    """A scene of the protocol: `light_e` (rows, cols), electrons over the whole frame."""

    file: Path
    corner: tuple[int, int]
    light_e: Picture
    protocol: Protocol

    def item(self, result_e: Picture) -> Item:
        return Item(self.file.name, list(self.corner), None, self.scores(result_e))

    def scores(self, result_e: Picture) -> dict[str, Any]:
        truth_e, protocol = self.light_e, self.protocol
        peak = float(np.percentile(truth_e, protocol["normalise_percentile"]))
        truth, result = (np.clip(x / peak, 0.0, 1.0) for x in (truth_e, result_e))
        well = float(protocol["full_well_e"])
        found: dict[str, Any] = {
            **frame_scores(truth, result, 1.0),
            "mu_psnr_db": decibels(metrics.mu_psnr(truth, result, 1.0, protocol["mu"])),
            "pu21_psnr_db": decibels(metrics.pu21_psnr(truth, result, 1.0, protocol["pu21_nits"])),
        }
        for name, where in (
            ("saturated", truth_e >= well),
            ("dark", truth_e < float(protocol["dark_fraction"]) * well),
        ):
            error = mean_square_error(truth[where], result[where]) if where.any() else None
            found[f"{name}_share"] = float(where.mean())
            found[f"{name}_psnr_db"] = None if error is None else decibels(psnr_of_mse(error, 1.0))
        return found


def panoramas(folder: Path) -> list[Path]:
    """The linear pictures of a folder by name; Rejected (NS0811) where there are none."""
    return protocol_files(
        folder, ENDINGS, "hdr-v1", "panoramas are files ending in",
        "linear panoramas, 512 x 1024",
    )  # fmt: skip


def crops(
    files: list[Path], protocol: Protocol, fraction: float | None = None
) -> Iterator[Crop | Unusable]:
    """The crops of panoramas, in order; those that cannot be used as `Unusable`."""
    rows, cols = protocol["panorama"]
    top, bottom = protocol["crop_rows"]
    size = int(protocol["crop_size"])
    weights = np.array(protocol["luminance"])
    for path in files:
        picture = linear(read_picture(path), "linear")
        light = picture @ weights if picture.ndim == 3 else picture
        if light.shape != (rows, cols):
            yield Unusable(path.name, {"crop": [0, 0]}, f"{light.shape}, not {(rows, cols)}")
            continue
        for left in range(0, cols - size + 1, size):
            part = np.maximum(light[top:bottom, left : left + size], 0.0)
            yield exposed_crop(path, (top, left), part, protocol, fraction)


def exposed_crop(
    path: Path, corner: tuple[int, int], light: Picture, protocol: Protocol,
    fraction: float | None = None,
) -> Crop | Unusable:  # fmt: skip
    """The crop scaled so that `fraction` of its pixels saturate when always open."""
    wanted = float(protocol["saturated_fraction"]) if fraction is None else fraction
    well, place = float(protocol["full_well_e"]), {"crop": list(corner)}
    if not np.isfinite(light).all():
        return Unusable(path.name, place, "its light is not finite")
    level = float(np.quantile(light, 1 - wanted, method="higher"))
    if level <= 0:
        return Unusable(path.name, place, "it is dark where it should saturate")
    scaled = light * (well / level)
    share = float(np.mean(scaled >= well))
    if abs(share - wanted) > float(protocol["saturated_tolerance"]):
        return Unusable(path.name, place, f"{share:.1%} saturate instead of {wanted:.0%}")
    return Crop(path, corner, scaled, protocol)


def parted(
    files: list[Path], protocol: Protocol, fraction: float | None = None
) -> tuple[list[Crop], list[Unusable]]:
    """The crops of panoramas, in order: those that can be used, and the others."""
    every = list(crops(files, protocol, fraction))
    return (
        [crop for crop in every if isinstance(crop, Crop)],
        [crop for crop in every if isinstance(crop, Unusable)],
    )


def also_saturated(
    files: list[Path], protocol: Protocol, scored: Callable[[list[Crop]], Sequence[Item]]
) -> list[dict[str, Any]]:
    """Means at the protocol's other parts of saturated pixels; `scored` gives the crops' items."""
    found = []
    for fraction in protocol["also_saturated"]:
        usable, left_out = parted(files, protocol, fraction)
        items = scored(usable)
        means: dict[str, Any] = {}
        for name in ("psnr_db", "ssim", "mu_psnr_db", "pu21_psnr_db"):
            scores = [number(item.metrics[name]) for item in items]
            mean = metrics.finite_mean(scores) if scores else np.inf
            means[f"mean_{name}"] = None if np.isinf(mean) else mean
        found.append({
            "saturated_fraction": fraction, "crops": len(items), "crops_left_out": len(left_out),
            **means,
        })  # fmt: skip
    return found
