"""Protocol deblur-v1: views of panoramas by a turning camera; the truth is the light of one
slot."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from nscc.arrays import Floats
from nscc_training import metrics
from nscc_training.measures import decibels, frame_scores
from nscc_training.protocol_scenes.hdr import light_of
from nscc_training.protocol_scenes.protocol_scene import ProtocolScene, Unusable, on_unit_range
from nscc_training.protocols import Protocol
from nscc_training.turning_camera import turned

Picture = Floats


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

    def scores(self, result_e: Picture) -> dict[str, Any]:
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
