"""A checked program: names are resolved, values are in range, codes are decoded."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Diagnostic
from nscc.operations import STEERING
from nscc.source import Source, Span
from nscc.words.container import DecodeTable
from nscc.words.machine import StateMachine

if TYPE_CHECKING:
    from nscc.words.pictures import Pictures

Codes = Literal["fixed", "open"]
"""Whether a program is compiled for the codes that the pixels use, or for every legal code."""


@dataclass(frozen=True)
class Field:
    """A field of the pixel code, with values `low`..`high`.

    `kind` is its declaration: a range, free bits (`bits` of them) or a row of the codebook `book`.
    `span` is the place of the declaration's range, bit count or book name, which a user would
    change. A chunk of a long bit field (`nscc.program.wide`) starts with bit number `first_bit` of
    it."""

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
    """The slots of a frame: the length of every slot in microseconds."""

    slot_us: tuple[float, ...]
    equal: bool
    span: Span
    count_span: Span


@dataclass(frozen=True)
class BucketRule:
    """A bucket: its name and the place of its rule."""

    name: str
    span: Span


@dataclass(frozen=True, eq=False, repr=False)
class Program:
    """A checked program, the input of all later passes.

    `table` contains the codes that are compiled (`mode`), sorted by field values and distinct; its
    shutters are distinct and sorted as rows of bits. `pixel_codes` int32 (rows, cols) is the row of
    `table.codes` at each pixel; None for a file without `pixels`, unless it has no fields and
    therefore one code. `class_name` is a, b, c, d, e, codebook or general; `class_reason` is a
    sentence on why. `legal_codes` is the number of codes that fields and `require` allow, None if
    there are too many to count. `target_span` is the place where the target statement names the
    chip, None if there is no such statement. `messages` are warnings and notes. If shutters depend
    on the light, `machine` is the state machine; then `table` has its behaviours instead of
    shutters, and their shutters in the dark, where no signal is above its level."""

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

    @property
    def spared_registers(self) -> tuple[str, ...]:
        """The digital registers that images and planes need beside the pixel codes: those that
        choose the neighbours of which bits are read."""
        return (*STEERING,) if self.pictures is not None and self.pictures.steering else ()

    def __repr__(self) -> str:
        return f"Program({self.source.name!r}, class {self.class_name}, {self.table!r})"
