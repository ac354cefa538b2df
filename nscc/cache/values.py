"""Frozen dataclasses as JSON and back, with strict types.

A dataclass becomes the list of its field values, a tuple a list, a large integer a hexadecimal
string. Reading returns exactly the annotated types or raises ValueError."""

from __future__ import annotations

from dataclasses import fields, is_dataclass
from functools import cache
from types import NoneType, UnionType
from typing import Any, TypeVar, Union, get_args, get_origin, get_type_hints

T = TypeVar("T")

_LARGE = 1 << 53
"""Integers above this are written as text, because not every JSON reader keeps them exact."""


def to_json(value: Any) -> bytes:
    """Return a dataclass as one line of JSON; the same value gives the same bytes."""
    import json

    return json.dumps(_plain(value), separators=(",", ":")).encode()


def from_json(kind: type[T], data: bytes) -> T:
    """Return the inverse of `to_json`; raise ValueError for data that `to_json` cannot have
    written."""
    import json

    try:
        value: T = _typed(kind, json.loads(data))
    except RecursionError as error:
        raise ValueError("nested too deeply") from error
    return value


def _plain(value: Any) -> Any:
    if value is None or isinstance(value, str | bool):
        return value
    if isinstance(value, int):
        return value if abs(value) < _LARGE else f"{value:x}"
    if isinstance(value, tuple):
        return [_plain(member) for member in value]
    if is_dataclass(value) and not isinstance(value, type):
        return [_plain(getattr(value, field.name)) for field in fields(value)]
    raise TypeError(f"{type(value).__name__} has no place in JSON")


def _typed(kind: Any, value: Any) -> Any:
    if kind is int:
        return _integer(value)
    if kind in (str, bool, NoneType):
        if type(value) is kind:
            return value
        raise ValueError(f"{value!r:.40} is not a {kind.__name__}")
    origin = get_origin(kind)
    if origin in (UnionType, Union):
        return _any_of(get_args(kind), value)
    if origin is not tuple and not is_dataclass(kind):
        raise TypeError(f"{kind} cannot be read back from JSON")
    if not isinstance(value, list):
        raise ValueError(f"{value!r:.40} is not a list")
    if origin is tuple:
        kinds = get_args(kind)
        if len(kinds) == 2 and kinds[1] is Ellipsis:
            return tuple([_typed(kinds[0], member) for member in value])
        return tuple([_typed(*pair) for pair in _paired(kinds, value)])
    return kind(*[_typed(*pair) for pair in _paired(_annotations(kind), value)])


def _paired(kinds: tuple[Any, ...], values: list[Any]) -> list[tuple[Any, Any]]:
    if len(kinds) != len(values):
        raise ValueError(f"{len(values)} values instead of {len(kinds)}")
    return list(zip(kinds, values, strict=True))


def _any_of(kinds: tuple[Any, ...], value: Any) -> Any:
    for kind in kinds:
        try:
            return _typed(kind, value)
        except ValueError:
            continue
    raise ValueError(f"{value!r:.40} is not one of {kinds}")


def _integer(value: Any) -> int:
    if type(value) is int:
        return value
    if type(value) is str:
        return int(value, 16)
    raise ValueError(f"{value!r:.40} is not an integer")


@cache
def _annotations(kind: Any) -> tuple[Any, ...]:
    hints = get_type_hints(kind)
    return tuple(hints[field.name] for field in fields(kind))
