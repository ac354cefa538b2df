"""Arrays in .npy streams that anyone may have made: the header first, then no more than it says."""

from __future__ import annotations

from math import prod
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray


def npy_header(stream: IO[bytes]) -> tuple[tuple[int, int], tuple[int, ...], bool, np.dtype[Any]]:
    """Version, shape, whether column-major, and type of an .npy stream's array.

    Raises what numpy does where the header is damaged.
    """
    from numpy.lib import format as npy

    version = npy.read_magic(stream)
    read = npy.read_array_header_1_0 if version == (1, 0) else npy.read_array_header_2_0
    return version, *read(stream)


def npy_values(
    stream: IO[bytes], shape: tuple[int, ...], fortran: bool, dtype: np.dtype[Any]
) -> NDArray[Any] | None:
    """The values behind that header; None if the stream is cut short or too long."""
    size = prod(shape) * dtype.itemsize
    data = stream.read(size + 1)
    if len(data) != size:
        return None
    values = np.frombuffer(data, dtype=dtype)
    return values.reshape(shape[::-1]).T if fortran else values.reshape(shape)
