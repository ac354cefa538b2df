"""A folder of entries by key, of bounded size, safe between processes; I/O errors are ignored.

An entry is a file named after its key: one line with format, key and checksum, then the data. Files
are replaced atomically. When the folder is too large, the least recently used entries are deleted.
"""

from __future__ import annotations

import os
import re
import stat
import time
from collections.abc import Iterator
from contextlib import suppress
from hashlib import sha256
from pathlib import Path

from nscc.cache.folder import foreign
from nscc.record import Record

MOST_BYTES = 64_000_000
"""Default limit on the total size of all entries, in bytes."""
_KEPT_SHARE = 0.75
"""Fraction of the size limit that remains after deletions, so that few writes must delete
entries."""
_LARGEST = MOST_BYTES // 4
"""Largest entry that is stored or read, in bytes."""

_FORMAT = b"nscc-cache-1"
_ENTRY = re.compile(r"[0-9a-f]{64}")
_PART = re.compile(r"\.[0-9a-f]{64}\.[0-9]+\.part")
_NEW = os.O_WRONLY | os.O_CREAT | os.O_EXCL
"""Flags that open a file for writing only if it does not exist yet."""
_PART_AGE_S = 600.0
"""Age in seconds above which a partial file belongs to a process that died."""


class Store(Record):
    """Entries of bytes by key in a folder, which need not exist.

    `most_bytes` limits their total size. No method raises file system errors: reading then finds
    nothing, and writing has no effect."""

    folder: Path
    most_bytes: int = MOST_BYTES

    def read(self, key: str) -> bytes | None:
        """Return the data stored under `key` (64 hexadecimal digits); None if missing or damaged.

        An entry of another user, or one larger than `_LARGEST`, is treated as missing. Reading
        marks the entry as recently used."""
        path = self.folder / key
        try:
            # Opening a pipe in the entry's place must not block.
            with os.fdopen(os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC), "rb") as file:
                status = os.fstat(file.fileno())
                is_entry = stat.S_ISREG(status.st_mode) and not foreign(status)
                if not is_entry or status.st_size > _LARGEST:
                    return None
                head, _, data = file.read().partition(b"\n")
        except OSError:
            return None
        if head != _head(key, data):
            return None
        with suppress(OSError):
            os.utime(path)
        return data

    def write(self, key: str, data: bytes) -> None:
        """Store `data` under `key`, replacing an earlier entry.

        The least recently used entries are then deleted if the folder is too large. Nothing is
        stored if the entry exceeds a quarter of `MOST_BYTES` or all of `most_bytes`, or if another
        thread of this process is writing it."""
        entry = _head(key, data) + b"\n" + data
        if len(entry) > min(_LARGEST, self.most_bytes):
            return
        temporary = self.folder / f".{key}.{os.getpid()}.part"
        try:
            self.folder.mkdir(mode=0o700, parents=True, exist_ok=True)
            with os.fdopen(os.open(temporary, _NEW, 0o600), "wb") as file:
                file.write(entry)
            os.replace(temporary, self.folder / key)
        except FileExistsError:
            return
        except OSError:
            _remove(temporary)
            return
        self._make_room()

    def entries(self) -> int:
        """Return the number of entries in the folder, damaged ones included; 0 if it does not exist
        or cannot be read."""
        return sum(1 for _ in self._files(_ENTRY))

    def bytes_used(self) -> int:
        """Return the total size of all entries in bytes, damaged ones included; 0 if the folder
        does not exist or cannot be read."""
        return sum(status.st_size for _, status in self._files(_ENTRY))

    def _make_room(self) -> None:
        """Delete partial files that a dead process left and, if the entries exceed `most_bytes`,
        old ones.

        The least recently used entries are deleted first, until at most `_KEPT_SHARE` of
        `most_bytes` remains. Files that cannot be deleted are left."""
        now = time.time()
        for path, status in self._files(_PART):
            if now - status.st_mtime > _PART_AGE_S:
                _remove(path)
        files = list(self._files(_ENTRY))
        used = sum(status.st_size for _, status in files)
        if used <= self.most_bytes:
            return
        for path, status in sorted(files, key=lambda item: (item[1].st_mtime_ns, item[0])):
            if used <= self.most_bytes * _KEPT_SHARE:
                return
            _remove(path)
            used -= status.st_size

    def _files(self, pattern: re.Pattern[str]) -> Iterator[tuple[Path, os.stat_result]]:
        """Yield path and status of the regular files whose whole names match `pattern`.

        Files that disappear meanwhile are skipped. A folder that cannot be read yields nothing."""
        try:
            with os.scandir(self.folder) as entries:
                names = [entry for entry in entries if pattern.fullmatch(entry.name)]
        except OSError:
            return
        for entry in names:
            try:
                status = entry.stat(follow_symlinks=False)
            except OSError:
                continue
            if stat.S_ISREG(status.st_mode):
                yield Path(entry.path), status


def _head(key: str, data: bytes) -> bytes:
    """Return the first line of an entry, without line break: format, key and SHA-256 of its
    `data`."""
    return b" ".join((_FORMAT, key.encode(), sha256(data).hexdigest().encode()))


def _remove(path: Path) -> None:
    """Delete a file; do nothing if it does not exist or cannot be deleted."""
    with suppress(OSError):
        path.unlink()
