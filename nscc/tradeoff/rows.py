"""Measurements of one tradeoff, kept while it runs: killed and started again, it goes on."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from nscc.experiment_store import ExperimentStore


class Rows:
    """Measurements by name, in an experiment store in `file`; without a file nothing is kept.

    `of` is the digest of everything that decides the measurements: those of another digest are
    ignored. Two processes with one file share the work. A user who interrupts one is told where
    its measurements are. Raises Rejected as `ExperimentStore`.
    """

    def __init__(self, file: Path | None = None, of: str = "") -> None:
        self._path, self._of = file, of
        self._store = None if file is None else ExperimentStore(file)

    def once(self, name: str, measure: Callable[[], Any]) -> Any:
        """Return what `measure` gives, as JSON has it; it is called if the name is not known."""
        return measure() if self._store is None else self._store.once(self._of, name, measure)

    def remove(self) -> None:
        """Remove the file: the products hold its values, and a new measurement takes new times."""
        if self._store is not None:
            self._store.remove()
            self._store = None

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, _type: type[BaseException] | None, value: BaseException | None,
        _trace: TracebackType | None,
    ) -> None:  # fmt: skip
        if self._store is None:
            return
        known = bool(self._store.values(self._of))
        self._store.close()
        if isinstance(value, KeyboardInterrupt) and known:
            raise KeyboardInterrupt(
                f"what was measured is kept in '{self._path}', and the same command goes on"
            ) from value
