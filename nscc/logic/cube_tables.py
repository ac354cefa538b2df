"""Tables of cubes that a search has found (`tests/benchmarks/search_cubes.py`).

A cube is found by one NOR if those of its planes stand inverted that are 1 in it. The cubes of a
table come one after the other in a frame, and are such that few planes are inverted in between.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Literal

from nscc.logic.cubes import Cube
from nscc.logic.gray import cycle
from nscc.truth import set_bits


@cache
def cube_rows(kind: Literal["bumps", "numbers"]) -> list[tuple[int, list[str]]]:
    """The tables of a kind: how many planes, and a line for each group or number."""
    import tomllib  # only where somebody asks

    tables = tomllib.loads(Path(__file__).with_name("cube_tables.toml").read_text())[kind]
    return [(table["planes"], table["rows"].strip().splitlines()) for table in tables]


def cube_of(row: str) -> Cube:
    """A cube from a character for each plane: 0, 1, or - where it does not read the plane."""
    return tuple((plane, int(value)) for plane, value in enumerate(row) if value != "-")


@cache
def codes_in(cube: Cube, planes: int) -> int:
    """The codes in a cube, as a bit mask."""
    codes = range(1 << planes)
    return sum(1 << code for code in codes if all(code >> p & 1 == v for p, v in cube))


def standing_at_first(cubes: Iterable[Cube]) -> tuple[dict[int, int], int]:
    """The value that each plane has in the first cube that reads it; and how often planes are
    inverted if cubes are read in this order, until all stand as they did at first."""
    first: dict[int, int] = {}
    standing: dict[int, int] = {}
    inversions = 0
    for plane, value in (literal for cube in cubes for literal in cube):
        first.setdefault(plane, value)
        inversions += standing.get(plane, value) != value
        standing[plane] = value
    return first, inversions + sum(standing[plane] != value for plane, value in first.items())


def inverted(cube: Cube, planes: Mapping[int, int]) -> Cube:
    """The cube after inverting the planes that have a 1 in `planes`."""
    return tuple((plane, value ^ planes[plane]) for plane, value in cube)


@cache
def number_cubes(count: int, planes: int) -> tuple[tuple[int, ...], tuple[Cube, ...]]:
    """Codes of so many numbers, and for each a cube that holds its code and no other one's.

    They come from a table, or are a Gray code, whatever inverts less. Every plane is 0 in the first
    cube that reads it.
    """
    codes = cycle(count, planes)
    choices = [tuple(tuple((p, code >> p & 1) for p in range(planes)) for code in codes)]
    for known, rows in cube_rows("numbers"):
        for start in range(len(rows) - count + 1) if known == planes else ():
            choices.append(tuple(map(cube_of, rows[start : start + count])))
    best = min(choices, key=lambda choice: standing_at_first(choice)[1])
    first, _ = standing_at_first(best)
    cubes = tuple(inverted(cube, first) for cube in best)
    return _own_codes(cubes, planes), cubes


def _own_codes(cubes: Sequence[Cube], planes: int) -> tuple[int, ...]:
    """The smallest code that is in each cube alone."""
    once = twice = 0
    for cube in cubes:
        twice |= once & codes_in(cube, planes)
        once |= codes_in(cube, planes)
    return tuple(set_bits(codes_in(cube, planes) & ~twice)[0] for cube in cubes)
