"""Records behave like frozen dataclasses, and compare like them."""

from __future__ import annotations

import copy
import pickle
from dataclasses import fields, is_dataclass, replace
from functools import cached_property

import pytest

from nscc.cache.digest import digest
from nscc.record import Record


class Point(Record):
    x: int
    y: int = 2

    @cached_property
    def total(self) -> int:
        return self.x + self.y


class Named(Point):
    name: str = "p"


class Lone(Record, eq=False):
    x: int


def test_records_take_values_by_position_name_or_default() -> None:
    assert Point(1) == Point(1, 2) == Point(y=2, x=1)
    assert repr(Named(1, name="q")) == "Named(x=1, y=2, name='q')"


@pytest.mark.parametrize("arguments", [{}, {"y": 1}, {"x": 1, "z": 1}])
def test_wrong_names_are_refused(arguments: dict[str, int]) -> None:
    with pytest.raises(TypeError, match="Point takes x, y"):
        Point(**arguments)


def test_too_many_or_repeated_values_are_refused() -> None:
    for call in (lambda: Point(1, 2, 3), lambda: Point(1, x=1)):
        with pytest.raises(TypeError, match="Point takes x, y"):
            call()


def test_records_are_frozen_values() -> None:
    point = Point(1)
    with pytest.raises(AttributeError, match=r"Point\.x is frozen"):
        point.x = 3  # type: ignore[misc]
    assert point.total == 3
    assert point == Point(1)  # what is cached is no part of the value
    assert hash(point) == hash(Point(1))
    assert point != Named(1)
    assert {Point(1), Point(1), Point(2)} == {Point(1), Point(2)}


def test_records_without_equality_are_compared_by_identity() -> None:
    lone = Lone(1)
    assert lone != Lone(1)
    assert {lone: 1}[lone] == 1


def test_functions_for_dataclasses_accept_records() -> None:
    assert is_dataclass(Named(1))
    assert [field.name for field in fields(Named)] == ["x", "y", "name"]
    assert [field.name for field in fields(Point)] == ["x", "y"]
    assert replace(Named(1), y=5) == Named(1, 5)
    assert digest(Point(1)) == digest(Point(1, 2)) != digest(Point(1, 3))
    assert pickle.loads(pickle.dumps(Point(4))) == copy.deepcopy(Point(4)) == Point(4)
    match Named(1):
        case Named(x, y, name):
            assert (x, y, name) == (1, 2, "p")
