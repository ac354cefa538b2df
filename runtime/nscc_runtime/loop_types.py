"""The numba types of a loop's parameters. Importing this module imports numba."""

from __future__ import annotations

import operator
from collections.abc import Iterable
from typing import Any

import numba
import numpy as np
from numba import extending as _extending
from numba import types as _types

from nscc_runtime.loop_given import ArrayGroup, LoopParameter

# numba has no annotations of its own.
extending: Any = _extending
types: Any = _types

Records: Any = type("Records", (types.CPointer,), {})
"""A pointer to records. Indexing returns a reference; numba's own pointers would copy."""

extending.register_model(Records)(extending.models.PointerModel)


def _record(_context: Any, builder: Any, _signature: Any, values: tuple[Any, Any]) -> Any:
    """Return the address of an element of an array of records, which represents the record in
    numba. `values`: the array's address and the index; `builder` makes LLVM code."""
    return builder.gep(values[0], [values[1]])


extending.lower_builtin(operator.getitem, Records, types.Integer)(_record)


def signature(parameters: Iterable[LoopParameter | ArrayGroup]) -> Any:
    """Return the numba signature of a loop with these `parameters`, in order, which returns
    nothing. A group of arrays becomes one NamedTuple."""
    parameter_types = []
    for parameter in parameters:
        kinds = [_type(array.kind, array.record is not None) for array in parameter.arrays]
        together = isinstance(parameter, ArrayGroup)
        parameter_types.append(types.NamedTuple(kinds, parameter.kind) if together else kinds[0])
    return types.void(*parameter_types)


def _type(kind: np.dtype[Any], is_record: bool) -> Any:
    """Return the numba type of a parameter of type `kind`: a record if `is_record`, else an array
    of records or a pointer."""
    numba_type = numba.from_dtype(kind)
    if is_record:
        return numba_type
    return Records(numba_type) if kind.names else types.CPointer(numba_type)
