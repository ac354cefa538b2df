"""The fields of the pixel code with their value ranges, and the digits of codebooks."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import assert_never

import numpy as np

from nscc.arrays import Bools
from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.program.arrays_file import ArraysFile
from nscc.program.constants import constant
from nscc.program.expressions import Meaning, Scope
from nscc.program.limits import MOST_BITS, PROOF_LIMIT
from nscc.program.names import Book, Declarations
from nscc.program.problems import Problems, clipped, counted
from nscc.program.program import CHUNK_BITS, Field
from nscc.source import Span
from nscc.syntax.tree import BookFromFile, BookInline, CodeBits, CodeRange, CodeRow

Digits = Bools


def make_books(
    books: dict[str, Book], slots: Meaning, base: Path, problems: Problems
) -> dict[str, Digits | None]:
    """Return the digits of every codebook in `books` by name, bool (K, N); None after reporting an
    error in it.

    `slots` is the meaning of N: if it has an error, row lengths are not checked and every book is
    None. Files are relative to `base`. Reports rows of wrong length or with other digits (NS0310)
    and errors of files (NS0313, NS0314, NS0315)."""
    digits_by_book: dict[str, Digits | None] = {}
    for name, book in books.items():
        if isinstance(book, BookInline):
            digits_by_book[name] = _inline(book, slots, problems)
            continue
        try:
            digits_by_book[name] = _from_file(book, slots, base)
        except Rejected as wrong:
            problems.adopt(wrong, book.path.span)
            digits_by_book[name] = None
    return digits_by_book


def _inline(book: BookInline, slots: Meaning, problems: Problems) -> Digits | None:
    """Return the digits of a codebook that is written in the program, bool (rows, N).

    `slots` is the meaning of N. Return None if N has an error, or after reporting an error in the
    rows."""
    has_errors = _wrong_digit(book, problems) or _wrong_length(book, slots, problems)
    if not book.rows:
        message = f"the codebook `{book.name.text}` has no rows"
        problems.error("NS0310", message, book.span, "no rows")
    if has_errors or not book.rows or slots.kind != "constant":
        return None
    text = "".join(row.digits for row in book.rows).encode("ascii")
    digits: Digits = np.frombuffer(text, dtype=np.uint8) == ord("1")
    return digits.reshape(len(book.rows), slots.value)


def _wrong_digit(book: BookInline, problems: Problems) -> bool:
    """Report the first row with a character other than 0 and 1; return whether there is one. The
    code is NS0310."""
    for row in book.rows:
        wrong_digit = next((d for d in row.digits if d not in "01"), None)
        if wrong_digit is not None:
            message = f"a codebook row contains `{clipped(wrong_digit)}`; only 0 and 1 are allowed"
            problems.error("NS0310", message, row.span, "1 is open, 0 is closed")
            return True
    return False


def _wrong_length(book: BookInline, slots: Meaning, problems: Problems) -> bool:
    """Report (NS0310) the first row that does not have N digits, and how many there are; return
    whether there is one.

    `slots` is the meaning of N; if it has an error, nothing is reported."""
    if slots.kind != "constant":
        return False
    wrong_rows = [row for row in book.rows if len(row.digits) != slots.value]
    if not wrong_rows:
        return False
    have = counted(len(wrong_rows[0].digits), "digit")
    message = f"this row has {have}, but the frame has {counted(slots.value, 'slot')}"
    count_text = f"{len(wrong_rows)} of {counted(len(book.rows), 'row')} have another length"
    notes = (count_text,) if len(wrong_rows) > 1 else ()
    helps = ("give every row a digit for each slot, the first for slot 0",)
    problems.error("NS0310", message, wrong_rows[0].span, have, notes=notes, helps=helps)
    return True


def _from_file(book: BookFromFile, slots: Meaning, base: Path) -> Digits | None:
    """Return the digits of a codebook in an .npz file, bool (rows, N); None if N has an error.

    `slots` is the meaning of N, and the path is relative to the folder `base`. The array is the one
    that the program names. If it names none, the array has the name of the codebook, or it is the
    only one of the file. Raises Rejected for a missing file (NS0313), a changed one (NS0315), a
    missing array or a wrong shape (NS0314) or values other than 0 and 1 (NS0310)."""
    file = ArraysFile(base / book.path.value, book.path.value)
    if book.sha256 is not None:
        file.require_sha256(book.sha256.value)
    key = book.name.text if book.key is None else book.key.text
    if book.key is None and key not in file.keys and len(file.keys) == 1:
        (key,) = file.keys
    rows = file.integers(key, most=PROOF_LIMIT, bools=True)
    array_text = f'the array `{clipped(key)}` of "{file.shown}"'
    if slots.kind != "constant":
        return None
    if rows.ndim != 2 or rows.shape[0] < 1 or rows.shape[1] != slots.value:
        shape_text = f"a codebook for this frame has shape (K, {slots.value})"
        helps = ("one row for each shutter, one column for each slot",)
        raise rejected("NS0314", f"{array_text} has shape {rows.shape}; {shape_text}", helps=helps)
    not_binary = (rows != 0) & (rows != 1)
    if not_binary.any():
        row, slot = (int(k) for k in np.unravel_index(int(not_binary.argmax()), rows.shape))
        value_text = f"{array_text} holds {rows[row, slot]} in row {row}, slot {slot}"
        helps = (f"{counted(int(not_binary.sum()), 'value is', 'values are')} neither",)
        raise rejected("NS0310", f"{value_text}; a codebook holds 0 and 1", helps=helps)
    digits: Digits = rows.astype(np.bool_)
    return digits


def make_fields(
    declared: Declarations,
    scope: Scope,
    books: Mapping[str, Bools | None],
    problems: Problems,
) -> dict[str, Field | None]:
    """Return every declared field by name; None after an error in it or its codebook.

    `books` has the digits of codebooks by name, bool (rows, N), as `make_books` returns them. Bit
    fields of more than `CHUNK_BITS` bits are added to `declared.wide`. Reports an empty range
    (NS0306), a bit count outside 1..MOST_BITS (NS0307) and `row of` something other than a codebook
    (NS0209, NS0214)."""
    maker = _Maker(declared, scope, books, problems)
    return {name: maker.make(statement) for name, statement in declared.codes.items()}


@dataclass(eq=False, repr=False)
class _Maker:
    """Makes fields from `code` statements. `scope` has the names that ranges may use. `books` has
    the digits of codebooks by name, bool (rows, N); None for an invalid codebook."""

    declared: Declarations
    scope: Scope
    books: Mapping[str, Bools | None]
    problems: Problems

    def make(self, statement: CodeRange | CodeBits | CodeRow) -> Field | None:
        """Return the field that a `code` statement declares; None after an error in it or its
        codebook. A long bit field is one field here; `chunks_of` splits it."""
        match statement:
            case CodeRange():
                low = constant(statement.low, self.scope, self.problems, "the start of a range")
                high = constant(statement.high, self.scope, self.problems, "the end of a range")
                if low is None or high is None:
                    return None
                span = statement.low.span.to(statement.high.span)
                if low > high:
                    message = f"the range {low}..{high} is empty"
                    why = "the first value is larger than the last"
                    # `0..K - 1` with K = 0 is 0..-1: there, reversing the range would not help.
                    helps = (f"write `{high}..{low}`",) if low - high > 1 else ()
                    self.problems.error("NS0306", message, span, why, helps=helps)
                    return None
                return Field(statement.name.text, "range", low, high, span)
            case CodeBits():
                count = constant(statement.count, self.scope, self.problems, "the number of bits")
                if count is None:
                    return None
                if not 1 <= count <= MOST_BITS:
                    message = f"invalid number of bits: {count}"
                    text = f"a bit field has 1 to {MOST_BITS} bits"
                    self.problems.error("NS0307", message, statement.count.span, text)
                    return None
                if count > CHUNK_BITS:
                    self.declared.wide.add(statement.name.text)
                # The place of `bit[K]`; the tree only has the place of K.
                place, text = statement.count.span, self.problems.source.text
                start = text.rfind("bit", statement.name.span.end, place.start)
                if start >= 0:
                    place = Span(start, statement.span.end)
                return Field(
                    statement.name.text, "bits", low=0, high=2**count - 1, span=place, bits=count
                )
            case CodeRow():
                book = statement.book.text
                if book not in self.declared.books:
                    helps = ("declare the shutters first: `shutters BOOK [ 1100, 0011 ]`",)
                    self.declared.report_other(
                        statement.book, "a codebook", "", self.declared.books, helps, self.problems
                    )
                    return None
                digits = self.books[book]
                if digits is None:
                    return None
                place = statement.book.span
                return Field(
                    statement.name.text,
                    "row",
                    low=0,
                    high=digits.shape[0] - 1,
                    span=place,
                    book=book,
                )
        assert_never(statement)
