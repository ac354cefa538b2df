"""Files written whole or not at all, one or several together, and never over what was read."""

from __future__ import annotations

import os
import re
import stat
from collections.abc import Callable, Collection, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from itertools import count
from pathlib import Path
from typing import BinaryIO

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected

Product = bytes | Callable[[BinaryIO], object]
"""What goes into a file: its bytes, or a function that writes them to the open file."""

_DESCRIPTOR = re.compile(r"/dev/(?:fd/\d+|stdin|stdout|stderr)|/proc/[^/]+/fd/\d+")
"""Names of what a process has open: a pipe, a terminal, a file that a shell has opened."""

_writes = count()

_Identity = tuple[int, int]
_inputs: ContextVar[dict[_Identity, Path] | None] = ContextVar("inputs", default=None)


@contextmanager
def inputs_kept() -> Iterator[None]:
    """Within it, a file that was noted with `reads` is never written to: one command, one scope."""
    token = _inputs.set({})
    try:
        yield
    finally:
        _inputs.reset(token)


def reads(*paths: Path) -> None:
    """Note input files, by what they are and not by their names; other paths are passed over."""
    known = _inputs.get()
    for path in paths if known is not None else ():
        try:
            found = path.stat()
        except (OSError, ValueError):  # it is read, if at all, by somebody who says what is wrong
            continue
        if known is not None and stat.S_ISREG(found.st_mode):
            known[found.st_dev, found.st_ino] = path


def read_whole(path: Path, most_bytes: int = 1 << 26) -> bytes:
    """Read an input file, and note it with `reads`.

    Raises OSError where it cannot be read, ValueError where it has more than `most_bytes`, however
    long it says that it is: a device has no end.
    """
    reads(path)
    with open(path, "rb") as file:
        data = file.read(most_bytes + 1)
    if len(data) > most_bytes:
        raise ValueError(f"it has more than {most_bytes >> 20} MiB")
    return data


def file_sha256(path: Path) -> str:
    """The SHA-256 of a file in hexadecimal, read block by block."""
    from hashlib import file_digest

    with open(path, "rb") as file:
        return file_digest(file, "sha256").hexdigest()


def write_whole(path: Path, data: Product) -> None:
    """Write a file whole or not at all; one that is replaced keeps its rights.

    Raises Rejected (NS0784, status 2) where it cannot be written.
    """
    write_together({path: data})


def write_together(products: Mapping[Path, Product]) -> None:
    """Write several files, none of them before the bytes of all are on the disk.

    Raises Rejected (status 2), and leaves no partial file: NS0784 where one cannot be written,
    NS0785 where one is an input of the same command (`reads`), unless nothing in it would change.
    """
    for path, data in products.items():
        _refuse_input(path, data)
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


def write_back(path: Path, data: Product) -> None:
    """As `write_whole`, of an input that its user asked to have changed."""
    known = _inputs.get()
    if known:
        for identity in [each for each, name in known.items() if name == path]:
            del known[identity]
    write_whole(path, data)


def write_new(products: Mapping[Path, Product]) -> None:
    """Write several files as `write_together`; Rejected (NS0788, status 2) where there is one."""
    for path in products:
        if path.exists():
            raise rejected(
                "NS0788",
                f"there is a file '{path}' already",
                helps=("take another name or folder, or remove it first",),
            )
    write_together(products)


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


def refuse_inputs(*paths: Path) -> None:
    """Raises Rejected (NS0785) where a product would replace an input: before work is done in
    vain. Writing looks once more."""
    for path in paths:
        _refuse_input(path, lambda _: None)


def _refuse_input(path: Path, data: Product) -> None:
    try:
        found = path.stat()
    except (OSError, ValueError):
        return
    given = (_inputs.get() or {}).get((found.st_dev, found.st_ino))
    if given is not None and not (isinstance(data, bytes) and path.read_bytes() == data):
        raise rejected(
            "NS0785",
            f"'{path}' is an input of this command, and would be overwritten",
            notes=() if given == path else (f"it is the file that was read as '{given}'",),
            helps=("give the product another name",),
        )


def _put_beside(path: Path, data: Product) -> list[tuple[Path, Path]]:
    """Write to a temporary neighbour of `path`, with the rights of a file that is there already;
    a pipe or device is written directly."""
    if path.is_dir():
        raise IsADirectoryError(21, "Is a directory", str(path))
    # Asked of the name itself: what a descriptor's link points to need not have a path.
    if _DESCRIPTOR.fullmatch(str(path)) or (
        path.exists() and not stat.S_ISREG(path.stat().st_mode)
    ):
        with open(path, "ab") as file:
            _fill(file, data)
        return []
    final = Path(os.path.realpath(path))
    temporary = _temporary_beside(final)
    # A process that was killed may have left it; in containers process numbers soon come again.
    temporary.unlink(missing_ok=True)
    kept = final.stat().st_mode & 0o777 if final.exists() else None
    asked = 0o666 if kept is None else kept
    final.parent.mkdir(parents=True, exist_ok=True)
    try:
        # Not even for a moment may others read what they could not read before.
        with open(temporary, "xb", opener=lambda name, flags: os.open(name, flags, asked)) as file:
            _fill(file, data)
        if kept not in (None, temporary.stat().st_mode & 0o777):
            temporary.chmod(asked)  # the umask took rights away
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise
    return [(temporary, final)]


def _temporary_beside(final: Path) -> Path:
    """A short name in the folder of `final` that no other write uses at the same time.

    The digest tells products and machines apart, the process number processes, the count the
    writes of one process.
    """
    from hashlib import sha256

    digest = sha256(os.fsencode(f"{os.uname().nodename}/{final.name}")).hexdigest()[:12]
    return final.with_name(f".{digest}.{os.getpid()}.{next(_writes)}.part")


def _fill(file: BinaryIO, data: Product) -> None:
    if isinstance(data, bytes):
        file.write(data)
    else:
        data(file)


def _cannot_write(path: Path, error: OSError) -> Rejected:
    reason = error.strerror or str(error)
    help_text = "name a file that you may write, in a folder with room"
    return rejected("NS0784", f"cannot write '{path}': {reason}", helps=(help_text,))
