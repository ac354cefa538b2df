"""Codes of bumps in which one cube says who opens and one cube says who closes.

Time is cut into groups of slots. A bump touches the groups i to j, and its code is such that for
every group k

* the rise cube of k contains the bumps with i = k, and none with k < i or j < k;
* the fall cube of k contains the bumps with j = k, and none with i <= k < j.

A bump in both cubes' blind spots is open already, or closed already, whatever is written then. So
cubes are chosen first, and a bump takes any code that all of them allow: the cubes of a table were
found by a search (`tests/benchmarks/search_bump_cubes.py`) for those that need the fewest planes to
be inverted as time goes on.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from nscc.logic.cubes import Cube
from nscc.truth import set_bits


@dataclass(frozen=True)
class BumpCubes:
    """The cubes of consecutive groups over `planes` code planes; the last group has no fall cube."""

    planes: int
    rises: tuple[Cube, ...]
    falls: tuple[Cube, ...]

    @staticmethod
    def of(planes: int, groups: int) -> BumpCubes | None:
        """The cubes for so many groups that need fewest inversions; None if none are known."""
        tables = [table for table in _tables() if table.planes == planes]
        windows = [
            table._window(first, groups)
            for table in tables
            for first in range(len(table.rises) - groups + 1)
        ]
        return min(windows, key=BumpCubes.inversions, default=None)

    def in_order(self) -> list[Cube]:
        """The cubes in the order in which a frame reads them."""
        pairs = zip(self.rises, (*self.falls, ()), strict=True)
        return [cube for pair in pairs for cube in pair]

    def inversions(self) -> int:
        """How often a frame inverts a plane, until all stand as at the start."""
        first: dict[int, int] = {}
        standing: dict[int, int] = {}
        count = 0
        for plane, value in (literal for cube in self.in_order() for literal in cube):
            first.setdefault(plane, value)
            count += standing.get(plane, value) != value
            standing[plane] = value
        return count + sum(standing[plane] != value for plane, value in first.items())

    def code(self, first: int, last: int) -> int:
        """The smallest code of a bump that touches the groups `first` to `last`."""
        wanted = [self.rises[first], *self.falls[last : last + 1]]
        banned = [*self.rises[:first], *self.rises[last + 1 :], *self.falls[first:last]]
        allowed = self._codes(())
        for cube in wanted:
            allowed &= self._codes(cube)
        for cube in banned:
            allowed &= ~self._codes(cube)
        return set_bits(allowed)[0]

    def _window(self, first: int, groups: int) -> BumpCubes:
        """The cubes of `groups` groups from `first` on."""
        end = first + groups
        return BumpCubes(self.planes, self.rises[first:end], self.falls[first : end - 1])

    def _codes(self, cube: Cube) -> int:
        """The codes in a cube, as a bit mask."""
        return _codes_in(cube, self.planes)


@cache
def _codes_in(cube: Cube, planes: int) -> int:
    codes = range(1 << planes)
    return sum(1 << code for code in codes if all(code >> p & 1 == v for p, v in cube))


@cache
def _tables() -> tuple[BumpCubes, ...]:
    import tomllib  # only from -O2 on: `check` starts without it

    text = Path(__file__).with_name("bump_cubes.toml").read_text()
    return tuple(_table(rows.split()) for rows in tomllib.loads(text)["cubes"])


def _table(rows: Sequence[str]) -> BumpCubes:
    """Cubes in the order in which a frame reads them, each a character a plane: 0, 1 or -."""
    cubes = [
        tuple((plane, int(value)) for plane, value in enumerate(row) if value != "-")
        for row in rows
    ]
    return BumpCubes(len(rows[0]), tuple(cubes[::2]), tuple(cubes[1::2]))
