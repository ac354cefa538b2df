"""Limits for every compiler: the numbers of shutters that a pixel's registers can distinguish.

They hold for any encoding of codes in digital registers."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable

from nscc.chips.target import Target
from nscc.program.limits import MOST_SLOTS

Count = Callable[[int], int]
"""A function that returns the number of different shutters of a class of a given size.

It does not decrease with the size."""


def bits_needed(shutters: int) -> int:
    """Return the fewest one-bit registers that distinguish this number of shutters."""
    return max(0, (shutters - 1).bit_length())


def capacity_note(shutters: int) -> str:
    """Return a note on why fewer registers than `bits_needed` are not enough."""
    return (
        f"certain for codes in digital registers: {shutters} shutters need "
        f"{bits_needed(shutters)} registers with any encoding"
    )


def largest_with(count: Count, most: int, least: int, ceiling: int) -> int:
    """Return the largest size in `least`..`ceiling` with at most `most` shutters; least - 1 if none
    has."""
    return least - 1 + bisect_right(range(least, ceiling + 1), most, key=count)


def impossible_from(count: Count, target: Target) -> int | None:
    """Return the smallest size whose shutters the registers of `target` cannot distinguish.

    None if all sizes up to the longest frame are possible."""
    fits = largest_with(count, 1 << len(target.digital_registers), 1, MOST_SLOTS)
    return fits + 1 if fits < MOST_SLOTS else None
