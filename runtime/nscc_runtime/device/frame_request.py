"""A frame that a host requests: its expected size and time, and the bytes received so far."""

from __future__ import annotations

from dataclasses import dataclass

from nscc_runtime.device.messages import CaptureReply, frame_bytes
from nscc_runtime.device.objects import Upload

LONGEST_US = 1_200_000_000
"""Longest time from the first to the last word of a frame, in microseconds."""
CHUNK = 64
"""Bytes of a frame are sent in multiples of this number, except at the end of the frame."""
_BESIDE_S = 10.0


@dataclass(eq=False)
class FrameRequest:
    """A frame to be exposed, with a unique number. `received`: its bytes so far. `program` is None
    if only the device knows it; `pixels` is then the number of pixels of the frame. `values`: those
    of the program's parameters."""

    number: int
    channels: int
    program: Upload | None = None
    pixels: int = 0
    received: FrameBytes | None = None
    values: tuple[int, ...] = ()

    def bytes(self, readouts: int) -> int:
        """Return the expected number of bytes of the frame; 0 for a wrong number of readouts."""
        program = self.program
        if program is None:
            return frame_bytes(self.channels, self.pixels, readouts, 0)
        matches = readouts == program.readouts
        return matches * frame_bytes(
            self.channels, program.pixels, readouts, program.states, program.report_bytes
        )

    def exposure_s(self, captured: CaptureReply) -> float:
        """Return the shorter of the loader's and the host's estimates of the exposure time."""
        own_ms = captured.estimate_ms if self.program is None else self.program.frame_ms
        return min(own_ms, captured.estimate_ms) / 1000

    @property
    def longest_s(self) -> float:
        """Longest time in seconds that a loader may take: twice the host's estimate, plus overhead.
        For an unknown program it is twice the limit of all loaders."""
        program = self.program
        if program is None:
            return 2e-6 * LONGEST_US
        return 2e-3 * (program.frame_ms + program.readout_ms) + _BESIDE_S


class FrameBytes:
    """The received bytes of a frame. `origin` identifies the exposure. They are kept when the line
    is lost, because a loader discards bytes that the host has confirmed."""

    def __init__(self, length: int, origin: tuple[int, int]) -> None:
        """Begin with all chunks of `length` bytes missing.

        `origin` names the frame: the loader's start and the time of the exposure."""
        self.origin = origin
        self.data = bytearray(length)
        self.missing = bytearray(b"\1" * -(-length // CHUNK))
        self.missing_count = len(self.missing)

    @property
    def confirmed(self) -> int:
        """The offset before which all bytes have been received."""
        first = self.missing.find(1)
        return len(self.data) if first < 0 else first * CHUNK

    def store(self, offset: int, data: bytes) -> bool:
        """Store bytes of complete chunks at `offset`; return whether any of them were missing
        before."""
        first, last = offset // CHUNK, -(-(offset + len(data)) // CHUNK)
        fresh = self.missing.count(1, first, last)
        if fresh:
            self.data[offset : offset + len(data)] = data
            self.missing[first:last] = bytes(last - first)
            self.missing_count -= fresh
        return bool(fresh)
