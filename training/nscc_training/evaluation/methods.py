"""Every way to get a clip from a frame that needs no run: those of baselines, and `any`."""

from __future__ import annotations

from collections.abc import Mapping

from nscc_training.any_code.decode import any_clip
from nscc_training.baselines import sci
from nscc_training.baselines.sci import Method

METHODS: Mapping[str, Method] = {
    **sci.METHODS,
    "any": Method("capture", lambda y, s, _truth, _n, _w: any_clip(y, s)),
}
