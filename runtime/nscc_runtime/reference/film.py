"""Frames of pixels that look, one after the other: kept states go on from each to the next."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.effects import Selection
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Scene
from nscc_runtime.frame_file import Frame, converted
from nscc_runtime.interface import Exposure
from nscc_runtime.looked_light import told_by

Bits = NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Executed:
    """One frame: the exposure, and the digital registers that are read, kept or hold code, as
    planes."""

    exposure: Exposure
    planes: Mapping[str, Bits]


def next_planes(
    container: Container, loaded: Mapping[str, Bits], left: Mapping[str, Bits]
) -> dict[str, Bits]:
    """The registers with which a frame starts after one that has `left` these planes: kept states
    go on, the codes that were `loaded` stay."""
    machine = container.machine
    assert machine is not None
    names = (state.name for state in machine.states if state.kept)
    kept = {register for name in names for register in container.state_planes[name].registers}
    return {**loaded, **{name: plane for name, plane in left.items() if name in kept}}


Exposing = Callable[[Scene, Mapping[str, Bits], tuple[int, int], int, range | None], "Executed"]
"""What exposes (scene, loaded, seeds, frame, rows) as `LookingReference.expose` does."""


def film(
    expose: Exposing, container: Container, scene: Scene, sensor: Sensor, effects: Selection,
    seeds: tuple[int, int], count: int,
) -> Iterator[Frame]:  # fmt: skip
    """Frames 0 .. `count` - 1, one after the other: kept states go on from frame to frame."""
    loaded: Mapping[str, Bits] = container.planes()
    for number in range(count):
        executed = expose(scene, loaded, seeds, number, None)
        loaded = next_planes(container, loaded, executed.planes)
        yield told_frame(container, executed, sensor, effects, seeds, number)


def told_frame(
    container: Container, executed: Executed, sensor: Sensor, effects: Selection,
    seeds: tuple[int, int], number: int,
) -> Frame:  # fmt: skip
    """Frame number `number` as its file has it."""
    frame = converted(executed.exposure, container.target, sensor, effects, seeds, number)
    return replace(frame, told=told_by(container, executed.planes, frame, sensor, effects))
