"""Truth vectors: Python integers with one bit for each shutter; and arrays of bits as integers.

Bit i belongs to shutter i of the decode table. Operations on integers with thousands of bits are
fast, so that exhaustive searches and proofs are cheap."""

from __future__ import annotations

from collections.abc import Iterable
from functools import reduce
from operator import or_

import numpy as np

from nscc.arrays import Bools, Indices, Ints


def columns(bits: Bools) -> list[int]:
    """Return the truth vectors of the columns of `bits`, bool (shutters, columns).

    The result has one integer for each column; its bit k belongs to shutter k (row k of `bits`)."""
    packed = np.packbits(np.ascontiguousarray(bits.T), axis=1, bitorder="little")
    return [int.from_bytes(row.tobytes(), "little") for row in packed]


def rows(vectors: list[int], count: int) -> Bools:
    """Return the bits of truth vectors as an array, bool (count, vectors); the inverse of
    `columns`.

    >>> rows([0b0011, 0b0101], 4).astype(int).tolist()
    [[1, 1], [1, 0], [0, 1], [0, 0]]
    """
    size = max(1, (count + 7) // 8)  # bytes of a vector; `reshape` needs one even without shutters
    if not vectors:
        return np.zeros((count, 0), dtype=np.bool_)
    raw = b"".join(vector.to_bytes(size, "little") for vector in vectors)
    packed = np.frombuffer(raw, dtype=np.uint8).reshape(len(vectors), size)
    bits = np.unpackbits(packed, axis=1, count=count, bitorder="little")
    return np.ascontiguousarray(bits.T).view(np.bool_)


def members(vector: int, count: int) -> Indices:
    """Return the indices of the shutters, out of `count`, whose bit in a truth vector is 1,
    ascending. The vector has no bits beyond `count`."""
    if vector & (vector - 1) == 0:  # at most one bit, a common case that is faster this way
        return np.array([vector.bit_length() - 1] if vector else [], dtype=np.intp)
    packed = np.frombuffer(vector.to_bytes((count + 7) // 8, "little"), dtype=np.uint8)
    return np.flatnonzero(np.unpackbits(packed, count=count, bitorder="little"))


def packed_bits(bits: Bools) -> int:
    """Return an array of bits of any shape as one number: its elements in C order, the first as the
    lowest bit."""
    return int.from_bytes(np.packbits(bits, bitorder="little").tobytes(), "little")


def unpacked_bits(number: int, shape: tuple[int, int]) -> Bools:
    """Return the bits of a number that `packed_bits` made, bool of `shape` (rows, cols).

    -1 is a 1 in every pixel; bits beyond the last pixel are ignored."""
    pixels = shape[0] * shape[1]
    data = (number & (1 << pixels) - 1).to_bytes(-(-pixels // 8), "little")
    flat = np.unpackbits(np.frombuffer(data, np.uint8), count=pixels, bitorder="little")
    return flat.astype(np.bool_).reshape(shape)


def vector(shutters: Indices) -> int:
    """Return the truth vector of a set of shutters, given by their indices.

    >>> bin(vector(np.array([0, 2])))
    '0b101'
    """
    if not len(shutters):
        return 0
    bits = np.zeros(int(shutters.max()) + 1, dtype=np.bool_)
    bits[shutters] = True
    return packed_bits(bits)


def union(vectors: Iterable[int]) -> int:
    """Return the OR of all truth vectors (integers with one bit for each shutter); 0 without
    any."""
    return reduce(or_, vectors, 0)


def set_bits(mask: int) -> tuple[int, ...]:
    """Return the positions of the 1 bits, ascending.

    >>> set_bits(0b1010)
    (1, 3)
    """
    places = []
    while mask:
        lowest = mask & -mask
        places.append(lowest.bit_length() - 1)
        mask ^= lowest
    return tuple(places)


def number_planes(numbers: Ints, width: int) -> list[int]:
    """Return the truth vectors of the `width` lowest bits of numbers, int64 (shutters,), lowest bit
    first. Bit k of a vector belongs to number k."""
    return columns((numbers[:, None] >> np.arange(width)) & 1 == 1)
