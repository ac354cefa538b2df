"""Digests of frozen values, files and folders: 64 hexadecimal digits."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from functools import cache
from hashlib import sha256
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from nscc.files import file_sha256
from nscc.plugins import sources


def content(path: Path) -> str:
    """Return the digest of a file's bytes, or of all files of a folder with their relative names.

    Return "" if the path does not exist, cannot be read, or is not a possible path. A file of a
    folder that cannot be read counts as "". The digest of an empty folder is that of no files."""
    try:
        if path.is_dir():
            files = sorted(entry for entry in path.rglob("*") if entry.is_file())
            return digest([(entry.relative_to(path).as_posix(), content(entry)) for entry in files])
        status = path.stat()
        return _content(path.resolve(), status.st_size, status.st_mtime_ns)
    # ValueError: the path contains a null character.
    except (OSError, ValueError):
        return ""


@cache
def _content(path: Path, _size: int, _mtime_ns: int) -> str:
    """Return the digest of a file's bytes.

    The result is memoized by path, size in bytes and time of the last modification, so that an
    unchanged file is read once."""
    return file_sha256(path)


_ROOT = Path(__file__).resolve().parents[1]
_DECIDES = (".py", ".toml", ".safetensors")


def digest(value: Any) -> str:
    """Return the digest of a value made of frozen dataclasses, tuples, lists, mappings, arrays,
    enums, texts and numbers.

    Different values have different digests, and so have 1, 1.0 and True. A list and a tuple with
    equal members have the same digest. Raises TypeError for other types, because ignoring a member
    could give two values the same digest."""
    return sha256(_token(value, {})).hexdigest()


@cache
def version_digest() -> str | None:
    """Return the digest of all that determines a compilation's result besides its input.

    These are the sources of nscc and of packages that add encodings, and the versions of Python and
    numpy. Return None if a source cannot be read. Raises Rejected (NS0905) if such a package cannot
    be imported. It is computed once."""
    roots = {"": _ROOT}
    for name, module in sources("nscc.encodings").items():
        file = getattr(sys.modules[module.partition(".")[0]], "__file__", None)
        if file is None:
            return None
        roots[name] = Path(file).parent if Path(file).stem == "__init__" else Path(file)
    return _digest_of(roots)


@cache
def package_digest(name: str) -> str | None:
    """Return the digest of the sources of another installed package, and of Python and numpy.

    `name` is its import name. Return None if it is not installed, has no sources, or they cannot be
    read. Only the first folder of a package in several folders is read."""
    spec = find_spec(name)
    if spec is None or not spec.submodule_search_locations:
        return None
    return _digest_of({name: Path(spec.submodule_search_locations[0])})


def _digest_of(roots: Mapping[str, Path]) -> str | None:
    """Return the digest of source files and of the versions of Python and numpy.

    `roots` maps a name to a file or a folder. Of a folder, the files that end in `_DECIDES` count.
    Return None if a root has no such file, or if a file cannot be read."""
    running = sha256(repr((sys.version_info[:3], np.__version__)).encode())
    try:
        for name, root in roots.items():
            paths = [root]
            if not root.is_file():
                paths = sorted(
                    Path(folder) / file
                    for folder, _, files in os.walk(root)
                    for file in files
                    if file.endswith(_DECIDES)
                )
            if not paths:
                return None
            for path in paths:
                running.update(f"\n{name}:{path.relative_to(root).as_posix()}\n".encode())
                running.update(sha256(path.read_bytes()).digest())
    except OSError:
        return None
    return running.hexdigest()


def _token(value: Any, known: dict[int, bytes]) -> bytes:
    """Return bytes that represent a value in the digest.

    `known` maps the id of an array, sequence, mapping or dataclass to its bytes, because many
    members are shared; this call may add to it. Raises TypeError for other types."""
    if isinstance(value, Enum):
        return f"e{type(value).__name__}.{value.name}".encode()
    # Before integers: True is an int in Python, but must differ from 1.
    if value is None or isinstance(value, bool | float):
        return repr(value).encode()
    if isinstance(value, int):
        # Hexadecimal, because Python limits the decimal digits of long integers, such as truth
        # vectors.
        return f"i{value:x}".encode()
    if isinstance(value, str):
        # File names that are not UTF-8 contain surrogates.
        return b"s" + value.encode(errors="surrogatepass")
    token = known.get(id(value))
    if token is None:
        token = known[id(value)] = _compound(value, known)
    return token


def _compound(value: Any, known: dict[int, bytes]) -> bytes:
    """Return the SHA-256 digest of an array, sequence, mapping or dataclass instance: 32 bytes.

    The digest covers the kind of `value`, the number of its members and the token of each member
    with its length. `known` is the cache of `_token`, to which this call may add. Raises TypeError
    for any other kind of value."""
    tokens: list[bytes]
    if isinstance(value, np.ndarray | np.generic):
        head = f"a{value.dtype.str}{value.shape}"
        tokens = [np.ascontiguousarray(value).tobytes()]
    elif isinstance(value, tuple | list):
        head = "t"
        tokens = [_token(token, known) for token in value]
    elif isinstance(value, Mapping):
        head = "m"
        tokens = [_token(token, known) for item in value.items() for token in item]
    elif is_dataclass(value) and not isinstance(value, type):
        head = f"d{type(value).__name__}"
        tokens = [_token(getattr(value, field.name), known) for field in fields(value)]
    else:
        raise TypeError(f"no digest for {type(value).__name__}")
    running = sha256(f"{head}{len(tokens)}".encode())
    for token in tokens:
        # The length separates the tokens: without it, ("ab", "c") and ("a", "bc") would be alike.
        running.update(f":{len(token)}:".encode())
        running.update(token)
    return running.digest()
