"""Bit fields of any length: one longer than an integer is stored as several integers, its chunks.

`code bits : bit[100]` has the chunks `bits` (bits 0 to 61) and `bits.62` (the others): columns of
the decode table, names in frame files. No name of the language has a dot.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from nscc.program.program import Field

CHUNK_BITS = 62
"""Most bits of a chunk: its value then stays below 2^62 like every other number."""

Plane = NDArray[np.int64]


def chunk_name(field: str, chunk: int) -> str:
    """The name of a field's chunk number `chunk`."""
    return field if chunk == 0 else f"{field}.{chunk * CHUNK_BITS}"


def whole_name(column: str) -> str:
    """The name of the field whose chunk is `column`."""
    return column.partition(".")[0]


def chunks_of(field: Field) -> Iterator[Field]:
    """The chunks of a field, each as a field: the field itself if it fits one integer."""
    bits = field.bits or 0
    if bits <= CHUNK_BITS:
        yield field
        return
    for chunk in range(-(-bits // CHUNK_BITS)):
        count = min(CHUNK_BITS, bits - chunk * CHUNK_BITS)
        yield replace(
            field, name=chunk_name(field.name, chunk), high=2**count - 1, bits=count,
            first_bit=chunk * CHUNK_BITS,
        )  # fmt: skip


def chunks_of_bits(bits: NDArray[np.integer]) -> list[Plane]:
    """Pack bits (rows, cols, K), bit 0 first, into the planes of chunks."""
    chunks = []
    for first in range(0, bits.shape[2], CHUNK_BITS):
        chunk_bits = bits[:, :, first : first + CHUNK_BITS].astype(np.int64)
        chunks.append(chunk_bits @ (np.int64(1) << np.arange(chunk_bits.shape[2], dtype=np.int64)))
    return chunks


def grouped(names: Sequence[str]) -> dict[str, list[str]]:
    """Group the columns of a decode table by field name."""
    columns_of_field: dict[str, list[str]] = {}
    for name in names:
        columns_of_field.setdefault(whole_name(name), []).append(name)
    return columns_of_field
