"""Factors of kernels: the kernels of the table that divide another kernel."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from nscc.neighbours.programs import (
    IDENTITY,
    TURNS,
    UNIT,
    Offset,
    Polynomial,
    Program,
    Taps,
    kernel_of,
    program_from_text,
    turned,
    turned_taps,
)
from nscc.neighbours.table import ROWS, WordForms
from nscc.record import Record

Key = frozenset[tuple[Offset, int]]
"""A convolution kernel as pairs (offset, nonzero weight in units of 1 / UNIT)."""


@cache
def rows(forms: WordForms) -> dict[Key, Program]:
    """Return the shortest program of each convolution kernel in the table, by kernel: a frozenset
    of pairs (offset, weight in units of 1 / UNIT).

    The kernels of the table also occur rotated and mirrored; of programs with equal length, the
    first in the table counts. `forms` are the words that the chip allows."""
    shortest: dict[Key, Program] = {}
    for line in ROWS.split("\n"):
        if line:
            program = forms.allowed(program_from_text(line))
            taps = kernel_of(program)
            for turn in TURNS:
                key = frozenset(turned_taps(taps, turn).items())
                # Without an entry, a program twice as long is replaced.
                if len(program) < len(shortest.get(key, program * 2)):
                    shortest[key] = turned(program, turn)
    return shortest


class Factor(Record):
    """A convolution kernel of at least two weights that may divide other kernels, with its program.

    `taps` are the weights by offset, in units of 1 / UNIT. `lead` is the offset of its last weight,
    ordered by column, then row. `size` are its numbers of columns and rows, minus 1. `corner` is
    the smallest column and row. `values` are those of the kernel as a polynomial at x and y = 1 or
    -1, which multiply if kernels are convolved."""

    taps: Taps
    program: Program
    lead: Offset
    size: Offset
    corner: Offset
    values: tuple[int, ...]

    @classmethod
    def of(cls, taps: Taps, program: Program) -> Factor:
        """Return a convolution kernel as a factor, with the program that computes it.

        `taps` are the weights by offset, in units of 1 / UNIT, at least one."""
        corner, size = box_of(taps)
        return cls(
            taps, program, lead=max(taps), size=size, corner=corner, values=_values_at_signs(taps)
        )


def box_of(taps: Taps) -> tuple[Offset, Offset]:
    """Return the smallest column and row of a convolution kernel, and its numbers of columns and
    rows minus 1.

    Each result is (columns, rows). Raises ValueError for a kernel without weights."""
    columns, rows_ = [x for x, _ in taps], [y for _, y in taps]
    corner = min(columns), min(rows_)
    return corner, (max(columns) - corner[0], max(rows_) - corner[1])


@cache
def factors(forms: WordForms) -> tuple[Factor, ...]:
    """Return the convolution kernels of the table that have at least two weights; rotated and
    mirrored kernels are factors of their own.

    `forms` are the words that the chip allows."""
    programs = rows(forms).items()
    return tuple(Factor.of(dict(key), program) for key, program in programs if len(key) > 1)


@cache
def factors_within(forms: WordForms, size: Offset) -> tuple[Factor, ...]:
    """Return the factors with at most as many columns and rows as a kernel of this size.

    `size` is its numbers of columns and rows, each minus 1. `forms` are the words that the chip
    allows."""
    return tuple(f for f in factors(forms) if f.size[0] <= size[0] and f.size[1] <= size[1])


def _values_at_signs(taps: Taps) -> tuple[int, ...]:
    """Return the values of a convolution kernel as a polynomial at (x, y) = (1, 1), (-1, 1), (1,
    -1) and (-1, -1).

    If kernels are convolved, these four numbers multiply. So a factor's values divide those of the
    product."""
    # The sums of the weights at even x and y, odd x only, odd y only, and odd x and y.
    sums = [0, 0, 0, 0]
    for (x, y), weight in taps.items():
        sums[x & 1 | (y & 1) << 1] += weight
    even, odd_x, odd_y, odd = sums
    return (
        even + odd_x + odd_y + odd,
        even - odd_x + odd_y - odd,
        even + odd_x - odd_y - odd,
        even - odd_x - odd_y + odd,
    )


def quotients(taps: Taps, forms: WordForms) -> Iterator[tuple[Factor, Polynomial]]:
    """Yield each convolution kernel of the table that divides `taps`, with the quotient; nothing if
    none does.

    `taps` and the quotient are weights by offset, in units of 1 / UNIT. The quotient is never the
    identity. `forms` are the words that the chip allows."""
    box, values = box_of(taps), [value * UNIT for value in _values_at_signs(taps)]
    for factor in factors_within(forms, box[1]):
        # Four divisions exclude most kernels before the long division.
        for value, divisor in zip(values, factor.values, strict=True):
            if value % divisor if divisor else value:  # only 0 is a multiple of 0
                break
        else:
            quotient = _quotient_of(taps, factor, *box)
            if quotient is not None and quotient != IDENTITY:
                yield factor, quotient


def _quotient_of(taps: Taps, factor: Factor, corner: Offset, size: Offset) -> Polynomial | None:
    """Return the convolution kernel whose product with `factor` is `taps`; None if there is none.

    It is found by long division from the last weight. `corner` is the smallest column and row of
    `taps`, and `size` its numbers of columns and rows minus 1; the quotient must stay within what
    they leave. Weights are in units of 1 / UNIT; None also if a weight of the quotient is not a
    whole number of these."""
    width, height = size[0] - factor.size[0], size[1] - factor.size[1]
    first_col, first_row = corner[0] - factor.corner[0], corner[1] - factor.corner[1]
    lead_weight = factor.taps[factor.lead]
    dividend, quotient = dict(taps), {}
    while dividend:
        last = max(dividend)
        x, y = last[0] - factor.lead[0], last[1] - factor.lead[1]
        weight, remainder = divmod(dividend[last] * UNIT, lead_weight)
        if remainder or not (
            first_col <= x <= first_col + width and first_row <= y <= first_row + height
        ):
            return None
        quotient[x, y] = weight
        for (right, down), factor_weight in factor.taps.items():
            offset = (x + right, y + down)
            difference = dividend.get(offset, 0) - weight * factor_weight // UNIT
            if difference:
                dividend[offset] = difference
            else:
                dividend.pop(offset, None)
    return quotient
