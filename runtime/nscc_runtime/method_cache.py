"""Cache the results of methods in their object, by their arguments."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from functools import wraps
from typing import Any, Concatenate, ParamSpec, TypeVar, cast

S = TypeVar("S")
P = ParamSpec("P")
R = TypeVar("R")


def remembered(method: Callable[Concatenate[S, P], R]) -> Callable[Concatenate[S, P], R]:
    """Cache a method's results for equal arguments, which must be positional and hashable. Results
    are stored in the object's `__dict__`, like those of `functools.cached_property`."""
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
    """A cache of the `most` results that were requested last."""

    def __init__(self, most: int) -> None:
        self._most = most
        self._found: dict[Hashable, Any] = {}

    def of(self, key: Hashable, make: Callable[[], R]) -> R:
        """Return the result cached for `key`, or else `make()`, which several threads may call."""
        result = self._found.pop(key, None)
        if result is None:
            result = make()
        self._found[key] = result
        for oldest in [*self._found][: -self._most]:
            self._found.pop(oldest, None)
        return cast(R, result)
