"""Formats of arrays: numpy's, and MATLAB's in the layout of the benchmark of snapshot compressive
imaging."""

from __future__ import annotations

import io
import zipfile
from types import SimpleNamespace
from typing import IO

import numpy as np

from nscc.files import Product
from nscc_runtime.formats.content import Arrays, Content


def npz(content: Content) -> bytes:
    """Return an .npz file of all arrays by name; equal arrays give equal bytes."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_STORED) as archive:
        for name, values in content.arrays.items():
            entry = io.BytesIO()
            np.lib.format.write_array(entry, np.asarray(values))
            archive.writestr(zipfile.ZipInfo(f"{name}.npy"), entry.getvalue())
    return stream.getvalue()


def npy(content: Content) -> Product:
    """Return a function that writes an .npy file of the main array to a stream."""
    first = content.main or (lambda: next(iter(content.arrays.values())))

    def write(file: IO[bytes]) -> None:
        # Hide the file's type from numpy, which would seek in it: pipes cannot seek.
        np.lib.format.write_array(SimpleNamespace(write=file.write), np.asarray(first()))

    return write


def mat(content: Content) -> bytes:
    """Return a compressed MATLAB file of version 5; time is the last axis."""
    from scipy.io import savemat

    arrays: Arrays = content.arrays if content.benchmark is None else content.benchmark()
    stream = io.BytesIO()
    savemat(stream, dict(arrays), do_compression=True)
    # The header's text, 116 bytes, contains the time; replace it.
    head = b"MATLAB 5.0 MAT-file, written by nscc".ljust(116)
    return head + stream.getvalue()[116:]
