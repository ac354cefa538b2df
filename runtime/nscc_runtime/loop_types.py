"""What numba is told of a loop's parameters. Importing this module imports numba."""

from __future__ import annotations

import operator
from collections.abc import Iterable
from typing import Any

import numba
from numba import extending as _extending
from numba import types as _types

from nscc_runtime.loop import Parameter

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


def signature(parameters: Iterable[Parameter]) -> Any:
    """The types of a loop, for numba."""
    return types.void(*map(_type, parameters))


def _type(parameter: Parameter) -> Any:
    kind = numba.from_dtype(parameter.kind)
    if parameter.record is not None:
        return kind
    return Records(kind) if parameter.kind.names else types.CPointer(kind)
