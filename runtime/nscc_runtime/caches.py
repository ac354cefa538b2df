"""Cache the results of methods in their object, and the analyses of a program for as long as the
program exists."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from functools import wraps
from threading import Lock
from typing import Any, Concatenate, Generic, ParamSpec, TypeVar, cast

from nscc.words.container import Container
from nscc_runtime.pool import after_fork

S = TypeVar("S")
P = ParamSpec("P")
R = TypeVar("R")
T = TypeVar("T")


class _Cache(dict[Any, Any]):
    """Cached results. Copies and pickled objects have an empty cache: results may contain functions
    and locks, and can be computed again."""

    def __reduce__(self) -> tuple[type[_Cache], tuple[()]]:
        """Return how a copy in another process is made: an empty cache."""
        return _Cache, ()


def remembered(method: Callable[Concatenate[S, P], R]) -> Callable[Concatenate[S, P], R]:
    """Cache a method's results for equal arguments, which must be positional and hashable. Results
    are stored in the object's `__dict__`, like those of `functools.cached_property`."""
    name = f"remembered {method.__name__}"

    @wraps(method)
    def call(self: S, /, *arguments: P.args, **named: P.kwargs) -> R:
        """Return the cached result for these positional arguments, or compute and cache it.

        Keyword arguments are passed on but do not distinguish results."""
        try:
            results: dict[Hashable, R] = self.__dict__[name]
            return results[arguments]
        except KeyError:
            pass
        result = method(self, *arguments, **named)
        self.__dict__.setdefault(name, _Cache())[arguments] = result
        return result

    return call


class Recent:
    """A cache of the `most` results that were requested last, by key. Threads may share it: then a
    result may be computed twice."""

    def __init__(self, most: int) -> None:
        """Begin empty; at most `most` (1 or more) results are kept."""
        self._most = most
        self._found: dict[Hashable, Any] = {}

    def of(self, key: Hashable, make: Callable[[], R]) -> R:
        """Return the result cached for `key`, or else `make()`, which several threads may call. A
        result of None is not cached; the result that was used longest ago is dropped first."""
        result = self._found.pop(key, None)
        if result is None:
            result = make()
        self._found[key] = result
        for oldest in [*self._found][: -self._most] if len(self._found) > self._most else ():
            self._found.pop(oldest, None)
        return cast(R, result)


_ANALYSES = "_analyses"
"""The attribute of a container that stores its analyses. Analyses refer to the container, so
storing them anywhere else would keep the container alive."""


class OfContainer(Generic[P, T]):
    """A function `make(container, ..)` whose results are cached for each container (a compiled
    program) and equal arguments. The arguments must be positional and hashable."""

    def __init__(self, make: Callable[Concatenate[Container, P], T]) -> None:
        """Store the results of `make` with the containers themselves. A container is a compiled
        program."""
        self._make = make
        self._renew()
        after_fork(self._renew)  # a thread of the parent process may have held the lock

    def _renew(self) -> None:
        """Begin with an open lock."""
        self._making = Lock()

    def __call__(self, container: Container, *key: P.args, **named: P.kwargs) -> T:
        """Return the cached analysis of a container (a compiled program) for this `key`, or compute
        and cache it.

        Keyword arguments are passed on but do not distinguish analyses. Threads wait for each
        other."""
        analyses: dict[Any, Any] = vars(container).setdefault(_ANALYSES, _Cache())
        entry = self, key
        try:
            known: T = analyses[entry]
            return known
        except KeyError:
            pass
        with self._making:  # threads that share a program wait for a single analysis
            if entry not in analyses:
                analyses[entry] = self._make(container, *key, **named)
            analysis: T = analyses[entry]
            return analysis
