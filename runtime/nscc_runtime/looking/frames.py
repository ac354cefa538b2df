"""Frames of programs that look: by their ways, or by the reference where these lack an effect."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.effects import Selection
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.emulator.capture import check
from nscc_runtime.frame_file import Frame, check_adc
from nscc_runtime.light import Light
from nscc_runtime.looking.ways import Ways
from nscc_runtime.pool import threads_of
from nscc_runtime.ready import MadeReady
from nscc_runtime.reference.capture import scene_of
from nscc_runtime.reference.film import Exposing, film
from nscc_runtime.reference.looks import LookingReference

Planes = Mapping[str, NDArray[np.bool_]]

ways_of = MadeReady(Ways)
"""The ways of a program on a sensor."""


def exposer(ways: Ways, effects: Selection, threads: int = 1) -> Exposing:
    """What exposes (scene, loaded, seeds, frame, rows) with these effects."""
    if ways.lacks(effects):
        return LookingReference(ways.container, ways.sensor, effects, threads).expose
    return lambda scene, loaded, seeds, frame, rows: ways.expose(
        scene, loaded, effects, seeds, frame, rows, threads
    )


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
    threads: int | None = None,
) -> Iterator[Frame]:
    """As `nscc_runtime.reference.looks.looking_frames`; `threads`, by default as many as there are
    processors, change no bit."""
    check(container, light)
    check_adc(container.target)
    ways = ways_of(container, sensor)
    expose = exposer(ways, effects, threads_of(threads))
    scene = scene_of(container, light, previous)
    return film(expose, container, scene, sensor, effects, (seed, device_seed), count)
