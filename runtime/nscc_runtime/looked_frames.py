"""Consecutive frames of programs that look: kept states continue from each frame to the next.

The compiled loop over paths exposes them, or the reference if the loop does not support an effect.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.caches import OfContainer
from nscc_runtime.effects import Selection
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Scene
from nscc_runtime.emulator.capture import check
from nscc_runtime.frame_file import Frame, check_adc, converted
from nscc_runtime.interface import Executed
from nscc_runtime.light import Light
from nscc_runtime.looked_light import told_by
from nscc_runtime.looking.looking_program import LookingProgram
from nscc_runtime.pool import threads_of
from nscc_runtime.reference.capture import scene_of
from nscc_runtime.reference.looks import LookingReference

Planes = Mapping[str, NDArray[np.bool_]]

looking_program_of = OfContainer(LookingProgram)
"""Return the `LookingProgram` of a container on a sensor, cached for each pair."""


def next_planes(
    container: Container, loaded: Planes, final_planes: Planes
) -> dict[str, NDArray[np.bool_]]:
    """Return the registers (rows, cols) at the start of the next frame, by name. Kept states are
    taken from the `final_planes` of this frame, everything else from `loaded`."""
    machine = container.machine
    names = (state.name for state in machine.states if state.is_kept)
    kept_registers = {
        register for name in names for register in container.state_planes[name].registers
    }
    return {
        **loaded,
        **{name: plane for name, plane in final_planes.items() if name in kept_registers},
    }


Exposing = Callable[[Scene, Planes, tuple[int, int], int, range | None], Executed]
"""A function of (scene, loaded, seeds, frame, rows) that exposes like `LookingReference.expose`."""


def film(
    expose: Exposing, container: Container, scene: Scene, sensor: Sensor, effects: Selection,
    seeds: tuple[int, int], count: int,
) -> Iterator[Frame]:  # fmt: skip
    """Yield frames 0 to `count` - 1; kept states continue from frame to frame."""
    loaded: Planes = container.planes()
    for number in range(count):
        executed = expose(scene, loaded, seeds, number, None)
        loaded = next_planes(container, loaded, executed.planes)
        frame = converted(executed.exposure, container.target, sensor, effects, seeds, number)
        yield replace(frame, told=told_by(container, executed.planes, frame, sensor, effects))


def exposer(
    looking_program: LookingProgram, effects: Selection, threads: int = 1, by_words: bool = False
) -> Exposing:
    """Return a function of (scene, loaded, seeds, frame, rows) that exposes with these effects.

    It uses the compiled loop, or the reference if the loop does not support an effect, or with
    `by_words`."""
    if by_words or looking_program.lacks(effects):
        return LookingReference(
            looking_program.container, looking_program.sensor, effects, threads
        ).expose
    return lambda scene, loaded, seeds, frame, rows: looking_program.expose(
        scene, loaded, effects, seeds, frame, rows, threads
    )


def frames(
    container: Container, light: Light, sensor: Sensor, effects: Selection, *,
    seed: int = 0, device_seed: int = 0, count: int = 1, threads: int | None = None,
    by_words: bool = False,
) -> Iterator[Frame]:  # fmt: skip
    """Yield frames 0 to `count` - 1 of `light`; kept states continue from frame to frame.

    `by_words`: use the reference. Results do not depend on `threads` (None: all processors). Raises
    Rejected, before the first frame, for programs and light that cannot run."""
    check(container, light)
    check_adc(container.target)
    scene, threads = scene_of(container, light), threads_of(threads)
    expose = exposer(looking_program_of(container, sensor), effects, threads, by_words)
    return film(expose, container, scene, sensor, effects, (seed, device_seed), count)
