"""The `meta` of frames that a device exposed: the keys of the emulator's, without its physics."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from nscc_runtime.device.messages import Info
from nscc_runtime.frame_file import SCHEMA, Frame
from nscc_runtime.light import Light
from nscc_runtime.sensor import Sensor, sensor_sha256


def device_meta(
    frame: Frame,
    info: Info,
    sensor: Sensor,
    program_sha256: str,
    buckets: Sequence[str],
    lowering: str | None,
    light: Light | None = None,
) -> dict[str, Any]:
    """What a frame file says of a device's frame. `light`: the scene, where the user named it.

    Seeds, plan and audit are None: nothing was simulated here.
    """
    return {
        "schema": SCHEMA,
        "program_sha256": program_sha256,
        "scene_sha256": light.sha256() if light else None,
        "sensor_sha256": sensor_sha256(sensor),
        "seed": None,
        "device_seed": None,
        "fidelity": "device",
        "lowering": lowering,
        "buckets": list(buckets),
        "electrons_per_lsb": sensor.electrons_per_lsb,
        "adc_offset": sensor.adc_offset_lsb,
        "exposure_scale_e": light.exposure_scale_e if light else None,
        "invalid_pixels": int(np.count_nonzero(~frame.valid)),
        "plan": None,
        "audit": None,
        "device": {"target": info.target_name, "loader": info.firmware},
    }
