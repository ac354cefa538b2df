"""Arrays of MATLAB files (.mat, to version 7), their size checked before they are unpacked."""

from __future__ import annotations

import zlib
from collections.abc import Iterator, Sequence
from math import prod
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from nscc.npy import MOST_BYTES, check_size

_HEADER_BYTES = 128
_COMPRESSED = 15
_BLOCK_BYTES = 1 << 20
_WIDEST_NUMBER = 8


def mat_names(path: Path) -> list[str]:
    """The names of the arrays in a .mat file; raises what scipy does for a damaged file."""
    from scipy.io import whosmat

    with open(path, "rb") as file:  # scipy does not say that there is no such file
        return [str(name) for name, _, _ in whosmat(file)]


def mat_arrays(
    path: Path, names: Sequence[str] | None = None, most_bytes: int = MOST_BYTES
) -> dict[str, NDArray[Any]]:
    """Read the named arrays of a .mat file, or all.

    Raises InvalidArrays where the file's arrays take more than `most_bytes`, and what scipy does
    where it is damaged.
    """
    from scipy.io import loadmat, whosmat

    with open(path, "rb") as file:
        shapes = [shape for name, shape, _ in whosmat(file) if names is None or name in names]
        check_size(sum(prod(shape) * _WIDEST_NUMBER for shape in shapes), most_bytes)
        file.seek(0)
        unpacked_bytes = 0
        for size in _unpacked_sizes(file):
            unpacked_bytes += size
            check_size(unpacked_bytes, most_bytes)
        file.seek(0)
        found = loadmat(file, variable_names=names)
    return {name: np.asarray(values) for name, values in found.items() if name[:2] != "__"}


def _unpacked_sizes(file: IO[bytes]) -> Iterator[int]:
    """Unpack the compressed elements of a version 5 file block by block, and yield their sizes:
    what an element states about its own size need not be true."""
    head = file.read(_HEADER_BYTES)
    orders = {b"IM": "<", b"MI": ">"}
    if head[-2:] not in orders:
        return
    kinds = np.dtype(f"{orders[head[-2:]]}u4")
    while len(tag := file.read(2 * kinds.itemsize)) == 2 * kinds.itemsize:
        kind, length = np.frombuffer(tag, kinds).tolist()
        if kind != _COMPRESSED:
            file.seek(length, 1)
            continue
        unpacker = zlib.decompressobj()
        while length > 0 and (block := file.read(min(length, _BLOCK_BYTES))):
            length -= len(block)
            while block and not unpacker.eof:
                yield len(unpacker.decompress(block, _BLOCK_BYTES))
                block = unpacker.unconsumed_tail
