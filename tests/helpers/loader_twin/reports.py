"""Reports about planes, as the loader's twin makes them: the whole plane at once."""

from __future__ import annotations

from dataclasses import dataclass
from struct import pack

import numpy as np

from nscc.chips.target import Target
from nscc_runtime.device.objects import unpacked_plane


@dataclass(frozen=True)
class Report:
    """What is told of the bits of a register that are not in the margins."""

    register: int
    most: int
    left: int
    right: int
    up: int
    down: int

    @property
    def length(self) -> int:
        """Bytes in a frame."""
        return 4 * self.most + 12

    def of(self, plane: bytes, target: Target) -> bytes:
        """Coordinates, the number of bits, the box around them."""
        found = [
            (x, y)
            for y, row in enumerate(unpacked_plane(plane, (target.rows, target.cols)))
            for x in np.flatnonzero(row).tolist()
            if self.left <= x < target.cols - self.right and self.up <= y < target.rows - self.down
        ]
        told = found[: self.most]
        told += [(0xFFFF, 0xFFFF)] * (self.most - len(told))
        xs, ys = zip(*found, strict=True) if found else ((0xFFFF,), (0xFFFF,))
        numbers = [n for place in told for n in place]
        box = min(xs), min(ys), max(xs), max(ys)
        return pack(f"<{len(numbers)}HI4H", *numbers, len(found), *box)
