"""Consecutive frames of programs that look: kept states continue from each frame to the next.

The block loop exposes them, or the reference if the loop does not support an effect.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace

import numpy as np

from nscc.arrays import Bools
from nscc.words.container import Container
from nscc_runtime.effects import Selection, Sensor
from nscc_runtime.emulator.capture import check
from nscc_runtime.execution.block_program import lacks
from nscc_runtime.execution.block_scene import BlockScene, expose_pixels, prepare_pixels
from nscc_runtime.exposed_frame import Executed, Exposure
from nscc_runtime.frame_file import Frame, check_adc, converted
from nscc_runtime.light import Light
from nscc_runtime.looked_light import told_by
from nscc_runtime.looking.paths import paths_of
from nscc_runtime.pool import threads_of
from nscc_runtime.reference.capture import Reference, reference_scene
from nscc_runtime.reference.trace import retention_us

Planes = Mapping[str, Bools]


def next_planes(container: Container, loaded: Planes, final_planes: Planes) -> dict[str, Bools]:
    """Return the digital registers at the start of the next frame, bits (rows, cols) by name. Kept
    states are taken from `final_planes`, the registers at the end of this frame; everything else
    from `loaded`, those at its start."""
    machine = container.machine
    names = (state.name for state in machine.states if state.is_kept)
    kept_registers = {
        register for name in names for register in container.state_planes[name].registers
    }
    return {
        **loaded,
        **{name: plane for name, plane in final_planes.items() if name in kept_registers},
    }


ExposeFrame = Callable[[Planes, int], Executed]
"""A function of (loaded registers, frame number) that exposes one frame; registers are bits (rows,
cols) by name."""


def frame_exposer(
    container: Container,
    light: Light,
    sensor: Sensor,
    effects: Selection,
    seeds: tuple[int, int],
    threads: int,
    by_words: bool = False,
) -> ExposeFrame:
    """Return a function that exposes frames of one light, prepared once.

    `seeds`: noise seed, device seed. Results do not depend on `threads`. `by_words`: use the
    reference, which is also used for effects and programs that the block loop does not support.
    Raises Rejected if a word is no operation of the chip."""
    if by_words or lacks(container, sensor, effects):
        reference, scene = (
            Reference.of(container, sensor, effects),
            reference_scene(container, light),
        )
        return lambda loaded, number: reference.execute(
            scene, loaded, seeds, number, threads=threads
        )
    shape = light.shape
    places = np.arange(shape[0] * shape[1], dtype=np.int64)
    block = prepare_pixels(container, sensor, light, effects, places, seeds[1], threads)
    return block_exposer(container, sensor, block, shape, seeds[0], threads)


def block_exposer(
    container: Container,
    sensor: Sensor,
    block: BlockScene,
    shape: tuple[int, ...],
    seed: int,
    threads: int,
) -> ExposeFrame:
    """Return a function that exposes frames of the pixels of `block`, arranged as `shape`, by the
    block loop, with the noise of `seed`. Results do not depend on `threads`."""
    paths = paths_of(container, retention_us(block.effects, sensor))
    assert not isinstance(paths, str)  # `lacks` says so

    def expose(loaded: Planes, number: int) -> Executed:
        """Expose frame `number`, in which registers begin with the bits `loaded` of `shape`, by
        name. Raises ValueError for bits that no code and no kept state has."""
        begins = paths.begins(loaded, shape).reshape(-1)
        pixels = expose_pixels(block, seed, number, threads, begins)
        whole = len(pixels.exposure_e), *shape
        exposure_e = pixels.exposure_e.reshape(whole)
        endings = pixels.endings.reshape(shape)
        planes = {name: bits.astype(np.bool_)[endings] for name, bits in paths.endings.items()}
        marks = pixels.saturated_by.reshape(whole)
        return Executed(Exposure(exposure_e, np.isfinite(exposure_e), marks), planes)

    return expose


def frames(
    container: Container,
    light: Light,
    sensor: Sensor,
    effects: Selection,
    *,
    seed: int = 0,
    device_seed: int = 0,
    count: int = 1,
    threads: int | None = None,
    by_words: bool = False,
) -> Iterator[Frame]:
    """Return an iterator over frames 0 to `count` - 1 of `light`; kept states continue from frame
    to frame.

    `seed`: of the noise. `device_seed`: of the fixed patterns. `by_words`: use the reference.
    Results do not depend on `threads` (None: all processors). Raises Rejected at the call, not at
    the first frame, for programs and light that do not fit."""
    check(container, light)
    check_adc(container.target)
    seeds = seed, device_seed
    expose = frame_exposer(container, light, sensor, effects, seeds, threads_of(threads), by_words)
    return _film(expose, container, sensor, effects, seeds, count)


def _film(
    expose: ExposeFrame,
    container: Container,
    sensor: Sensor,
    effects: Selection,
    seeds: tuple[int, int],
    count: int,
) -> Iterator[Frame]:
    """Yield frames 0 to `count` - 1, each exposed by `expose` with the states that the frame before
    it kept, and converted with the readout effects of `effects`. `seeds`: noise seed, device
    seed."""
    loaded: Planes = container.planes()
    for number in range(count):
        executed = expose(loaded, number)
        loaded = next_planes(container, loaded, executed.planes)
        frame = converted(executed.exposure, container.target, sensor, effects, seeds, number)
        yield replace(frame, told=told_by(container, executed.planes, frame, sensor, effects))
