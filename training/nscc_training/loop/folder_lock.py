"""The lock of a run folder: one process at a time trains into it."""

from __future__ import annotations

import fcntl
import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from nscc.diagnostics.rejection import rejected


@contextmanager
def locked_folder(folder: Path) -> Iterator[None]:
    """Create a folder and lock it against other processes until the end of the block.

    Raises Rejected (NS0848) if another process holds the lock. The lock ends with the process and
    leaves no file."""
    is_new = not folder.exists()
    folder.mkdir(parents=True, exist_ok=True)
    descriptor = os.open(folder, os.O_RDONLY | os.O_CLOEXEC)
    try:
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise rejected(
                "NS0848",
                f"another process is training in '{folder}'",
                notes=(
                    "only one process at a time may write a run folder, because two would mix "
                    "their results",
                ),
                helps=("wait until it ends, or give --out another folder",),
            ) from None
        yield
    except BaseException:
        if is_new:  # remove the folder of a run that did not begin
            with suppress(OSError):
                folder.rmdir()
        raise
    finally:
        os.close(descriptor)
