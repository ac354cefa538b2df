"""Values of expression nodes, and exact arithmetic for many codes, slots or pixels at once.

Integers never wrap: results beyond 2^62 - 1 in magnitude, division by zero and shift counts outside
0..61 are faults. `low` and `high` come from interval arithmetic in unbounded integers; only if they
allow a fault are the single values checked."""

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


class Value:
    """The values of a node: integers in `low`..`high`.

    Where `faults` hold, the data is undefined. For a single integer, `low` and `high` are set to
    it."""

    __slots__ = ("data", "faults", "high", "low")

    def __init__(self, data: Data, low: int, high: int, faults: Faults = None) -> None:
        if type(data) is int:
            low = high = data
        self.data = data
        self.low = low
        self.high = high
        self.faults = faults


def scalar(number: int) -> Value:
    """Return the value of a single integer."""
    return Value(number, number, number)


def array(numbers: NDArray[np.int64]) -> Value:
    """Return the value of an int64 array."""
    if numbers.size == 0:
        return Value(numbers, 0, 0)
    return Value(numbers, int(numbers.min()), int(numbers.max()))


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


def _bounded(
    node: Binary, a: Value, b: Value, low: int, high: int, faults: Faults,
    compute: Callable[[], Data], beyond: Callable[[], Data],
) -> Value:  # fmt: skip
    """Return `compute()` as a value, with faults at the places that `beyond()` returns.

    These are the places where the result exceeds the limit on integers."""

    def fault() -> Fault:
        text = f"{clipped(a.data)} {node.op} {clipped(b.data)} is beyond 2^62 - 1"
        return Fault("NS0305", f"a number is too large: {text}", node.span, text)

    if low >= -LIMIT and high <= LIMIT:
        return Value(compute(), low, high, faults)
    if isinstance(a.data, int) and isinstance(b.data, int):
        return Value(0, 0, 0, either(faults, fault()))
    with np.errstate(over="ignore"):
        data, faults = guard(beyond(), compute(), 0, fault, faults)
    return Value(data, max(low, -LIMIT), min(high, LIMIT), faults)


def _sum(node: Binary, a: Value, b: Value) -> Value:
    sign = 1 if node.op == "+" else -1
    low = a.low + (b.low if sign > 0 else -b.high)
    high = a.high + (b.high if sign > 0 else -b.low)

    def compute() -> Data:
        return a.data + b.data if sign > 0 else a.data - b.data

    faults = either(a.faults, b.faults)
    return _bounded(
        node, a, b, low, high, faults, compute, lambda: np.abs(compute()) > LIMIT
    )  # two values within the limit sum to less than 2^63, so compute() does not wrap


def _product(node: Binary, a: Value, b: Value) -> Value:
    corners = (a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high)

    def beyond() -> Data:
        return np.abs(a.data) > LIMIT // np.maximum(np.abs(b.data), 1)

    return _bounded(
        node, a, b, min(corners), max(corners), either(a.faults, b.faults),
        lambda: a.data * b.data, beyond,
    )  # fmt: skip


def _divisor(node: Binary, a: Value, b: Value) -> tuple[Data, Faults]:
    faults = either(a.faults, b.faults)
    if not b.low <= 0 <= b.high:
        return b.data, faults
    message = "division by zero" if node.op == "/" else "remainder of a division by zero"
    fault = Fault("NS0302", message, node.right.span, "this is 0")
    return guard(b.data == 0, b.data, 1, lambda: fault, faults)


def _quotient(node: Binary, a: Value, b: Value) -> Value:
    divisor, faults = _divisor(node, a, b)
    if b.low <= 0 <= b.high:
        most = max(abs(a.low), abs(a.high))
        low, high = -most, most
    else:
        corners = (a.low // b.low, a.low // b.high, a.high // b.low, a.high // b.high)
        low, high = min(corners), max(corners)
    return Value(a.data // divisor, low, high, faults)


def _remainder(node: Binary, a: Value, b: Value) -> Value:
    divisor, faults = _divisor(node, a, b)
    return Value(a.data % divisor, min(b.low + 1, 0), max(b.high - 1, 0), faults)


def _shift(node: Binary, a: Value, b: Value) -> Value:
    faults = either(a.faults, b.faults)
    count = b
    if b.low < 0 or b.high > MOST_SHIFT:

        def fault() -> Fault:
            count, place = clipped(b.data), node.right.span
            message = f"invalid shift by {count}"
            return Fault("NS0304", message, place, f"the count is {count}")

        out_of_range = (b.data < 0) | (b.data > MOST_SHIFT)
        data, faults = guard(out_of_range, b.data, 0, fault, faults)
        low, high = max(b.low, 0), min(max(b.high, 0), MOST_SHIFT)
        count = Value(data, min(low, high), high, faults)
        if data is not b.data:
            count.low = 0
    corners = (
        a.low << count.low, a.low << count.high, a.high << count.low, a.high << count.high,
    )  # fmt: skip

    def beyond() -> Data:
        return np.abs(a.data) > LIMIT >> count.data

    return _bounded(
        node, a, count, min(corners), max(corners), faults,
        lambda: a.data << count.data, beyond,
    )  # fmt: skip


ARITHMETIC: dict[str, Callable[[Binary, Value, Value], Value]] = {
    "+": _sum,
    "-": _sum,
    "*": _product,
    "/": _quotient,
    "%": _remainder,
    "<<": _shift,
}
