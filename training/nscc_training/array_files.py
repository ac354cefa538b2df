"""Reading pictures and clips as arrays from untrusted files."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected
from nscc.diagnostics.suggest import meant
from nscc.npy import InvalidArrays, check_size, npy_array, npz_arrays
from nscc_runtime.scenes.light_arrays import mat_array, mat_names
from nscc_training.problems import listed, unreadable

KEYS = ("image", "video", "truth_e", "light", "orig")
"""Array names to look for in a file with several arrays; the first one present is used."""

_MOST_BYTES = 1 << 28
"""Largest size of an array in bytes; a comparison of two arrays needs several times as much
memory."""

ARRAYS = (".mat", ".npy", ".npz")


def read_picture_or_clip(path: Path, key: str | None = None) -> NDArray[Any]:
    """Read the array of a file: (rows, cols) or (T, rows, cols), finite real numbers.

    Accepts `.npy`, `.npz` and `.mat` files; `key` names one of several arrays. The arrays `orig`
    and `video` of .mat files are (rows, cols, T) and are transposed. Also accepts linear pictures,
    as luminance, and grey display pictures, as stored. Raises Rejected: NS0801 for a file that
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


def _read(path: Path, key: str | None) -> NDArray[Any]:
    suffix = path.suffix.lower()
    try:
        if not path.is_file():
            raise rejected("NS0801", f"'{path}' is not a file", helps=("name an existing file",))
        if suffix in ARRAYS:
            return _read_array(path, suffix, key)
    except Rejected:
        raise
    except Exception as error:  # zipfile, numpy and scipy raise a dozen types for damaged files
        message = f"'{path}' cannot be read as a {suffix} file"
        hint = "check that the file is complete and that its ending matches its format"
        raise unreadable("NS0801", message, error, hint) from error
    return _read_image(path, suffix)


def _read_array(path: Path, suffix: str, key: str | None) -> NDArray[Any]:
    if suffix == ".npy":
        return npy_array(path, _MOST_BYTES)
    if suffix == ".npz":
        _, names = npz_arrays(path, lambda _: False)
        name = _chosen(path, names, key)
        return npz_arrays(path, name.__eq__, _MOST_BYTES)[0][name]
    name = _chosen(path, mat_names(path), key)
    array = mat_array(path, name, _MOST_BYTES)
    return np.moveaxis(array, 2, 0) if name in ("orig", "video") and array.ndim == 3 else array


def _chosen(path: Path, names: list[str], key: str | None) -> str:
    candidates = [key] if key is not None else [name for name in KEYS if name in names]
    if key is None and not candidates and len(names) == 1:
        candidates = names
    if candidates and candidates[0] in names:
        return candidates[0]
    unnamed = f"name the array with an option; without one, nscc looks for {', '.join(KEYS)}"
    raise rejected(
        "NS0801",
        f"'{path}' has no array '{key}'"
        if key
        else f"'{path}' contains several arrays, and nscc cannot tell which one to use",
        notes=(f"it holds {listed(sorted(names))}",),
        helps=meant(key or "", names, unnamed),
    )


def _pages(path: Path) -> list[NDArray[Any]]:
    """Return the pictures of a file; raise an error if several pictures exceed the size limit of
    arrays."""
    from nscc_runtime.scenes.picture_files import open_pages

    pages: list[NDArray[Any]] = []
    for page in open_pages(path).read():
        pages.append(page)
        try:
            check_size((len(pages) - 1) * page.nbytes, _MOST_BYTES)
        except InvalidArrays as error:
            message = f"'{path}' holds too many pictures"
            raise unreadable("NS0801", message, error, "save fewer pictures in a file") from error
    return pages


def _read_image(path: Path, suffix: str) -> NDArray[Any]:
    from nscc_runtime.scenes.colour import linear, luminance
    from nscc_runtime.scenes.picture_files import LINEAR, PICTURES

    if suffix not in PICTURES:
        raise rejected(
            "NS0801",
            f"the ending of '{path}' is not a format for pictures or arrays",
            notes=(f"arrays end in {', '.join(ARRAYS)}, pictures in {', '.join(PICTURES)}",),
            helps=("give the file the ending of its format",),
        )
    pages = _pages(path)
    stored = np.stack(pages) if len(pages) > 1 else pages[0]
    if pages[0].ndim == 2:
        return stored
    if suffix in LINEAR:
        return luminance(linear(stored, "linear"))
    if (stored == stored[..., :1]).all():
        return stored[..., 0]
    raise rejected(
        "NS0801",
        f"'{path}' is a colour picture",
        notes=("the sensor and its reconstructions have one channel",),
        helps=("compare luminance: convert the picture to grey, or use a linear one (.exr .hdr)",),
    )
