"""Arrays in files of MATLAB: version 5 by scipy, version 7.3, which is HDF5, by h5py."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

_SIGNATURE = b"\x89HDF\r\n\x1a\n"
_USER_BLOCKS = (0, 512, 1024, 2048, 4096)
"""Where HDF5 may begin; MATLAB writes a header of 512 bytes before it."""


def is_hdf5(path: Path) -> bool:
    """Whether a file is HDF5, with or without a block of the user before it."""
    with open(path, "rb") as file:
        for start in _USER_BLOCKS:
            file.seek(start)
            if file.read(len(_SIGNATURE)) == _SIGNATURE:
                return True
    return False


def mat_names(path: Path) -> list[str]:
    """The names of the variables in a .mat file of any version."""
    if is_hdf5(path):
        import h5py

        with h5py.File(path, "r") as file:
            return [name for name in file if not name.startswith("#")]
    from scipy.io import whosmat

    return [str(name) for name, _, _ in whosmat(path)]


def mat_array(path: Path, name: str) -> NDArray[Any]:
    """The array of that name, its axes in MATLAB's order; ValueError for what is no array."""
    if not is_hdf5(path):
        from scipy.io import loadmat

        found = loadmat(path, variable_names=[name])[name]
    else:
        import h5py

        with h5py.File(path, "r") as file:
            stored = file[name]
            if not isinstance(stored, h5py.Dataset):
                raise ValueError(f"'{name}' is a {type(stored).__name__}, not an array")
            # MATLAB stores columns first: HDF5 has its axes the other way round.
            found = np.asarray(stored).T
    if not isinstance(found, np.ndarray):
        raise ValueError(f"'{name}' is a {type(found).__name__}, not an array")
    return found
