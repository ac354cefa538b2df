"""The `meta` of frames that a device exposed: the keys of the emulator's, without its physics."""

from __future__ import annotations

from typing import Any

import numpy as np

from nscc.words.container import Container
from nscc_runtime.device.messages import Info
from nscc_runtime.frame_file import SCHEMA, Frame, open_us
from nscc_runtime.light import Light
from nscc_runtime.sensor import Sensor, sensor_sha256


def device_meta(
    frame: Frame,
    info: Info,
    sensor: Sensor,
    program_sha256: str,
    container: Container | None,
    light: Light | None = None,
) -> dict[str, Any]:
    """What a frame file says of a device's frame. `container` None: a program that the device
    held, whose buckets have numbers. `light`: the scene, where the user named it.

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
        "lowering": container.notes.get("lowering") if container else None,
        "buckets": list(container.buckets) if container else _numbered(frame),
        "electrons_per_lsb": sensor.electrons_per_lsb,
        "adc_offset": sensor.adc_offset_lsb,
        "exposure_scale_e": light.exposure_scale_e if light else None,
        "open_us": open_us(container) if container else None,
        "invalid_pixels": int(np.count_nonzero(~frame.valid)),
        "plan": None,
        "audit": None,
        "device": {"target": info.target_name, "loader": info.firmware},
    }


def _numbered(frame: Frame) -> list[str]:
    return [f"bucket{number}" for number in range(frame.frame.shape[-3])]
