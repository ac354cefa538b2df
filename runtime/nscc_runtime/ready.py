"""What is analysed of a program once, and kept as long as the program is."""

from __future__ import annotations

from collections.abc import Callable
from threading import Lock
from typing import Generic, TypeVar
from weakref import WeakKeyDictionary

from nscc.words.container import Container
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.pool import after_fork

T = TypeVar("T")


class OfContainer(Generic[T]):
    """`make(container)`, once for each."""

    def __init__(self, make: Callable[[Container], T]) -> None:
        self._make = make
        self._found: WeakKeyDictionary[Container, T] = WeakKeyDictionary()
        self._renew()
        after_fork(self._renew)  # a thread of the parent process may hold the lock

    def _renew(self) -> None:
        self._making = Lock()

    def __call__(self, container: Container) -> T:
        with self._making:  # threads that share a program wait for one analysis of it
            if container not in self._found:
                self._found[container] = self._make(container)
            return self._found[container]


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
