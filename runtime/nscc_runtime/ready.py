"""What is analysed of a program once, and kept as long as the program is."""

from __future__ import annotations

from collections.abc import Callable
from threading import Lock
from typing import Any, Generic, TypeVar

from nscc.words.container import Container
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.pool import after_fork

T = TypeVar("T")

_ANALYSES = "_analyses"
"""The attribute of a container that holds its analyses. They refer to the container: kept anywhere
else they would keep it alive."""


class OfContainer(Generic[T]):
    """`make(container)`, once for each."""

    def __init__(self, make: Callable[[Container], T]) -> None:
        self._make = make
        self._renew()
        after_fork(self._renew)  # a thread of the parent process may hold the lock

    def _renew(self) -> None:
        self._making = Lock()

    def __call__(self, container: Container) -> T:
        with self._making:  # threads that share a program wait for one analysis of it
            analyses: dict[OfContainer[Any], Any] = vars(container).setdefault(_ANALYSES, {})
            if self not in analyses:
                analyses[self] = self._make(container)
            made: T = analyses[self]
            return made


class MadeReady(Generic[T]):
    """`make(container, sensor)`, once for each."""

    def __init__(self, make: Callable[[Container, Sensor], T]) -> None:
        self._make = make
        self._of: OfContainer[dict[Sensor, T]] = OfContainer(lambda _container: {})
        self._renew()
        after_fork(self._renew)

    def _renew(self) -> None:
        self._making = Lock()

    def __call__(self, container: Container, sensor: Sensor) -> T:
        with self._making:
            found = self._of(container)
            if sensor not in found:
                found[sensor] = self._make(container, sensor)
            return found[sensor]
