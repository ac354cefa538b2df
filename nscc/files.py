"""Atomic writing of files, without overwriting input files."""

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

from nscc.diagnostics.diagnostic import Rejected, rejected

Product = bytes | Callable[[BinaryIO], object]
"""The content of a file: its bytes, or a function that writes them to the open file."""

_DESCRIPTOR = re.compile(r"/dev/(?:fd/\d+|stdin|stdout|stderr)|/proc/[^/]+/fd/\d+")
"""Paths of open file descriptors: pipes, terminals, redirected files."""

_writes = count()

_Identity = tuple[int, int]
_inputs: ContextVar[dict[_Identity, Path] | None] = ContextVar("inputs", default=None)


@contextmanager
def inputs_kept() -> Iterator[None]:
    """Refuse writing to files recorded by `reads`, within a `with` block for one command.

    `refuse_inputs` and the functions that write files then raise Rejected (NS0785)."""
    token = _inputs.set({})
    try:
        yield
    finally:
        _inputs.reset(token)


def reads(*paths: Path) -> None:
    """Record files that the command reads, so that it cannot overwrite them within `inputs_kept`.

    They are identified by device and inode. Paths that are missing or not regular files are
    ignored; outside of `inputs_kept`, all are."""
    known = _inputs.get()
    for path in paths if known is not None else ():
        try:
            status = path.stat()
        except (OSError, ValueError):  # the function that reads the file reports the error
            continue
        if known is not None and stat.S_ISREG(status.st_mode):
            known[status.st_dev, status.st_ino] = path


def read_whole(path: Path, most_bytes: int = 1 << 26) -> bytes:
    """Return the bytes of an input file, and record it with `reads`.

    Raises OSError if it cannot be read, and ValueError if it has more than `most_bytes`. The size
    on disk is not used, because devices have none."""
    reads(path)
    with open(path, "rb") as file:
        data = file.read(most_bytes + 1)
    if len(data) > most_bytes:
        raise ValueError(f"it has more than {most_bytes >> 20} MiB")
    return data


def why_no_file(path: Path) -> str:
    """Return why `path` is not a file: it does not exist, or is a folder or a device. Raises
    OSError or ValueError for a path that cannot be looked up."""
    return "it is not a file" if path.exists() else "the file does not exist"


def file_sha256(path: Path) -> str:
    """Return the SHA-256 of the file `path` in hexadecimal, read block by block. Raises OSError if
    it cannot be read."""
    from hashlib import file_digest

    with open(path, "rb") as file:
        return file_digest(file, "sha256").hexdigest()


def write_whole(path: Path, data: Product) -> None:
    """Write a file atomically; a file that it replaces keeps its permissions.

    Raises Rejected (status 2): NS0784 if it cannot be written, NS0785 if it is an input of the
    command."""
    write_together({path: data})


def write_together(products: Mapping[Path, Product]) -> None:
    """Write the products of a command, and remember that it wrote files (`wrote_files`).

    `products` maps paths to contents; no file is replaced before all data is on the disk. Raises
    Rejected (status 2): NS0784 if a file cannot be written, NS0785 if it is an input of the
    command."""
    store_files(products)
    _written.extend(path for path in products if path.is_file())


_written: list[Path] = []


def wrote_files() -> bool:
    """Return whether this process wrote a product to a file."""
    return bool(_written)


def store_files(products: Mapping[Path, Product]) -> None:
    """Write several files, given as contents by path; none is replaced before all data is on the
    disk.

    Raises Rejected (status 2) and leaves no partial file: NS0784 if a file cannot be written,
    NS0785 if it is an input of the same command (`reads`) and would change."""
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
    """Write `data` to an input file that the user asked to change, atomically. Raises Rejected
    (NS0784, status 2) if it cannot be written.

    The file then no longer counts as an input, which may not be overwritten."""
    known = _inputs.get()
    if known:
        for identity in [key for key, name in known.items() if name == path]:
            del known[identity]
    write_whole(path, data)


def write_new(products: Mapping[Path, Product]) -> None:
    """Write several new files, or none; raise Rejected (NS0788, status 2) if one of them exists."""
    for path in products:
        if path.exists():
            raise rejected(
                "NS0788",
                f"the file '{path}' exists already",
                helps=("choose another name or folder, or remove the file first",),
            )
    write_together(products)


def refuse_same(paths: Collection[Path], options: str) -> None:
    """Raise Rejected (NS0745, status 2) if two products have the same path, after they are made
    absolute; links are not followed.

    `options` are the options that name the paths."""
    if len({path.absolute() for path in paths}) < len(paths):
        raise rejected(
            "NS0745",
            f"two outputs have the same file name: {', '.join(map(str, paths))}",
            helps=(f"give {options} different names",),
        )


def refuse_inputs(*paths: Path) -> None:
    """Raise Rejected (NS0785) if one of these paths is an input of the command; call this before
    long work."""
    for path in paths:
        _refuse_input(path, lambda _: None)


def _refuse_input(path: Path, data: Product) -> None:
    """Raise Rejected (NS0785) if `path` is an input of the command and `data` would change it. A
    function as `data` counts as a change."""
    try:
        status = path.stat()
    except (OSError, ValueError):
        return
    input_path = (_inputs.get() or {}).get((status.st_dev, status.st_ino))
    # Formatting a file that is formatted already changes nothing.
    if input_path is not None and not (isinstance(data, bytes) and path.read_bytes() == data):
        raise rejected(
            "NS0785",
            f"the output '{path}' would overwrite an input of this command",
            notes=() if input_path == path else (f"the command reads this file as '{input_path}'",),
            helps=("choose another name for the output",),
        )


def _put_beside(path: Path, data: Product) -> list[tuple[Path, Path]]:
    """Write data to a temporary file beside `path`, with the permissions of an existing file.
    Missing folders are created.

    Return [(temporary, final path)]. Pipes and devices are written directly, which returns [].
    Raises OSError."""
    if path.is_dir():
        raise IsADirectoryError(21, "Is a directory", str(path))  # 21 is EISDIR
    # The name itself is checked, because the target of a descriptor's link need not have a path.
    if _DESCRIPTOR.fullmatch(str(path)) or (
        path.exists() and not stat.S_ISREG(path.stat().st_mode)
    ):
        with open(path, "ab") as file:
            _fill(file, data)
        return []
    from hashlib import sha256

    final = Path(os.path.realpath(path))
    # The name is short, and no other write of this or another process or machine uses it.
    digest = sha256(os.fsencode(f"{os.uname().nodename}/{final.name}")).hexdigest()[:12]
    temporary = final.with_name(f".{digest}.{os.getpid()}.{next(_writes)}.part")
    # A killed process may have left it, and process numbers repeat quickly in containers.
    temporary.unlink(missing_ok=True)
    old_mode = final.stat().st_mode & 0o777 if final.exists() else None  # the permissions
    mode = 0o666 if old_mode is None else old_mode
    final.parent.mkdir(parents=True, exist_ok=True)
    try:
        # Permissions must be restricted from the start.
        with open(temporary, "xb", opener=lambda name, flags: os.open(name, flags, mode)) as file:
            _fill(file, data)
        if old_mode not in (None, temporary.stat().st_mode & 0o777):
            temporary.chmod(mode)  # the umask removed permissions
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise
    return [(temporary, final)]


def _fill(file: BinaryIO, data: Product) -> None:
    """Write a product to an open file: bytes as they are, or by calling the product with the
    file."""
    if isinstance(data, bytes):
        file.write(data)
    else:
        data(file)


def _cannot_write(path: Path, error: OSError) -> Rejected:
    """Return the exception (NS0784) that a file cannot be written, with the reason of `error`."""
    reason = error.strerror or str(error)
    help_text = "choose a file that you may write, in a folder with enough space"
    return rejected("NS0784", f"cannot write '{path}': {reason}", helps=(help_text,))
