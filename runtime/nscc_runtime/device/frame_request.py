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
"""Time beside exposure and readout that any frame may take, in seconds."""


@dataclass(eq=False)
class FrameRequest:
    """A frame to be exposed, with a unique `number`.

    `channels`: bits of `Channel`. `program`: None if only the device knows it; `pixels` is then the
    number of pixels of the frame. `received`: its bytes so far, None before the loader's first
    reply. `values`: those of the program's parameters, in their order."""

    number: int
    channels: int
    program: Upload | None = None
    pixels: int = 0
    received: FrameBytes | None = None
    values: tuple[int, ...] = ()

    def bytes(self, readouts: int) -> int:
        """Return the expected number of bytes of the frame if the loader reports this number of
        `readouts`; 0 if the program has another number."""
        program = self.program
        if program is None:
            return frame_bytes(self.channels, self.pixels, readouts, 0)
        matches = readouts == program.readouts
        return matches * frame_bytes(
            self.channels, program.pixels, readouts, program.states, program.report_bytes
        )

    def exposure_s(self, captured: CaptureReply) -> float:
        """Return the shorter of two estimates of the exposure time in seconds: the loader's, in its
        reply `captured`, and the host's if it knows the program."""
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
    """The received bytes of a frame. `origin` identifies the exposure: the loader's start
    (`Info.boot`) and its clock when the exposure began.

    They are kept when the line is lost, because a loader discards bytes that the host has
    confirmed. `missing` has a byte for each chunk of `CHUNK` bytes, 1 until it has arrived, and
    `missing_count` counts the ones."""

    def __init__(self, length: int, origin: tuple[int, int]) -> None:
        """Begin with all chunks of the frame's `length` bytes missing. `origin` is the loader's
        start and its clock when the exposure began."""
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
        """Store bytes of complete chunks at `offset`, a multiple of `CHUNK`; only the frame's last
        chunk may be shorter. Return whether any of them were missing before; if none was, change
        nothing."""
        first, last = offset // CHUNK, -(-(offset + len(data)) // CHUNK)
        fresh = self.missing.count(1, first, last)
        if fresh:
            self.data[offset : offset + len(data)] = data
            self.missing[first:last] = bytes(last - first)
            self.missing_count -= fresh
        return bool(fresh)
