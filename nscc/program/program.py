"""A checked program: names are resolved, values are in range, codes are decoded."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from nscc.arrays import Ints, Ints32
from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Diagnostic
from nscc.operations import STEERING
from nscc.record import Record
from nscc.source import Source, Span
from nscc.words.container import DecodeTable
from nscc.words.machine import NO_LOOKS, StateMachine
from nscc.words.pictures import NO_PICTURES, Pictures

Codes = Literal["fixed", "open"]
"""Whether a program is compiled for the codes that the pixels use, or for every legal code."""


class Field(Record):
    """A field of the pixel code, with the values `low`..`high`, both included.

    `kind` is its declaration: a range, free bits (`bits` of them) or a row of the codebook `book`.
    `span` is the place of the declaration's range, bit count or book name, which a user would
    change. A bit field of more than CHUNK_BITS bits is split into fields, called chunks, which
    begin with its bit `first_bit`."""

    name: str
    kind: Literal["range", "bits", "row"]
    low: int
    high: int
    span: Span
    bits: int | None = None
    first_bit: int = 0
    book: str | None = None


class SlotGrid(Record):
    """The slots of a frame: the length of every slot in microseconds (`slot_us`), and whether all
    are `equal`.

    `span` is the place of the `frame` statement, `count_span` that of the number of slots or their
    lengths."""

    slot_us: tuple[float, ...]
    equal: bool
    span: Span
    count_span: Span


class BucketRule(Record):
    """A bucket: its name, "frame" for `open when`, and the place of its rule."""

    name: str
    span: Span


class Program(Record, eq=False):
    """A checked program, the input of all later passes.

    `source` is its text, `frame` has its slots, and `buckets` are in the order of the text. `table`
    contains the codes that are compiled (`mode`), sorted by field values and distinct; its shutters
    are distinct and sorted as rows of bits. `pixel_codes` int32 (rows, cols) is the row of
    `table.codes` at each pixel; None for a file without `pixels`, unless it has no fields and
    therefore one code. `class_name` is a, b, c, d, e, codebook or general; `class_reason` is a
    sentence on why. `legal_codes` is the number of codes that fields and `require` allow, None if
    there are too many to count. `target_span` is the place where the target statement names the
    chip, None if there is no such statement. `messages` are warnings and notes. If shutters depend
    on the light, `machine` is the state machine; then `table` has its behaviours (sets of codes
    that act alike) instead of shutters, and their shutters in the dark, where no signal is above
    its level."""

    source: Source
    target: Target
    target_span: Span | None
    frame: SlotGrid
    fields: tuple[Field, ...]
    buckets: tuple[BucketRule, ...]
    mode: Codes
    table: DecodeTable
    legal_codes: int | None
    pixel_codes: Ints32 | None
    class_name: str
    class_reason: str
    messages: tuple[Diagnostic, ...]
    machine: StateMachine = NO_LOOKS
    pictures: Pictures = NO_PICTURES

    @property
    def spared_registers(self) -> tuple[str, ...]:
        """The digital registers that must not hold pixel codes, because images and planes need
        them.

        They choose from which neighbour bits are read."""
        return (*STEERING,) if self.pictures.steering else ()

    def __repr__(self) -> str:
        """Return name, class and table as one line."""
        return f"Program({self.source.name!r}, class {self.class_name}, {self.table!r})"


CHUNK_BITS = 62
"""Most bits of a chunk, so that its value is below 2^62 like every other number.

A bit field that does not fit one integer is stored as several, called chunks: `code bits :
bit[100]` has the chunks `bits` (bits 0 to 61) and `bits.62` (the others). Chunks are columns of the
decode table, and have names in frame files. Names of the language contain no dots."""

Plane = Ints


def chunk_name(field: str, chunk: int) -> str:
    """Return the name of chunk number `chunk`, from 0, of a field: `bits` for 0, then `bits.62`,
    `bits.124` and so on."""
    return field if chunk == 0 else f"{field}.{chunk * CHUNK_BITS}"


def whole_name(column: str) -> str:
    """Return the name of the field to which the chunk `column`, such as `bits.62`, belongs.

    A name without a dot is returned as it is."""
    return column.partition(".")[0]


def chunks_of(field: Field) -> Iterator[Field]:
    """Yield the chunks of a field, each as a field of at most CHUNK_BITS bits.

    A field that fits one integer yields itself. The order is that of the bits, bit 0 first."""
    bits = field.bits or 0
    if bits <= CHUNK_BITS:
        yield field
        return
    for chunk in range(-(-bits // CHUNK_BITS)):
        count = min(CHUNK_BITS, bits - chunk * CHUNK_BITS)
        yield replace(
            field,
            name=chunk_name(field.name, chunk),
            high=2**count - 1,
            bits=count,
            first_bit=chunk * CHUNK_BITS,
        )


def chunks_of_bits(bits: NDArray[np.integer]) -> list[Plane]:
    """Return single bits (rows, cols, K), bit 0 first, packed into one int64 array (rows, cols) for
    each chunk of at most CHUNK_BITS bits."""
    chunks = []
    for first in range(0, bits.shape[2], CHUNK_BITS):
        chunk_bits = bits[:, :, first : first + CHUNK_BITS].astype(np.int64)
        chunks.append(chunk_bits @ (np.int64(1) << np.arange(chunk_bits.shape[2], dtype=np.int64)))
    return chunks


def grouped(names: Sequence[str]) -> dict[str, list[str]]:
    """Return the columns of a decode table by the name of their field; a long bit field has
    several, in the order of `names`."""
    columns_of_field: dict[str, list[str]] = {}
    for name in names:
        columns_of_field.setdefault(whole_name(name), []).append(name)
    return columns_of_field
