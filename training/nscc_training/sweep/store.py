"""Where results are kept: a line for each, whole or not there, whatever kills the process.

`rows.jsonl` holds what was found: the same lines wherever points are computed, in whatever order.
`times.csv` holds how long that took whom, and when it ended, in seconds since the sweep began.
"""

from __future__ import annotations

import json
from pathlib import Path
from time import monotonic
from types import TracebackType
from typing import Any, Self

from nscc.diagnostics.rejection import rejected
from nscc.lines import Lines
from nscc_training.sweep.point import Row

ROWS, TIMES = "rows.jsonl", "times.csv"
_TIMES_HEAD = "key,name,seconds,ended_s,worker\n"


class Store:
    """The results in a folder, which is made. One process at a time has it open, to the end of a
    `with`.

    `rows` are those that can be read, by key. Raises Rejected: NS0834 where another process has
    the folder, NS0784 where it cannot be written.
    """

    def __init__(self, folder: Path) -> None:
        try:
            folder.mkdir(parents=True, exist_ok=True)
            self._rows = Lines(folder / ROWS)
            self._times = Lines(folder / TIMES)
        except BlockingIOError:
            raise rejected(
                "NS0834",
                f"another sweep is at work in '{folder}'",
                helps=("wait for it, end it, or give --out another folder",),
            ) from None
        except OSError as error:
            raise rejected(
                "NS0784",
                f"cannot write into '{folder}': {error.strerror or error}",
                helps=("give --out a folder that you may write",),
            ) from error
        if not self._times.lines:
            self._times.add(_TIMES_HEAD)
        self._begin = monotonic()
        self.rows: dict[str, Row] = {}
        for line in self._rows.lines:
            row = _row(line)
            if row is not None:
                self.rows[row.key] = row

    def add(self, row: Row, name: str, seconds: float, worker: str) -> None:
        """Keeps a row, which took a worker so many seconds; it is on the disk when this returns."""
        values = {"key": row.key, "figures": row.figures, "code": row.code, "error": row.error}
        ended_s = monotonic() - self._begin
        self._times.add(f"{row.key[:12]},{name},{seconds:.3f},{ended_s:.3f},{worker}\n")
        self._rows.add(json.dumps(values, allow_nan=False) + "\n", sync=True)
        self.rows[row.key] = row

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, _type: type[BaseException] | None, _value: BaseException | None,
        _trace: TracebackType | None,
    ) -> None:  # fmt: skip
        self._rows.close()
        self._times.close()


def _row(line: str) -> Row | None:
    """The row of a line; None for one that is none: its point is computed again."""
    try:
        held: dict[str, Any] = json.loads(line)
        row = Row(held["key"], held["figures"], held["code"], held["error"])
    except (ValueError, KeyError, TypeError, RecursionError):
        return None
    kinds = (row.key, str), (row.figures, dict), (row.code, str), (row.error, str)
    return row if all(isinstance(value, kind) for value, kind in kinds) else None
