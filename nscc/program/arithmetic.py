"""Values of expression nodes, and exact arithmetic for many codes, slots or pixels at once.

Integers never wrap: results beyond 2^62 - 1 in magnitude, division by zero and shift counts outside
0..61 are faults."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nscc.program.expressions import LIMIT
from nscc.program.problems import clipped
from nscc.source import Span
from nscc.syntax.tree import Binary

MOST_SHIFT = 61

Data = Any
"""An int or a bool, or an int64 or bool array that broadcasts with other data."""


class Fault(NamedTuple):
    """The reason why an expression has no value: an error code, a message, the place and its label.

    These are the arguments of `Problems.error`."""

    code: str
    message: str
    span: Span
    text: str


Faults = Fault | NDArray[np.bool_] | None
"""The faults of an expression: none, one for all places, or the places with a fault."""


class Value(NamedTuple):
    """The values of a node. Where `faults` hold, the data is undefined."""

    data: Data
    faults: Faults = None


def either(a: Faults, b: Faults) -> Faults:
    """Return the union of the faults of two operands."""
    if a is None or isinstance(b, Fault):
        return b if a is None or not isinstance(a, Fault) else a
    if b is None or isinstance(a, Fault):
        return a
    return a | b


def faults_where(condition: Data, faults: Faults) -> Faults:
    """Return the faults that remain if only the places of `condition` are evaluated."""
    if faults is None:
        return None
    if isinstance(condition, np.ndarray):
        if isinstance(faults, Fault):
            return condition.copy()
        return condition & faults
    return faults if condition else None


def guard(
    at_fault: Data, data: Data, harmless: int, fault: Callable[[], Fault], before: Faults
) -> tuple[Data, Faults]:
    """Return `data` with the value `harmless` at the places `at_fault`, and the faults at these
    places."""
    if isinstance(at_fault, np.ndarray):
        if not at_fault.any():
            return data, before
        return np.where(at_fault, harmless, data), either(before, at_fault)
    if not at_fault:
        return data, before
    return harmless, either(before, fault())


def _limited(node: Binary, a: Value, b: Value, faults: Faults, data: Data, beyond: Data) -> Value:
    """Return `data` as a value, with faults where it is `beyond` the limit on integers."""

    def fault() -> Fault:
        text = f"{clipped(a.data)} {node.op} {clipped(b.data)} is beyond 2^62 - 1"
        return Fault("NS0305", f"a number is too large: {text}", node.span, text)

    return Value(*guard(beyond, data, 0, fault, faults))


def _sum(node: Binary, a: Value, b: Value) -> Value:
    # Two values within the limit sum to less than 2^63, so that int64 does not wrap.
    data = a.data + b.data if node.op == "+" else a.data - b.data
    return _limited(node, a, b, either(a.faults, b.faults), data, np.abs(data) > LIMIT)


def _product(node: Binary, a: Value, b: Value) -> Value:
    beyond = np.abs(a.data) > LIMIT // np.maximum(np.abs(b.data), 1)
    return _limited(node, a, b, either(a.faults, b.faults), a.data * b.data, beyond)


def _divisor(node: Binary, a: Value, b: Value) -> tuple[Data, Faults]:
    message = "division by zero" if node.op == "/" else "remainder of a division by zero"
    fault = Fault("NS0302", message, node.right.span, "this is 0")
    return guard(b.data == 0, b.data, 1, lambda: fault, either(a.faults, b.faults))


def _quotient(node: Binary, a: Value, b: Value) -> Value:
    divisor, faults = _divisor(node, a, b)
    return Value(a.data // divisor, faults)


def _remainder(node: Binary, a: Value, b: Value) -> Value:
    divisor, faults = _divisor(node, a, b)
    return Value(a.data % divisor, faults)


def _shift(node: Binary, a: Value, b: Value) -> Value:
    def fault() -> Fault:
        count, place = clipped(b.data), node.right.span
        return Fault("NS0304", f"invalid shift by {count}", place, f"the count is {count}")

    out_of_range = (b.data < 0) | (b.data > MOST_SHIFT)
    count, faults = guard(out_of_range, b.data, 0, fault, either(a.faults, b.faults))
    beyond = np.abs(a.data) > LIMIT >> count
    return _limited(node, a, b, faults, a.data << count, beyond)


ARITHMETIC: dict[str, Callable[[Binary, Value, Value], Value]] = {
    "+": _sum,
    "-": _sum,
    "*": _product,
    "/": _quotient,
    "%": _remainder,
    "<<": _shift,
}
