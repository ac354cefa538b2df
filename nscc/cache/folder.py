"""The user's cache folder: the one place that decides whether a folder or file of it is safe.

nscc executes files of its cache. So the folder, and every file that is executed, must belong to
this user, and nobody else may write to it."""

from __future__ import annotations

import os
import stat
from collections.abc import Mapping
from pathlib import Path

_refusal: list[str] = []
"""The reason against the folder that the environment names, as found last."""


def cache_folder(environment: Mapping[str, str] | None = None) -> Path | None:
    """Return the cache folder, which need not exist; None if `NSCC_CACHE=off` or if it is not safe.

    The folder is `NSCC_CACHE_DIR`, else `XDG_CACHE_HOME`/nscc if that is an absolute path, else
    ~/.cache/nscc. `environment` holds these variables; None means those of the process. `refusal`
    then tells why a folder is not safe."""
    variables = os.environ if environment is None else environment
    if variables.get("NSCC_CACHE", "").lower() == "off":
        return None
    named, shared = variables.get("NSCC_CACHE_DIR", ""), variables.get("XDG_CACHE_HOME", "")
    if named:
        folder = Path(named)
    elif os.path.isabs(shared):
        folder = Path(shared) / "nscc"
    else:
        home = variables["HOME"] if "HOME" in variables else os.path.expanduser("~")
        folder = Path(home) / ".cache" / "nscc"
    reason = _unsafe(folder)
    _refusal[:] = [f"'{folder}' {reason}, so nscc runs without a cache"] if reason else []
    return None if reason else folder


def refusal() -> str:
    """Return why the last call of `cache_folder` found its folder not safe, or an empty text."""
    return "".join(_refusal)


def forget_refusal() -> None:
    """Clear the text that `refusal` returns, so that the next command does not print it again."""
    _refusal.clear()


def is_own(path: Path) -> bool:
    """Return whether a file or folder belongs to this user and nobody else may write to it.

    Return False if it does not exist or cannot be examined."""
    try:
        return not foreign(os.stat(path))
    except OSError:
        return False


def foreign(status: os.stat_result) -> str:
    """Return why a file or folder is not safe, as the end of a sentence; an empty text if it is.

    It is safe if it belongs to this user and nobody else may write to it. `status` is the result of
    `os.stat`."""
    if status.st_uid != os.geteuid():
        return "belongs to another user"
    others = stat.S_IWGRP | stat.S_IWOTH
    return "can be written by other users" if status.st_mode & others else ""


def _unsafe(folder: Path) -> str:
    """Return why a folder cannot be the cache, as the end of a sentence; an empty text if it can.

    A folder that does not exist is judged by its closest existing parent, in which it would be
    made. A parent with the sticky bit, such as /tmp, is safe: nobody can replace what belongs to
    another user."""
    if not folder.is_absolute():
        return "is not an absolute path"
    try:
        existing = next(path for path in (folder, *folder.parents) if os.path.lexists(path))
        status = os.stat(existing)
    except OSError as error:
        return f"cannot be used: {error.strerror}"
    if not stat.S_ISDIR(status.st_mode):
        return "is not a folder"
    if existing != folder and status.st_mode & stat.S_ISVTX:
        return ""
    reason = foreign(status)
    if not reason and not os.access(existing, os.W_OK | os.X_OK):
        reason = "cannot be written"
    return reason and (
        reason if existing == folder else f"would be in '{existing}', which {reason}"
    )
