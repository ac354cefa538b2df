"""The chip of a stand-in: the emulator, exposed to a scene."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import Future
from dataclasses import dataclass, field, replace
from threading import Thread
from typing import TYPE_CHECKING

import numpy as np

from nscc.arrays import Array
from nscc.words.readout import converter_of_registers
from nscc_runtime.device.messages import Channel
from nscc_runtime.device.objects import packed_plane
from nscc_runtime.device.recording import BoardProgram, ExecutedFrame

if TYPE_CHECKING:
    from nscc.chips.target import Target
    from nscc_runtime.light import Light
    from nscc_runtime.sensor import Sensor

Scene = Callable[[Sequence[float]], "Light"]
"""A function of slot lengths in microseconds that returns the light on the array in these slots."""


@dataclass
class EmulatedChip:
    """A chip that exposes frames of `scene` with the emulator; slots of equal lengths see equal
    light.

    `sensor`: None for the defaults of `target`. `device_seed` numbers the chip's fixed patterns.
    `report` is called with each error, because the host only learns that an error occurred."""

    scene: Scene
    target: Target
    sensor: Sensor | None = None
    device_seed: int = 0
    report: Callable[[Exception], None] = lambda _: None
    _light: tuple[tuple[float, ...], Light] | None = field(default=None, init=False)

    def execute(self, program: BoardProgram, channels: int) -> ExecutedFrame:
        """Expose one frame of `program`. `channels` are the bits of `Channel` that are read out.

        The bytes of the frame are, as far as they are requested, all converter codes, then all
        exposures, then all planes of states. Codes and exposures are in the order of readout,
        column and row. Raises what the scene raises for these slots."""
        from nscc_runtime.exposed_frame import Exposure
        from nscc_runtime.frame_file import read_out
        from nscc_runtime.neighbours.pictured_program import image_sensor

        # The light depends on the lengths of the slots only, so it is computed once for a
        # program.
        if self._light is None or self._light[0] != program.slot_us:
            self._light = (program.slot_us, self.scene(program.slot_us))
        registers = [*(name for name, _ in program.readouts), *program.images]
        digital = [*program.states, *program.chip.planes]
        contents, bits = program.chip.run(
            self._light[1], [*registers, *program.kept], digital, device_seed=self.device_seed
        )
        kept = dict(zip(program.kept, contents[len(registers) :], strict=True))
        contents = contents[: len(registers)]
        gains = np.array([gain for _, gain in program.readouts] + [1.0] * len(program.images))
        exposure_e = contents * gains[:, None, None] + 0.0  # -0 + 0 is +0
        sensor = self._converting([*registers, *program.kept])
        # Buckets are converted as the target says; images, whose values may be negative, in full
        # range.
        full = replace(self.target, readout="full")
        codes = [
            read_out(Exposure(values, np.isfinite(values)), target, of_readouts).frame
            for values, target, of_readouts in (
                (exposure_e[: len(program.readouts)], self.target, sensor),
                (exposure_e[len(program.readouts) :], full, image_sensor(sensor, self.target)),
            )
        ]
        chunks = [in_columns(values) for values in codes] if channels & Channel.CODES else []
        if channels & Channel.EXPOSURE:
            chunks.append(in_columns(exposure_e.astype("<f8")))
        planes = [packed_plane(plane) for plane in bits]
        if channels & Channel.STATES:
            chunks += planes[: len(program.states)]
        loaded = zip(program.chip.planes, planes[len(program.states) :], strict=True)
        return ExecutedFrame(b"".join(chunks), dict(loaded), kept)

    def _converting(self, registers: Sequence[str]) -> Sensor:
        """Return the sensor with the converter's scale (electrons per code, and offset) for a
        program that reads the analog registers named `registers`. Exposures are not spread over the
        whole scale if these registers forbid it."""
        from nscc_runtime.sensor import default_sensor

        program_sensor = default_sensor(converter_of_registers(self.target, registers))
        if self.sensor is None:
            return program_sensor
        # The chip's sensor describes a program that spreads: what this program changes is applied
        # to it.
        common = default_sensor(self.target)
        return self.sensor.changed(
            electrons_per_lsb=self.sensor.electrons_per_lsb
            * (program_sensor.electrons_per_lsb / common.electrons_per_lsb),
            adc_offset_lsb=self.sensor.adc_offset_lsb
            + program_sensor.adc_offset_lsb
            - common.adc_offset_lsb,
        )


def in_columns(frame: Array) -> bytes:
    """Return the bytes of `frame` (.., rows, cols) column by column, each from the top, as loaders
    send them."""
    return np.ascontiguousarray(frame.swapaxes(-2, -1)).tobytes()


def in_background(work: Callable[[], ExecutedFrame]) -> Future[ExecutedFrame]:
    """Run `work` in a daemon thread, which does not delay exit, and return the future of its
    result. An exception of `work` is raised by the future."""
    future: Future[ExecutedFrame] = Future()

    def run() -> None:
        """Call `work` and store its result or its exception in the future, for the thread that
        waits."""
        try:
            future.set_result(work())
        except Exception as error:
            future.set_exception(error)

    Thread(target=run, daemon=True).start()
    return future
