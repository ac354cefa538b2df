"""Arrays as bytes of container files and assembly texts: little endian, without gaps.

Eight booleans are packed into a byte, lowest bit first. The hint of a record's field says the type
and the names of the dimensions of its array: `Annotated[NDArray[np.int32], "nodes buckets"]`."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from math import prod
from typing import Annotated, Any, NamedTuple, get_args, get_origin, get_type_hints

import numpy as np
from numpy.typing import DTypeLike

from nscc.arrays import Array


class StoredArray(NamedTuple):
    """The name, the type and the shape of an array."""

    name: str
    dtype: np.dtype[Any]
    shape: tuple[int, ...]

    @property
    def nbytes(self) -> int:
        """The bytes of the array in the file, where a bit takes one eighth, rounded up."""
        items = prod(self.shape)
        return (items + 7) // 8 if self.dtype == np.bool_ else items * self.dtype.itemsize


def layout_of(kind: type, sizes: Mapping[str, int]) -> list[StoredArray]:
    """Return the arrays that the hints of a record class declare, in order; other fields are left
    out.

    `sizes` has the lengths of their dimensions by name; raises KeyError if one is missing."""
    return [
        StoredArray(name, dtype, tuple(sizes[dimension] for dimension in dimensions))
        for name, dtype, dimensions in _arrays_of(kind)
    ]


@cache
def _arrays_of(kind: type) -> list[tuple[str, np.dtype[Any], list[str]]]:
    """Return (name, type, names of dimensions) of each array of a record class, in order: of each
    field whose hint is `Annotated`."""
    arrays = []
    for name, hint in get_type_hints(kind, include_extras=True).items():
        if get_origin(hint) is Annotated:
            array, dimensions = get_args(hint)
            arrays.append((name, np.dtype(number_type(array)), dimensions.split()))
    return arrays


def number_type(hint: Any) -> Any:
    """Return the type of the numbers of `NDArray[type]`.

    Up to numpy 2.4, it stands for `ndarray[shape, dtype[type]]`; from 2.5 on, an alias has the type
    itself as its argument."""
    last = get_args(hint)[-1]
    return next(iter(get_args(last)), last)


def array_faults(record: object, sizes: Mapping[str, int]) -> Iterator[str]:
    """Yield the errors of a record's arrays whose shape or type differs from the hints of its
    class, as texts such as "values is int32 (3,), not int64 (3, 2)".

    `sizes` has the lengths of their dimensions by name."""
    for name, dtype, shape in layout_of(type(record), sizes):
        yield from array_fault(name, getattr(record, name), dtype, shape)


def array_fault(name: str, array: Array, dtype: DTypeLike, shape: tuple[int, ...]) -> Iterator[str]:
    """Yield a text if the shape or type of the array `name` differs from `shape` and `dtype`; else
    nothing."""
    if array.shape != shape or array.dtype != dtype:
        yield f"{name} is {array.dtype} {array.shape}, not {np.dtype(dtype)} {shape}"


def packed(layout: Sequence[StoredArray], arrays: Mapping[str, Array]) -> list[bytes]:
    """Return the bytes of each array of `layout`, in order; `arrays` has them by name, and may have
    others.

    Types are converted to those of the layout, and shapes are not checked."""
    return [
        np.packbits(arrays[name], axis=None, bitorder="little").tobytes()
        if dtype == np.bool_
        else arrays[name].astype(dtype.newbyteorder("<"), copy=False).tobytes()
        for name, dtype, _ in layout
    ]


def unpacked(layout: Sequence[StoredArray], data: bytes, start: int) -> dict[str, Array]:
    """Return the arrays of `layout` by name, from byte `start` of `data` on; inverse of `packed`.

    Raises ValueError unless they fill the data exactly."""
    need = start + sum(array.nbytes for array in layout)
    if need != len(data):
        raise ValueError(f"its arrays need {need} bytes and it has {len(data)}")
    arrays: dict[str, Array] = {}
    for array in layout:
        raw = np.frombuffer(data, np.uint8, array.nbytes, start)
        start += array.nbytes
        if array.dtype == np.bool_:
            bits = np.unpackbits(raw, count=prod(array.shape), bitorder="little")
            values: Array = bits.view(np.bool_)
        else:
            values = raw.view(array.dtype.newbyteorder("<")).astype(array.dtype)
        arrays[array.name] = values.reshape(array.shape)
    return arrays
