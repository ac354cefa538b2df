"""Several frames of one scene by the reference, read out."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.effects import Selection
from nscc_runtime.effects.readout import ADC_NOISE, noise_lsb
from nscc_runtime.emulator.capture import check
from nscc_runtime.frame_file import Frame, read_out
from nscc_runtime.light import Light
from nscc_runtime.reference.capture import Reference, scene_of
from nscc_runtime.sensor.sensor import Sensor


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
    rows, cols = light.shape
    places = np.arange(rows * cols, dtype=np.int64)

    def each() -> Iterator[Frame]:
        for number in range(count):
            exposure = reference.expose(scene, seed, device_seed, number)
            noise: NDArray[np.float64] | float = 0.0
            if ADC_NOISE in effects:
                buckets = range(len(container.buckets))
                drawn = [noise_lsb(sensor, seed, number, bucket, places) for bucket in buckets]
                noise = np.stack(drawn).reshape(exposure.exposure_e.shape)
            yield read_out(exposure, container.target, sensor, noise)

    return each()
