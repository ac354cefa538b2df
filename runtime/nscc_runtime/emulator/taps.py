"""One frame of a chip without logic, without sensor effects: bits select the tap that collects
light."""

from __future__ import annotations

import numpy as np

from nscc.words.container import Container
from nscc_runtime.interface import Exposure
from nscc_runtime.light import Light


def sorted_light(container: Container, light: Light) -> Exposure:
    """Return the exposure: for each bucket the light that its tap collects, times the tap's gain,
    in float64.

    Raises ValueError for a container without planes. Other errors must be checked before."""
    sent = container.stream
    if sent is None:
        raise ValueError("a container without planes")
    exposure = np.zeros((len(container.buckets), *light.shape))
    for slot in range(container.slots):
        fallen = light.slot(slot).astype(np.float64)
        place = sent.place(slot, light.shape[1])
        for bucket in range(len(exposure)):
            exposure[bucket] += np.where(place == bucket, fallen, 0.0)
    exposure *= np.array([readout.gain for readout in container.readouts])[:, None, None]
    return Exposure(exposure, np.isfinite(exposure))
