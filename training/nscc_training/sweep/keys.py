"""By what a point's result is known: the digest of all that decides it."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from hashlib import sha256
from importlib import metadata
from pathlib import Path

from nscc import __version__
from nscc.cache.digest import digest, package_digest, version_digest
from nscc_training.sweep.kinds import KINDS
from nscc_training.sweep.point import Point

_SCHEMA = "nscc-point-1"


def key_of(point: Point, threads: int) -> str:
    """The key of a point: 64 hexadecimal digits. Paths are relative to the current folder.

    Its values count, the content of every file that they name, the sources of the packages that
    compute it, and the versions of those that do it for them. Where torch computes, the number of
    `threads` counts as well: sums of floats depend on it. Raises Rejected for a program that cannot
    be read.
    """
    kind = KINDS[point.kind]
    after = "" if point.after is None else key_of(point.after, threads)
    given = {name: kind_plain(value) for name, value in sorted(point.values.items())}
    return digest((
        _SCHEMA, kind.name, given, [content(path) for path in kind.reads(point.values)],
        versions(kind.packages, kind.distributions),
        threads if "torch" in kind.distributions else 0, after,
    ))  # fmt: skip


def kind_plain(value: object) -> object:
    """A value as it counts: 1 and 1.0 are the same number."""
    if isinstance(value, float) and value.is_integer():
        return int(value)
    return value


def content(path: Path) -> str:
    """The digest of a file, or of all files of a folder by their names; "" where there is none."""
    try:
        if path.is_dir():
            files = sorted(each for each in path.rglob("*") if each.is_file())
            return digest([(each.relative_to(path).as_posix(), content(each)) for each in files])
        status = path.stat()
        return _content(path.resolve(), status.st_size, status.st_mtime_ns)
    except (OSError, ValueError):
        return ""


@cache
def _content(path: Path, _size: int, _mtime_ns: int) -> str:
    """The digest of a file that has had this size since that time: large ones are read once."""
    with open(path, "rb") as file:
        running = sha256()
        while block := file.read(1 << 20):
            running.update(block)
    return running.hexdigest()


@cache
def versions(packages: Sequence[str], distributions: Sequence[str]) -> tuple[str, ...]:
    """What computes: the digests of our own packages, then the versions of others."""
    own = (version_digest() if name == "nscc" else package_digest(name) for name in packages)
    return (*(each or __version__ for each in own), *map(_version, distributions))


def _version(distribution: str) -> str:
    try:
        return metadata.version(distribution)
    except metadata.PackageNotFoundError:
        return ""
