"""Reading of integer arrays from untrusted .npz files.

Declared sizes are checked before unpacking, pickled objects are refused, and every failure is a
`Rejected` (status 2) without a place in a program."""

from __future__ import annotations

from io import BytesIO
from pathlib import Path

from nscc.arrays import Array
from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.diagnostics.suggest import meant
from nscc.files import reads
from nscc.npy import InvalidArrays, UnsuitableArray, npz_arrays
from nscc.program.problems import clipped

MOST_FILE_BYTES = 2**27
"""Largest file to read, in bytes: twice the largest unpacked codebook."""

_MOST_KEYS = 4096
"""Most arrays that a file may list."""


class ArraysFile:
    """An .npz file that a program names, read into memory: its `keys` (names of arrays) in stored
    order.

    `shown` is the path as the user wrote it."""

    def __init__(self, path: Path, shown: str) -> None:
        """Read the file and list its arrays; `shown` is its path as written in the program.

        `path` is where the file lies. Raises Rejected (NS0313) for a file that is missing, too
        large, not an .npz file or lists too many arrays."""
        self.shown = clipped(shown, 80)
        self._data = self._bytes(path)
        try:
            _, keys = npz_arrays(BytesIO(self._data), lambda _: False)
        except (InvalidArrays, OSError) as error:
            help_text = "write one with `numpy.savez(PATH, NAME=array)`"
            message = f'"{self.shown}" is not an .npz file'
            raise rejected("NS0313", message, helps=(help_text,)) from error
        if len(keys) > _MOST_KEYS:
            raise self._broken(f"it lists {len(keys)} arrays")
        self.keys = tuple(keys)

    @property
    def sha256(self) -> str:
        """The SHA-256 digest of the file in hexadecimal."""
        from hashlib import sha256

        return sha256(self._data).hexdigest()

    def require_sha256(self, stated_sha256: str) -> None:
        """Check the file's digest against the one that the program states: 64 hexadecimal digits,
        upper or lower case.

        Raises Rejected (NS0315) if the stated digest is invalid or differs."""
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

    def integers(self, key: str, *, most: int, bools: bool = False) -> Array:
        """Return the array `key`, of at most `most` values, with its stored integer dtype.

        With `bools`, it may also be of bool. Raises Rejected: NS0313 for a damaged file, NS0314 for
        a missing array, one of another type or one with more than `most` values. Any shape is
        allowed."""
        if key not in self.keys:
            listed = ", ".join(f"`{clipped(k, 30)}`" for k in self.keys[:12]) or "no arrays"
            message, notes = (
                f'"{self.shown}" has no array `{clipped(key)}`',
                (f"the file has {listed}",),
            )
            raise rejected("NS0314", message, notes=notes, helps=meant(key, self.keys))
        try:
            # An integer has at most 8 bytes.
            arrays, _ = npz_arrays(BytesIO(self._data), key.__eq__, 8 * most)
        except UnsuitableArray as error:
            raise self._unsuitable(key, str(error), most) from error
        except (InvalidArrays, MemoryError, OSError) as error:
            raise self._broken(str(error) or "it does not fit the memory") from error
        values = arrays[key]
        if values.dtype.kind not in ("iub" if bools else "iu"):
            raise rejected(
                "NS0314",
                f'the array `{clipped(key)}` of "{self.shown}" is of type {values.dtype}, but must '
                "contain integers",
                helps=(f"round and convert it before saving: `{key}.astype(numpy.int64)`",),
            )
        if values.size > most:
            raise self._unsuitable(key, f"it has {values.size} values", most)
        return values

    def _bytes(self, path: Path) -> bytes:
        """Return the content of the file, at most `MOST_FILE_BYTES`.

        `path` is where the file lies. The file is noted as an input of the command, which products
        must not overwrite. Raises Rejected (NS0313) if it is missing, too large or cannot be read.
        """
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

    def _broken(self, reason: str) -> Rejected:
        """Return the error (NS0313) for a damaged file, for `reason`."""
        return rejected("NS0313", f'"{self.shown}" is damaged: {reason}')

    def _unsuitable(self, key: str, reason: str, most: int) -> Rejected:
        """Return the error (NS0314) that the array `key` cannot be used for `reason`; `most` is the
        most values allowed."""
        message = f'the array `{clipped(key)}` of "{self.shown}" cannot be used: {reason}'
        return rejected("NS0314", message, helps=(f"give at most {most} integers",))
