"""Codes of numbers from the tables: each number has a cube of its own, with few inversions."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from nscc.logic.cube_tables import number_cubes
from nscc.logic.digits import cycle


def literals(cube):
    """A cube as the tables write it, of ten planes."""
    values = dict(cube)
    return "".join(str(values.get(plane, "-")) for plane in range(10))


def agrees(code, cube):
    """Whether a code, its lowest bit first, is in a cube as the tables write one."""
    return all(bit in ("-", str(code >> plane & 1)) for plane, bit in enumerate(cube))


@pytest.mark.parametrize(("planes", "count"), [*product((4, 5, 6), (5, 12, 16)), (6, 48), (7, 64)])
def test_every_number_has_a_cube_of_its_own(planes, count):
    codes, cubes = number_cubes(count, planes)
    inside = [[agrees(code, literals(cube)) for code in codes] for cube in cubes]
    assert np.array_equal(inside, np.eye(count))
    assert inversions(map(literals, cubes)) <= inversions(
        "".join(str(code >> plane & 1) for plane in range(planes)) for code in cycle(count, planes)
    )


def inversions(cubes):
    """How often a plane is asked for in the other polarity, the way back to the first included."""
    return sum(
        before != after
        for column in zip(*cubes, strict=True)
        for values in [[bit for bit in column if bit != "-"]]
        for before, after in zip(values, [*values[1:], *values[:1]], strict=True)
    )
