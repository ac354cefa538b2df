"""What is analysed of a program once, and kept as long as the program is."""

from __future__ import annotations

from collections.abc import Callable
from threading import Lock
from typing import Any, Concatenate, Generic, ParamSpec, TypeVar

from nscc.words.container import Container
from nscc_runtime.pool import after_fork

P = ParamSpec("P")
T = TypeVar("T")

_ANALYSES = "_analyses"
"""The attribute of a container that holds its analyses. They refer to the container: kept anywhere
else they would keep it alive."""


class OfContainer(Generic[P, T]):
    """`make(container, ..)`, once for each container and all equal arguments, which are given by
    place and hashable: of a sensor, say, or of effects."""

    def __init__(self, make: Callable[Concatenate[Container, P], T]) -> None:
        self._make = make
        self._renew()
        after_fork(self._renew)  # a thread of the parent process may hold the lock

    def _renew(self) -> None:
        self._making = Lock()

    def __call__(self, container: Container, *key: P.args, **named: P.kwargs) -> T:
        with self._making:  # threads that share a program wait for one analysis of it
            analyses: dict[Any, Any] = vars(container).setdefault(_ANALYSES, {})
            if (self, key) not in analyses:
                analyses[self, key] = self._make(container, *key, **named)
            analysis: T = analyses[self, key]
            return analysis
