"""Read scenes as arrays: `light` in electrons in .npz, .npy and .mat, `orig` clips in .mat.

An .npz or .npy array is checked by its header before its data is read."""

from __future__ import annotations

import zipfile
import zlib
from collections.abc import Callable, Iterator, Sequence
from math import prod
from pathlib import Path
from typing import IO, Any

import numpy as np

from nscc.arrays import Array, Floats32
from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.npy import MOST_BYTES, check_size, npy_header, npy_values
from nscc_runtime.scenes.errors import damaged, refuse_no_light, size
from nscc_runtime.scenes.pages import head_of

_SIGNATURE = b"\x89HDF\r\n\x1a\n"
_USER_BLOCKS = (0, 512, 1024, 2048, 4096)
"""Offsets at which HDF5 may begin; MATLAB writes a header of 512 bytes before it."""
_HEADER_BYTES = 128
"""Length of the header of a version 5 .mat file."""
_COMPRESSED = 15
"""Number of the type of compressed elements in a version 5 .mat file."""
_BLOCK_BYTES = 1 << 20
"""Number of bytes that are unpacked at a time."""
_WIDEST_NUMBER = 8
"""Bytes of the largest number (double), because `whosmat` does not tell the type."""


def is_hdf5(path: Path) -> bool:
    """Return whether the file `path` is HDF5 (MATLAB 7.3), also behind a block of up to 4096 bytes
    of other data. Raises OSError if it cannot be read."""
    head = head_of(path)
    return any(head.startswith(_SIGNATURE, start) for start in _USER_BLOCKS)


def mat_shapes(path: Path) -> dict[str, tuple[int, ...]]:
    """Return the shapes of the variables in a .mat file of any version, by name, with axes in
    MATLAB's order. HDF5 files have () for variables that are not arrays. Raises FileNotFoundError,
    and the exceptions of scipy and h5py for a damaged file."""
    if is_hdf5(path):
        import h5py

        with h5py.File(path, "r") as file:
            stored = {name: file[name] for name in file if not name.startswith("#")}
            return {
                # MATLAB stores columns first: HDF5 has its axes the other way round.
                name: tuple(dataset.shape or ())[::-1] if isinstance(dataset, h5py.Dataset) else ()
                for name, dataset in stored.items()
            }
    from scipy.io import whosmat

    with open(path, "rb") as file:  # for a missing path scipy raises no FileNotFoundError
        return {str(name): tuple(shape) for name, shape, _ in whosmat(file)}


def mat_array(path: Path, name: str, most_bytes: int = MOST_BYTES) -> Array:
    """Read the array `name` of a .mat file of any version, with axes in MATLAB's order. Raises
    ValueError if there is no such array, InvalidArrays if it needs more than `most_bytes`, and the
    exceptions of scipy and h5py for a damaged file."""
    arrays = mat_arrays(path, [name], most_bytes)
    if name not in arrays:
        raise ValueError(f"'{name}' is not an array")
    return arrays[name]


def mat_arrays(
    path: Path, names: Sequence[str] | None = None, most_bytes: int = MOST_BYTES
) -> dict[str, Array]:
    """Read arrays of a .mat file of any version, by name, with axes in MATLAB's order.

    `names`: the arrays to read, None for all. Names that are missing, and variables that are no
    arrays, are left out. Raises InvalidArrays for more than `most_bytes`, and the exceptions of
    scipy and h5py for a damaged file."""
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
    """Unpack the compressed elements of the version 5 .mat file `file` block by block, and yield
    the number of bytes of each block.

    The caller adds them up and stops at its limit: the size in the header of an element may be
    wrong. Yields nothing for other versions, which are not compressed. Raises zlib.error for
    damaged data."""
    head = file.read(_HEADER_BYTES)
    orders = {b"IM": "<", b"MI": ">"}  # the letters show in which order a machine wrote bytes
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


def _of_hdf5(path: Path, names: Sequence[str] | None, most_bytes: int) -> dict[str, Array]:
    """Return arrays of a MATLAB 7.3 file by name, with axes in MATLAB's order. `names`: the arrays
    to read, None for all; missing names and variables that are no arrays are left out. Raises
    InvalidArrays, before data is read, if they need more than `most_bytes`."""
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
    """Return the number of bytes of the h5py dataset `stored`, or of its largest chunk if that is
    larger; HDF5 unpacks whole chunks."""
    shapes = (stored.shape or (), stored.chunks or ())
    return max(prod(map(int, shape)) for shape in shapes) * int(stored.dtype.itemsize)


def _check_chunks(stored: Any) -> None:
    """Raise InvalidArrays if a compressed chunk of the h5py dataset `stored` unpacks to more than
    the size of a chunk, because HDF5 would allocate all the memory. Datasets without chunks or gzip
    pass."""
    if stored.chunks is None or stored.compression != "gzip":
        return
    most = prod(stored.chunks) * stored.dtype.itemsize
    for index in range(stored.id.get_num_chunks()):
        offset = stored.id.get_chunk_info(index).chunk_offset
        mask, packed = stored.id.read_direct_chunk(offset)
        if mask == 0:  # all filters were applied, so the chunk is compressed
            # One byte more than allowed is unpacked, which shows that there is too much.
            check_size(len(zlib.decompressobj().decompress(packed, most + 1)), most)


KEY = "light"
MAT_CLIP_KEY = "orig"
Check = Callable[[tuple[int, ...]], None]
"""A function that raises Rejected for a shape of light that does not fit the program."""


def check_type(name: Path | str, key: str, dtype: np.dtype[Any]) -> None:
    """Raise Rejected (NS0733) unless `dtype`, the type of array `key` of file `name`, is of real
    numbers."""
    if dtype.kind in "uif":
        return
    kinds = {"b": "true/false", "c": "complex", "O": "pickled objects", "U": "text", "S": "text"}
    kind = kinds.get(dtype.kind, f"of type {dtype}"[:60])
    raise rejected(
        "NS0733",
        f"'{key}' in '{name}' is {kind}, not real numbers",
        helps=("save it as float32: np.savez(file, light=a.astype(np.float32))",),
    )


def check_shape(name: str, shape: tuple[int, ...], slots: int, need: tuple[int, int]) -> None:
    """Raise Rejected for a `light` array of this `shape` in the scene `name` that does not fit a
    program with `slots` slots and an array of size `need` (rows, cols).

    NS0733: not two or three axes, or axes in another order. NS0734: another size. NS0735: a clip
    with another number of frames."""
    _refuse_other_axes(name, shape, slots, need)
    if len(shape) not in (2, 3):
        raise rejected(
            "NS0733",
            f"'light' in '{name}' has {len(shape)} dimension{'s' * (len(shape) != 1)}: "
            f"{size(shape)}",
            notes=(f"a still is (rows, cols) = {size(need)}, a clip (slots, rows, cols)",),
            helps=("give the array two or three dimensions",),
        )
    if tuple(shape[-2:]) != need:
        raise rejected(
            "NS0734",
            f"'light' in '{name}' is {size(shape[-2:])}, but the array is {size(need)}",
            notes=("sizes are rows x columns; light in electrons is not cropped or scaled",),
            helps=("crop the array to that size, or use a target of the scene's size",),
            data={"scene": list(shape[-2:]), "array": list(need)},
        )
    if len(shape) == 3 and shape[0] != slots:
        raise rejected(
            "NS0735",
            f"'light' in '{name}' has {shape[0]} frame{'' if shape[0] == 1 else 's'}, but "
            f"the program has {slots} slots",
            notes=("a light array contains the electrons of each slot: one frame per slot",),
            helps=(
                "use a program with as many slots, or a still: (rows, cols), electrons per second",
            ),
            data={"frames": shape[0], "needed": slots},
        )


def _refuse_other_axes(
    name: str, shape: tuple[int, ...], slots: int, need: tuple[int, int]
) -> None:
    """Raise Rejected (NS0733) if light of this `shape` in the scene `name` has the axes of other
    tools: time or colour last. Other shapes pass.

    `slots` is the number of slots, `need` (rows, cols) the size of the array."""
    count = shape[-1] if len(shape) in (3, 4) else 0
    # Rows and columns lie before the last axis, and not also at the end, where they belong.
    if shape[-3:-1] != need or tuple(shape[-2:]) == need:
        return
    subject = f"'light' in '{name}' is {size(shape)}"
    grey = (
        "light has no colour: `a @ [0.2126, 0.7152, 0.0722]` computes the luminance of red, "
        "green, blue"
    )
    ahead = "time must be the first axis: `np.moveaxis(a, -1, 0)`"
    if count in (3, 4):
        message = f"{subject}: this looks like a colour picture, but light is one number per pixel"
        helps = (grey, ahead) if len(shape) == 3 and count == slots else (grey,)
    elif len(shape) == 3:
        message, helps = f"{subject}: this looks like (rows, cols, slots)", (ahead,)
    else:
        return
    raise rejected(
        "NS0733",
        message,
        notes=(f"a still is (rows, cols) = {size(need)}, a clip (slots, rows, cols)",),
        helps=helps,
    )


def read_light(path: Path, check: Check) -> Floats32:
    """Read the array `light` of an .npz or .npy file: float32, (T, rows, cols) or (rows, cols).

    Raises Rejected: NS0732 for a damaged file, NS0733 for a missing key or another kind of numbers,
    NS0736 for values that are not light, and what `check` raises for the shape."""
    try:
        if path.suffix.lower() == ".npy":
            with open(path, "rb") as file:
                return _read_npy(file, path, check)
        with zipfile.ZipFile(path) as archive:
            names = archive.namelist()
            if f"{KEY}.npy" not in names:
                raise missing_key(path, [name.removesuffix(".npy") for name in names], (KEY,))
            with archive.open(f"{KEY}.npy") as entry:
                return _read_npy(entry, path, check)
    except Rejected:
        raise
    except Exception as error:  # zipfile and numpy raise a dozen types for damaged files
        raise damaged(path, error) from error


def missing_key(path: Path, have: list[str], keys: tuple[str, ...]) -> Rejected:
    """Return the error NS0733 that the file `path` has none of the arrays `keys` of a scene. `have`
    are the names of its arrays; if they are those of a frame file, the help says how to decode
    it."""
    shown = ", ".join(repr(name[:40]) for name in sorted(have)[:12]) or "nothing"
    further = f" and {len(have) - 12} more" if len(have) > 12 else ""
    names = " or ".join(f"'{key}'" for key in keys)
    help_text = (
        "save the scene's light under that name: np.savez(file, light=a), electrons per slot "
        "(T, rows, cols) or electrons per second (rows, cols)"
    )
    if {"frame", "meta"} <= set(have):
        help_text = f"it is a frame file: `nscc reconstruct any {path} -o OUT.png` decodes it"
    return rejected(
        "NS0733",
        f"'{path}' has no array {names}",
        notes=(f"it holds {shown}{further}",),
        helps=(help_text,),
    )


def _read_npy(file: IO[bytes], path: Path, check: Check) -> Floats32:
    """Return the light in the open .npy file `file`; `path` is for messages.

    `check` gets its shape before data is read, and raises if it does not fit. Raises ValueError for
    damaged data, and Rejected: NS0733 for other numbers, NS0736 for values that are not light."""
    _, shape, fortran, dtype = npy_header(file)
    check_type(path, KEY, dtype)
    check(shape)
    values = npy_values(file, shape, fortran, dtype)
    if values is None:
        raise ValueError("its array is cut short or too long")
    return _light_of(path, values)


def _light_of(path: Path, values: Array) -> Floats32:
    """Return `values` of the file `path` as float32 in C order. Raises NS0736 for values that are
    not light."""
    refuse_no_light(values, path)
    return np.require(values, np.float32, ["C"])


def clip_white(clip: Array) -> float | None:
    """Return the white level of a clip in a .mat file: 255 for floats that exceed 1, as in the
    benchmark; None for the default of the type."""
    return 255.0 if clip.dtype.kind == "f" and float(clip.max()) > 1 else None


def read_mat(path: Path, check: Check) -> tuple[str, Array]:
    """Read the scene in the .mat file `path`, as a pair of key and array: "light" with a float32
    array, or "orig" with an array (rows, cols, T) as stored. `light` has precedence.

    `check` gets the shape of `light` and raises if it does not fit. Raises Rejected like
    `read_light`, NS0733 also for an `orig` of other dimensions or without frames; ImportError
    without scipy or h5py."""
    keys = (KEY, MAT_CLIP_KEY)
    try:
        names = [*mat_shapes(path)]
        key = next((k for k in keys if k in names), None)
        if key is None:
            raise missing_key(path, names, keys)
        array = mat_array(path, key)
    except (Rejected, ImportError):
        raise
    except Exception as error:  # scipy.io and h5py raise a dozen types for damaged files
        raise damaged(path, error) from error
    check_type(path, key, array.dtype)
    if key == KEY:
        check(array.shape)
        return key, _light_of(path, array)
    if array.ndim != 3 or 0 in array.shape:
        raise rejected(
            "NS0733",
            f"'{key}' in '{path}' is {size(array.shape)}, not (rows, cols, T)",
            helps=("a clip is three-dimensional, time last, with at least one frame",),
        )
    return key, array
