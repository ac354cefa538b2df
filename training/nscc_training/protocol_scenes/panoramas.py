"""Scenes from panoramas: crops (protocol hdr-v1), and moments of turning cameras (deblur-v1)."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from nscc.arrays import Floats
from nscc.mappings import JsonObject
from nscc_runtime.scenes.colour import linear
from nscc_runtime.scenes.picture_files import read_picture
from nscc_training import metrics
from nscc_training.measures import decibels, frame_scores
from nscc_training.protocol_scenes.protocol_scene import (
    Item,
    ProtocolScene,
    Unusable,
    on_unit_range,
)
from nscc_training.protocols import Protocol
from nscc_training.turning_camera import turned

Picture = Floats
ENDINGS = (".hdr", ".exr", ".pfm")
"""Endings of panorama files."""


class Crop(ProtocolScene):
    """A crop of a panorama. Errors are relative to its peak: the percentile of its light that the
    protocol names."""

    @property
    def peak_e(self) -> float:
        """The percentile of the light that the protocol names."""
        return float(np.percentile(self.light_e, self.protocol["normalise_percentile"]))

    def scores(self, result_e: Picture) -> Item:
        """Return the scores of the reconstruction `result_e` as JSON values: PSNR, SSIM, mu-law
        PSNR and PU21 PSNR; and for saturated and for dark pixels their PSNR and their fraction.

        `result_e` (rows, cols) is in electrons over the frame. A pixel counts as saturated if its
        true light over the frame fills the well, and as dark if it is below the fraction
        `dark_fraction` of a full well. The PSNR of either is None if the crop has no such pixels.
        """
        truth_e, protocol = self.light_e, self.protocol
        truth, result = on_unit_range(truth_e, result_e, self.peak_e)
        well_e = float(protocol["full_well_e"])
        values: JsonObject = {
            **frame_scores(truth, result, 1.0),
            "mu_psnr_db": decibels(
                metrics.mu_psnr(truth, result, data_range=1.0, mu=protocol["mu"])
            ),
            "pu21_psnr_db": decibels(
                metrics.pu21_psnr(truth, result, data_range=1.0, nits=protocol["pu21_nits"])
            ),
        }
        dark = truth_e < float(protocol["dark_fraction"]) * well_e
        for name, region in (("saturated", truth_e >= well_e), ("dark", dark)):
            values[f"{name}_share"] = float(region.mean())
            values[f"{name}_psnr_db"] = (
                decibels(metrics.psnr(truth[region], result[region], data_range=1.0))
                if region.any()
                else None
            )
        return values


def light_of(path: Path, protocol: Protocol) -> Picture:
    """Return the light (rows, cols) of a linear picture file: luminance by the protocol's weights,
    with negative values set to 0."""
    picture = linear(read_picture(path), "linear")
    light = picture @ np.array(protocol["luminance"]) if picture.ndim == 3 else picture
    return np.maximum(light, 0.0)


def crops(
    path: Path, protocol: Protocol, fraction: float | None = None
) -> Iterator[Crop | Unusable]:
    """Yield the crops of a panorama, in order; `Unusable` for crops that cannot be exposed, or for
    a picture of another size than the protocol's.

    `fraction` replaces the fraction of a crop that saturates; None keeps the protocol's."""
    light = light_of(path, protocol)
    if light.shape != tuple(protocol["panorama"]):
        reason = f"{light.shape}, not {tuple(protocol['panorama'])}"
        yield Unusable(path, {"crop": [0, 0]}, reason)
    else:
        yield from crops_of(path, light, protocol, fraction)


def crops_of(
    path: Path, light: Picture, protocol: Protocol, fraction: float | None = None
) -> Iterator[Crop | Unusable]:
    """Yield the square crops of a picture from left to right, in its middle rows. `light` is (rows,
    cols). `fraction` replaces the fraction of a crop that saturates, None keeps the protocol's;
    `path` names the picture. A rest at the right that is narrower than a crop is left out."""
    size = min(int(protocol["crop_size"]), *light.shape)
    first_row = (light.shape[0] - size) // 2
    for first_col in range(0, light.shape[1] - size + 1, size):
        region = light[first_row : first_row + size, first_col : first_col + size]
        yield exposed_crop(path, (first_row, first_col), region, protocol, fraction)


def exposed_crop(
    path: Path,
    corner: tuple[int, int],
    light: Picture,
    protocol: Protocol,
    fraction: float | None = None,
) -> Crop | Unusable:
    """Return a crop as a scene: its light is scaled so that `fraction` of its pixels would saturate
    if always open; None takes the protocol's fraction.

    `corner` (row, column) is that of the crop in its picture. Returns Unusable for light that is
    not finite, too dark, or equal in so many pixels that another fraction saturates."""
    share = float(protocol["saturated_fraction"]) if fraction is None else fraction
    well_e, place = float(protocol["full_well_e"]), {"crop": list(corner)}
    if not np.isfinite(light).all():
        return Unusable(path, place, "its light is not finite")
    # "higher" takes the light of a pixel, which is then exactly at the full well.
    level = float(np.quantile(light, 1 - share, method="higher"))
    if level <= 0:
        return Unusable(path, place, "it is dark at the percentile that should saturate")
    scaled = light * (well_e / level)
    saturated = float(np.mean(scaled >= well_e))
    if abs(saturated - share) > float(protocol["saturated_tolerance"]):
        return Unusable(path, place, f"{saturated:.1%} saturate instead of {share:.0%}")
    return Crop(path, corner, None, scaled, protocol)


class DeblurMoment(ProtocolScene):
    """A view of a panorama by a turning camera, in slots. The truth is the light of one slot, as if
    the camera had stood still."""

    @property
    def truth_e(self) -> Picture:
        """The light of the one slot that is scored."""
        return self.moment_e(self.light_e)

    @property
    def peak_e(self) -> float:
        """The percentile of the light of the true slot that the protocol names."""
        return float(np.percentile(self.truth_e, self.protocol["normalise_percentile"]))

    def moment_e(self, clip_e: Picture) -> Picture:
        """Return the true slot of a clip (slots, rows, cols), in electrons over the frame."""
        return np.asarray(clip_e[int(self.protocol["moment"])] * len(clip_e))

    def scores(self, result_e: Picture) -> Item:
        """Return PSNR, SSIM and mu-law PSNR of the light of one slot, as JSON values.

        `result_e` is that light, in electrons over the frame (rows, cols), or a clip (slots, rows,
        cols), of which the slot is taken."""
        result = self.moment_e(result_e) if result_e.ndim == 3 else result_e
        pair = on_unit_range(self.truth_e, result, self.peak_e)
        mu_db = metrics.mu_psnr(*pair, 1.0, self.protocol["mu"])
        return {**frame_scores(*pair, 1.0), "mu_psnr_db": decibels(mu_db)}


def moments(path: Path, index: int, protocol: Protocol) -> Iterator[DeblurMoment | Unusable]:
    """Yield the views of a turning camera in the panorama `path`, in order; `Unusable` for those
    that cannot be exposed.

    A panorama of another size than the protocol's gives only `Unusable`. `index` is the number of
    the panorama. With the number of the view it determines the motion."""
    slots, size = int(protocol["frames"]), int(protocol["size"])
    light = light_of(path, protocol)
    for number in range(int(protocol["views"])):
        if light.shape != tuple(protocol["panorama"]):
            reason = f"{light.shape}, not {tuple(protocol['panorama'])}"
            yield Unusable(path, {"view": number}, reason)
            continue
        drawn = np.random.default_rng((protocol["view_seed"], index, number))
        clip = turned(light.astype(np.float32), drawn, slots, size).astype(np.float64)
        yield exposed_moment(path, number, clip, protocol)


def exposed_moment(
    path: Path, number: int, clip: Picture, protocol: Protocol
) -> DeblurMoment | Unusable:
    """Return view number `number` of the panorama `path` as a scene: its light is scaled so that
    the median over the frame is the protocol's mid grey.

    `clip` (slots, rows, cols) is its light in any unit. Returns Unusable if half of it is dark, or
    light is not finite."""
    grey = float(np.median(clip.sum(axis=0)))
    if not (np.isfinite(clip).all() and grey > 0):
        return Unusable(path, {"view": number}, "half of it is dark")
    wanted_e = protocol.mid_grey_e
    assert wanted_e is not None
    return DeblurMoment(path, None, number, clip * (wanted_e / grey), protocol)
