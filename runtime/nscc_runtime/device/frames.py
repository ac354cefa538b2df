"""Frames that a device exposed: `meta` has the keys of the emulator's, without its physics."""

from __future__ import annotations

from typing import Any

import numpy as np

from nscc.words.container import Container
from nscc_runtime.device.chip import Chip
from nscc_runtime.frame_file import SCHEMA, Frame, open_us, stacked
from nscc_runtime.light import Light
from nscc_runtime.progress import Progress, unseen
from nscc_runtime.sensor import Sensor, default_sensor, sensor_sha256


def exposed(
    chip: Chip,
    container: Container,
    light: Light | None = None,
    repeat: int | None = None,
    progress: Progress = unseen,
) -> tuple[Frame, dict[str, Any]]:
    """The frame that `chip` exposes with a program, or `repeat` of them, and its meta.

    `light`: the scene before it, where that is known. Raises Rejected (status 3) where it fails.
    """
    chip.upload(container)
    count = repeat or 1
    shots = (chip.capture(container) for _ in range(count))
    frames = [shot.frame for shot in progress(shots, "exposing", count)]
    frame = stacked(frames) if repeat else frames[0]
    sensor = chip.sensor or default_sensor(container.target)
    return frame, device_meta(chip, frame, sensor, container, light)


def device_meta(
    chip: Chip,
    frame: Frame,
    sensor: Sensor,
    container: Container | None,
    light: Light | None = None,
) -> dict[str, Any]:
    """What a frame file says of a frame that `chip` exposed just now.

    `container` None: a program that the device held, whose buckets have numbers. `light`: the
    scene, where the user named it. Seeds, plan and audit are None: nothing was simulated here.
    """
    info = chip.link.host.info
    assert info is not None  # a frame came
    return {
        "schema": SCHEMA,
        "program_sha256": chip.label.hex(),
        "scene_sha256": light.sha256() if light else None,
        "sensor_sha256": sensor_sha256(sensor),
        "seed": None,
        "device_seed": None,
        "fidelity": "device",
        "lowering": container.notes.get("lowering") if container else None,
        "buckets": [*container.buckets]
        if container
        else [f"bucket{number}" for number in range(frame.frame.shape[-3])],
        "electrons_per_lsb": sensor.electrons_per_lsb,
        "adc_offset": sensor.adc_offset_lsb,
        "exposure_scale_e": light.exposure_scale_e if light else None,
        "open_us": open_us(container) if container else None,
        "invalid_pixels": int(np.count_nonzero(~frame.valid)),
        "plan": None,
        "audit": None,
        "device": {"target": info.target_name, "loader": info.firmware},
    }
