"""The fields of the pixel code and their value ranges."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import assert_never

import numpy as np
from numpy.typing import NDArray

from nscc.program.constants import constant
from nscc.program.expressions import Scope
from nscc.program.limits import MOST_BITS
from nscc.program.names import Declarations
from nscc.program.problems import Problems
from nscc.program.program import Field
from nscc.program.wide import CHUNK_BITS
from nscc.source import Span
from nscc.syntax.tree import CodeBits, CodeRange, CodeRow


def make_fields(
    declared: Declarations,
    scope: Scope,
    books: Mapping[str, NDArray[np.bool_] | None],
    problems: Problems,
) -> dict[str, Field | None]:
    """Return every declared field, None after an error in it or its codebook.

    Sets the long bit fields in `declared`. Reports an empty range (NS0306), a bit count outside
    1..MOST_BITS (NS0307) and `row of` something other than a codebook (NS0209, NS0214)."""
    maker = _Maker(declared, scope, books, problems)
    return {name: maker.make(statement) for name, statement in declared.codes.items()}


@dataclass(eq=False, repr=False)
class _Maker:
    """The inputs for making fields."""

    declared: Declarations
    scope: Scope
    books: Mapping[str, NDArray[np.bool_] | None]
    problems: Problems

    def make(self, statement: CodeRange | CodeBits | CodeRow) -> Field | None:
        match statement:
            case CodeRange():
                return self._range(statement)
            case CodeBits():
                return self._bits(statement)
            case CodeRow():
                return self._row(statement)
        assert_never(statement)

    def _range(self, statement: CodeRange) -> Field | None:
        low = constant(statement.low, self.scope, self.problems, "the start of a range")
        high = constant(statement.high, self.scope, self.problems, "the end of a range")
        if low is None or high is None:
            return None
        span = statement.low.span.to(statement.high.span)
        if low > high:
            message = f"the range {low}..{high} is empty"
            why = "the first value is larger than the last"
            helps = (f"write `{high}..{low}`",) if low - high > 1 else ()
            self.problems.error("NS0306", message, span, why, helps=helps)
            return None
        return Field(statement.name.text, "range", low, high, span)

    def _bits(self, statement: CodeBits) -> Field | None:
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
        return Field(statement.name.text, "bits", 0, 2**count - 1, place, bits=count)

    def _row(self, statement: CodeRow) -> Field | None:
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
        return Field(statement.name.text, "row", 0, digits.shape[0] - 1, place, book=book)
