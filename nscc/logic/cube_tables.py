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

from nscc.logic.cubes import Cube
from nscc.logic.digits import cycle
from nscc.truth import set_bits


@cache
def number_cubes(count: int, planes: int) -> tuple[tuple[int, ...], tuple[Cube, ...]]:
    """Return codes of `count` numbers, and for each number a cube that contains only its code."""
    known = [cubes for width, cubes in _tables() if width == planes and len(cubes) >= count]
    if not known:
        codes = cycle(count, planes)
        return codes, tuple(tuple((p, code >> p & 1) for p in range(planes)) for code in codes)
    cubes = min(known, key=len)[:count]
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
def _tables() -> tuple[tuple[int, tuple[Cube, ...]], ...]:
    """Return the numbers of planes of all tables, and the cubes of their numbers."""
    import tomllib  # slow to import, and few programs need it

    tables = tomllib.loads(Path(__file__).with_suffix(".toml").read_text())["numbers"]
    return tuple((table["planes"], tuple(map(_cube, table["rows"].split()))) for table in tables)


def _cube(row: str) -> Cube:
    """Parse a cube with one character for each plane: 0, 1, or - if it does not read the plane."""
    return tuple((plane, int(bit)) for plane, bit in enumerate(row) if bit != "-")
