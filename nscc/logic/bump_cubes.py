"""Codes of bumps in which few cubes say who opens, and one cube says who closes.

Time is cut into groups of slots. A bump touches the groups i to j, and its code is such that for
every group k

* the rise cubes of k contain the bumps with i = k, and none with k < i or j < k;
* the fall cube of k contains the bumps with j = k, and none with i <= k < j.

What is open already may rise again, and what is closed may fall again. So a bump may have any code
that all cubes allow, and the cubes can be chosen first (`nscc.logic.cube_tables`).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from itertools import chain

from nscc.logic.cube_tables import (
    codes_in,
    cube_of,
    cube_rows,
    inverted,
    standing_at_first,
)
from nscc.logic.cubes import Cube
from nscc.truth import set_bits, union


@dataclass(frozen=True)
class BumpCubes:
    """The cubes of consecutive groups over `planes` planes; the last group has no fall cube."""

    planes: int
    rises: tuple[tuple[Cube, ...], ...]
    falls: tuple[Cube, ...]

    @staticmethod
    def of(planes: int, groups: int) -> BumpCubes | None:
        """Cubes of so many groups over as many planes as there are; None if none are known.

        Every plane is 0 in the first cube that reads it.
        """
        windows = (
            BumpCubes(
                table.planes,
                table.rises[first : first + groups],
                table.falls[first : first + groups - 1],
            )
            for table in _tables()
            for first in range(len(table.rises) - groups + 1)
            if table.planes <= planes
        )
        best = min(windows, key=lambda w: (-w.planes, w._words()), default=None)
        return best and best._upright()

    def _in_order(self) -> list[Cube]:
        """The cubes in the order in which a frame reads them."""
        falls = (*((cube,) for cube in self.falls), ())
        return [cube for pair in zip(self.rises, falls, strict=True) for cube in chain(*pair)]

    def _words(self) -> int:
        """Words that second rise cubes and inversions of planes take, more or less."""
        _, inversions = standing_at_first(self._in_order())
        return 2 * inversions + 4 * sum(len(cubes) - 1 for cubes in self.rises)

    def _upright(self) -> BumpCubes:
        """The cubes for planes that are inverted where their first cube asks for it."""
        first, _ = standing_at_first(self._in_order())
        return BumpCubes(
            self.planes,
            tuple(tuple(inverted(cube, first) for cube in cubes) for cubes in self.rises),
            tuple(inverted(cube, first) for cube in self.falls),
        )

    def code(self, first: int, last: int) -> int:
        """The smallest code of a bump that touches the groups `first` to `last`."""
        allowed = self._codes(*self.rises[first])
        if last < len(self.falls):
            allowed &= self._codes(self.falls[last])
        for k, cubes in enumerate(self.rises):
            if not first <= k <= last:
                allowed &= ~self._codes(*cubes)
        for cube in self.falls[first:last]:
            allowed &= ~self._codes(cube)
        return set_bits(allowed)[0]

    def _codes(self, *cubes: Cube) -> int:
        """The codes in any of some cubes, as a bit mask."""
        return union(codes_in(cube, self.planes) for cube in cubes)


@cache
def _tables() -> tuple[BumpCubes, ...]:
    tables = []
    for planes, lines in cube_rows("bumps"):
        groups = [line.split(" |") for line in lines]
        rises = tuple(tuple(map(cube_of, rise.split())) for rise, _ in groups)
        falls = tuple(cube_of(fall.strip()) for _, fall in groups[:-1])
        tables.append(BumpCubes(planes, rises, falls))
    return tuple(tables)
