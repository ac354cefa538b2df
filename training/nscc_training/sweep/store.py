"""Result rows of a sweep in its experiment store, with their computing times."""

from __future__ import annotations

import csv
import io
from pathlib import Path

from nscc.diagnostics.rejection import rejected
from nscc.experiment_store import STORE, ExperimentStore
from nscc_training.sweep.point import PointRow

TIMES = "times.csv"
POINTS = "points"
"""The name of the store's experiment that contains all rows."""


def store_in(folder: Path) -> ExperimentStore:
    """Create `folder` and return the experiment store in it; raise Rejected (NS0784) if
    that fails."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        message = f"cannot write into '{folder}': {error.strerror or error}"
        help_text = "give --out a folder that you may write"
        raise rejected("NS0784", message, helps=(help_text,)) from error
    return ExperimentStore(folder / STORE)


def rows_in(store: ExperimentStore) -> dict[str, PointRow]:
    """Return all rows by key."""
    return {key: PointRow(key, **value) for key, value in store.values(POINTS).items()}


def put_row(store: ExperimentStore, row: PointRow, name: str, seconds: float, worker: str) -> None:
    """Store a row with its computing time and worker; on return it is on the disk."""
    value = {"figures": row.figures, "code": row.code, "error": row.error}
    store.keep(POINTS, row.key, value, label=name, seconds=seconds, worker=worker)


def times_csv(store: ExperimentStore) -> str:
    """Return the time and worker of each point as CSV; times start with the first point."""
    timings = store.timings(POINTS)
    begin = min((timing.ended - timing.seconds for timing in timings), default=0.0)
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(("key", "name", "seconds", "ended_s", "worker"))
    writer.writerows(
        (timing.name[:12], timing.label, f"{timing.seconds:.3f}", f"{timing.ended - begin:.3f}",
         timing.worker)
        for timing in timings
    )  # fmt: skip
    return text.getvalue()
