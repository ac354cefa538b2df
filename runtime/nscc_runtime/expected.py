"""The noise that a frame is expected to have, before there is one."""

from __future__ import annotations

from math import sqrt

import numpy as np

from nscc.words.container import Container
from nscc.words.readout import converter_of
from nscc_runtime.decode_table import decode_arrays
from nscc_runtime.sensor import Sensor, default_sensor


def expected_noise(
    container: Container, sensor: Sensor | None = None
) -> tuple[float, float] | None:
    """The rms in electrons, over pixels and buckets, in the dark and at half a full well.

    Photons, dark current, resets, reads, analog words and the converter's steps are counted, with
    the figures of `sensor` (default: the chip's own), as light that fell while pixels were open.
    None for a program without pixels or without shutters that codes alone tell.
    """
    sensor = sensor or default_sensor(converter_of(container))
    arrays = decode_arrays(container, sensor, None) if container.machine is None else {}
    if not arrays:
        return None
    row = arrays["decode_row"]
    used = np.bincount(row.reshape(-1), minlength=len(arrays["decode_gain"]))
    opened = np.unpackbits(arrays["decode_shutter"], axis=-1).any(axis=-1)
    weight = opened * used[:, None]
    if not weight.any():
        return None
    gain = arrays["decode_gain"].astype(np.float64)
    dark_e2 = float(np.average(arrays["decode_variance_e2"] / gain**2, weights=weight))
    return sqrt(dark_e2), sqrt(dark_e2 + sensor.full_well_e / 2)
