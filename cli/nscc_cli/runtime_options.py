"""Options of scenes, captures and serial ports, as `nscc_runtime` declares them."""

from __future__ import annotations

from nscc_cli.options import (
    DEVICE,
    SCENE,
    build_options,
    declared,
    pixels_option,
    section,
    sensor_options,
    together,
)
from nscc_runtime.device.link_settings import LinkSettings
from nscc_runtime.request import Request
from nscc_runtime.scene_settings import Scene

placing_options = section(
    SCENE,
    declared(
        Scene,
        "exposure",
        "transfer",
        "white",
        "skip",
        "bracket",
        "times",
        "fps",
        "crop",
        "frames_are",
    ),
)
"""Options that place a scene on the array."""

fit_option = section(SCENE, declared(Scene, "fit", show=True))

link_options = section(DEVICE, declared(LinkSettings, show=True))
"""Options of commands that open a serial port."""

measured_options = together(
    declared(Request, "seed", "device_seed", show=True),
    pixels_option,
    placing_options,
    sensor_options,
    build_options,
)
"""Options of tradeoffs that measure frames of a program."""
