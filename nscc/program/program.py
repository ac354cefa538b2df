"""A checked program: every name resolved, every value in range, every code decoded."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Diagnostic
from nscc.source import Source, Span
from nscc.words.container import DecodeTable
from nscc.words.machine import StateMachine
from nscc.words.pictures import Pictures

Codes = Literal["fixed", "open"]
"""Specialised to the codes that the pixels use, or compiled for every legal code."""


@dataclass(frozen=True)
class Field:
    """A field of the pixel code: its values are `low`..`high`.

    `kind` is how it was declared: a range, free bits (`bits` of them) or a row of `book`.
    `span` is the declaration's range, bit count or book name: the place a user would change. A part
    of a long bit field (`nscc.program.wide`) begins with bit number `first_bit` of it.
    """

    name: str
    kind: Literal["range", "bits", "row"]
    low: int
    high: int
    span: Span
    bits: int | None = None
    first_bit: int = 0
    book: str | None = None


@dataclass(frozen=True)
class SlotGrid:
    """The time grid: the length of every slot in microseconds."""

    slot_us: tuple[float, ...]
    equal: bool
    span: Span
    count_span: Span


@dataclass(frozen=True)
class BucketRule:
    """One frame of the exposure: its name and where its rule stands."""

    name: str
    span: Span


@dataclass(frozen=True, eq=False, repr=False)
class Program:
    """What the parts after the front end know about a file.

    `table` holds the codes compiled for (`mode`), sorted by field values and distinct; its
    shutters are distinct and sorted as rows of bits. `pixel_codes` int32 (rows, cols) is the row of
    `table.codes` at each pixel: None for a file without `pixels`, unless it has no fields and so
    one code. `class_name` is a, b, c, d, e, codebook or general, `class_reason` a sentence saying
    how it was recognised. `legal_codes` is the number of codes that fields and `require` allow,
    None where they are too many to count. `target_span` is where the target statement names the
    chip, None if there is none. `messages` are warnings and notes. Where shutters depend on the
    light, `machine` says how; `table` then has its behaviours for shutters, and the shutters that
    they are in the dark, where no signal is above its level.
    """

    source: Source
    target: Target
    target_span: Span | None
    frame: SlotGrid
    fields: tuple[Field, ...]
    buckets: tuple[BucketRule, ...]
    mode: Codes
    table: DecodeTable
    legal_codes: int | None
    pixel_codes: NDArray[np.int32] | None
    class_name: str
    class_reason: str
    messages: tuple[Diagnostic, ...]
    machine: StateMachine | None = None
    pictures: Pictures | None = None

    def __repr__(self) -> str:
        return f"Program({self.source.name!r}, class {self.class_name}, {self.table!r})"
