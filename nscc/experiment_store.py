"""Measurements in an SQLite file; each is written atomically, even if a process is killed."""

from __future__ import annotations

import fcntl
import json
import os
import sqlite3
from collections.abc import Callable
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from time import sleep, time
from types import TracebackType
from typing import Any, Self

from nscc.diagnostics.rejection import rejected

STORE = "store.sqlite"
"""The file name of the store in a folder of results."""
CLAIMS = ".claims"
"""Suffix of the file that contains the claims of processes."""
_BUSY_S = 60.0
"""Seconds for which a write waits for other processes."""
_POLL_S = 0.2
_IN_USE = 1 << 60
"""Byte of the claims file on which each process that uses the store holds a shared lock."""
_TABLE = """
CREATE TABLE IF NOT EXISTS measurement (
    experiment TEXT, name TEXT, value TEXT NOT NULL, label TEXT NOT NULL, seconds REAL NOT NULL,
    ended REAL NOT NULL, worker TEXT NOT NULL, PRIMARY KEY (experiment, name)
)
"""


@dataclass(frozen=True)
class Timing:
    """The duration of a measurement in seconds, its end (in seconds since the epoch), and its
    worker.

    `label` describes the measurement for people."""

    name: str
    label: str
    seconds: float
    ended: float
    worker: str


class ExperimentStore:
    """Measurements of experiments, as JSON values, by name.

    A measurement is on the disk when `keep` returns. Several processes may use a store: the process
    that has the claim of a name measures it, and the others wait for the result. A claim ends with
    its process. The first value that is written for a name is never replaced.

    Raises Rejected: NS0784 if the file cannot be written, NS0834 if it is not a store."""

    def __init__(self, path: Path) -> None:
        self._path = path
        try:
            claims = path.with_name(path.name + CLAIMS)
            self._claims = os.open(claims, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o666)
            fcntl.lockf(self._claims, fcntl.LOCK_SH, 1, _IN_USE)
            self._database = sqlite3.connect(path, timeout=_BUSY_S, isolation_level=None)
            self._database.execute("PRAGMA journal_mode = WAL")
            self._database.execute("PRAGMA synchronous = FULL")
            self._database.execute(_TABLE)
        except (OSError, sqlite3.OperationalError) as error:
            raise rejected(
                "NS0784",
                f"cannot write '{path}': {getattr(error, 'strerror', None) or error}",
                helps=("choose a folder that you may write to",),
            ) from error
        except sqlite3.DatabaseError as error:
            raise rejected(
                "NS0834",
                f"'{path}' is not an experiment store",
                notes=(f"SQLite says: {error}",),
                helps=(
                    "move the file away: nscc then creates a new store and repeats all "
                    "measurements",
                ),
            ) from error

    def values(self, experiment: str) -> dict[str, Any]:
        """Return all measurements of an experiment by name, in the order in which they ended."""
        rows = self._database.execute(
            "SELECT name, value FROM measurement WHERE experiment = ? ORDER BY rowid", (experiment,)
        )
        return {name: json.loads(value) for name, value in rows}

    def timings(self, experiment: str) -> list[Timing]:
        """Return the timings of an experiment, in the order in which its measurements ended."""
        rows = self._database.execute(
            "SELECT name, label, seconds, ended, worker FROM measurement WHERE experiment = ? "
            "ORDER BY rowid", (experiment,),
        )  # fmt: skip
        return [Timing(*row) for row in rows]

    def get(self, experiment: str, name: str) -> Any | None:
        """Return a measurement, or None if it is not stored."""
        row = self._database.execute(
            "SELECT value FROM measurement WHERE experiment = ? AND name = ?", (experiment, name)
        ).fetchone()
        return None if row is None else json.loads(row[0])

    def keep(
        self, experiment: str, name: str, value: Any, *, label: str = "", seconds: float = 0.0,
        worker: str = "",
    ) -> None:  # fmt: skip
        """Store a measurement; raise ValueError for None, NaN and infinity, which JSON cannot
        represent."""
        if value is None:
            raise ValueError(f"the measurement '{name}' has no value")
        self._database.execute(
            "INSERT OR IGNORE INTO measurement VALUES (?, ?, ?, ?, ?, ?, ?)",
            (experiment, name, json.dumps(value, allow_nan=False), label, seconds, time(), worker),
        )

    def forget(self, experiment: str, *names: str) -> None:
        """Delete measurements of an experiment."""
        self._database.executemany(
            "DELETE FROM measurement WHERE experiment = ? AND name = ?",
            [(experiment, name) for name in names],
        )

    def once(self, experiment: str, name: str, measure: Callable[[], Any]) -> Any:
        """Return a stored measurement, or call `measure` and store its result.

        If another process has the claim, wait for its result. Results pass through JSON, so tuples
        become lists."""
        while (value := self.get(experiment, name)) is None:
            if not self.claim(experiment, name):
                sleep(_POLL_S)
                continue
            try:
                if self.get(experiment, name) is None:
                    self.keep(experiment, name, measure())
            finally:
                self.release(experiment, name)
        return value

    def claim(self, experiment: str, name: str) -> bool:
        """Claim a measurement; return False if another process has the claim, else True."""
        try:
            fcntl.lockf(self._claims, fcntl.LOCK_EX | fcntl.LOCK_NB, 1, _place(experiment, name))
        except BlockingIOError:
            return False
        return True

    def release(self, experiment: str, name: str) -> None:
        """Release the claim of a measurement."""
        fcntl.lockf(self._claims, fcntl.LOCK_UN, 1, _place(experiment, name))

    def remove(self) -> None:
        """Close the store, and delete its files if no other process uses them."""
        try:
            fcntl.lockf(self._claims, fcntl.LOCK_EX | fcntl.LOCK_NB, 1, _IN_USE)
        except BlockingIOError:
            return self.close()
        self._database.close()
        for end in ("", "-wal", "-shm", CLAIMS):
            self._path.with_name(self._path.name + end).unlink(missing_ok=True)
        os.close(self._claims)

    def close(self) -> None:
        """Release all claims of this process and close the file."""
        self._database.close()
        os.close(self._claims)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, _type: type[BaseException] | None, _value: BaseException | None,
        _trace: TracebackType | None,
    ) -> None:  # fmt: skip
        self.close()


def _place(experiment: str, name: str) -> int:
    """Return the offset in the claims file of the byte whose lock is the claim of a measurement."""
    return int.from_bytes(sha256(f"{experiment}\0{name}".encode()).digest()[:7])


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
