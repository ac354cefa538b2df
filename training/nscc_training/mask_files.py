"""Reading masks and measurements of snapshot compressive imaging from untrusted files."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected
from nscc.files import reads
from nscc.npy import npy_array, npz_arrays
from nscc_runtime.scenes.light_arrays import mat_array, mat_names
from nscc_training.problems import listed, unreadable

ENDINGS = (".mat", ".npy", ".npz")
Floats = NDArray[np.float64]

_MOST = 1e15
"""Largest value of a measurement: its square fits single precision."""


def array_names(path: Path) -> list[str]:
    """Return the names of the arrays in a .mat or .npz file; empty for an .npy file.

    Raises Rejected (NS0845) for another file."""
    return _read(path, None)[0]


def real_array(path: Path, name: str) -> Floats:
    """Return the array `name` of a file, or its only array; all values are finite real numbers.

    Raises
    ------
    Rejected
        NS0845 for a file without such an array, or with other values.
    """
    names, array = _read(path, name)
    if array is None:
        raise refused(path, f"the array `{name}` is missing", f"it holds {listed(sorted(names))}")
    if array.dtype.kind not in "uifb":
        raise refused(path, f"`{name}` holds {array.dtype}, not real numbers")
    values = np.asarray(array, np.float64)
    bad_count = int(np.count_nonzero(~np.isfinite(values)))
    if bad_count:
        raise refused(path, f"{bad_count} of {values.size} values of `{name}` are not finite")
    if (np.abs(values) > _MOST).any():
        raise refused(path, f"`{name}` has values beyond {_MOST:g}")
    return values


def _read(path: Path, name: str | None) -> tuple[list[str], NDArray[Any] | None]:
    """Return the names in a file, and the array `name` or the only array; None without that
    array."""
    reads(path)
    suffix = path.suffix.lower()
    if suffix not in ENDINGS or not path.is_file():
        reason = (
            f"it does not end in {', '.join(ENDINGS)}"
            if path.is_file()
            else "the file does not exist"
        )
        raise refused(path, reason)
    try:
        if suffix == ".npy":
            return [], npy_array(path)
        if suffix == ".npz":
            _, names = npz_arrays(path, lambda _: False)
            chosen = _chosen(names, name)
            if chosen is None or chosen not in names:
                return names, None
            return names, npz_arrays(path, chosen.__eq__)[0][chosen]
        names = mat_names(path)
        chosen = _chosen(names, name)
        return names, None if chosen is None else mat_array(path, chosen)
    except (Rejected, ImportError):
        raise
    except Exception as error:  # numpy, scipy, h5py and zipfile raise a dozen types
        message = f"'{path}' cannot be read as a {suffix} file"
        raise unreadable("NS0845", message, error, "save the arrays again") from error


def _chosen(names: list[str], name: str | None) -> str | None:
    if name is None or name in names:
        return name
    return names[0] if len(names) == 1 and name == "mask" else None


def read_mask(path: Path) -> Floats:
    """Return the array `mask` of a file, or its only array: three axes, values from 0 to 1.

    Raises
    ------
    Rejected
        NS0845 as for `real_array`, and for other shapes and values.
    """
    mask = real_array(path, "mask")
    if mask.ndim != 3 or 0 in mask.shape:
        reason = f"`mask` has the shape {mask.shape}"
        raise refused(path, reason, "a mask is (rows, cols, slots) or (slots, rows, cols)")
    low, high = float(mask.min()), float(mask.max())
    if low < 0 or high > 1:
        raise refused(
            path, f"`mask` has values from {low:g} to {high:g}",
            "a mask is the fraction of each slot in which a pixel is open, 0 to 1; divide "
                "by the largest value",
        )  # fmt: skip
    if high == 0:
        raise refused(path, "`mask` is 0 everywhere: no pixel ever opens")
    return mask


def refused(path: Path, reason: str, note: str = "") -> Rejected:
    """Return the error (NS0845) for a file without a usable mask and measurement."""
    return rejected(
        "NS0845",
        f"'{path}' cannot be used: {reason}",
        notes=(note,) if note else (),
        helps=(
            "np.savez(FILE, mask=mask, meas=meas): mask (rows, cols, slots) or (slots, rows, "
            "cols), meas (rows, cols) or (rows, cols, K)",
        ),
    )
