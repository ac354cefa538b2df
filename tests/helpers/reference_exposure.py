"""One exposure by the reference, before the converter, for tests that compare it."""

from __future__ import annotations

from nscc.words.container import Container
from nscc_runtime.effects import Selection
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.emulator.capture import check
from nscc_runtime.exposed_frame import Exposure
from nscc_runtime.light import Light
from nscc_runtime.reference.capture import Reference, reference_scene


def expose(
    container: Container,
    light: Light,
    sensor: Sensor,
    effects: Selection,
    *,
    seed: int = 0,
    device_seed: int = 0,
    frame: int = 0,
    threads: int | None = None,
) -> Exposure:
    """The exposure of frame number `frame` with the noise of `seed` and the fixed patterns of
    `device_seed`. Raises Rejected if the program and the light do not fit."""
    check(container, light)
    scene = reference_scene(container, light)
    return Reference.of(container, sensor, effects).expose(scene, seed, device_seed, frame, threads)
