"""Doing a thing again whenever one of its files changes."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from time import sleep

_PAUSE_S = 0.2

State = tuple[int, ...] | None
"""What tells one content of a file from another; None for a file that is not there."""


def rounds(files: Callable[[], Iterable[Path]]) -> Iterator[list[str]]:
    """Yields once at first, then the names of the files that changed, whenever some did.

    Changes while the caller is at work are not missed. `files` is asked again each time: what a
    file names may be others then. A file may be missing, and come.
    """
    known_states = _states(files())
    changed: list[str] = []
    while True:
        yield changed
        now = _states(files())
        known_states = {path: known_states.get(path, state) for path, state in now.items()}
        while now == known_states:
            sleep(_PAUSE_S)
            now = _states(now)
        changed = sorted(path.as_posix() for path in now if now[path] != known_states[path])
        known_states = now


def _states(files: Iterable[Path]) -> dict[Path, State]:
    return {path: _state(path) for path in files}


def _state(path: Path) -> State:
    try:
        status = os.stat(path)
    except (OSError, ValueError):
        return None
    return status.st_mtime_ns, status.st_size, status.st_ino
