"""Several frames of one scene by the reference, read out."""

from __future__ import annotations

from collections.abc import Iterator

from nscc.words.container import Container
from nscc_runtime.effects import Selection
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.emulator.capture import check
from nscc_runtime.frame_file import Frame, converted
from nscc_runtime.light import Light
from nscc_runtime.reference.capture import Reference, scene_of


def frames(
    container: Container,
    light: Light,
    sensor: Sensor,
    effects: Selection,
    *,
    seed: int = 0,
    device_seed: int = 0,
    count: int = 1,
    previous: Light | None = None,
) -> Iterator[Frame]:
    """Frames 0 .. `count` - 1 of `light`, as `nscc_runtime.reference.expose` exposes them.

    What can be refused is refused before the first frame.
    """
    check(container, light)
    reference = Reference.of(container, sensor, effects)
    scene = scene_of(container, light, previous)
    return (
        converted(
            reference.expose(scene, seed, device_seed, number), container.target, sensor, effects,
            (seed, device_seed), number,
        )
        for number in range(count)
    )  # fmt: skip
