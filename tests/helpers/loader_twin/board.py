"""An emulated chip as the board of the loader in Python."""

from __future__ import annotations

from concurrent.futures import Future

from loader_twin.parsing import Held
from nscc_runtime.device.board import EmulatedChip, ExecutedFrame, in_background


class BackgroundChip:
    """An emulated chip that takes its time without keeping anybody waiting: a loader's board."""

    def __init__(self, chip: EmulatedChip) -> None:
        self._chip = chip
        self._exposing: Future[ExecutedFrame] | None = None
        self._held: Held | None = None

    def expose(self, held: Held, channels: int) -> None:
        """Begin to expose a program that a loader has checked."""
        chip, self._held = self._chip, held
        program, channels = held.program(chip.target, channels), held.board_channels(channels)
        self._exposing = in_background(lambda: chip.execute(program, channels))

    def exposed(self) -> bytes | None:
        """The frame, None before it is there; RuntimeError where there is none."""
        if self._exposing is None or self._held is None:
            raise RuntimeError("nothing is exposed")
        if not self._exposing.done():
            return None
        try:
            executed = self._exposing.result()
        except Exception as error:
            self._exposing = None
            self._chip.report(error)
            raise RuntimeError("no frame") from error
        self._held.take(executed, self._chip.target)
        return executed.frame
