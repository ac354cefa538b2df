"""What a chip without logic is sent: a plane of bits for every slot, and where each bit leads.

In a slot a pixel's light goes to one place: a tap, or the drain. Its bit chooses between two of
them, which are the same for all pixels: `ones` where it is 1, `zeros` where it is 0. Bucket number
b of a program is collected in tap number b.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc.chips.target import Target

DRAIN = -1
"""Where light goes that no tap shall have, where a tap's number stands for the tap."""

Bits = NDArray[np.uint8]


@dataclass(frozen=True, eq=False)
class Stream:
    """The planes of a frame, as they are sent.

    `planes` uint8 (N, rows, ceil(cols / 8)): the bits of each row, its first pixel in the lowest
    bit, 0 behind the last one. `ones`, `zeros` int8 (N,): the tap's number, or DRAIN.
    """

    planes: Bits
    ones: NDArray[np.int8]
    zeros: NDArray[np.int8]

    @property
    def slots(self) -> int:
        """The slots of a frame."""
        return len(self.planes)

    def bits(self, slot: int, cols: int) -> NDArray[np.bool_]:
        """The bits (rows, cols) of a slot."""
        unpacked = np.unpackbits(self.planes[slot], axis=1, count=cols, bitorder="little")
        return unpacked.view(np.bool_)

    def place(self, slot: int, cols: int) -> NDArray[np.int8]:
        """Where the light of each pixel goes in a slot (rows, cols): a tap's number, or DRAIN."""
        found: NDArray[np.int8] = np.where(self.bits(slot, cols), self.ones[slot], self.zeros[slot])
        return found

    def shutters(self, buckets: int, cols: int) -> Bits:
        """When each pixel is open, uint8 (buckets, rows, cols, ceil(N / 8)), as in a frame file:
        packed along the slots, the first one in the lowest bit."""
        shape = self.planes.shape[1], cols
        found = np.zeros((buckets, *shape, -(-self.slots // 8)), np.uint8)
        for slot in range(self.slots):
            place = self.place(slot, cols)
            for bucket in range(buckets):
                found[bucket, :, :, slot // 8] |= (place == bucket).view(np.uint8) << slot % 8
        return found


@dataclass(frozen=True)
class Loading:
    """When the plane of a slot is sent and when it acts, in microseconds from the frame's start.

    A chip with two latches a pixel loads it in the slot before (the first one before the frame):
    what acts, acts on all rows at once. One with a single latch leads light away while it loads.
    """

    load_us: float
    acts_us: float


def schedule(target: Target, slot_us: tuple[float, ...]) -> Iterator[Loading]:
    """The loading of every slot's plane."""
    start, load = 0.0, target.plane_load_us
    for length in slot_us:
        yield Loading(start - load, start) if target.pipelined else Loading(start, start + load)
        start += length


def faults(stream: Stream, target: Target, slots: int, buckets: int) -> Iterator[str]:
    """What is wrong with planes of a container, each as part of a sentence."""
    shape = slots, target.rows, -(-target.cols // 8)
    for name, array, wanted, dtype in (
        ("planes", stream.planes, shape, np.uint8),
        ("ones", stream.ones, (slots,), np.int8),
        ("zeros", stream.zeros, (slots,), np.int8),
    ):
        if array.shape != wanted or array.dtype != dtype:
            yield (
                f"{name} is {array.dtype} {array.shape}, not {np.dtype(dtype)} {wanted} as the "
                "rest of it needs"
            )
            return
    behind = target.cols % 8
    if behind and np.any(stream.planes[:, :, -1] >> behind):
        yield "a plane has bits after the last column"
    places = np.concatenate([stream.ones, stream.zeros])
    if not all(DRAIN <= place < len(target.taps) for place in places.tolist()):
        yield f"light is sent to a tap outside the {len(target.taps)} taps of {target.name}"
    if not target.drain and np.any(places == DRAIN):
        yield f"light is sent to a drain, but {target.name} has no drain"
    if buckets > len(target.taps):
        yield f"it has {buckets} buckets, but {target.name} has {len(target.taps)} taps"
