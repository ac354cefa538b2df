"""The firmware's loader a step at a time, on the clock of whoever drives it."""

from __future__ import annotations

from functools import partial
from struct import Struct

from nscc_runtime.device.board import EmulatedChip
from nscc_runtime.device.firmware import Built, RunningFirmware

SANITIZERS = ("-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-g")
_STEP = Struct("<QI")


class Lockstep(RunningFirmware):
    """A loader that answers when it is asked."""

    busy = True

    def __init__(self, loader: Built, chip: EmulatedChip) -> None:
        super().__init__([str(loader.path), "--lockstep"], loader.target, chip)
        self._arrived = b""

    def watched(self) -> list[int]:
        """Nothing announces that there is something to do."""
        return []

    def announce(self) -> None:
        """Start the loader anew."""
        super().announce()
        self._arrived = b""
        self.busy = True

    def receive(self, data: bytes, now_us: int) -> None:
        """Keep bytes for the next step."""
        self._arrived += data
        self.busy = True

    def poll(self, now_us: int, room: int) -> bytes:
        """One step of the loader."""
        self.write_record(b"I", _STEP.pack(now_us, room) + self._arrived)
        self._arrived = b""
        exposing = False
        while True:
            while (found := self.next()) is None:
                self.fill()
            if found[0] == b"O":
                self.busy = exposing or bool(found[1][0])
                return found[1][1:]
            job = self._recording.take(*found)
            if job is not None:
                self.answer(job, partial(self.execute, job))
                exposing = True
