"""Reading of integer arrays from untrusted .npz files.

Declared sizes are checked before unpacking, pickled objects are refused, and every failure is a
`Rejected` (status 2) without a place in a program."""

from __future__ import annotations

from io import BytesIO
from math import prod
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected
from nscc.diagnostics.suggest import meant
from nscc.files import reads
from nscc.npy import npy_header, npy_values
from nscc.program.problems import clipped

if TYPE_CHECKING:
    from zipfile import ZipFile

MOST_FILE_BYTES = 2**27
"""Largest file to read, in bytes: twice the largest unpacked codebook."""

_MOST_KEYS = 4096
_MOST_HEADER_BYTES = 2**16


class ArraysFile:
    """An open .npz file: its `keys` in stored order, and the `sha256` of the file in hexadecimal.

    `shown` is the path as the user wrote it."""

    def __init__(self, path: Path, shown: str) -> None:
        self.shown = clipped(shown, 80)
        self._data = self._bytes(path)
        self._zip = self._unzip()
        names = [info.filename for info in self._zip.infolist()]
        if len(names) > _MOST_KEYS:
            raise self._broken(f"it lists {len(names)} arrays")
        self.keys = tuple(name.removesuffix(".npy") for name in names if name.endswith(".npy"))

    @property
    def sha256(self) -> str:
        """The SHA-256 digest of the file in hexadecimal."""
        from hashlib import sha256

        return sha256(self._data).hexdigest()

    def require_sha256(self, stated_sha256: str) -> None:
        """Raise Rejected (NS0315) if the digest differs from the one that the program states."""
        if len(stated_sha256) != 64 or not all(
            c in "0123456789abcdefABCDEF" for c in stated_sha256
        ):
            message = (
                f'"{clipped(stated_sha256)}" is not a SHA-256 digest: a digest has 64 hexadecimal '
                "digits"
            )
            raise rejected("NS0315", message, helps=(f'the file has sha256 "{self.sha256}"',))
        if stated_sha256.lower() != self.sha256:
            message = (
                f'the contents of "{self.shown}" differ from the file that the program was '
                "written for"
            )
            notes = (f"expected {stated_sha256.lower()}", f"found    {self.sha256}")
            raise rejected("NS0315", f"{message}: its SHA-256 differs", notes=notes)

    def integers(self, key: str, *, most: int, bools: bool = False) -> NDArray[Any]:
        """Return the array `key` with an integer dtype (or bool, with `bools`) and at most `most`
        values.

        Raises Rejected: NS0313 for a damaged file, NS0314 for a missing or unsuitable array."""
        if key not in self.keys:
            raise self._missing(key)
        from zipfile import BadZipFile
        from zlib import error as ZlibError  # noqa: N812 (a class with a small name)

        try:
            if self._zip.getinfo(f"{key}.npy").file_size > 8 * most + _MOST_HEADER_BYTES:
                raise self._too_large(key, most)
            with self._zip.open(f"{key}.npy") as stream:
                return self._array(stream, key, most, bools)
        except (
            BadZipFile, ZlibError, EOFError, OSError, ValueError, RuntimeError, SyntaxError,
            TypeError, KeyError, MemoryError, OverflowError,
        ) as error:  # fmt: skip
            raise self._broken(f"the array `{clipped(key)}` cannot be unpacked") from error

    def _array(self, stream: IO[bytes], key: str, most: int, bools: bool) -> NDArray[Any]:
        version, shape, fortran, dtype = npy_header(stream)
        if version not in ((1, 0), (2, 0)):
            raise self._broken(f"the array `{clipped(key)}` has npy version {version}")
        if dtype.kind not in ("iub" if bools else "iu"):
            raise self._not_integers(key, dtype)
        if prod(shape) > most:
            raise self._too_large(key, most)
        if any(length < 0 for length in shape):
            raise self._broken(f"the array `{clipped(key)}` has the shape {shape}")
        values = npy_values(stream, shape, fortran, dtype)
        if values is None:
            raise self._broken(f"the array `{clipped(key)}` is cut short or too long")
        return values

    def _bytes(self, path: Path) -> bytes:
        try:
            if not path.is_file():
                problem = "is not a file" if path.exists() else "does not exist"
                help_text = "paths are relative to the file that names them"
                raise rejected("NS0313", f'"{self.shown}" {problem}', helps=(help_text,))
            size = path.stat().st_size
            if size > MOST_FILE_BYTES:
                message = (
                    f'"{self.shown}" has {size} bytes, but at most {MOST_FILE_BYTES} are allowed'
                )
                raise rejected("NS0313", message)
            reads(path)
            with path.open("rb") as stream:
                return stream.read(MOST_FILE_BYTES)
        except (OSError, ValueError) as error:
            reason = getattr(error, "strerror", None) or "not a possible path"
            raise rejected("NS0313", f'"{self.shown}" cannot be read: {reason}') from error

    def _unzip(self) -> ZipFile:
        from zipfile import BadZipFile, ZipFile

        try:
            return ZipFile(BytesIO(self._data))
        except (BadZipFile, OSError, ValueError, NotImplementedError, EOFError) as error:
            help_text = "write one with `numpy.savez(PATH, NAME=array)`"
            message = f'"{self.shown}" is not an .npz file'
            raise rejected("NS0313", message, helps=(help_text,)) from error

    def _broken(self, reason: str) -> Rejected:
        return rejected("NS0313", f'"{self.shown}" is damaged: {reason}')

    def _too_large(self, key: str, most: int) -> Rejected:
        message = f'the array `{clipped(key)}` of "{self.shown}" has more than {most} values'
        return rejected("NS0314", message, helps=("no program of this size needs so many values",))

    def _missing(self, key: str) -> Rejected:
        listed = ", ".join(f"`{clipped(k, 30)}`" for k in self.keys[:12]) or "no arrays"
        message, notes = (
            f'"{self.shown}" has no array `{clipped(key)}`',
            (f"the file has {listed}",),
        )
        return rejected("NS0314", message, notes=notes, helps=meant(key, self.keys))

    def _not_integers(self, key: str, dtype: np.dtype[Any]) -> Rejected:
        kind = "Python objects" if dtype.hasobject else f"of type {dtype}"
        help_text = f"round and convert it before saving: `{key}.astype(numpy.int64)`"
        return rejected(
            "NS0314",
            f'the array `{clipped(key)}` of "{self.shown}" is {kind}, but must contain integers',
            helps=() if dtype.hasobject else (help_text,),
        )
