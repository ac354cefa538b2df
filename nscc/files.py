"""Files written whole or not at all, one or several together."""

from __future__ import annotations

import os
import stat
from collections.abc import Callable, Collection, Mapping
from pathlib import Path
from typing import BinaryIO

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected

Product = bytes | Callable[[BinaryIO], object]
"""What goes into a file: its bytes, or a function that writes them to the open file."""


def write_whole(path: Path, data: Product) -> None:
    """Write a file whole or not at all; raises Rejected (NS0784, status 2) where it cannot be."""
    write_together({path: data})


def write_together(products: Mapping[Path, Product]) -> None:
    """Write several files, none of them before the bytes of all are on the disk.

    Raises Rejected (NS0784, status 2) where one cannot be written, and leaves no partial file.
    """
    waiting: list[tuple[Path, Path]] = []
    try:
        for path, data in products.items():
            try:
                waiting.extend(_put_beside(path, data))
            except OSError as error:
                raise _cannot_write(path, error) from error
        while waiting:
            temporary, final = waiting[0]
            try:
                os.replace(temporary, final)
            except OSError as error:
                raise _cannot_write(final, error) from error
            waiting.pop(0)
    finally:
        for temporary, _ in waiting:
            temporary.unlink(missing_ok=True)


def refuse_same(paths: Collection[Path], options: str) -> None:
    """Raises Rejected (NS0745, status 2) where two of the products would be one file.

    `options` are those that name them.
    """
    if len({path.absolute() for path in paths}) < len(paths):
        raise rejected(
            "NS0745",
            f"two products would be written to one file: {', '.join(map(str, paths))}",
            helps=(f"give {options} different names",),
        )


def _put_beside(path: Path, data: Product) -> list[tuple[Path, Path]]:
    """Write to a temporary neighbour of `path`; a pipe or device is written directly."""
    final = Path(os.path.realpath(path))
    if final.is_dir():
        raise IsADirectoryError(21, "Is a directory", str(path))
    if final.exists() and not stat.S_ISREG(final.stat().st_mode):
        with open(final, "wb") as file:
            _fill(file, data)
        return []
    temporary = final.with_name(f".{final.name[:200]}.{os.getpid()}.part")
    # Left by a process that was killed while it wrote; in containers numbers soon come again.
    temporary.unlink(missing_ok=True)
    try:
        with open(temporary, "xb") as file:
            _fill(file, data)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise
    return [(temporary, final)]


def _fill(file: BinaryIO, data: Product) -> None:
    if isinstance(data, bytes):
        file.write(data)
    else:
        data(file)


def _cannot_write(path: Path, error: OSError) -> Rejected:
    reason = error.strerror or str(error)
    folder = path.parent
    if not folder.is_dir():
        help_text = f"make the folder '{folder}' first, or name another file"
    else:
        help_text = "name a file that you may write, in a folder with room"
    return rejected("NS0784", f"cannot write '{path}': {reason}", helps=(help_text,))
