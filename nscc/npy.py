"""Safe reading of untrusted .npy and .npz files; sizes are checked before data is read."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from math import prod
from pathlib import Path
from typing import IO, Any

import numpy as np

from nscc.arrays import Array

MOST_BYTES = 1 << 30
"""Default limit on the memory of the arrays in one file."""

_MOST_HEADER_BYTES = 1 << 16
"""Longest header that is read, as in version 1 of the format."""
_BLOCK_BYTES = 1 << 24
"""Bytes read at a time, so that a header that claims too much costs little."""


class InvalidArrays(ValueError):
    """Raised if a file of arrays cannot be read; the text is the reason."""


class UnsuitableArray(InvalidArrays):
    """The reason why an intact array is not read: its size, or Python objects in it."""


def npy_header(stream: IO[bytes]) -> tuple[tuple[int, int], tuple[int, ...], bool, np.dtype[Any]]:
    """Read the header of an .npy stream, and return version (major, minor), shape, whether the
    order is Fortran's, and dtype.

    The length of a version 2 header is limited. Raises InvalidArrays beyond that, and numpy's
    errors for a damaged header."""
    from io import BytesIO

    from numpy.lib import format as npy

    version = npy.read_magic(stream)
    # Version 1 has a header of at most 64 KiB; later versions allow 4 GiB.
    if version == (1, 0):
        return version, *npy.read_array_header_1_0(stream)
    # These versions store the length of the header in 4 bytes, the lowest first.
    length = stream.read(4)
    if int.from_bytes(length, "little") > _MOST_HEADER_BYTES:
        raise InvalidArrays(f"the header of an array is longer than {_MOST_HEADER_BYTES} bytes")
    text = stream.read(int.from_bytes(length, "little"))
    return version, *npy.read_array_header_2_0(BytesIO(length + text))


def npy_values(
    stream: IO[bytes], shape: tuple[int, ...], fortran: bool, dtype: np.dtype[Any]
) -> Array | None:
    """Return the array of this `shape` and `dtype` that follows the header of an .npy stream.

    `fortran` tells whether its first axis changes fastest. Return None if the stream is too short
    or too long."""
    data = memoryview(bytearray(prod(shape) * dtype.itemsize))
    filled = 0
    while block := stream.read(_BLOCK_BYTES):
        if filled + len(block) > len(data):
            return None
        data[filled : filled + len(block)] = block
        filled += len(block)
    if filled < len(data):
        return None
    values = np.frombuffer(data, dtype=dtype)
    # Fortran's order is that of the transposed array in C's order.
    return values.reshape(shape[::-1]).T if fortran else values.reshape(shape)


def npz_arrays(
    path: Path | IO[bytes],
    is_wanted: Callable[[str], bool] = lambda name: True,
    most_bytes: int = MOST_BYTES,
) -> tuple[dict[str, Array], list[str]]:
    """Return the arrays of an .npz file whose names satisfy `is_wanted`, by name, and the names of
    all arrays in stored order.

    The arrays may take `most_bytes` together, which is checked before anything is unpacked. Raises
    InvalidArrays for an invalid, damaged or too large file, and for Python objects; OSError if the
    file cannot be read."""
    from zipfile import BadZipFile, ZipFile

    try:
        archive = ZipFile(path)
    except (BadZipFile, ValueError, NotImplementedError, EOFError) as error:
        raise InvalidArrays("it is not an .npz file") from error
    arrays: dict[str, Array] = {}
    with archive:
        names = [
            entry.removesuffix(".npy") for entry in archive.namelist() if entry.endswith(".npy")
        ]
        for name in filter(is_wanted, names):
            with _damage_of(name):
                stream = archive.open(f"{name}.npy")
            with stream:
                before_bytes = sum(values.nbytes for values in arrays.values())
                arrays[name] = _array(stream, name, most_bytes, before_bytes)
    return arrays, names


def npy_array(file: Path | IO[bytes], most_bytes: int = MOST_BYTES) -> Array:
    """Return the array of an .npy file, given by its path or as an open file; it may take
    `most_bytes`. Raises InvalidArrays for a damaged or too large file and for Python objects, and
    OSError if it cannot be read."""
    if isinstance(file, Path):
        with open(file, "rb") as stream:
            return _array(stream, file.name, most_bytes)
    return _array(file, "array", most_bytes)


def _array(stream: IO[bytes], name: str, most_bytes: int, before_bytes: int = 0) -> Array:
    """Return the array of an .npy stream; `name` is for messages.

    It may take `most_bytes` together with `before_bytes`, the arrays read before from the same
    file. Raises UnsuitableArray for Python objects or too large an array, and InvalidArrays for
    data that does not fit its header. Sizes are checked before data is read."""
    with _damage_of(name):
        _, shape, fortran, dtype = npy_header(stream)
        check_size(before_bytes + prod(shape) * dtype.itemsize, most_bytes)
        if dtype.hasobject:
            raise UnsuitableArray(f"`{name[:40]}` holds Python objects")
        values = npy_values(stream, shape, fortran, dtype)
    if values is None:
        raise InvalidArrays(f"its array `{name[:40]}` is cut short or too long")
    return values


@contextmanager
def _damage_of(name: str) -> Iterator[None]:
    """Turn the many errors of zipfile and numpy for a damaged array, within a `with` block, into
    InvalidArrays."""
    try:
        yield
    except (InvalidArrays, MemoryError):
        raise
    except Exception as error:
        raise InvalidArrays(f"its array `{name[:40]}` is damaged: {error}") from error


def check_size(size: int, most_bytes: int = MOST_BYTES) -> None:
    """Raise UnsuitableArray if an array of `size` bytes exceeds `most_bytes`."""
    if size > most_bytes:
        raise UnsuitableArray(
            f"its arrays unpack to {size / 2**20:,.0f} MiB, but at most "
            f"{most_bytes >> 20:,} MiB are allowed"
        )
