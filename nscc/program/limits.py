"""Limits on enumeration, checked before it starts, and on the numbers of shutters that a pixel's
registers can distinguish.

Those hold for any encoding of codes in digital registers."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Mapping
from math import isqrt

from nscc.chips.target import Target
from nscc.program.expressions import Checked, operands
from nscc.syntax.tree import Index, Name

PROOF_LIMIT = 2**26
"""Most codes x buckets x slots, each of which is evaluated, stored as a byte, and proved.

67 million take less than 100 MB and about a second."""

COMBINATION_LIMIT = 2**22
"""Most combinations of field values to test against `require` if every legal code is compiled."""

TABLE_LIMIT = 2**23
"""Most codes x fields, stored as 8 bytes each: 64 MB."""

WORK_LIMIT = 2**32
"""Most operations to evaluate one expression, which take about ten seconds."""

SURVEY_LIMIT = 2**20
"""Most codes x buckets x slots for determining the class if only used codes are compiled.

The limit keeps `nscc check` fast."""

MOST_SLOTS = 65536
"""Most slots in a frame: 16 times the longest frame in the literature.

A table of 1024 codes with this number of slots is within the proof limit."""

MOST_FIELDS = 64
"""Most fields of a pixel code: more than any target has registers for."""

MOST_BITS = MOST_SLOTS
"""Most bits of a bit field: one for each slot of the longest frame."""


def work(expr: Checked, sizes: Mapping[str, tuple[int, int]]) -> int:
    """Return the number of operations to evaluate `expr` for all values of its variables.

    `sizes` has the array axis (0 or 1) and the number of values of every variable. Other names are
    constants. A node of the syntax tree costs one operation for each combination of the variables
    below it."""
    axes: list[frozenset[int]] = []
    lengths = dict.fromkeys((0, 1), 1)
    lengths.update(dict(sizes.values()))
    total = 0
    none: frozenset[int] = frozenset()
    for node in expr.nodes:
        count = len(operands(node))
        varies = none.union(*axes[len(axes) - count :]) if count else none
        del axes[len(axes) - count :]
        if isinstance(node, Name) and node.text in sizes:
            varies = frozenset((sizes[node.text][0],))
        elif isinstance(node, Index):
            # A codebook is no variable: its digit depends on the index and on the slot n.
            base = sizes.get(node.base.text, sizes.get("n"))
            varies |= {base[0]} if base else none
        axes.append(varies)
        cost = 1
        for axis in varies:
            cost *= lengths[axis]
        total += cost
    return total


Count = Callable[[int], int]
"""A function that returns the number of different shutters of a class of a given size.

It does not decrease with the size."""


def bits_needed(shutters: int) -> int:
    """Return the fewest one-bit registers whose contents distinguish this number of shutters.

    `shutters` is at least 1; a single shutter needs no register."""
    return max(0, (shutters - 1).bit_length())


def capacity_note(shutters: int) -> str:
    """Return a note that this number of `shutters` needs `bits_needed` registers with any
    encoding."""
    return (
        f"certain for codes in digital registers: {shutters} shutters need "
        f"{bits_needed(shutters)} registers with any encoding"
    )


def largest_with(count: Count, most: int, least: int, ceiling: int) -> int:
    """Return the largest size in `least`..`ceiling` with at most `most` shutters; `least` - 1 if
    there is none.

    `count(size)` is the number of shutters, which must not decrease with the size. All sizes tried
    are in this range."""
    return least - 1 + bisect_right(range(least, ceiling + 1), most, key=count)


def impossible_from(count: Count, target: Target) -> int | None:
    """Return the smallest size whose shutters the registers of `target` cannot distinguish.

    `count(size)` is the number of shutters of a class with this many slots; it must not decrease.
    Return None if all sizes up to the longest frame are possible."""
    fits = largest_with(count, 1 << len(target.digital_registers), least=1, ceiling=MOST_SLOTS)
    return fits + 1 if fits < MOST_SLOTS else None


def largest(least: int, most: int, fits: Callable[[int], bool], budget: int) -> int | None:
    """Return the largest size in `least`..`most` that fits, found by bisection; None if no tried
    size fits, or if the range is empty.

    `fits(size)` tells whether a size fits. At most `budget` sizes are tried, `most` first, then by
    factors, then by differences: trials of small sizes take less time. The result is exact if all
    sizes below a fitting size fit and the budget suffices; else it is the largest tried size that
    fits."""
    if most < least or budget < 1:
        return None
    if fits(most):
        return most
    # `least` - 1 counts as fitting, until a size that fits is found.
    largest_fit, smallest_misfit = least - 1, most
    for _ in range(budget - 1):
        if smallest_misfit - largest_fit <= 1:
            break
        middle = (largest_fit + smallest_misfit) // 2
        if smallest_misfit > 8 * (largest_fit + 1):
            middle = isqrt((largest_fit + 1) * smallest_misfit)
        if fits(middle):
            largest_fit = middle
        else:
            smallest_misfit = middle
    return largest_fit if largest_fit >= least else None
