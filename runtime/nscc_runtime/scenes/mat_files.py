"""Read arrays in MATLAB files: version 5 by scipy, version 7.3 (HDF5) by h5py.

The size of arrays is checked before they are unpacked."""

from __future__ import annotations

import zlib
from collections.abc import Iterator, Sequence
from math import prod
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from nscc.npy import MOST_BYTES, check_size

_SIGNATURE = b"\x89HDF\r\n\x1a\n"
_USER_BLOCKS = (0, 512, 1024, 2048, 4096)
"""Offsets at which HDF5 may begin; MATLAB writes a header of 512 bytes before it."""
_HEADER_BYTES = 128
_COMPRESSED = 15
_BLOCK_BYTES = 1 << 20
_WIDEST_NUMBER = 8


def is_hdf5(path: Path) -> bool:
    """Return whether a file is HDF5, with or without a user block."""
    with open(path, "rb") as file:
        for start in _USER_BLOCKS:
            file.seek(start)
            if file.read(len(_SIGNATURE)) == _SIGNATURE:
                return True
    return False


def mat_shapes(path: Path) -> dict[str, tuple[int, ...]]:
    """Return the shapes of the variables in a .mat file of any version; () for variables that are
    not arrays. Raises the exceptions of scipy and h5py for a damaged file."""
    if is_hdf5(path):
        import h5py

        with h5py.File(path, "r") as file:
            stored = {name: file[name] for name in file if not name.startswith("#")}
            return {
                name: tuple(dataset.shape or ())[::-1] if isinstance(dataset, h5py.Dataset) else ()
                for name, dataset in stored.items()
            }
    from scipy.io import whosmat

    with open(path, "rb") as file:  # for a missing path scipy raises no FileNotFoundError
        return {str(name): tuple(shape) for name, shape, _ in whosmat(file)}


def mat_names(path: Path) -> list[str]:
    """Return the names of the variables in a .mat file of any version."""
    return [*mat_shapes(path)]


def mat_array(path: Path, name: str, most_bytes: int = MOST_BYTES) -> NDArray[Any]:
    """Read an array by name, with axes in MATLAB's order. Raises ValueError if it is not an array,
    and InvalidArrays if it needs more than `most_bytes`."""
    arrays = mat_arrays(path, [name], most_bytes)
    if name not in arrays:
        raise ValueError(f"'{name}' is not an array")
    return arrays[name]


def mat_arrays(
    path: Path, names: Sequence[str] | None = None, most_bytes: int = MOST_BYTES
) -> dict[str, NDArray[Any]]:
    """Read the named arrays of a .mat file of any version (None: all arrays); other variables are
    skipped.

    Raises InvalidArrays for more than `most_bytes`, and the exceptions of scipy and h5py for a
    damaged file."""
    if is_hdf5(path):
        return _of_hdf5(path, names, most_bytes)
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
        variables = loadmat(file, variable_names=names)
    return {
        name: values
        for name, values in variables.items()
        if name[:2] != "__" and isinstance(values, np.ndarray)
    }


def _unpacked_sizes(file: IO[bytes]) -> Iterator[int]:
    """Unpack the compressed elements of a version 5 file block by block, and yield the block sizes.
    The size in the header of an element may be wrong."""
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


def _of_hdf5(
    path: Path, names: Sequence[str] | None, most_bytes: int
) -> dict[str, NDArray[Any]]:  # fmt: skip
    import h5py

    with h5py.File(path, "r") as file:
        chosen_names = [name for name in file if name[:1] != "#"] if names is None else names
        stored = {name: file[name] for name in chosen_names if name in file}
        arrays = {
            name: dataset for name, dataset in stored.items() if isinstance(dataset, h5py.Dataset)
        }
        check_size(sum(map(_stated_bytes, arrays.values())), most_bytes)
        for dataset in arrays.values():
            _check_chunks(dataset)
        # MATLAB stores columns first: HDF5 has its axes the other way round.
        return {name: np.asarray(dataset).T for name, dataset in arrays.items()}


def _stated_bytes(stored: Any) -> int:
    """Return the number of bytes of the array, or of its largest chunk if larger."""
    shapes = (stored.shape or (), stored.chunks or ())
    return max(prod(map(int, shape)) for shape in shapes) * int(stored.dtype.itemsize)


def _check_chunks(stored: Any) -> None:
    """Raise InvalidArrays for a compressed chunk that unpacks to more than a chunk, because HDF5
    would allocate all the memory."""
    if stored.chunks is None or stored.compression != "gzip":
        return
    most = prod(stored.chunks) * stored.dtype.itemsize
    for index in range(stored.id.get_num_chunks()):
        offset = stored.id.get_chunk_info(index).chunk_offset
        mask, packed = stored.id.read_direct_chunk(offset)
        if mask == 0:
            check_size(len(zlib.decompressobj().decompress(packed, most + 1)), most)
