"""The chip of a stand-in: the emulator, exposed to a scene."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Future
from dataclasses import dataclass, field
from threading import Thread
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nscc.operations import WordEffect
from nscc.words.encoding import decode
from nscc.words.readout import converter_of
from nscc_runtime.device.messages import Channel
from nscc_runtime.device.objects import packed_plane

if TYPE_CHECKING:
    from nscc.chips.target import Target
    from nscc.words.container import Container
    from nscc_runtime.light import Light
    from nscc_runtime.sensor import Sensor

Scene = Callable[[Sequence[float]], "Light"]
"""A function of slot lengths in microseconds that returns the light on the array in these slots."""


@dataclass(frozen=True, eq=False)
class ExecutedFrame:
    """One frame of the emulator. `frame`: its bytes as a loader sends them. `planes`: the code
    registers after the frame as bytes of PLANE objects, by register; kept states are stored in code
    registers."""

    frame: bytes
    planes: Mapping[str, bytes]


Arrays = list[NDArray[Any]]


@dataclass
class EmulatedChip:
    """A chip that exposes frames of `scene` with the emulator; slots of equal lengths see equal
    light.

    `report` is called with each error, because the host only learns that an error occurred."""

    scene: Scene
    target: Target
    sensor: Sensor | None = None
    device_seed: int = 0
    report: Callable[[Exception], None] = lambda _: None
    _light: tuple[tuple[float, ...], Light] | None = field(default=None, init=False)

    def execute(self, container: Container, channels: int) -> ExecutedFrame:
        """Expose one frame of a container with the requested `channels`. The bytes are all codes,
        then all exposures, by readout and column, then all planes of states."""
        from nscc_runtime.frame_file import read_out

        if self._light is None or self._light[0] != container.slot_us:
            self._light = (container.slot_us, self.scene(container.slot_us))
        light = self._light[1]
        if not container.pictures.launches:
            if looks(container):
                from nscc_runtime.reference.capture import executed

                looked = executed(container, light, self.sensor, self.device_seed)
                exact, planes = looked.exposure, looked.planes
            else:
                from nscc_runtime.emulator import expose

                exact = expose(container, light, device_seed=self.device_seed)
                planes = container.planes()
            frame = read_out(exact, self.target, self._converting(container))
            codes, exposures = [*frame.frame], [*frame.exposure_e]
            sent_planes = [planes[name] for name in container.state_planes]
            kept = {name: planes[name] for name in container.code_registers}
        else:
            codes, exposures, sent_planes, kept = self._pictured(container, light)
        chunks = [in_columns(values) for values in codes] if channels & Channel.CODES else []
        if channels & Channel.EXPOSURE:
            chunks += [in_columns(values.astype("<f8")) for values in exposures]
        if channels & Channel.STATES:
            chunks += map(packed_plane, sent_planes)
        return ExecutedFrame(
            b"".join(chunks), {name: packed_plane(bits) for name, bits in kept.items()}
        )

    def _pictured(
        self, container: Container, light: Light
    ) -> tuple[Arrays, Arrays, Arrays, dict[str, NDArray[np.bool_]]]:
        """Return the codes and electrons of buckets and images, the planes that are read, and the
        registers that are kept, of a frame whose images and planes are computed after the exposure.

        States continue from the code registers."""
        from nscc_runtime.effects import selected
        from nscc_runtime.neighbours.pictured_program import PicturedProgram

        program = PicturedProgram(container, self._converting(container), selected("none"))
        exposure = program.exposing(light, self.device_seed)(0, 0)
        frame, kept_bits = program.next_frame(exposure, {}, None, (0, self.device_seed), 0)
        images, told = container.pictures.images_read, frame.told
        return (
            [*frame.frame, *(told[f"image_codes_{name}"] for name in images)],
            [*frame.exposure_e, *(told[f"image_{name}"] for name in images)],
            [bits for name, bits in told.items() if name.startswith("plane_")],
            container.planes() | kept_bits,
        )

    def _converting(self, container: Container) -> Sensor:
        """Return the sensor with this program's code scale, not spread if registers forbid it."""
        from nscc_runtime.sensor import default_sensor

        program_sensor = default_sensor(converter_of(container))
        if self.sensor is None:
            return program_sensor
        common = default_sensor(self.target)
        return self.sensor.changed(
            electrons_per_lsb=self.sensor.electrons_per_lsb
            * (program_sensor.electrons_per_lsb / common.electrons_per_lsb),
            adc_offset_lsb=self.sensor.adc_offset_lsb
            + program_sensor.adc_offset_lsb
            - common.adc_offset_lsb,
        )


def in_columns(frame: NDArray[Any]) -> bytes:
    """Return the bytes of values (.., rows, cols) column by column, as loaders send them."""
    return np.ascontiguousarray(frame.swapaxes(-2, -1)).tobytes()


def looks(container: Container) -> bool:
    """Return whether words compare analog values, so that each pixel has its own FLAG."""
    words = (word for kernel in container.kernels for word in kernel.words)
    return any(decode(word).operation.effect is WordEffect.FLAG_ANALOG for word in words)


def in_background(work: Callable[[], ExecutedFrame]) -> Future[ExecutedFrame]:
    """Run `work` in a daemon thread, which does not delay exit, and return its future."""
    future: Future[ExecutedFrame] = Future()

    def run() -> None:
        try:
            future.set_result(work())
        except Exception as error:
            future.set_exception(error)

    Thread(target=run, daemon=True).start()
    return future
