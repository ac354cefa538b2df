"""Values of checked expressions, exact, for many codes, slots or pixels at once.

Integers never wrap: beyond 2^62 - 1 in magnitude an operation is a fault, as are division by zero,
an index outside its bits or rows, and a shift count outside 0..61. Faults are lazy where the
language chooses: `and`, `or` and a chain of comparisons stop at the first part that decides them,
and `A if C else B` evaluates only the branch that C names, so `n != 0 and 8 / n > 2` has none.
(`xor`, `min` and `max` use all their operands.)
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, assert_never

import numpy as np
from numpy.typing import NDArray

from nscc.program.expressions import LIMIT, Checked, operands
from nscc.program.problems import clipped
from nscc.source import Span
from nscc.syntax.tree import (
    Binary,
    Bool,
    Call,
    Compare,
    Expr,
    IfElse,
    Index,
    Int,
    Name,
    Unary,
)

MOST_SHIFT = 61

Data = Any
"""An int or a bool, or an int64 or bool array that broadcasts against the others."""


class Fault:
    """Why an expression has no value: a code of nscc, one line of text, the place."""

    __slots__ = ("code", "message", "span", "text")

    def __init__(self, code: str, message: str, span: Span, text: str) -> None:
        self.code = code
        self.message = message
        self.span = span
        self.text = text


Faults = Fault | NDArray[np.bool_] | None
"""No fault, one that holds everywhere, or the places where there is one."""


class Value:
    """What one node is worth: integers lie in `low`..`high`; where `faults` hold, data is void.

    One integer bounds itself: the bounds given with it are not used.
    """

    __slots__ = ("data", "faults", "high", "low")

    def __init__(self, data: Data, low: int, high: int, faults: Faults = None) -> None:
        if type(data) is int:
            low = high = data
        self.data = data
        self.low = low
        self.high = high
        self.faults = faults


Bindings = Mapping[str, Value]
Books = Mapping[str, NDArray[np.bool_]]


def scalar(number: int) -> Value:
    """The value of one integer."""
    return Value(number, number, number)


def array(numbers: NDArray[np.int64]) -> Value:
    """The value of an int64 array of numbers within the limit."""
    if numbers.size == 0:
        return Value(numbers, 0, 0)
    return Value(numbers, int(numbers.min()), int(numbers.max()))


def evaluate(expr: Checked, bindings: Bindings, books: Books) -> Value:
    """The value of `expr`; `bindings` gives every variable that it reads, `books` (K, N) digits."""
    stack: list[Value] = []
    for node in expr.nodes:
        count = len(operands(node))
        given = stack[len(stack) - count :]
        del stack[len(stack) - count :]
        stack.append(_value(node, given, expr.constants, bindings, books))
    (result,) = stack
    if isinstance(result.faults, np.ndarray) and not result.faults.any():
        result = Value(result.data, result.low, result.high)
    return result


def fault_at(
    expr: Checked, bindings: Bindings, books: Books, shape: tuple[int, ...], place: tuple[int, ...]
) -> Fault:
    """The fault of `expr` at one place of the broadcast `shape`, with the values found there."""
    here = {
        name: scalar(int(np.broadcast_to(value.data, shape)[place]))
        for name, value in bindings.items()
    }
    fault = evaluate(expr, here, books).faults
    assert isinstance(fault, Fault)
    return fault


def _value(
    node: Expr,
    given: list[Value],
    constants: Mapping[str, int],
    bindings: Bindings,
    books: Books,
) -> Value:
    match node:
        case Int():
            return scalar(node.value)
        case Bool():
            return Value(node.value, 0, 1)
        case Name():
            known = constants.get(node.text)
            return bindings[node.text] if known is None else scalar(known)
        case Unary(op="not"):
            return Value(given[0].data ^ True, 0, 1, given[0].faults)
        case Unary():
            (a,) = given
            return Value(-a.data, -a.high, -a.low, a.faults)
        case Binary(op="and"):
            return _junction(given[0], given[1], True)
        case Binary(op="or"):
            return _junction(given[0], given[1], False)
        case Binary(op="xor"):
            a, b = given
            return Value(a.data ^ b.data, 0, 1, _either(a.faults, b.faults))
        case Binary():
            return _ARITHMETIC[node.op](node, *given)
        case Compare():
            return _chain(node, given)
        case IfElse():
            return _chosen(*given)
        case Index():
            if node.base.text in books:
                return _digit(node, given[0], books[node.base.text], bindings["n"])
            return _bit(node, given[0], bindings[node.base.text], bindings)
        case Call():
            return _extreme(node.function.text, given)
    assert_never(node)


# Faults: which of them reach a result.


def _either(a: Faults, b: Faults) -> Faults:
    if a is None or isinstance(b, Fault):
        return b if a is None or not isinstance(a, Fault) else a
    if b is None or isinstance(a, Fault):
        return a
    return a | b


def _where(condition: Data, faults: Faults) -> Faults:
    """The faults that remain where only the places of `condition` are evaluated."""
    if faults is None:
        return None
    if isinstance(condition, np.ndarray):
        if isinstance(faults, Fault):
            return condition.copy()
        return condition & faults
    return faults if condition else None


def _guard(
    wrong: Data, data: Data, harmless: int, fault: Callable[[], Fault], before: Faults
) -> tuple[Data, Faults]:
    """`data` with the places that are `wrong` made `harmless`, and the faults they are."""
    if isinstance(wrong, np.ndarray):
        if not wrong.any():
            return data, before
        return np.where(wrong, harmless, data), _either(before, wrong)
    if not wrong:
        return data, before
    return harmless, _either(before, fault())


# Choices.


def _pick(condition: Data, then: Data, other: Data) -> Data:
    if isinstance(condition, np.ndarray):
        return np.where(condition, then, other)
    return then if condition else other


def _chosen(condition: Value, then: Value, other: Value) -> Value:
    branches = _either(
        _where(condition.data, then.faults), _where(condition.data ^ True, other.faults)
    )
    return Value(
        _pick(condition.data, then.data, other.data),
        min(then.low, other.low),
        max(then.high, other.high),
        _either(condition.faults, branches),
    )


def _junction(a: Value, b: Value, conjunction: bool) -> Value:
    undecided = a.data if conjunction else a.data ^ True
    data = a.data & b.data if conjunction else a.data | b.data
    return Value(data, 0, 1, _either(a.faults, _where(undecided, b.faults)))


def _chain(node: Compare, given: list[Value]) -> Value:
    links = [
        Value(_COMPARE[op](a.data, b.data), 0, 1, b.faults)
        for op, a, b in zip(node.ops, given, given[1:], strict=False)
    ]
    result = Value(links[0].data, 0, 1, _either(given[0].faults, links[0].faults))
    for link in links[1:]:
        result = _junction(result, link, True)
    return result


def _extreme(name: str, given: list[Value]) -> Value:
    least = name == "min"
    result = given[0]
    for b in given[1:]:
        if isinstance(result.data, int) and isinstance(b.data, int):
            data = min(result.data, b.data) if least else max(result.data, b.data)
        else:
            data = (np.minimum if least else np.maximum)(result.data, b.data)
        pick = min if least else max
        result = Value(
            data,
            pick(result.low, b.low),
            pick(result.high, b.high),
            _either(result.faults, b.faults),
        )
    return result


# Arithmetic: `low` and `high` come from interval arithmetic in unbounded integers, so that places
# are searched for faults only where the intervals allow one.


def _bounded(
    node: Binary, a: Value, b: Value, low: int, high: int, faults: Faults,
    compute: Callable[[], Data], beyond: Callable[[], Data],
) -> Value:  # fmt: skip
    """`compute` guarded against results beyond the limit; `beyond` finds the places."""

    def fault() -> Fault:
        text = f"{clipped(a.data)} {node.op} {clipped(b.data)} is beyond 2^62 - 1"
        return Fault("NS0305", f"a number becomes too large: {text}", node.span, text)

    if low >= -LIMIT and high <= LIMIT:
        return Value(compute(), low, high, faults)
    if isinstance(a.data, int) and isinstance(b.data, int):
        return Value(0, 0, 0, _either(faults, fault()))
    with np.errstate(over="ignore"):
        data, faults = _guard(beyond(), compute(), 0, fault, faults)
    return Value(data, max(low, -LIMIT), min(high, LIMIT), faults)


def _sum(node: Binary, a: Value, b: Value) -> Value:
    sign = 1 if node.op == "+" else -1
    low = a.low + (b.low if sign > 0 else -b.high)
    high = a.high + (b.high if sign > 0 else -b.low)

    def compute() -> Data:
        return a.data + b.data if sign > 0 else a.data - b.data

    faults = _either(a.faults, b.faults)
    return _bounded(
        node, a, b, low, high, faults, compute, lambda: np.abs(compute()) > LIMIT
    )  # two values within the limit sum to less than 2^63: compute() itself never wraps


def _product(node: Binary, a: Value, b: Value) -> Value:
    corners = (a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high)

    def beyond() -> Data:
        return np.abs(a.data) > LIMIT // np.maximum(np.abs(b.data), 1)

    return _bounded(
        node, a, b, min(corners), max(corners), _either(a.faults, b.faults),
        lambda: a.data * b.data, beyond,
    )  # fmt: skip


def _divisor(node: Binary, a: Value, b: Value) -> tuple[Data, Faults]:
    faults = _either(a.faults, b.faults)
    if not b.low <= 0 <= b.high:
        return b.data, faults
    what = "division by zero" if node.op == "/" else "remainder of a division by zero"
    return _guard(
        b.data == 0,
        b.data,
        1,
        lambda: Fault("NS0302", what, node.right.span, "this is 0"),
        faults,
    )


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
    faults = _either(a.faults, b.faults)
    count = b
    if b.low < 0 or b.high > MOST_SHIFT:

        def fault() -> Fault:
            text = f"the count is {clipped(b.data)}"
            return Fault(
                "NS0304", f"a shift by {clipped(b.data)} is not possible", node.right.span, text
            )

        wrong = (b.data < 0) | (b.data > MOST_SHIFT)
        data, faults = _guard(wrong, b.data, 0, fault, faults)
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


# Digits.


def _position(node: Index, index: Value, size: int, what: str) -> tuple[Data, Faults]:
    if index.low >= 0 and index.high < size:
        return index.data, index.faults

    def fault() -> Fault:
        shown = clipped(index.data)
        return Fault(
            "NS0303",
            f"`{node.base.text}[{shown}]` does not exist: `{node.base.text}` has {what}, "
            f"0..{size - 1}",
            node.index.span,
            f"the index is {shown}",
        )

    wrong = (index.data < 0) | (index.data >= size)
    return _guard(wrong, index.data, 0, fault, index.faults)


def _bit(node: Index, index: Value, field: Value, bindings: Bindings) -> Value:
    bits = bindings[bit_count(node.base.text)].low
    position, faults = _position(node, index, bits, f"{bits} bits")
    return Value((field.data >> position) & 1 != 0, 0, 1, _either(field.faults, faults))


def bit_count(field: str) -> str:
    """The binding that holds the number of bits of a bit field (no name of the language)."""
    return f"{field}[]"


def _digit(node: Index, index: Value, book: NDArray[np.bool_], slot: Value) -> Value:
    row, faults = _position(node, index, book.shape[0], f"{book.shape[0]} rows")
    n = slot.data
    if isinstance(row, int) and isinstance(n, int):
        return Value(bool(book[row, n]), 0, 1, faults)
    if isinstance(n, np.ndarray) and n.size == book.shape[1]:
        # All slots at once: take whole rows, which is much faster than single digits.
        if isinstance(row, int):
            return Value(book[row].reshape(n.shape), 0, 1, faults)
        if row.shape[-1] == 1:
            return Value(book[row[..., 0]], 0, 1, faults)
    return Value(book[row, n], 0, 1, faults)


_ARITHMETIC: dict[str, Callable[[Binary, Value, Value], Value]] = {
    "+": _sum,
    "-": _sum,
    "*": _product,
    "/": _quotient,
    "%": _remainder,
    "<<": _shift,
}

_COMPARE: dict[str, Callable[[Data, Data], Data]] = {
    "<": lambda a, b: a < b,
    "<=": lambda a, b: a <= b,
    ">": lambda a, b: a > b,
    ">=": lambda a, b: a >= b,
    "==": lambda a, b: a == b,
    "!=": lambda a, b: a != b,
}
