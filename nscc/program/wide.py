"""Bit fields of any length, stored as several integers, called chunks, if they do not fit one.

`code bits : bit[100]` has the chunks `bits` (bits 0 to 61) and `bits.62` (the others). Chunks are
columns of the decode table, and have names in frame files. Names of the language contain no dots.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from nscc.program.program import Field

CHUNK_BITS = 62
"""Most bits of a chunk, so that its value is below 2^62 like every other number."""

Plane = NDArray[np.int64]


def chunk_name(field: str, chunk: int) -> str:
    """Return the name of a field's chunk number `chunk`."""
    return field if chunk == 0 else f"{field}.{chunk * CHUNK_BITS}"


def whole_name(column: str) -> str:
    """Return the name of the field to which the chunk `column` belongs."""
    return column.partition(".")[0]


def chunks_of(field: Field) -> Iterator[Field]:
    """Yield the chunks of a field, each as a field; a field that fits one integer yields itself."""
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
    """Return bits (rows, cols, K), bit 0 first, packed into the planes of chunks."""
    chunks = []
    for first in range(0, bits.shape[2], CHUNK_BITS):
        chunk_bits = bits[:, :, first : first + CHUNK_BITS].astype(np.int64)
        chunks.append(chunk_bits @ (np.int64(1) << np.arange(chunk_bits.shape[2], dtype=np.int64)))
    return chunks


def grouped(names: Sequence[str]) -> dict[str, list[str]]:
    """Return the columns of a decode table grouped by field name."""
    columns_of_field: dict[str, list[str]] = {}
    for name in names:
        columns_of_field.setdefault(whole_name(name), []).append(name)
    return columns_of_field
