"""Protocol deblur-v1: views of panoramas by a turning camera; the truth is the light of one
slot."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_training import metrics
from nscc_training.measures import decibels, frame_scores
from nscc_training.protocol_scenes.hdr import light_of
from nscc_training.protocol_scenes.protocol_scene import ProtocolScene, Unusable, on_unit_range
from nscc_training.protocols import Protocol
from nscc_training.turning_camera import turned

Picture = NDArray[np.float64]


class DeblurMoment(ProtocolScene):
    """A view of a panorama by a turning camera; the truth is the light of one slot."""

    @property
    def truth_e(self) -> Picture:
        """The light of the one slot that is scored."""
        return self.moment_e(self.light_e)

    @property
    def peak_e(self) -> float:
        """The percentile of that light that the protocol names."""
        return float(np.percentile(self.truth_e, self.protocol["normalise_percentile"]))

    def moment_e(self, clip_e: Picture) -> Picture:
        """Return the true slot of a clip (slots, rows, cols), in electrons over the frame."""
        return np.asarray(clip_e[int(self.protocol["moment"])] * len(clip_e))

    def scores(self, result_e: Picture) -> dict[str, Any]:
        """Return PSNR, SSIM and mu-law PSNR of one slot's light `result_e` (rows, cols), in
        electrons; a clip is cut to this slot."""
        result = self.moment_e(result_e) if result_e.ndim == 3 else result_e
        pair = on_unit_range(self.truth_e, result, self.peak_e)
        mu_db = metrics.mu_psnr(*pair, 1.0, self.protocol["mu"])
        return {**frame_scores(*pair, 1.0), "mu_psnr_db": decibels(mu_db)}


def moments(path: Path, index: int, protocol: Protocol) -> Iterator[DeblurMoment | Unusable]:
    """Yield the views of a panorama, in order; `index` is the panorama's and, with the number of
    the view, seeds the motion."""
    slots, size = int(protocol["frames"]), int(protocol["size"])
    light = light_of(path, protocol)
    for number in range(int(protocol["views"])):
        if light.shape != tuple(protocol["panorama"]):
            reason = f"{light.shape}, not {tuple(protocol['panorama'])}"
            yield Unusable(path.name, {"view": number}, reason)
            continue
        drawn = np.random.default_rng((protocol["view_seed"], index, number))
        clip = turned(light.astype(np.float32), drawn, slots, size).astype(np.float64)
        yield exposed_moment(path, number, clip, protocol)


def exposed_moment(
    path: Path, number: int, clip: Picture, protocol: Protocol
) -> DeblurMoment | Unusable:
    """Return view `number` of the file `path`: `clip` scaled so that the median of its light over
    the frame is the protocol's mid grey. Unusable if half of it is dark."""
    grey = float(np.median(clip.sum(axis=0)))
    if not (np.isfinite(clip).all() and grey > 0):
        return Unusable(path.name, {"view": number}, "half of it is dark")
    wanted_e = protocol.mid_grey_e
    assert wanted_e is not None
    return DeblurMoment(path, None, number, clip * (wanted_e / grey), protocol)
