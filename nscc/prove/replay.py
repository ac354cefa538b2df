"""Replay of programs with fixed shutters; each lane is a row of the container's encoding."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from nscc.operations import Op
from nscc.prove.pixels import (
    TOLERANCE,
    WRONG_CODE,
    WRONG_EXPOSURE,
    ReplayError,
    ReplayPixels,
    Values,
)
from nscc.words.container import Container


class Replay(ReplayPixels):
    """The simulated pixels of all codes."""

    def __init__(
        self, container: Container, kernels: Sequence[Sequence[Op]], *, lights: int = 1,
        quiet: bool = False,
    ) -> None:  # fmt: skip
        super().__init__(container, kernels, container.encoding, lights=lights, quiet=quiet)
        self.code = self.code_bits(container.encoding)

    def exposures(self, light: Values) -> dict[str, Values]:
        """Run one frame in `light` (N, lights), in electrons per slot.

        Returns the exposure of each bucket in electrons (lanes, lights)."""
        container = self.container
        gathered = np.zeros((container.slots + 1, light.shape[1]))
        np.cumsum(light, axis=0, out=gathered[1:])
        self.start_frame()
        before = 0
        for boundary in self.launches:
            self.analog["PIX"] += gathered[boundary] - gathered[before]
            self.run_launches(boundary)
            before = boundary
        self.analog["PIX"] += gathered[-1] - gathered[before]
        self.end_frame()
        return {r.bucket: self.analog[r.register] * r.gain for r in container.readouts}

    def prove_frame(self, light: Values) -> None:
        """Run one frame in `light` (N,); raise ReplayError if it differs from the decode table."""
        measured = self.exposures(light[:, None])
        table = self.container.table
        for index, bucket in enumerate(self.container.buckets):
            if bucket not in measured:
                raise ReplayError("no register is read out", bucket)
            opens = table.shutters[:, index, :]
            rows = max(1, (1 << 20) // max(1, opens.shape[1]))  # blocks, to limit the memory
            blocks = [opens[i : i + rows] @ light for i in range(0, len(opens), rows)]
            expected = np.concatenate(blocks)
            differs = ~(np.abs(measured[bucket][:, 0] - expected) <= TOLERANCE * light.sum())
            if differs.any():
                raise ReplayError(WRONG_EXPOSURE, bucket, int(np.flatnonzero(differs)[0]))
        if any(self.read(name) != bits for name, bits in self.code.items()):
            raise ReplayError(WRONG_CODE)


# Number of slots whose light one float64 can distinguish: powers of four from 1 to 4^23, so that
# weights of -1, 0, 1 and 2 a slot are exact.
_SLOTS_A_LIGHT = 24


def shutters(container: Container, kernels: Sequence[Sequence[Op]]) -> NDArray[np.bool_] | None:
    """Return S[n] of every lane (lanes, buckets, slots); None if a slot's weight is neither 0 nor
    1.

    The words are replayed with light in one slot at a time. Lanes are the rows of
    `container.encoding`."""
    slots = container.slots
    lights = -(-slots // _SLOTS_A_LIGHT)
    light = np.zeros((slots, lights))
    numbers = np.arange(slots)
    light[numbers, numbers // _SLOTS_A_LIGHT] = 4.0 ** (numbers % _SLOTS_A_LIGHT)
    # A reset level of zero keeps the sums exact; the proof checks that programs subtract it.
    replay = Replay(container, kernels, lights=lights, quiet=True)
    measured = replay.exposures(light)
    opened = np.zeros((replay.lanes, len(container.buckets), slots), dtype=np.bool_)
    for index, bucket in enumerate(container.buckets):
        value = measured[bucket]
        if not np.isfinite(value).all():
            return None
        for digit in range(_SLOTS_A_LIGHT):
            weight = np.rint(value) % 4
            if not np.isin(weight, (0, 1)).all():
                return None
            columns_ = slice(digit, None, _SLOTS_A_LIGHT)
            opened[:, index, columns_] = weight[:, : len(range(*columns_.indices(slots)))] == 1
            value = (value - weight) / 4
        if np.any(value != 0):
            return None
    return opened
