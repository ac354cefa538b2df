"""What no compiler can do: counts of shutters that a pixel's registers cannot tell apart.

Nothing here is a property of nscc's gates: these bounds hold for any encoding of codes that are
held in digital registers.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable

from nscc.chips.target import Target
from nscc.program.limits import MOST_SLOTS

Count = Callable[[int], int]
"""How many different shutters a class has at a size; it never falls as the size grows."""


def bits_needed(shutters: int) -> int:
    """The fewest one-bit registers that tell so many shutters apart."""
    return max(0, (shutters - 1).bit_length())


def capacity_note(shutters: int) -> str:
    """Why fewer registers than `bits_needed` are not enough, in words."""
    return (
        f"certain for codes in digital registers: {shutters} shutters need "
        f"{bits_needed(shutters)} registers with any encoding"
    )


def largest_with(count: Count, most: int, least: int, ceiling: int) -> int:
    """The largest size in `least`..`ceiling` that has at most `most` shutters; least - 1 if none
    has."""
    return least - 1 + bisect_right(range(least, ceiling + 1), most, key=count)


def impossible_from(count: Count, target: Target) -> int | None:
    """The smallest size whose shutters the registers of `target` cannot tell apart; None if every
    size up to the longest frame passes."""
    fits = largest_with(count, 1 << len(target.digital_registers), 1, MOST_SLOTS)
    return fits + 1 if fits < MOST_SLOTS else None
