"""Reading pictures, clips, masks and measurements as arrays from untrusted files."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np

from nscc.arrays import Array, Floats
from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.diagnostics.suggest import meant
from nscc.files import reads
from nscc.npy import MOST_BYTES, InvalidArrays, check_size, npy_array, npz_arrays
from nscc_runtime.scenes.light_arrays import mat_array, mat_shapes
from nscc_training.problems import listed, unreadable

KEYS = ("image", "video", "truth_e", "light", "orig")
"""Array names to look for in a file with several arrays; the first one present is used."""

_MOST_BYTES = 1 << 28
"""Largest size of an array in bytes; a comparison of two arrays needs several times as much
memory."""

ARRAYS = (".mat", ".npy", ".npz")


def read_picture_or_clip(path: Path, key: str | None = None) -> Array:
    """Read one picture (rows, cols) or clip (T, rows, cols) of finite real numbers from the file
    `path`.

    Accepts `.npy`, `.npz` and `.mat` files; `key` names one of several arrays. None takes the first
    of `KEYS`, or the only array. The arrays `orig` and `video` of .mat files are (rows, cols, T)
    and are transposed. Also accepts linear pictures, as luminance, and grey display pictures, as
    stored. A clip of one frame is returned as a picture. Raises Rejected: NS0801 for a file that
    cannot be read, NS0802 for other shapes, NS0804 for values that are not finite."""
    array = _read(path, key)
    if array.dtype.kind not in "uifb":
        raise rejected(
            "NS0801",
            f"the array in '{path}' holds {array.dtype}, not real numbers",
            helps=("save it as float32, or as integers",),
        )
    if array.ndim == 3 and array.shape[0] == 1:
        array = array[0]
    if array.ndim not in (2, 3) or 0 in array.shape:
        raise rejected(
            "NS0802",
            f"the array in '{path}' has the shape {array.shape}",
            notes=("a picture is (rows, cols), a clip (T, rows, cols)",),
            helps=("save one picture or one clip, without axes for colours or batches",),
        )
    bad_count = int(np.count_nonzero(~np.isfinite(array))) if array.dtype.kind == "f" else 0
    if bad_count:
        raise rejected(
            "NS0804",
            f"{bad_count} of {array.size} values in '{path}' are not finite",
            notes=("a single such value makes every mean error meaningless",),
            helps=("find the source of these values; np.nan_to_num hides them",),
            data={"count": bad_count},
        )
    return array


def _read(path: Path, key: str | None) -> Array:
    """Return the array in a file, or the pictures of an image file as a stack.

    `key` names one of several arrays; None takes the first of `KEYS`, or the only array. A clip in
    a .mat file is turned to (frames, rows, cols). Raises Rejected (NS0801) for files that cannot be
    read."""
    suffix = path.suffix.lower()
    try:
        if not path.is_file():
            raise rejected("NS0801", f"'{path}' is not a file", helps=("name an existing file",))
        if suffix in ARRAYS:
            choose = partial(_chosen, path, key)
            _, name, array = _stored(path, choose, _MOST_BYTES)
            assert array is not None  # a name is chosen, or an error is raised
            turned = suffix == ".mat" and name in ("orig", "video") and array.ndim == 3
            return np.moveaxis(array, 2, 0) if turned else array
    except Rejected:
        raise
    except Exception as error:  # zipfile, numpy and scipy raise a dozen types for damaged files
        message = f"'{path}' cannot be read as a {suffix} file"
        hint = "check that the file is complete and that its ending matches its format"
        raise unreadable("NS0801", message, error, hint) from error
    return _read_image(path, suffix)


def _stored(
    path: Path, choose: Callable[[list[str]], str | None], most_bytes: int = MOST_BYTES
) -> tuple[list[str], str | None, Array | None]:
    """Return the names of the arrays in a .mat, .npy or .npz file, the name that `choose` selects
    from them, and its array.

    Name and array are None if `choose` returns None. A .npy file has no names: the list is empty,
    the name None, and `choose` is not called. An array above `most_bytes` raises InvalidArrays."""
    suffix = path.suffix.lower()
    if suffix == ".npy":
        return [], None, npy_array(path, most_bytes)
    names = npz_arrays(path, lambda _: False)[1] if suffix == ".npz" else [*mat_shapes(path)]
    name = choose(names)
    if name is None:
        return names, None, None
    if suffix == ".npz":
        return names, name, npz_arrays(path, name.__eq__, most_bytes)[0][name]
    return names, name, mat_array(path, name, most_bytes)


def _chosen(path: Path, key: str | None, names: list[str]) -> str:
    """Return the name of the array to read: `key` if it is not None, else the first of `KEYS` that
    the file has, else its only array.

    Raises Rejected (NS0801), with the names in the file at `path`, if there is no such array."""
    candidates = [key] if key is not None else [name for name in KEYS if name in names]
    if key is None and not candidates and len(names) == 1:
        candidates = names
    if candidates and candidates[0] in names:
        return candidates[0]
    looked = f"nscc looks for {', '.join(KEYS)}"
    unnamed = f"name the array with --truth-key or --rec-key; without them, {looked}"
    raise rejected(
        "NS0801",
        f"'{path}' has no array '{key}'"
        if key
        else f"nscc cannot tell which array of '{path}' to use",
        notes=(f"it holds {listed(sorted(names))}",),
        helps=meant(key or "", names, unnamed),
    )


def _read_image(path: Path, suffix: str) -> Array:
    """Return the picture in an image file as (rows, cols), or several as (pictures, rows, cols).

    `suffix` is its ending in lower case. Linear colours become luminance. A colour picture whose
    three channels are equal counts as grey. Raises Rejected (NS0801) for other colour pictures, for
    unknown endings, and for more than `_MOST_BYTES`."""
    from nscc_runtime.scenes.colour import grey
    from nscc_runtime.scenes.picture_files import PICTURES, open_pages

    if suffix not in PICTURES:
        raise rejected(
            "NS0801",
            f"the ending of '{path}' is not a format for pictures or arrays",
            notes=(f"arrays end in {', '.join(ARRAYS)}, pictures in {', '.join(PICTURES)}",),
            helps=("give the file the ending of its format",),
        )
    pages = open_pages(path)
    pictures: list[Array] = []
    for picture in pages.read():
        pictures.append(picture)
        try:
            check_size((len(pictures) - 1) * picture.nbytes, _MOST_BYTES)
        except InvalidArrays as error:
            message = f"'{path}' holds too many pictures"
            raise unreadable("NS0801", message, error, "save fewer pictures in a file") from error
    if pages.is_light and pictures[0].ndim == 3:
        pictures = [grey(picture, pages.colours, channel=None) for picture in pictures]
    stored = np.stack(pictures) if len(pictures) > 1 else pictures[0]
    if pictures[0].ndim == 2:
        return stored
    # Three equal channels are a grey picture.
    if (stored == stored[..., :1]).all():
        return stored[..., 0]
    raise rejected(
        "NS0801",
        f"'{path}' is a colour picture",
        notes=("the sensor and its reconstructions have one channel",),
        helps=("compare luminance: convert the picture to grey, or use a linear one (.exr .hdr)",),
    )


MOST = 1e15
"""Largest value of a measurement: its square fits single precision."""


def array_names(path: Path) -> list[str]:
    """Return the names of the arrays in a .mat or .npz file. Raise Rejected (NS0845) if it cannot
    be read."""
    return _named(path, None)[0]


def real_array(path: Path, name: str) -> Floats:
    """Return the array `name` of the .mat, .npy or .npz file `path` as float64. All values are
    finite real numbers, at most `MOST` in magnitude. A .npy file has only one array. For the name
    "mask", the only array of another file counts, too.

    Raises
    ------
    Rejected
        NS0845 for a file without such an array, or with other values.
    """
    names, array = _named(path, name)
    if array is None:
        raise refused(path, f"the array `{name}` is missing", f"it holds {listed(sorted(names))}")
    if array.dtype.kind not in "uifb":
        raise refused(path, f"`{name}` holds {array.dtype}, not real numbers")
    values = np.asarray(array, np.float64)
    bad_count = int(np.count_nonzero(~np.isfinite(values)))
    if bad_count:
        raise refused(path, f"{bad_count} of {values.size} values of `{name}` are not finite")
    if (np.abs(values) > MOST).any():
        raise refused(path, f"`{name}` has values beyond {MOST:g}")
    return values


def _named(path: Path, name: str | None) -> tuple[list[str], Array | None]:
    """Return the names of the arrays in the file `path` (none for .npy), and the array `name`.

    For the name "mask", the only array of a file counts, whatever its name. The array is None if it
    is missing, or if `name` is None. Raises Rejected (NS0845) if the file cannot be read."""
    reads(path)
    suffix = path.suffix.lower()
    if suffix not in ARRAYS or not path.is_file():
        reason = f"it does not end in {', '.join(ARRAYS)}"
        raise refused(path, reason if path.is_file() else "the file does not exist")

    def choose(names: list[str]) -> str | None:
        """Return the wanted name if the file has it; None, to read nothing, if it does not. The
        only array of a file may be a mask by any name."""
        if name is None or name in names:
            return name
        return names[0] if len(names) == 1 and name == "mask" else None

    try:
        names, _, array = _stored(path, choose)
        return names, array
    except (Rejected, ImportError):
        raise
    except Exception as error:  # numpy, scipy, h5py and zipfile raise a dozen types
        message = f"'{path}' cannot be read as a {suffix} file"
        raise unreadable("NS0845", message, error, "save the arrays again") from error


def read_mask(path: Path) -> Floats:
    """Return the array `mask` of the file `path`, or its only array: three axes, values 0 to 1,
    float64. Which axis counts slots is not decided here.

    Raises
    ------
    Rejected
        NS0845 for a file that cannot be read or has no such array, for values that are not finite
        real numbers from 0 to 1 or are all 0, and for other numbers of axes.
    """
    mask = real_array(path, "mask")
    if mask.ndim != 3 or 0 in mask.shape:
        reason = f"`mask` has the shape {mask.shape}"
        raise refused(path, reason, "a mask is (rows, cols, slots) or (slots, rows, cols)")
    low, high = float(mask.min()), float(mask.max())
    if low < 0 or high > 1:
        raise refused(
            path,
            f"`mask` has values from {low:g} to {high:g}",
            "a mask is the fraction of each slot in which a pixel is open, 0 to 1; divide "
            "by the largest value",
        )
    if high == 0:
        raise refused(path, "`mask` is 0 everywhere: no pixel ever opens")
    return mask


def ambiguous_axes(path: Path, shape: tuple[int, ...]) -> Rejected:
    """Return the error (NS0845), for the caller to raise, that the mask in file `path` can be read
    in two ways: slots first or slots last. `shape` is the sizes of its three axes."""
    first, middle, last = shape
    return rejected(
        "NS0845",
        f"the mask in '{path}' is {first} x {middle} x {last}, which can be read in two ways",
        notes=(
            f"slots last: {first} x {middle} pixels, {last} slots",
            f"slots first: {first} slots, {middle} x {last} pixels",
        ),
        helps=("--slots-axis last or --slots-axis first selects one of them",),
    )


def is_square_tile(shape: tuple[int, ...]) -> bool:
    """Return whether a mask of three axes must be (rows, cols, slots): the first two sizes are
    equal, the last is another."""
    return shape[0] == shape[1] != shape[2]


def refused(path: Path, reason: str, note: str = "") -> Rejected:
    """Return the error (NS0845) that the file `path` has no usable mask and measurement, because of
    `reason`. `note`, if not empty, is a fact printed below it."""
    return rejected(
        "NS0845",
        f"'{path}' cannot be used: {reason}",
        notes=(note,) if note else (),
        helps=(
            "np.savez(FILE, mask=mask, meas=meas): mask (rows, cols, slots) or (slots, rows, "
            "cols), meas (rows, cols) or (rows, cols, K)",
        ),
    )
