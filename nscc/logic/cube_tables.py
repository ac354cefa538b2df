"""Codes and cubes from precomputed tables, made by `tests/benchmarks/search_cubes.py`.

A generator needs codes for which certain sets of shutters are single cubes, because one NOR
computes a cube. Planes that are 1 in a cube must first be inverted, so good codes also need few
inversions in a frame. Such codes are hard to find. The tables therefore list the cubes; a shutter
gets any code that all its cubes allow. In the tables, every plane is 0 in the first cube of a
frame that reads it."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import Any

from nscc.logic.cubes import Cube
from nscc.logic.digits import cycle
from nscc.record import Record
from nscc.truth import set_bits, union


class BumpCubes(Record):
    """Cubes over `planes` planes for bumps that touch the groups i to j of slots.

    `rises[k]`, one or two cubes, contain the bumps with i = k, and none with k < i or j < k.
    `falls[k]`, for all groups except the last, contains the bumps with j = k, and none with i <= k
    < j. Opening open shutters and closing closed shutters has no effect."""

    planes: int
    rises: tuple[tuple[Cube, ...], ...]
    falls: tuple[Cube, ...]

    @staticmethod
    def of(planes: int, groups: int) -> BumpCubes | None:
        """Return the cubes for these numbers of planes and groups; None if no table has them."""
        known = [t for t in _bump_tables() if t.planes <= planes and len(t.rises) >= groups]
        best = min(known, key=lambda t: (-t.planes, len(t.rises)), default=None)
        return best and BumpCubes(best.planes, best.rises[:groups], best.falls[: groups - 1])

    def code(self, first: int, last: int) -> int:
        """Return the smallest code of a bump that touches the groups `first` to `last`."""
        rising = [_codes_in(cubes, self.planes) for cubes in self.rises]
        falling = [_codes_in((cube,), self.planes) for cube in self.falls]
        allowed = rising[first]
        if last < len(falling):
            allowed &= falling[last]
        banned = union([*rising[:first], *rising[last + 1 :], *falling[first:last]])
        return set_bits(allowed & ~banned)[0]


@cache
def number_cubes(count: int, planes: int) -> tuple[tuple[int, ...], tuple[Cube, ...]]:
    """Return codes of `count` numbers, and for each number a cube that contains only its code."""
    known = [rows for width, rows in _tables("numbers") if width == planes and len(rows) >= count]
    if not known:
        codes = cycle(count, planes)
        return codes, tuple(tuple((p, code >> p & 1) for p in range(planes)) for code in codes)
    cubes = tuple(map(_cube, min(known, key=len)[:count]))
    once = twice = 0
    for cube in cubes:
        twice |= once & _codes_in((cube,), planes)
        once |= _codes_in((cube,), planes)
    return tuple(set_bits(_codes_in((cube,), planes) & ~twice)[0] for cube in cubes), cubes


@cache
def _codes_in(cubes: Iterable[Cube], planes: int) -> int:
    """Return the codes in any of the cubes, as a bit mask."""
    return sum(
        1 << code
        for code in range(1 << planes)
        if any(all(code >> plane & 1 == value for plane, value in cube) for cube in cubes)
    )


@cache
def _bump_tables() -> tuple[BumpCubes, ...]:
    tables = []
    for planes, rows in _tables("bumps"):
        groups = [row.split("|") for row in rows]
        rises = tuple(tuple(map(_cube, rise.split())) for rise, _ in groups)
        tables.append(BumpCubes(planes, rises, tuple(_cube(fall) for _, fall in groups[:-1])))
    return tuple(tables)


def _tables(kind: str) -> list[tuple[int, list[str]]]:
    """Return the tables of a kind: the number of planes, and a row for each group or number."""
    return [(table["planes"], table["rows"].strip().splitlines()) for table in _file()[kind]]


@cache
def _file() -> dict[str, Any]:
    import tomllib  # slow to import, and few programs need it

    return tomllib.loads(Path(__file__).with_suffix(".toml").read_text())


def _cube(row: str) -> Cube:
    """Parse a cube with one character for each plane: 0, 1, or - if it does not read the plane."""
    return tuple((plane, int(bit)) for plane, bit in enumerate(row.strip()) if bit != "-")
