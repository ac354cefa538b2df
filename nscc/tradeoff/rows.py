"""Stored measurements of a tradeoff, so that an interrupted measurement can be resumed."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from nscc.experiment_store import ExperimentStore


class Rows:
    """Measurements by name, in an experiment store in `file`; without a file nothing is stored.

    `of` is the digest of everything that affects the measurements; measurements with another digest
    are ignored. Several processes can share a file and its work. After an interrupt, the user is
    told where the measurements are. Raises Rejected as `ExperimentStore` does."""

    def __init__(self, file: Path | None = None, of: str = "") -> None:
        self._path, self._of = file, of
        self._store = None if file is None else ExperimentStore(file)

    def once(self, name: str, measure: Callable[[], Any]) -> Any:
        """Return the stored result, or call `measure` and store its result as JSON."""
        return measure() if self._store is None else self._store.once(self._of, name, measure)

    def remove(self) -> None:
        """Delete the file, after its values were written to the products."""
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
                f"completed measurements are stored in '{self._path}'; the same command continues"
            ) from value
