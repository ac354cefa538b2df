"""The data for a chip without logic: a bit plane for every slot, and the destinations of bits.

In a slot a pixel's light goes to one destination: a tap, or the drain. Its bit chooses between two
destinations that are the same for all pixels: `ones` if it is 1, `zeros` if it is 0. Bucket b of a
program is tap b."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from nscc.arrays import Bools, Bytes
from nscc.chips.target import Target
from nscc.record import Record
from nscc.words.stored_arrays import array_faults

DRAIN = -1
"""The destination of light that no tap collects; other destinations are indices of taps."""

Bits = Bytes


class Stream(Record, eq=False):
    """The bit planes of a frame of N slots.

    `planes` uint8 (N, rows, ceil(cols / 8)) contain the bits of each row, first pixel in the lowest
    bit, padded with 0. `ones` and `zeros` int8 (N,) are the destinations of the light of pixels
    whose bit is 1 and 0: the index of a tap, or DRAIN."""

    planes: Annotated[Bits, "slots rows row_bytes"]
    ones: Annotated[NDArray[np.int8], "slots"]
    zeros: Annotated[NDArray[np.int8], "slots"]

    @property
    def slots(self) -> int:
        """The number of slots."""
        return len(self.planes)

    def bits(self, slot: int, cols: int) -> Bools:
        """Return the bit plane of the slot with the index `slot`, bool (rows, cols); `cols` is the
        array's number of columns, which the padded rows do not tell."""
        unpacked = np.unpackbits(self.planes[slot], axis=1, count=cols, bitorder="little")
        return unpacked.view(np.bool_)

    def destinations(self, slot: int, cols: int) -> NDArray[np.int8]:
        """Return the destination of each pixel's light in a slot, int8 (rows, cols): the index of a
        tap, or DRAIN.

        `cols` is the array's number of columns."""
        destinations: NDArray[np.int8] = np.where(
            self.bits(slot, cols), self.ones[slot], self.zeros[slot]
        )
        return destinations


class Loading(Record):
    """When a slot's bit plane is sent and when it takes effect, in microseconds from the start of
    the frame.

    A chip with two latches per pixel loads the plane in the previous slot (the first plane before
    the frame), and it takes effect in all rows at once. A chip with one latch drains the light
    while it loads."""

    load_us: float
    acts_us: float


def schedule(target: Target, slot_us: tuple[float, ...]) -> Iterator[Loading]:
    """Yield for each slot when its bit plane begins to load and when it takes effect.

    `slot_us` are the lengths of the slots in microseconds; whether a plane loads within its slot is
    not checked. On a pipelined chip (two latches per pixel) the plane loads at the end of the slot
    before, else at the start of its own slot. The first time may be negative."""
    start, load = 0.0, target.plane_load_us
    for length in slot_us:
        yield Loading(start - load, start) if target.pipelined else Loading(start, start + load)
        start += length


def faults(stream: Stream, target: Target, slots: int, bucket_count: int) -> Iterator[str]:
    """Yield the errors of the bit planes, each as the end of a sentence about the container (a
    compiled program); nothing if they are sound.

    `slots` and `bucket_count` are the numbers that the program has. If shapes or types are wrong,
    nothing else is checked."""
    sizes = {"slots": slots, "rows": target.rows, "row_bytes": -(-target.cols // 8)}
    if wrong := list(array_faults(stream, sizes)):
        yield wrong[0]
        return
    behind = target.cols % 8
    # A row is padded to whole bytes; the padding must be 0.
    if behind and np.any(stream.planes[:, :, -1] >> behind):
        yield "a plane has bits after the last column"
    taps = np.concatenate([stream.ones, stream.zeros])
    if not all(DRAIN <= tap < len(target.taps) for tap in taps.tolist()):
        yield f"light is sent to a tap outside the {len(target.taps)} taps of {target.name}"
    if not target.drain and np.any(taps == DRAIN):
        yield f"light is sent to a drain, but {target.name} has no drain"
    if bucket_count > len(target.taps):
        yield f"it has {bucket_count} buckets, but {target.name} has {len(target.taps)} taps"
