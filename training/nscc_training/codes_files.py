"""Code files, `.npz` and `.mat`: an integer array per field, and `book` for a codebook."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nscc.arrays import Ints
from nscc.diagnostics.arguments import as_array, path_of, shown, wrong_argument
from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.files import write_whole
from nscc.npy import npz_arrays
from nscc_runtime.scenes.light_arrays import mat_arrays
from nscc_training.problems import unreadable

Codes = Mapping[str, Ints]


def codes_bytes(codes: Codes) -> bytes:
    """Return codes as the content of an .npz file, with an array for each field in the smallest
    type. The same codes give the same bytes, whatever the time and the order of the fields."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in sorted(codes):
            entry = io.BytesIO()
            np.lib.format.write_array(entry, _small(codes[name]), version=(1, 0))
            # The earliest date of the format; the present one would make bytes differ.
            info = zipfile.ZipInfo(f"{name}.npy", (1980, 1, 1, 0, 0, 0))
            archive.writestr(info, entry.getvalue(), zipfile.ZIP_DEFLATED)
    return stream.getvalue()


def save_codes(path: Path | str, codes: Codes) -> None:
    """Write codes to a file.

    Parameters
    ----------
    path : Path or str
        Ends in `.npz` or `.mat`.
    codes : mapping of str to array of int
        Values (rows, cols) by field.

    Raises
    ------
    Rejected
        NS0805 for another ending or other contents, NS0784 if the file cannot be written.
    """
    out = _path("save_codes", path)
    if not isinstance(codes, Mapping):
        raise wrong_argument(f"save_codes takes arrays by the names of fields, not {shown(codes)}")
    arrays = {
        str(name): _integers(out, str(name), as_array("save_codes", f"'{name}'", values))
        for name, values in codes.items()
    }
    if out.suffix.lower() == ".npz":
        write_whole(out, codes_bytes(arrays))
    else:
        from scipy.io import savemat

        write_whole(out, lambda file: savemat(file, arrays, do_compression=True))


def load_codes(path: Path | str) -> dict[str, Ints]:
    """Read codes from a file.

    Parameters
    ----------
    path : Path or str
        A `.npz` or `.mat` file of integer arrays. Floats that are whole numbers count as integers,
        because MATLAB saves them so.

    Returns
    -------
    dict of str to array of int64

    Raises
    ------
    Rejected
        NS0805 for a file that cannot be read or has other contents.
    """
    path = _path("load_codes", path)
    try:
        if path.suffix.lower() == ".mat":
            arrays = mat_arrays(path)
        else:
            arrays, _ = npz_arrays(path)
        return {name: _integers(path, name, values) for name, values in arrays.items()}
    except Rejected:
        raise
    except Exception as error:  # numpy, zipfile and scipy raise a dozen types for damaged files
        hint = "codes are .npz or .mat files with one integer array (rows, cols) per field"
        message = f"the codes in '{path}' cannot be read"
        raise unreadable("NS0805", message, error, hint) from error


def _path(call: str, value: object) -> Path:
    """Return the argument `value` of the function `call` as the path of a code file. Raises
    Rejected (NS0805) unless it ends in .npz or .mat."""
    path = path_of(call, value)
    if path.suffix.lower() not in (".npz", ".mat"):
        raise rejected(
            "NS0805",
            f"the ending of '{path}' is not a format for codes",
            notes=("codes are .npz or .mat files with one integer array (rows, cols) per field",),
            helps=(
                "`nscc import-mask MASK.npy -o P.nsl` converts an array of open slots to a program",
            )
            if path.suffix.lower() == ".npy"
            else ("give the file the ending of its format",),
        )
    return path


def _integers(path: Path, name: str, values: NDArray[np.generic]) -> Ints:
    """Return `values` as the codes of a field, int64 (rows, cols). Raise Rejected (NS0805) for
    other types or shapes.

    `name` is the field and `path` the file, for the message. Floats that are whole numbers are
    accepted."""
    integral = values.dtype.kind in "iub"
    if values.dtype.kind == "f":
        reals = values.astype(np.float64)
        # Larger floats do not represent all whole numbers.
        integral = bool((np.abs(reals) < 2**53).all() and (np.rint(reals) == reals).all())
    if values.dtype.kind == "u" and values.size and int(values.max()) > np.iinfo(np.int64).max:
        integral = False
    if not integral or values.ndim != 2 or values.size == 0:
        raise rejected(
            "NS0805",
            f"'{name}' in '{path}' is not a code: {values.dtype}, {values.shape}",
            notes=("the codes of a field are integers, (rows, cols) of the tile or of the array",),
            helps=(
                "save only integers in the file",
                "`nscc import-mask MASK.npz -o P.nsl` converts a mask of open slots to a program",
            ),
        )
    return values.astype(np.int64)


def _small(values: Ints) -> NDArray[np.generic]:
    """Return the values, of any shape and at least one, in the first of uint8, uint16 and int32
    that holds all of them; if none does, return them unchanged."""
    low, high = int(values.min()), int(values.max())
    for kind in (np.uint8, np.uint16, np.int32):
        if np.iinfo(kind).min <= low and high <= np.iinfo(kind).max:
            return values.astype(kind)
    return values
