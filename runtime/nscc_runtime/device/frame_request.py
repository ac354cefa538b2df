"""A frame that a host wants: what it must be as the host reckons, and what is there of it."""

from __future__ import annotations

from dataclasses import dataclass

from nscc_runtime.device.messages import CaptureReply, frame_bytes
from nscc_runtime.device.objects import Upload

LONGEST_US = 1_200_000_000
"""From the first word of a frame to its last, at most."""
CHUNK = 64
"""Bytes of a frame come in multiples of so many, but for its end."""
_BESIDE_S = 10.0


@dataclass(eq=False)
class FrameRequest:
    """A frame to be exposed, by its number: no other has it. `received` is what came of it so far.

    Of what program it is, None where only the device knows: then of so many `pixels`.
    """

    number: int
    channels: int
    program: Upload | None = None
    pixels: int = 0
    received: FrameBytes | None = None

    def bytes(self, readouts: int) -> int:
        """What the frame has to have; 0 where it cannot have so many readouts."""
        program = self.program
        if program is None:
            return frame_bytes(self.channels, self.pixels, readouts, 0)
        matches = readouts == program.readouts
        return matches * frame_bytes(self.channels, program.pixels, readouts, program.states)

    def exposure_s(self, captured: CaptureReply) -> float:
        """What its slots take, by the loader's figures and the host's own."""
        own_ms = captured.estimate_ms if self.program is None else self.program.frame_ms
        return min(own_ms, captured.estimate_ms) / 1000

    @property
    def longest_s(self) -> float:
        """What a loader may take for it, whatever it says: twice what the host makes it, and what
        is beside the frame; of an unknown program what no loader exceeds."""
        program = self.program
        if program is None:
            return 2e-6 * LONGEST_US
        return 2e-3 * (program.frame_ms + program.readout_ms) + _BESIDE_S


class FrameBytes:
    """The bytes of a frame that are here. A loader does not keep those that a host says it has, so
    they outlast a line that goes away. `origin` is what tells this exposure from another."""

    def __init__(self, length: int, origin: tuple[int, int]) -> None:
        self.origin = origin
        self.data = bytearray(length)
        self.missing = bytearray(b"\1" * -(-length // CHUNK))
        self.missing_count = len(self.missing)

    @property
    def confirmed(self) -> int:
        """All bytes before this one are here."""
        first = self.missing.find(1)
        return len(self.data) if first < 0 else first * CHUNK

    def store(self, offset: int, data: bytes) -> bool:
        """Keep bytes of whole chunks; whether any of them were missing."""
        first, last = offset // CHUNK, -(-(offset + len(data)) // CHUNK)
        fresh = self.missing.count(1, first, last)
        if fresh:
            self.data[offset : offset + len(data)] = data
            self.missing[first:last] = bytes(last - first)
            self.missing_count -= fresh
        return bool(fresh)
