"""Measurements in an SQLite file; each is written atomically, even if a process is killed."""

from __future__ import annotations

import errno
import fcntl
import json
import os
import sqlite3
from collections.abc import Callable
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from shutil import disk_usage
from time import monotonic, time
from types import TracebackType
from typing import Any, Self

from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.mappings import JsonObject

STORE = "store.sqlite"
"""The file name of the store in a folder of results."""
CLAIMS = ".claims"
"""Suffix of the file that contains the claims of processes."""
_BUSY_S, _PATIENCE_S = 60.0, 2.0
"""Seconds for which a statement waits for other processes in all, and until the user is told."""
_LEAST_BYTES = 1 << 16
"""A disk with less free space than this is full: SQLite writes whole pages."""
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
    """When and how long a measurement took: `seconds`, and `ended` in seconds since 1970.

    `label` describes the measurement for people, and `worker` names the process that made it."""

    name: str
    label: str
    seconds: float
    ended: float
    worker: str


class ExperimentStore:
    """The measurements of one experiment, as JSON values, by name.

    Other experiments in the file are ignored; `experiment` is the digest of everything that affects
    its measurements.

    A measurement is on the disk when `keep` returns. Several processes may use a store: the process
    that has the claim of a name measures it, and the others wait for the result. A claim ends with
    its process. The first value that is written for a name is never replaced.

    Without `path` the measurements are kept in memory. `report` receives a text if another process
    holds the file locked. After an interrupt, the user is told where the measurements are.

    Raises Rejected: NS0784 if the file cannot be written, or if it stays locked for a minute,
    NS0834 if it is not a store."""

    def __init__(
        self,
        path: Path | None = None,
        experiment: str = "",
        report: Callable[[str], object] = lambda _text: None,
    ) -> None:
        """Open the database at `path`, or one in memory if it is None, and create its table.

        See the class for the arguments. A lock on a file beside the database tells other processes
        that it is in use. Raises Rejected if the file cannot be opened."""
        self._path, self._of, self._report = path, experiment, report
        self._claims: int | None = None
        self._known = False
        try:
            if path is not None:
                path.parent.mkdir(parents=True, exist_ok=True)
                claims = path.with_name(path.name + CLAIMS)
                self._claims = os.open(claims, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o666)
                # A shared lock on one byte, at the place that means "in use".
                fcntl.lockf(self._claims, fcntl.LOCK_SH, 1, _IN_USE)
            self._database = sqlite3.connect(
                path or ":memory:", timeout=_PATIENCE_S, isolation_level=None
            )
        except (OSError, sqlite3.OperationalError) as error:
            raise self._rejected(error) from error
        try:
            for statement in ("PRAGMA journal_mode = WAL", "PRAGMA synchronous = FULL", _TABLE):
                self._execute(statement)
        except Rejected:
            self.close()
            raise

    def _execute(self, statement: str, *values: object) -> list[Any]:
        """Return the rows of an SQL statement with `values` for its question marks.

        Wait while another process holds the file locked, at most `_BUSY_S` seconds. Raises Rejected
        (NS0784, NS0834)."""
        begin = monotonic()
        reported = False
        while True:
            try:
                return self._database.execute(statement, values).fetchall()
            except sqlite3.DatabaseError as error:
                # A fault of nscc, not of the file.
                if isinstance(error, sqlite3.ProgrammingError):
                    raise
                if not _is_locked(error) or monotonic() - begin > _BUSY_S:
                    raise self._rejected(error) from error
            if not reported:
                self._report(f"waiting for another process, which holds '{self._path}' locked")
            reported = True

    def _rejected(self, error: Exception) -> Rejected:
        """Return the exception for a file that is not a store (NS0834) or cannot be used (NS0784),
        with what to do. `error` is what SQLite or the system raised."""
        # The lowest byte of SQLite's code is the primary error; the others add details.
        primary = getattr(error, "sqlite_errorcode", sqlite3.SQLITE_OK) & 0xFF
        if primary in (sqlite3.SQLITE_NOTADB, sqlite3.SQLITE_CORRUPT, sqlite3.SQLITE_ERROR):
            return rejected(
                "NS0834",
                f"'{self._path}' is not an experiment store",
                notes=(f"SQLite says: {error}",),
                helps=(
                    "move the file away: nscc then creates a new store and repeats all "
                    "measurements",
                ),
            )
        reason = getattr(error, "strerror", None) or str(error)
        help_text = "choose a folder that you may write to"
        if _is_locked(error):
            reason = f"another process has held it locked for {_BUSY_S:.0f} seconds ({reason})"
            help_text = "end the other process, or wait for it; then the same command continues"
        elif self._is_full(error):
            help_text = "free some space on this disk; then the same command continues"
        return rejected("NS0784", f"cannot write '{self._path}': {reason}", helps=(help_text,))

    def _is_full(self, error: Exception) -> bool:
        """Return whether an error means that the disk is full; SQLite reports some of these as I/O
        errors."""
        if getattr(error, "errno", 0) in (errno.ENOSPC, errno.EDQUOT):
            return True
        primary = getattr(error, "sqlite_errorcode", 0) & 0xFF
        if primary != sqlite3.SQLITE_IOERR or self._path is None:
            return bool(primary == sqlite3.SQLITE_FULL)
        return disk_usage(self._path.parent).free < _LEAST_BYTES

    def values(self) -> JsonObject:
        """Return all measurements as JSON values by name, in the order in which they were
        stored."""
        rows = self._execute(
            "SELECT name, value FROM measurement WHERE experiment = ? ORDER BY rowid", self._of
        )
        self._known |= bool(rows)
        return {name: json.loads(value) for name, value in rows}

    def timings(self) -> list[Timing]:
        """Return when and how long all measurements took, in the order in which they were
        stored."""
        rows = self._execute(
            "SELECT name, label, seconds, ended, worker FROM measurement WHERE experiment = ? "
            "ORDER BY rowid",
            self._of,
        )
        return [Timing(*row) for row in rows]

    def get(self, name: str) -> Any | None:
        """Return the measurement `name` as a JSON value, or None if it is not stored."""
        rows = self._execute(
            "SELECT value FROM measurement WHERE experiment = ? AND name = ?", self._of, name
        )
        self._known |= bool(rows)
        return json.loads(rows[0][0]) if rows else None

    def keep(
        self,
        name: str,
        value: Any,
        *,
        label: str = "",
        seconds: float = 0.0,
        worker: str = "",
    ) -> None:
        """Store a measurement, which is on the disk when this returns; one that is stored already
        stays as it is.

        `value` is a JSON value. `label` describes it for people, `seconds` is how long it took, and
        `worker` names the process. Raises ValueError for None, NaN and infinity, which JSON cannot
        represent or `get` not distinguish."""
        if value is None:
            raise ValueError(f"the measurement '{name}' has no value")
        self._execute(
            "INSERT OR IGNORE INTO measurement VALUES (?, ?, ?, ?, ?, ?, ?)",
            self._of,
            name,
            json.dumps(value, allow_nan=False),
            label,
            seconds,
            time(),
            worker,
        )
        self._known = True

    def forget(self, *names: str) -> None:
        """Delete the measurements with these names; missing ones are ignored."""
        for name in names:
            where = "experiment = ? AND name = ?"
            self._execute(f"DELETE FROM measurement WHERE {where}", self._of, name)

    def claim(self, name: str) -> bool:
        """Claim the measurement `name` for this process; return False if another process has
        claimed it, else True.

        A process that has the claim already gets True again. Claims are locks on bytes of a file,
        so a process that dies releases them. Without a file, every claim succeeds."""
        if self._claims is not None:
            place = _place(self._of, name)
            try:
                fcntl.lockf(self._claims, fcntl.LOCK_EX | fcntl.LOCK_NB, 1, place)
            except BlockingIOError:
                return False
        return True

    def release(self, name: str) -> None:
        """Release this process's claim of the measurement `name`, so that others may measure it;
        without a claim, do nothing."""
        if self._claims is not None:
            fcntl.lockf(self._claims, fcntl.LOCK_UN, 1, _place(self._of, name))

    def remove(self) -> None:
        """Close the store, and delete its files unless another process uses them; that process then
        keeps them."""
        self._database.close()
        if self._path is None or self._claims is None:
            return
        try:
            # Fails if another process holds its shared lock on this byte.
            fcntl.lockf(self._claims, fcntl.LOCK_EX | fcntl.LOCK_NB, 1, _IN_USE)
            for end in ("", "-wal", "-shm", CLAIMS):
                self._path.with_name(self._path.name + end).unlink(missing_ok=True)
        except BlockingIOError:
            pass  # the last process that uses the files deletes them
        self.close()

    def close(self) -> None:
        """Release all claims of this process and close the file."""
        self._database.close()
        if self._claims is not None:
            os.close(self._claims)
        self._claims = None

    def __enter__(self) -> Self:
        """Return the store, which is closed at the end of the `with` block."""
        return self

    def __exit__(
        self,
        _type: type[BaseException] | None,
        value: BaseException | None,
        _trace: TracebackType | None,
    ) -> None:
        """Close the store. After Ctrl-C, raise KeyboardInterrupt with the path of the stored
        measurements, if there are any in a file."""
        self.close()
        if isinstance(value, KeyboardInterrupt) and self._known and self._path is not None:
            raise KeyboardInterrupt(
                f"completed measurements are stored in '{self._path}'; the same command continues"
            ) from value


def _is_locked(error: Exception) -> bool:
    """Return whether SQLite failed because another process has locked the file."""
    primary = getattr(error, "sqlite_errorcode", 0) & 0xFF  # the lowest byte
    return primary in (sqlite3.SQLITE_BUSY, sqlite3.SQLITE_LOCKED)


def _place(experiment: str, name: str) -> int:
    """Return the offset, below 2^56, in the claims file of the byte that stands for a measurement
    of an experiment."""
    # 7 bytes keep the offset below `_IN_USE`, and make equal places of two names unlikely.
    return int.from_bytes(sha256(f"{experiment}\0{name}".encode()).digest()[:7])
