"""What numba is told of a loop's parameters. Importing this module imports numba."""

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
"""A pointer to records; indexed, it is one of them: numba's own pointers would copy it."""

extending.register_model(Records)(extending.models.PointerModel)


def _record(_context: Any, builder: Any, _signature: Any, values: tuple[Any, Any]) -> Any:
    """The address of a record, which is how numba holds one."""
    return builder.gep(values[0], [values[1]])


extending.lower_builtin(operator.getitem, Records, types.Integer)(_record)


def signature(parameters: Iterable[tuple[type | None, list[tuple[np.dtype[Any], bool]]]]) -> Any:
    """The types of a loop, for numba: of each parameter the NamedTuple that it is, or None, and of
    its parts, or itself, the kind, and whether it is one record."""
    found = []
    for together, parts in parameters:
        kinds = [_type(*part) for part in parts]
        found.append(kinds[0] if together is None else types.NamedTuple(kinds, together))
    return types.void(*found)


def _type(kind: np.dtype[Any], is_record: bool) -> Any:
    found = numba.from_dtype(kind)
    if is_record:
        return found
    return Records(found) if kind.names else types.CPointer(found)
