"""Bit planes as unions of address patterns; the chip sets all pixels of a pattern at once.

The devkit counts rows from the top and columns from the right: pixel (row y, column x) has the
address (y, cols - 1 - x). A pattern fixes some address bits and ignores the others."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

ADDRESS_BITS = 8
"""Number of address bits of a row, and of a column."""

MOST_BITS = 12
"""Most address bits of a plane that is loaded by patterns: a tile of 64 x 64 pixels.

Such a plane needs up to about 700 patterns. With more bits, drawing an image pixel by pixel is as
fast."""

_SIDE = 1 << ADDRESS_BITS
_OPEN = _SIDE - 1


@dataclass(frozen=True, slots=True, order=True)
class Match:
    """All pixels whose address equals (row, col) in the bits that are not ignored by the masks."""

    row: int
    col: int
    row_mask: int
    col_mask: int


@dataclass(frozen=True, slots=True)
class Patterns:
    """A plane as the union of `matches`, or the complement of this union if `inverted`."""

    matches: tuple[Match, ...]
    inverted: bool


def patterns_of(plane: NDArray[np.bool_]) -> Patterns | None:
    """Return `plane` bool (rows, cols) as address patterns; None if it depends on too many address
    bits.

    Addresses outside the array are don't-cares."""
    rows, cols = plane.shape
    on, off = (np.zeros((_SIDE, _SIDE), dtype=np.bool_) for _ in range(2))
    on[:rows, :cols] = plane[:, ::-1]
    off[:rows, :cols] = ~plane[:, ::-1]
    ones, zeros, bits = _support(on, off)
    if len(bits) > MOST_BITS:
        return None
    everything = (1 << (1 << len(bits))) - 1
    plain, _ = _cover(ones, everything & ~zeros, len(bits))
    complement, _ = _cover(zeros, everything & ~ones, len(bits))
    inverted = len(complement) + 1 < len(plain)  # inverting is a kernel of its own
    cubes = complement if inverted else plain
    return Patterns(tuple(sorted(_match(cube, bits) for cube in cubes)), inverted)


_Bit = tuple[bool, int]
"""An address bit: whether it is a column bit, and its value."""

_Cube = tuple[int, int]
"""A cube: the mask of its variables, and the mask of the variables that are 1."""


def _support(on: NDArray[np.bool_], off: NDArray[np.bool_]) -> tuple[int, int, list[_Bit]]:
    """Return the address bits that the planes depend on, lowest first, and both truth tables over
    them."""
    cube = (2,) * (2 * ADDRESS_BITS)
    on, off = on.reshape(cube), off.reshape(cube)
    bits: list[_Bit] = []
    for index in range(2 * ADDRESS_BITS):
        on_0, on_1 = np.take(on, [0], index), np.take(on, [1], index)
        off_0, off_1 = np.take(off, [0], index), np.take(off, [1], index)
        if (on_0 & off_1).any() or (on_1 & off_0).any():
            bits.append((index >= ADDRESS_BITS, 1 << (ADDRESS_BITS - 1 - index % ADDRESS_BITS)))
        else:
            on, off = on_0 | on_1, off_0 | off_1
    return _table(on), _table(off), bits[::-1]


def _table(plane: NDArray[np.bool_]) -> int:
    return int.from_bytes(np.packbits(plane.ravel(), bitorder="little").tobytes(), "little")


def _cover(needed: int, allowed: int, bits: int) -> tuple[list[_Cube], int]:
    """Return an irredundant union of cubes that contains `needed` and lies in `allowed`, and its
    table.

    Truth tables are integers. The method is the algorithm of Minato and Morreale."""
    if not needed:
        return [], 0
    if allowed == (1 << (1 << bits)) - 1:
        return [(0, 0)], allowed
    variable, half = 1 << (bits - 1), 1 << (bits - 1)
    low = (1 << half) - 1
    needed_0, needed_1 = needed & low, needed >> half
    allowed_0, allowed_1 = allowed & low, allowed >> half
    cubes_0, covered_0 = _cover(needed_0 & ~allowed_1, allowed_0, bits - 1)
    cubes_1, covered_1 = _cover(needed_1 & ~allowed_0, allowed_1, bits - 1)
    uncovered = (needed_0 & ~covered_0) | (needed_1 & ~covered_1)
    both, covered = _cover(uncovered, allowed_0 & allowed_1, bits - 1)
    cubes = [
        *((named | variable, ones) for named, ones in cubes_0),
        *((named | variable, ones | variable) for named, ones in cubes_1),
        *both,
    ]
    return cubes, (covered_0 | covered) | (covered_1 | covered) << half


def _match(cube: _Cube, bits: list[_Bit]) -> Match:
    named, ones = cube
    value, mask = [0, 0], [_OPEN, _OPEN]
    for index, (column, bit) in enumerate(bits):
        if named >> index & 1:
            mask[column] &= ~bit
            value[column] |= bit if ones >> index & 1 else 0
    return Match(value[0], value[1], mask[0], mask[1])
