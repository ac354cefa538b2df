"""Gray codes: the codes of consecutive groups differ in one bit.

One NOR selects a group's shutters if every plane that is 1 in its code has been inverted. Stepping
to the next group inverts two bits on average in binary, always one in a Gray code (F. Gray, US
patent 2 632 058, 1953). All planes must be restored at the frame's end; among all Gray codes, the
one with the cheapest restoration is chosen.
"""

from __future__ import annotations

from functools import cache
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

Numbers = TypeVar("Numbers", int, NDArray[np.int64])

# Limits of the search for a rotation: visited codes (some 0.05 s), bits, and the words for
# restoration at which it stops.
_MOST_VISITED = 20_000
_WIDEST = 5
_GOOD = 2


def gray(number: Numbers) -> Numbers:
    """The reflected binary Gray code of a number."""
    return number ^ (number >> 1)


def cycle(groups: int, bits: int) -> tuple[int, ...]:
    """A Gray code whose last or last but one code is a neighbour of the first: few bits to
    restore."""
    # Count up without the top bit and down with it, which is a cycle. An odd number adds one code
    # after the last.
    half = groups // 2
    ascending = [gray(i) for i in range(half)]
    top = 1 << bits - 1
    codes = ascending + [top | code for code in reversed(ascending)]
    if groups % 2:
        codes.append(codes[-1] ^ max(top >> 1, 1) if half else 0)
    return tuple(codes)


@cache
def rotation(groups: int, bits: int) -> tuple[int, ...] | None:
    """A Gray code for bits that are inverted by NOT into a free register, which costs one word.
    Each inversion moves a bit to another register. The code is chosen so that the fewest words
    restore every bit and its place; None if the search is too large or finds none."""
    if bits > _WIDEST or groups > 1 << bits:
        return None
    search = _Rotation(groups, bits)
    search.visit([0], list(range(bits)), bits)
    return search.best


class _Rotation:
    """A depth-first search for codes; `place[b]` is the register of bit b, `free` the free
    register."""

    def __init__(self, groups: int, bits: int) -> None:
        self.groups, self.bits = groups, bits
        self.left = _MOST_VISITED
        self.best: tuple[int, ...] | None = None
        self.words = 1 << 30

    def visit(self, codes: list[int], place: list[int], free: int) -> None:
        """Try all continuations of `codes`."""
        self.left -= 1
        if self.left < 0 or self.words <= _GOOD:
            return
        if len(codes) == self.groups:
            words = self._way_back(codes[-1], place)
            if words < self.words:
                self.best, self.words = tuple(codes), words
            return
        for bit in range(self.bits):
            code = codes[-1] ^ 1 << bit
            if code in codes:
                continue
            was, place[bit] = place[bit], free
            codes.append(code)
            self.visit(codes, place, was)
            codes.pop()
            place[bit] = was

    def _way_back(self, code: int, place: list[int]) -> int:
        """Words that restore the register and polarity of every bit: one a move, two an inversion
        in place."""
        # The moves home form chains, which end at the free register, and cycles, which a move to
        # the free register opens (see `improve.recolour`; only the words count here).
        holder = {register: bit for bit, register in enumerate(place)}
        astray = {b for b in range(self.bits) if place[b] != b}
        words = 2 * sum(place[b] == b and code >> b & 1 for b in range(self.bits)) + len(astray)
        while astray:
            start = bit = min(astray)
            while bit in astray:
                astray.discard(bit)
                bit = holder.get(bit, -1)
            words += bit == start
        return words
