"""The chip of a stand-in: our emulator, looking at a scene."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from threading import Thread
from typing import TYPE_CHECKING

import numpy as np

from nscc_runtime.device.messages import Channel

if TYPE_CHECKING:
    from nscc.target.target import Target
    from nscc.words.container import Container
    from nscc_runtime.device.parsing import Held
    from nscc_runtime.frame_file import Frame
    from nscc_runtime.light import Light
    from nscc_runtime.sensor import Sensor

Scene = Callable[[Sequence[float]], "Light"]
"""The light on the array in slots of these lengths, in microseconds."""


def channel_bytes(frame: Frame, channels: int) -> bytes:
    """A frame as a loader sends it: all codes, then all exposures, bucket by bucket."""
    parts = []
    if channels & Channel.CODES:
        parts.append(frame.frame.astype(np.uint8).tobytes())
    if channels & Channel.EXPOSURE:
        parts.append(frame.exposure_e.astype("<f8").tobytes())
    return b"".join(parts)


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

    def __post_init__(self) -> None:
        self._light: tuple[tuple[float, ...], Light] | None = None
        self._frame: bytes | None = None
        self._failed = False

    def expose(self, held: Held, channels: int) -> None:
        """Expose a program that a loader has checked."""
        try:
            self._frame = self.exposure(held.container(self.target), channels)
            self._failed = False
        except Exception as error:
            # Whatever it is, the loader has to go on and to say that there is no frame.
            self._failed = True
            self.report(error)

    def exposed(self) -> bytes | None:
        """The frame that `expose` made; RuntimeError where it could not."""
        if self._failed:
            raise RuntimeError("no frame")
        return self._frame

    def exposure(self, container: Container, channels: int) -> bytes:
        """The channels of one frame of a container."""
        from nscc_runtime.emulator import expose
        from nscc_runtime.frame_file import read_out

        if self._light is None or self._light[0] != container.slot_us:
            self._light = (container.slot_us, self.scene(container.slot_us))
        exact = expose(container, self._light[1], device_seed=self.device_seed)
        return channel_bytes(read_out(exact, self.target, self.sensor), channels)


class Background:
    """Work in a thread of its own, so that a line is served meanwhile."""

    def __init__(self, work: Callable[[], bytes]) -> None:
        self._work = work
        self._result: bytes | None = None
        self._error: Exception | None = None
        self._thread = Thread(target=self._run, daemon=True)
        self._thread.start()

    def _run(self) -> None:
        try:
            self._result = self._work()
        except Exception as error:
            self._error = error

    def result(self) -> bytes | None:
        """What came of it, None before; raises what the work raised."""
        if self._thread.is_alive():
            return None
        if self._error is not None:
            raise self._error
        return self._result


class BackgroundChip:
    """An emulated chip that takes its time without keeping anybody waiting: a loader's board."""

    def __init__(self, chip: EmulatedChip) -> None:
        self._chip = chip
        self._exposing: Background | None = None

    def expose(self, held: Held, channels: int) -> None:
        """Begin to expose a program that a loader has checked."""
        chip = self._chip
        self._exposing = Background(lambda: chip.exposure(held.container(chip.target), channels))

    def exposed(self) -> bytes | None:
        """The frame, None before it is there; RuntimeError where there is none."""
        if self._exposing is None:
            raise RuntimeError("nothing is exposed")
        try:
            return self._exposing.result()
        except Exception as error:
            self._exposing = None
            self._chip.report(error)
            raise RuntimeError("no frame") from error
