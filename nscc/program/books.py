"""Codebooks: the digits of every row, written in the program or read from a file."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected
from nscc.program.arrays_file import ArraysFile
from nscc.program.expressions import Meaning
from nscc.program.limits import PROOF_LIMIT
from nscc.program.names import Book
from nscc.program.problems import Problems, clipped, counted
from nscc.syntax.tree import BookFromFile, BookInline

Digits = NDArray[np.bool_]


def make_books(
    books: dict[str, Book], slots: Meaning, base: Path, problems: Problems
) -> dict[str, Digits | None]:
    """The digits (K, N) of every codebook, None where an error was reported.

    `slots` is what N means: where that failed, row lengths are not judged and every book is None.
    Reports rows of a wrong length or with other digits (NS0310), files (NS0313, NS0314, NS0315).
    """
    return {name: _make(book, slots, base, problems) for name, book in books.items()}


def _make(book: Book, slots: Meaning, base: Path, problems: Problems) -> Digits | None:
    if isinstance(book, BookInline):
        return _inline(book, slots, problems)
    try:
        return _from_file(book, slots, base)
    except Rejected as wrong:
        problems.adopt(wrong, book.path.span)
        return None


def _inline(book: BookInline, slots: Meaning, problems: Problems) -> Digits | None:
    bad = _wrong_digit(book, problems) or _wrong_length(book, slots, problems)
    if not book.rows:
        message = f"the codebook `{book.name.text}` has no rows"
        problems.error("NS0310", message, book.span, "no rows")
    if bad or not book.rows or slots.kind != "constant":
        return None
    text = "".join(row.digits for row in book.rows).encode("ascii")
    digits: Digits = np.frombuffer(text, dtype=np.uint8) == ord("1")
    return digits.reshape(len(book.rows), slots.value)


def _wrong_digit(book: BookInline, problems: Problems) -> bool:
    for row in book.rows:
        other = next((d for d in row.digits if d not in "01"), None)
        if other is not None:
            message = f"a codebook row contains `{clipped(other)}`; only 0 and 1 are allowed"
            problems.error("NS0310", message, row.span, "1 is open, 0 is closed")
            return True
    return False


def _wrong_length(book: BookInline, slots: Meaning, problems: Problems) -> bool:
    """Reports the first row that has not N digits, and how many have not."""
    if slots.kind != "constant":
        return False
    wrong = [row for row in book.rows if len(row.digits) != slots.value]
    if not wrong:
        return False
    have = counted(len(wrong[0].digits), "digit")
    message = f"this row has {have}, but the frame has {counted(slots.value, 'slot')}"
    many = f"{len(wrong)} of {counted(len(book.rows), 'row')} have another length"
    notes = (many,) if len(wrong) > 1 else ()
    helps = ("give every row a digit for each slot, the first for slot 0",)
    problems.error("NS0310", message, wrong[0].span, have, notes=notes, helps=helps)
    return True


def _from_file(book: BookFromFile, slots: Meaning, base: Path) -> Digits | None:
    file = ArraysFile(base / book.path.value, book.path.value)
    if book.sha256 is not None:
        file.require_sha256(book.sha256.value)
    key = _key(book, file)
    rows = file.integers(key, most=PROOF_LIMIT, bools=True)
    where = f'the array `{clipped(key)}` of "{file.shown}"'
    if slots.kind != "constant":
        return None
    if rows.ndim != 2 or rows.shape[0] < 1 or rows.shape[1] != slots.value:
        wanted = f"a codebook for this frame has shape (K, {slots.value})"
        helps = ("one row for each shutter, one column for each slot",)
        raise rejected("NS0314", f"{where} has shape {rows.shape}; {wanted}", helps=helps)
    wrong = (rows != 0) & (rows != 1)
    if wrong.any():
        row, slot = (int(k) for k in np.unravel_index(int(wrong.argmax()), rows.shape))
        found = f"{where} holds {rows[row, slot]} in row {row}, slot {slot}"
        helps = (f"{counted(int(wrong.sum()), 'value is', 'values are')} neither",)
        raise rejected("NS0310", f"{found}; a codebook holds 0 and 1", helps=helps)
    digits: Digits = rows.astype(np.bool_)
    return digits


def _key(book: BookFromFile, file: ArraysFile) -> str:
    """The array meant: the stated key, else the one of the book's name, else the only one."""
    if book.key is not None:
        return book.key.text
    if book.name.text not in file.keys and len(file.keys) == 1:
        return file.keys[0]
    return book.name.text
