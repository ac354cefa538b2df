"""Compiled loaders in the cache, verified by SHA-256 before they are executed."""

from __future__ import annotations

import os
import shutil
import tempfile
from atexit import register
from contextlib import suppress
from hashlib import sha256
from pathlib import Path

from nscc.cache.store import cache_folder
from nscc.files import write_together


def _digest_of(place: Path) -> Path:
    """Return the path of the file with the SHA-256 of a cached loader."""
    return place.with_name(f"{place.name}.sha256")


def is_whole(place: Path) -> bool:
    """Return whether a cached loader is intact and executable."""
    try:
        digest = sha256(place.read_bytes()).hexdigest().encode()
        return _digest_of(place).read_bytes() == digest and os.access(place, os.X_OK)
    except OSError:
        return False


def keep(place: Path, image: bytes) -> None:
    """Store a loader with its SHA-256. Raises Rejected if the folder is not writable."""
    write_together({_digest_of(place): sha256(image).hexdigest().encode(), place: image})
    place.chmod(0o755)


def cached_folder() -> Path:
    """Return the cache folder of loaders, or a temporary folder for this process."""
    cache = cache_folder()
    if cache is not None:
        folder = cache / "firmware"
        with suppress(OSError):
            folder.mkdir(parents=True, exist_ok=True)
            if os.access(folder, os.W_OK):
                return folder
    return passing_folder()


def passing_folder() -> Path:
    """Return a temporary folder that is removed when this process ends."""
    folder = tempfile.mkdtemp(prefix="nscc-firmware-")
    register(shutil.rmtree, folder, ignore_errors=True)
    return Path(folder)
