"""Predict the noise of a frame from the program and the sensor."""

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
    """Return the RMS noise in electrons, over pixels and buckets: in the dark, and at half a full
    well.

    It includes photons, dark current, resets, reads, analog words and the converter, with the
    values of `sensor` (None: the target's defaults). It is relative to the light that a pixel
    collects while it is open. Returns None for a program without pixels, or whose shutters depend
    on more than codes."""
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
