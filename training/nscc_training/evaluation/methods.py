"""Every way to get a clip from a frame that needs no run: those of baselines, and `any`."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from nscc_training.baselines import sci
from nscc_training.baselines.sci import Method
from nscc_training.baselines.tv import Clip


def _any_clip(measurement: NDArray[np.float32], mask: Clip) -> Clip:
    from nscc_training.any_code.decode import any_clip  # with torch, which the others do without

    return any_clip(measurement, mask)


METHODS: Mapping[str, Method] = {
    **sci.METHODS,
    "any": Method("capture", lambda y, s, _truth, _n, _w: _any_clip(y, s)),
}
