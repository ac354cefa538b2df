"""Methods whose results an object keeps for as long as it lives, by their arguments."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from functools import wraps
from typing import Any, Concatenate, ParamSpec, TypeVar, cast

S = TypeVar("S")
P = ParamSpec("P")
R = TypeVar("R")


def remembered(method: Callable[Concatenate[S, P], R]) -> Callable[Concatenate[S, P], R]:
    """A method that is run once for all equal arguments, which are given by place and hashable.

    Results lie in the object's `__dict__`, as those of `functools.cached_property` do.
    """
    name = f"remembered {method.__name__}"

    @wraps(method)
    def call(self: S, /, *arguments: P.args, **named: P.kwargs) -> R:
        try:
            results: dict[Hashable, R] = self.__dict__[name]
            return results[arguments]
        except KeyError:
            pass
        result = method(self, *arguments, **named)
        self.__dict__.setdefault(name, {})[arguments] = result
        return result

    return call


class Recent:
    """The `most` results that were asked for last."""

    def __init__(self, most: int) -> None:
        self._most = most
        self._found: dict[Hashable, Any] = {}

    def of(self, key: Hashable, make: Callable[[], R]) -> R:
        """What `make` gives, or gave for this key. Threads may make it more than once."""
        result = self._found.pop(key, None)
        if result is None:
            result = make()
        self._found[key] = result
        for oldest in [*self._found][: -self._most]:
            self._found.pop(oldest, None)
        return cast(R, result)
