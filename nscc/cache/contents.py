"""Digests of files and folders."""

from __future__ import annotations

from functools import cache
from hashlib import sha256
from pathlib import Path

from nscc.cache.digest import digest


def content(path: Path) -> str:
    """Return the digest of a file, or of all files of a folder with their names; "" if the path
    does not exist."""
    try:
        if path.is_dir():
            files = sorted(entry for entry in path.rglob("*") if entry.is_file())
            return digest([(entry.relative_to(path).as_posix(), content(entry)) for entry in files])
        status = path.stat()
        return _content(path.resolve(), status.st_size, status.st_mtime_ns)
    except (OSError, ValueError):
        return ""


@cache
def _content(path: Path, _size: int, _mtime_ns: int) -> str:
    """Return the digest of a file; memoized by path, size and modification time."""
    with open(path, "rb") as file:
        running = sha256()
        while block := file.read(1 << 20):
            running.update(block)
    return running.hexdigest()
