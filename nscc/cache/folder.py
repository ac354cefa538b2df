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
    """Return the cache folder; None if `NSCC_CACHE=off`, or if there is no safe folder.

    The folder is `NSCC_CACHE_DIR`, else `XDG_CACHE_HOME`/nscc if that is an absolute path, else
    ~/.cache/nscc. It need not exist. The reason against an unsafe one is kept for `refusal`."""
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
    """Return why this process has no cache, or an empty text."""
    return "".join(_refusal)


def forget_refusal() -> None:
    """Forget the reason of `refusal`, so that the next command does not say it again."""
    _refusal.clear()


def is_own(path: Path) -> bool:
    """Return whether the file or folder `path` belongs to this user, and nobody else may write to
    it. False if it does not exist."""
    try:
        return not foreign(os.stat(path))
    except OSError:
        return False


def foreign(status: os.stat_result) -> str:
    """Return why a file or folder with this `status` is not safe; an empty text if it is."""
    if status.st_uid != os.geteuid():
        return "belongs to another user"
    others = stat.S_IWGRP | stat.S_IWOTH
    return "can be written by other users" if status.st_mode & others else ""


def _unsafe(folder: Path) -> str:
    """Return why a folder cannot be the cache; an empty text if it can.

    A folder that does not exist is judged by its closest parent: in a folder such as /tmp, nobody
    can replace what belongs to another user."""
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
