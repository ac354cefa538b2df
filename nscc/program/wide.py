"""Bit fields of any length: one longer than a number is kept as several, each a part of its bits.

`code bits : bit[100]` has the parts `bits` (bits 0 to 61) and `bits.62` (the others): columns of
the decode table, names in frame files. No name of the language has a dot.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from nscc.program.program import Field

PART_BITS = 62
"""Most bits of a part: its value then stays below 2^62 like every other number."""

Plane = NDArray[np.int64]


def part_name(field: str, part: int) -> str:
    """The name of a part of a field, counted from 0."""
    return field if part == 0 else f"{field}.{part * PART_BITS}"


def whole_name(part: str) -> str:
    """The name of the field that a part belongs to."""
    return part.partition(".")[0]


def parts_of(field: Field) -> Iterator[Field]:
    """A field as the numbers that hold it: itself, or its parts."""
    bits = field.bits or 0
    if bits <= PART_BITS:
        yield field
        return
    for part in range(-(-bits // PART_BITS)):
        count = min(PART_BITS, bits - part * PART_BITS)
        yield replace(
            field, name=part_name(field.name, part), high=2**count - 1, bits=count,
            first_bit=part * PART_BITS,
        )  # fmt: skip


def parts_of_bits(bits: NDArray[np.integer]) -> list[Plane]:
    """The numbers that hold the bits (rows, cols, K) of every pixel, bit 0 first."""
    found = []
    for first in range(0, bits.shape[2], PART_BITS):
        part = bits[:, :, first : first + PART_BITS].astype(np.int64)
        found.append(part @ (np.int64(1) << np.arange(part.shape[2], dtype=np.int64)))
    return found


def grouped(names: Sequence[str]) -> dict[str, list[str]]:
    """The parts of every field among the columns of a table, by the field's name."""
    found: dict[str, list[str]] = {}
    for name in names:
        found.setdefault(whole_name(name), []).append(name)
    return found
