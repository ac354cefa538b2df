"""The rows of a sweep in its experiment store, and how long each took."""

from __future__ import annotations

import csv
import io
from pathlib import Path
from types import TracebackType
from typing import Self

from nscc.diagnostics.rejection import rejected
from nscc.experiment_store import STORE, ExperimentStore
from nscc_training.sweep.point import Row

TIMES = "times.csv"
_POINTS = "points"
"""The experiment that a point's row belongs to: its key says everything else."""


class RowStore:
    """The rows of points by key, in the store of a folder, which is made.

    Rejected (NS0784) if the folder cannot be written, and as `ExperimentStore`.
    """

    def __init__(self, folder: Path) -> None:
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise rejected(
                "NS0784",
                f"cannot write into '{folder}': {error.strerror or error}",
                helps=("give --out a folder that you may write",),
            ) from error
        self._store = ExperimentStore(folder / STORE)

    def rows(self) -> dict[str, Row]:
        """Return all rows by key."""
        return {key: Row(key, **value) for key, value in self._store.values(_POINTS).items()}

    def get(self, key: str) -> Row | None:
        """Return the row of a key; None if there is none."""
        value = self._store.get(_POINTS, key)
        return None if value is None else Row(key, **value)

    def add(self, row: Row, name: str, seconds: float, worker: str) -> None:
        """Keep a row, which took a worker so many seconds; it is on the disk when this returns."""
        value = {"figures": row.figures, "code": row.code, "error": row.error}
        self._store.put(_POINTS, row.key, value, label=name, seconds=seconds, worker=worker)

    def forget(self, key: str) -> None:
        """Drop a row: its point is computed again."""
        self._store.forget(_POINTS, key)

    def claim(self, key: str) -> bool:
        """Take a point for this process; False if another process computes it."""
        return self._store.claim(_POINTS, key)

    def release(self, key: str) -> None:
        """Let other processes have a point."""
        self._store.release(_POINTS, key)

    def times_csv(self) -> str:
        """Return how long each point took, and where; the first one began at 0 s."""
        timings = self._store.timings(_POINTS)
        begin = min((each.ended - each.seconds for each in timings), default=0.0)
        text = io.StringIO()
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(("key", "name", "seconds", "ended_s", "worker"))
        writer.writerows(
            (each.name[:12], each.label, f"{each.seconds:.3f}", f"{each.ended - begin:.3f}",
             each.worker)
            for each in timings
        )  # fmt: skip
        return text.getvalue()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, _type: type[BaseException] | None, _value: BaseException | None,
        _trace: TracebackType | None,
    ) -> None:  # fmt: skip
        self._store.close()
