"""The numba types of a loop's parameters. Importing this module imports numba."""

from __future__ import annotations

import operator
from collections.abc import Iterable
from typing import Any

import numba
import numpy as np
from numba import extending as _extending
from numba import types as _types

# numba has no annotations of its own.
extending: Any = _extending
types: Any = _types

Records: Any = type("Records", (types.CPointer,), {})
"""A pointer to records. Indexing returns a reference; numba's own pointers would copy."""

extending.register_model(Records)(extending.models.PointerModel)


def _record(_context: Any, builder: Any, _signature: Any, values: tuple[Any, Any]) -> Any:
    """Return the address of a record, which represents the record in numba."""
    return builder.gep(values[0], [values[1]])


extending.lower_builtin(operator.getitem, Records, types.Integer)(_record)


def signature(parameters: Iterable[tuple[type | None, list[tuple[np.dtype[Any], bool]]]]) -> Any:
    """Return the numba signature of a loop. For each parameter: the NamedTuple class or None, and
    for each of its arrays the dtype and whether it is one record."""
    parameter_types = []
    for together, arrays in parameters:
        kinds = [_type(*array) for array in arrays]
        parameter_types.append(kinds[0] if together is None else types.NamedTuple(kinds, together))
    return types.void(*parameter_types)


def _type(kind: np.dtype[Any], is_record: bool) -> Any:
    numba_type = numba.from_dtype(kind)
    if is_record:
        return numba_type
    return Records(numba_type) if kind.names else types.CPointer(numba_type)
