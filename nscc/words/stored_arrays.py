"""Arrays as bytes of container files and assembly texts: little endian, without gaps.

Eight booleans are packed into a byte, lowest bit first."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import prod
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray


class StoredArray(NamedTuple):
    """The name, the type and the shape of an array."""

    name: str
    dtype: str
    shape: tuple[int, ...]

    @property
    def nbytes(self) -> int:
        items = prod(self.shape)
        return (items + 7) // 8 if self.dtype == "?" else items * np.dtype(self.dtype).itemsize


def array_faults(
    *arrays: tuple[str, NDArray[Any], tuple[int, ...], type[np.generic]],
) -> Iterator[str]:
    """Yield the arrays (name, array, shape, type) that have another shape or type."""
    for name, array, shape, dtype in arrays:
        if array.shape != shape or array.dtype != dtype:
            yield (
                f"{name} is {array.dtype} {array.shape}, not {np.dtype(dtype)} {shape} as the "
                "rest of it needs"
            )


def packed(layout: Sequence[StoredArray], arrays: Mapping[str, NDArray[Any]]) -> list[bytes]:
    """Return the bytes of each array of `layout`."""
    return [
        np.packbits(arrays[name], axis=None, bitorder="little").tobytes()
        if dtype == "?"
        else arrays[name].astype(dtype, copy=False).tobytes()
        for name, dtype, _ in layout
    ]


def unpacked(layout: Sequence[StoredArray], data: bytes, start: int) -> dict[str, NDArray[Any]]:
    """Return the arrays from byte `start` on; raise ValueError unless they fill `data`."""
    need = start + sum(array.nbytes for array in layout)
    if need != len(data):
        raise ValueError(f"its arrays need {need} bytes and it has {len(data)}")
    arrays: dict[str, NDArray[Any]] = {}
    for array in layout:
        raw = np.frombuffer(data, np.uint8, array.nbytes, start)
        start += array.nbytes
        if array.dtype == "?":
            bits = np.unpackbits(raw, count=prod(array.shape), bitorder="little")
            values: NDArray[Any] = bits.view(np.bool_)
        else:
            values = raw.view(array.dtype).astype(np.dtype(array.dtype).newbyteorder("="))
        arrays[array.name] = values.reshape(array.shape)
    return arrays
