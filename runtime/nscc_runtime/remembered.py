"""Methods whose results an object keeps for as long as it lives, by their arguments."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Concatenate, ParamSpec, TypeVar, cast

S = TypeVar("S")
P = ParamSpec("P")
R = TypeVar("R")


def remembered(method: Callable[Concatenate[S, P], R]) -> Callable[Concatenate[S, P], R]:
    """A method that is run once for all equal arguments, which are given by place and hashable.

    Results lie in the object's `__dict__`, as those of `functools.cached_property` do.
    """
    name = f"remembered {method.__name__}"

    @wraps(method)
    def found(self: S, /, *given: P.args, **named: P.kwargs) -> R:
        kept = vars(self)
        try:
            return cast(R, kept[name][given])
        except KeyError:
            pass
        result = method(self, *given, **named)
        kept.setdefault(name, {})[given] = result
        return result

    return found
