"""The chip of a stand-in: our emulator, looking at a scene."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import Future
from dataclasses import dataclass, field
from threading import Thread
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.device.messages import Channel

if TYPE_CHECKING:
    from nscc.target.target import Target
    from nscc.words.container import Container
    from nscc_runtime.device.parsing import Held
    from nscc_runtime.light import Light
    from nscc_runtime.sensor import Sensor

Scene = Callable[[Sequence[float]], "Light"]
"""The light on the array in slots of these lengths, in microseconds."""


@dataclass
class EmulatedChip:
    """Exposes frames of `scene` with the emulator; slots of the same lengths see the same light.

    `report` is told what went wrong: the host only learns that something did.
    """

    scene: Scene
    target: Target
    sensor: Sensor | None = None
    device_seed: int = 0
    report: Callable[[Exception], None] = lambda _: None
    _light: tuple[tuple[float, ...], Light] | None = field(default=None, init=False)

    def exposure(self, container: Container, channels: int) -> bytes:
        """One frame of a container as a loader sends it: all codes, then all exposures, readout by
        readout, column by column.
        """
        from nscc_runtime.emulator import expose
        from nscc_runtime.frame_file import read_out

        if self._light is None or self._light[0] != container.slot_us:
            self._light = (container.slot_us, self.scene(container.slot_us))
        exact = expose(container, self._light[1], device_seed=self.device_seed)
        frame = read_out(exact, self.target, self.sensor)
        codes = in_columns(frame.frame) if channels & Channel.CODES else b""
        exposed = in_columns(frame.exposure_e.astype("<f8"))
        return codes + (exposed if channels & Channel.EXPOSURE else b"")


def in_columns(frame: NDArray[Any]) -> bytes:
    """The bytes of (readouts, rows, cols) values in the order in which a loader sends them."""
    return np.ascontiguousarray(frame.transpose(0, 2, 1)).tobytes()


def in_background(work: Callable[[], bytes]) -> Future[bytes]:
    """What comes of work in a thread of its own, for which nobody waits when the process ends."""
    future: Future[bytes] = Future()

    def run() -> None:
        try:
            future.set_result(work())
        except Exception as error:
            future.set_exception(error)

    Thread(target=run, daemon=True).start()
    return future


class BackgroundChip:
    """An emulated chip that takes its time without keeping anybody waiting: a loader's board."""

    def __init__(self, chip: EmulatedChip) -> None:
        self._chip = chip
        self._exposing: Future[bytes] | None = None

    def expose(self, held: Held, channels: int) -> None:
        """Begin to expose a program that a loader has checked."""
        chip = self._chip
        self._exposing = in_background(lambda: chip.exposure(held.container(chip.target), channels))

    def exposed(self) -> bytes | None:
        """The frame, None before it is there; RuntimeError where there is none."""
        if self._exposing is None:
            raise RuntimeError("nothing is exposed")
        if not self._exposing.done():
            return None
        try:
            return self._exposing.result()
        except Exception as error:
            self._exposing = None
            self._chip.report(error)
            raise RuntimeError("no frame") from error
