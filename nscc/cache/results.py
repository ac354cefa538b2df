"""Cached results of the search for gates.

The key covers the whole problem (demands, plan, times, target, level) and the compiler with its
added generators (`nscc.cache.digest.version_digest`). A change of any of them changes the key.

Frozen dataclasses are stored as JSON with strict types: a dataclass as the list of its field
values, a tuple as a list, a large integer as a hexadecimal string. Reading returns exactly the
annotated types or raises ValueError."""

from __future__ import annotations

from collections.abc import Iterable
from contextlib import suppress
from dataclasses import dataclass, field, fields, is_dataclass
from functools import cache
from types import NoneType, UnionType
from typing import Any, TypeVar, Union, get_args, get_origin, get_type_hints

from nscc.cache.digest import digest, version_digest
from nscc.cache.store import Store, cache_folder
from nscc.logic.problem import Machine, Problem, Solution
from nscc.logic.replay import fault
from nscc.record import Record

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
        if type(value) is int:
            return value
        if type(value) is str:
            return int(value, 16)
        raise ValueError(f"{value!r:.40} is not an integer")
    if kind in (str, bool, NoneType):
        if type(value) is kind:
            return value
        raise ValueError(f"{value!r:.40} is not a {kind.__name__}")
    origin = get_origin(kind)
    if origin in (UnionType, Union):
        for member in get_args(kind):
            with suppress(ValueError):
                return _typed(member, value)
        raise ValueError(f"{value!r:.40} is not one of {get_args(kind)}")
    if origin is not tuple and not is_dataclass(kind):
        raise TypeError(f"{kind} cannot be read back from JSON")
    if not isinstance(value, list):
        raise ValueError(f"{value!r:.40} is not a list")
    kinds = get_args(kind) if origin is tuple else _annotations(kind)
    if origin is tuple and len(kinds) == 2 and kinds[1] is Ellipsis:
        return tuple([_typed(kinds[0], member) for member in value])
    # zip raises ValueError for another number of values.
    members = [_typed(*pair) for pair in zip(kinds, value, strict=True)]
    return tuple(members) if origin is tuple else kind(*members)


@cache
def _annotations(kind: Any) -> tuple[Any, ...]:
    hints = get_type_hints(kind)
    return tuple(hints[field.name] for field in fields(kind))


LEAST_LEVEL = 2
"""Lowest level whose results are cached; below it, a search is faster than reading its result."""


@dataclass
class Results:
    """The search results of one compilation, in a store.

    Results are read from the store only while `trusted` is true, but always written to it. `read`
    counts the results that came from the store."""

    store: Store
    trusted: bool = field(default=True, init=False)
    read: int = field(default=0, init=False)

    def distrust(self) -> None:
        """Stop reading from the store; every search runs, and its result replaces the
        stored one."""
        self.trusted, self.read = False, 0

    def find(self, problem: Problem, machine: Machine, level: int, *context: Any) -> Result:
        """Look up the solution of a problem; `context` contains everything else that affects the
        best solution."""
        version = version_digest() if level >= LEAST_LEVEL else None
        if version is None:
            return Result()
        key = digest((version, problem, machine, level, context))
        known = _solution(self.store.read(key), problem, machine) if self.trusted else None
        self.read += known is not None
        return Result(known, self.store, key)


class Result(Record):
    """The result of a search: the best solution if it is stored, otherwise the key for
    storing it."""

    known: Solution | None = None
    store: Store | None = None
    key: str = ""

    def or_else(self, solutions: Iterable[Solution]) -> Iterable[Solution]:
        """Return only the known solution; without one, return `solutions`, which are generated
        lazily."""
        return solutions if self.known is None else (self.known,)

    def keep(self, best: Solution) -> None:
        """Store the best solution of a search, unless it came from the store."""
        if self.store is not None and self.known is None:
            self.store.write(self.key, to_json(best))


def results_of_user() -> Results | None:
    """Return the results in the user's cache folder; None if the cache is off."""
    folder = cache_folder()
    return None if folder is None else Results(Store(folder))


def _solution(data: bytes | None, problem: Problem, machine: Machine) -> Solution | None:
    """Return the solution in a stored entry; None if the entry is invalid or does not solve the
    problem."""
    if data is None:
        return None
    try:
        solution = from_json(Solution, data)
    except ValueError:
        return None
    return solution if fault(problem, machine, solution) is None else None
