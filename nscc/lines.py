"""Text files that only grow, line by line, and survive whatever kills the process that writes."""

from __future__ import annotations

import fcntl
import os
from pathlib import Path


class Lines:
    """A text file that only grows. `lines` are those that were there, all whole: a last one that
    was cut short is cut off. One process at a time has it: BlockingIOError where another one does;
    OSError where it cannot be written."""

    def __init__(self, path: Path) -> None:
        self._file = os.open(path, os.O_RDWR | os.O_CREAT | os.O_APPEND | os.O_CLOEXEC, 0o666)
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            with open(self._file, "rb", closefd=False) as file:
                data = file.read()
            whole = data.rfind(b"\n") + 1
            os.ftruncate(self._file, whole)
        except BaseException:
            os.close(self._file)
            raise
        self.lines = data[:whole].decode("utf-8", "replace").splitlines()

    def add(self, line: str, *, sync: bool = False) -> None:
        """Writes a line, with its end; with `sync` it is on the disk when this returns."""
        data = line.encode()
        while data:
            data = data[os.write(self._file, data) :]
        if sync:
            os.fsync(self._file)

    def clear(self) -> None:
        """Takes out all lines."""
        os.ftruncate(self._file, 0)
        self.lines = []

    def close(self) -> None:
        """Lets others have it."""
        os.close(self._file)
