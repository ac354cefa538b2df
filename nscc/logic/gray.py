"""Gray codes: groups that follow one another differ in one bit of their codes.

A group's shutters are found by one NOR if every plane that is 1 in its code has been turned over.
In binary the step from group to group turns two bits over on average, in a Gray code (F. Gray, US
patent 2 632 058, 1953) always one. At the frame's end all must be back as they were; so the order
of the codes, which is free as long as neighbours differ in one bit, is chosen for what that costs.
"""

from __future__ import annotations

from functools import cache
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

Numbers = TypeVar("Numbers", int, NDArray[np.int64])

# Codes that the search for a rotation may visit (some 0.05 s), the widest ones that it looks at,
# and the words for the way back that are good enough to end it.
_MOST_VISITED = 20_000
_WIDEST = 5
_GOOD = 2


def gray(number: Numbers) -> Numbers:
    """The reflected binary code: the codes of neighbours differ in one bit."""
    return number ^ (number >> 1)


def cycle(groups: int, bits: int) -> tuple[int, ...]:
    """Codes whose last one, or last but one, is next to the first: few bits are turned back."""
    # There on the codes without the top bit and back on those with it: a circle. If the number is
    # odd, one more follows on the last.
    half = groups // 2
    ascending = [gray(i) for i in range(half)]
    top = 1 << bits - 1
    codes = ascending + [top | code for code in reversed(ascending)]
    if groups % 2:
        codes.append(codes[-1] ^ max(top >> 1, 1) if half else 0)
    return tuple(codes)


@cache
def rotation(groups: int, bits: int) -> tuple[int, ...] | None:
    """Codes for bits that are turned over by a NOT into a free register, which costs one word.

    Each turn moves a bit to another register. The codes are those after which fewest words bring
    every bit back to where it was, as it was; None if the search is too large or finds none.
    """
    if bits > _WIDEST or groups > 1 << bits:
        return None
    search = _Rotation(groups, bits)
    search.visit([0], list(range(bits)), bits)
    return search.best


class _Rotation:
    """A depth-first search over codes; `place[b]` is the register of bit b, `free` the free one."""

    def __init__(self, groups: int, bits: int) -> None:
        self.groups, self.bits = groups, bits
        self.left = _MOST_VISITED
        self.best: tuple[int, ...] | None = None
        self.words = 1 << 30

    def visit(self, codes: list[int], place: list[int], free: int) -> None:
        """Tries all ways on from `codes`."""
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
        """Words that move every bit home, the right way round: one a move, two to turn in place."""
        # The moves home are chains, which end at the register that is free, and circles, which a
        # move to the free register opens (see `improve.recolour`; here only the words of it count).
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
