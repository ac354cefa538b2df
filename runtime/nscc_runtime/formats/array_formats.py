"""Arrays as files: numpy's own, and MATLAB's as the benchmark of snapshot compressive imaging."""

from __future__ import annotations

import io
import zipfile
from types import SimpleNamespace
from typing import IO

import numpy as np

from nscc.files import Product
from nscc_runtime.formats.content import Arrays, Content


def npz(content: Content) -> bytes:
    """All arrays by name; the same arrays, the same bytes."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_STORED) as archive:
        for name, values in content.arrays.items():
            entry = io.BytesIO()
            np.lib.format.write_array(entry, np.asarray(values))
            archive.writestr(zipfile.ZipInfo(f"{name}.npy"), entry.getvalue())
    return stream.getvalue()


def npy(content: Content) -> Product:
    """The main array."""
    first = content.main or (lambda: next(iter(content.arrays.values())))

    def write(file: IO[bytes]) -> None:
        # By blocks: in what numpy knows as a file it seeks, and a pipe cannot.
        np.lib.format.write_array(SimpleNamespace(write=file.write), np.asarray(first()))

    return write


def mat(content: Content) -> bytes:
    """A file of MATLAB's version 5, compressed; time is the last axis in it."""
    from scipy.io import savemat

    arrays: Arrays = content.arrays if content.benchmark is None else content.benchmark()
    stream = io.BytesIO()
    savemat(stream, dict(arrays), do_compression=True)
    # The header's text, 116 bytes, says when it was written.
    head = b"MATLAB 5.0 MAT-file, written by nscc".ljust(116)
    return head + stream.getvalue()[116:]
