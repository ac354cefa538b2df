"""Cache the analyses of a program for as long as the program exists."""

from __future__ import annotations

from collections.abc import Callable
from threading import Lock
from typing import Any, Concatenate, Generic, ParamSpec, TypeVar

from nscc.words.container import Container
from nscc_runtime.pool import after_fork

P = ParamSpec("P")
T = TypeVar("T")

_ANALYSES = "_analyses"
"""The attribute of a container that stores its analyses. Analyses refer to the container, so
storing them anywhere else would keep the container alive."""


class OfContainer(Generic[P, T]):
    """A function `make(container, ..)` whose results are cached for each container and equal
    arguments. The arguments must be positional and hashable."""

    def __init__(self, make: Callable[Concatenate[Container, P], T]) -> None:
        self._make = make
        self._renew()
        after_fork(self._renew)  # a thread of the parent process may have held the lock

    def _renew(self) -> None:
        self._making = Lock()

    def __call__(self, container: Container, *key: P.args, **named: P.kwargs) -> T:
        with self._making:  # threads that share a program wait for a single analysis
            analyses: dict[Any, Any] = vars(container).setdefault(_ANALYSES, {})
            if (self, key) not in analyses:
                analyses[self, key] = self._make(container, *key, **named)
            analysis: T = analyses[self, key]
            return analysis
