"""Measurements of one tradeoff, stored while it runs, so that it can be interrupted and resumed."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from nscc.experiment_store import ExperimentStore


class Rows:
    """Measurements by name, in an experiment store in `file`; not stored without a file.

    `of` is the digest of everything that affects the measurements; others are ignored. Several
    processes can share a file and its work. After an interrupt, the user is told where the
    measurements are. Raises Rejected as `ExperimentStore`.
    """

    def __init__(self, file: Path | None = None, of: str = "") -> None:
        self._path, self._of = file, of
        self._store = None if file is None else ExperimentStore(file)

    def once(self, name: str, measure: Callable[[], Any]) -> Any:
        """Return a stored result, or call `measure`; results pass through JSON."""
        return measure() if self._store is None else self._store.once(self._of, name, measure)

    def remove(self) -> None:
        """Delete the file once the products have its values; the next run measures again."""
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
