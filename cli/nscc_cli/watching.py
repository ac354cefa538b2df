"""Waiting for changes of files."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from time import sleep

_PAUSE_S = 0.2

State = tuple[int, ...] | None
"""A summary of a file's state that changes with its content; None if the file does not exist."""


def rounds(files: Callable[[], Iterable[Path]]) -> Iterator[list[str]]:
    """Yield an empty list, then after each change the names of the changed files.

    Changes while the caller works are not missed. `files` is called again after each change,
    because the set of files may change. Files may be missing and appear later."""
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
