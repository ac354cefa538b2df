"""Exact values of checked expressions, for many codes, slots or pixels at once.

Integers never wrap: results beyond 2^62 - 1 in magnitude, division by zero and shift counts outside
0..61 are faults. A fault, or an index outside its bits or rows, leaves a place without a value.
Operands that do not decide the result are not evaluated: `and`, `or` and a chain of comparisons
stop at the first operand that decides them, and `A if C else B` evaluates only the branch that C
selects. So `n != 0 and 8 / n > 2` has no fault at n = 0. (`xor`, `min` and `max` evaluate all their
operands.)"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import pairwise
from operator import eq, ge, gt, le, lt, ne
from typing import Any, NamedTuple, assert_never

import numpy as np

from nscc.arrays import Array, Bools
from nscc.program.expressions import LIMIT, Checked, operands
from nscc.program.problems import Problems, clipped
from nscc.program.program import CHUNK_BITS, chunk_name
from nscc.source import Span
from nscc.syntax import tree
from nscc.syntax.tree import Binary

MOST_SHIFT = 61
"""Largest shift count: integers have at most 62 bits without their sign."""
_NOT_0 = "test for 0 first, `b != 0 and a % b == 0`, or exclude 0 with a range or with `require`"

Data = Any
"""An int or a bool, or an int64 or bool array that broadcasts with other data."""


class Fault(NamedTuple):
    """Why an expression has no value: an error code, a message, the place in the program with a
    label (`text`), and what to do about it (`helps`)."""

    code: str
    message: str
    span: Span
    text: str
    helps: tuple[str, ...] = ()

    def report(self, problems: Problems, **members: Any) -> None:
        """Add the error to `problems`. `members` are further fields of `Diagnostic`, such as
        `notes`."""
        problems.error(self.code, self.message, self.span, self.text, helps=self.helps, **members)


def outside_range(name: str, values: range, value: int, span: Span, what_to_do: str) -> Fault:
    """Return the fault that the state `name`, which has the `values`, gets another `value` from the
    expression at `span`."""
    message = f"`{name}` gets the value {value}, outside its range"
    text = f"`{name}` has the values {values[0]}..{values[-1]}"
    return Fault("NS0311", message, span, text, (what_to_do,))


Faults = Fault | Bools | None
"""The faults of an expression: none, one for all places, or the places with a fault."""


class Value(NamedTuple):
    """The values of an expression, and its `faults`: the places without a value, where `data` is
    undefined."""

    data: Data
    faults: Faults = None


def either(a: Faults, b: Faults) -> Faults:
    """Return the faults (places without a value) of an operation on two operands with the faults
    `a` and `b`.

    None means that there is no fault. The or of two arrays of marks is returned. A `Fault` stands
    for all places and replaces an array; of two, the first operand's is returned."""
    if a is None or isinstance(b, Fault):  # `b`, unless `a` is a fault of all places, too
        return b if a is None or not isinstance(a, Fault) else a
    if b is None or isinstance(a, Fault):
        return a
    return a | b  # both are arrays that mark the places with a fault


def faults_where(condition: Data, faults: Faults) -> Faults:
    """Return the part of `faults` that remains if an expression is evaluated only where `condition`
    is true. A fault is a place without a value.

    If `condition` is an array, the result is a bool array that is true at the remaining places."""
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
    """Return `data`, and the faults (places without a value) `before` together with those at the
    places `at_fault`.

    At these places `harmless` replaces the data, so that later operations cause no further fault or
    overflow. `at_fault` is a bool, or a bool array of marks. `fault` makes the error; it is called
    only for a single bool, because an array only marks places."""
    if isinstance(at_fault, np.ndarray):
        if not at_fault.any():
            return data, before
        return _wide(np.where(at_fault, harmless, data)), either(before, at_fault)
    if not at_fault:
        return data, before
    return harmless, either(before, fault())


def _wide(data: Any) -> Any:
    """Return integers as int64, and booleans as they are; numpy's own choice has 32 bits in
    WebAssembly."""
    return data if data.dtype == np.bool_ else data.astype(np.int64, copy=False)


def _limited(node: Binary, a: Value, b: Value, faults: Faults, data: Data, beyond: Data) -> Value:
    """Return `data`, the result of the operation `node` on `a` and `b`, as a value with its faults
    (places without a value).

    `beyond` is true where the result exceeds the limit on integers: these places get a fault
    (NS0305) and the data 0. `faults` are those of the operands."""

    def fault() -> Fault:
        """Return the fault (NS0305) of the first value beyond the limit."""
        text = f"{clipped(a.data)} {node.op} {clipped(b.data)} is beyond 2^62 - 1"
        return Fault("NS0305", f"a number is too large: {text}", node.span, text)

    return Value(*guard(beyond, data, harmless=0, fault=fault, before=faults))


def _sum(node: Binary, a: Value, b: Value) -> Value:
    """Return a + b or a - b, as the operator of `node` says, with faults (NS0305) beyond 2^62 -
    1."""
    # Two values within the limit sum to less than 2^63, so that int64 does not wrap.
    data = a.data + b.data if node.op == "+" else a.data - b.data
    return _limited(
        node, a, b, faults=either(a.faults, b.faults), data=data, beyond=np.abs(data) > LIMIT
    )


def _product(node: Binary, a: Value, b: Value) -> Value:
    """Return a * b, with faults (NS0305) where it exceeds 2^62 - 1 in magnitude; `node` is the
    place in the program."""
    # Compared by division, because the product itself could wrap. The 1 replaces
    # b = 0, with which no product is too large.
    beyond = np.abs(a.data) > LIMIT // np.maximum(np.abs(b.data), 1, dtype=np.int64)
    return _limited(
        node, a, b, faults=either(a.faults, b.faults), data=a.data * b.data, beyond=beyond
    )


def _divisor(node: Binary, a: Value, b: Value) -> tuple[Data, Faults]:
    """Return the divisors `b` of the division `node` of `a`, with 1 in place of 0. Return also the
    faults (places without a value): those of the operands, and the divisors 0 (NS0302)."""
    message = "division by zero" if node.op == "/" else "remainder of a division by zero"
    fault = Fault("NS0302", message, node.right.span, "this is 0", (_NOT_0,))
    return guard(
        b.data == 0, b.data, harmless=1, fault=lambda: fault, before=either(a.faults, b.faults)
    )


def _quotient(node: Binary, a: Value, b: Value) -> Value:
    """Return a / b, rounded down (-7 / 2 is -4), with faults (NS0302) where b is 0."""
    divisor, faults = _divisor(node, a, b)
    return Value(a.data // divisor, faults)


def _remainder(node: Binary, a: Value, b: Value) -> Value:
    """Return a % b, which has the sign of b, with faults (NS0302) where b is 0."""
    divisor, faults = _divisor(node, a, b)
    return Value(a.data % divisor, faults)


def _shift(node: Binary, a: Value, b: Value) -> Value:
    """Return a << b, with faults for shift counts outside 0..61 (NS0304) and results beyond 2^62 -
    1."""

    def fault() -> Fault:
        """Return the fault (NS0304) of the first invalid shift."""
        count, span = clipped(b.data), node.right.span
        helps = (f"shift by 0 to {MOST_SHIFT} bits",)
        return Fault("NS0304", f"invalid shift by {count}", span, f"the count is {count}", helps)

    out_of_range = (b.data < 0) | (b.data > MOST_SHIFT)
    count, faults = guard(
        out_of_range, b.data, harmless=0, fault=fault, before=either(a.faults, b.faults)
    )
    beyond = np.abs(a.data) > LIMIT >> count
    return _limited(node, a, b, faults, data=a.data << count, beyond=beyond)


ARITHMETIC: dict[str, Callable[[Binary, Value, Value], Value]] = {
    "+": _sum,
    "-": _sum,
    "*": _product,
    "/": _quotient,
    "%": _remainder,
    "<<": _shift,
}


Bindings = Mapping[str, Value]
Books = Mapping[str, Bools]


def evaluate(expr: Checked, bindings: Bindings, books: Books) -> Value:
    """Return the value of a checked expression.

    `bindings` contains the values of every variable that it reads, which broadcast with each other.
    If it reads codebooks, `n` is among them. `books` has the digits of codebooks by name, bool
    (rows, N). Places without a value are marked in the result's `faults`; nothing is raised."""
    stack: list[Value] = []
    for node in expr.nodes:
        count = len(operands(node))
        arguments = stack[len(stack) - count :]
        del stack[len(stack) - count :]
        stack.append(_value(node, arguments, expr.constants, bindings, books))
    (result,) = stack
    if isinstance(result.faults, np.ndarray) and not result.faults.any():
        result = Value(result.data)
    return result


class Gap(NamedTuple):
    """Places where an expression has no value.

    `fault` and `first_index` (array indices) are those of the first place, row by row; `number`
    counts the places."""

    fault: Fault
    first_index: tuple[int, ...]
    number: int


def values_of(
    expr: Checked,
    bindings: Bindings,
    books: Books,
    shape: tuple[int, ...],
    needed: Bools | bool = True,
) -> tuple[Array, Gap | None]:
    """Return the values of an expression as an array of `shape`, and where values are missing.

    `bindings` and `books` are those of `evaluate`. A value is missing if it has a fault and is
    `needed` (bool of `shape`, or True for all places). The second result is None if no value is
    missing. Values with a fault are arbitrary."""
    value = evaluate(expr, bindings, books)
    data = np.broadcast_to(np.asarray(value.data), shape)
    if value.faults is None:
        return data, None
    faults = value.faults if isinstance(value.faults, np.ndarray) else True
    at_fault = np.broadcast_to(faults, shape) & needed
    if not at_fault.any():
        return data, None
    index = tuple(int(k) for k in np.unravel_index(int(at_fault.argmax()), shape))
    # Evaluated once more at this index, for a message with its values.
    at_index = {
        name: Value(int(np.broadcast_to(binding.data, shape)[index]))
        for name, binding in bindings.items()
    }
    fault = evaluate(expr, at_index, books).faults
    assert isinstance(fault, Fault)
    return data, Gap(fault, index, int(at_fault.sum()))


def _value(
    node: tree.Expr,
    arguments: list[Value],
    constants: Mapping[str, int],
    bindings: Bindings,
    books: Books,
) -> Value:
    """Return the value of one node of the syntax tree from the values of its operands
    (`arguments`).

    `constants` and `bindings` give the values of names (a constant comes first), and `books` the
    digits of codebooks. Faults of operands that do not decide the result are dropped."""
    match node:
        case tree.Int():
            return Value(node.value)
        case tree.Bool():
            return Value(node.value)
        case tree.Name():
            known = constants.get(node.text)
            return bindings[node.text] if known is None else Value(known)
        case tree.Unary(op="not"):
            return Value(arguments[0].data ^ True, arguments[0].faults)
        case tree.Unary():
            (a,) = arguments
            return Value(-a.data, a.faults)
        case tree.Binary(op="and"):
            return _junction(arguments[0], arguments[1], conjunction=True)
        case tree.Binary(op="or"):
            return _junction(arguments[0], arguments[1], conjunction=False)
        case tree.Binary(op="xor"):
            a, b = arguments
            return Value(a.data ^ b.data, either(a.faults, b.faults))
        case tree.Binary():
            return ARITHMETIC[node.op](node, *arguments)
        case tree.Compare():
            links = [
                Value(_COMPARE[op](a.data, b.data), b.faults)
                for op, (a, b) in zip(node.ops, pairwise(arguments), strict=True)
            ]
            # As with `and`, a later operand counts only where the comparisons before are true.
            result = Value(links[0].data, either(arguments[0].faults, links[0].faults))
            for link in links[1:]:
                result = _junction(result, link, conjunction=True)
            return result
        case tree.IfElse():
            return _chosen(*arguments)
        case tree.Index():
            if node.base.text in books:
                return _digit(node, arguments[0], books[node.base.text], bindings["n"])
            return _bit(node, arguments[0], bindings[node.base.text], bindings)
        case tree.Call():
            of_integers, of_arrays = (
                (min, np.minimum) if node.function.text == "min" else (max, np.maximum)
            )
            result = arguments[0]
            for argument in arguments[1:]:
                integers = isinstance(result.data, int) and isinstance(argument.data, int)
                data = (of_integers if integers else of_arrays)(result.data, argument.data)
                result = Value(data, either(result.faults, argument.faults))
            return result
        case tree.Place() | tree.Amount():
            raise AssertionError("`check` refuses levels and bits of neighbours")
    assert_never(node)


def _chosen(condition: Value, then: Value, otherwise: Value) -> Value:
    """Return `then` where the boolean `condition` holds and `otherwise` elsewhere.

    The faults (places without a value) are those of the condition and, at each place, of the chosen
    branch."""
    branches = either(
        faults_where(condition.data, then.faults),
        faults_where(condition.data ^ True, otherwise.faults),
    )
    if isinstance(condition.data, np.ndarray):
        data: Data = _wide(np.where(condition.data, then.data, otherwise.data))
    else:
        data = then.data if condition.data else otherwise.data
    return Value(data, either(condition.faults, branches))


def _junction(a: Value, b: Value, conjunction: bool) -> Value:
    """Return `a and b` (if `conjunction`) or `a or b`; both are boolean. Faults of b count only
    where a does not decide."""
    undecided = a.data if conjunction else a.data ^ True
    data = a.data & b.data if conjunction else a.data | b.data
    return Value(data, either(a.faults, faults_where(undecided, b.faults)))


def _position(node: tree.Index, index: Value, size: int, size_text: str) -> tuple[Data, Faults]:
    """Return an index with a fault (NS0303) and the index 0 where it is outside 0..`size` - 1.

    `node` is the expression with brackets. `size_text` is the size in words, such as "8 bits"."""

    def fault() -> Fault:
        """Return the error that names the first index out of range."""
        shown = clipped(index.data)
        return Fault(
            "NS0303",
            f"the index of `{node.base.text}[{shown}]` is out of range: `{node.base.text}` "
            f"has {size_text}, 0..{size - 1}",
            node.index.span,
            f"the index is {shown}",
        )

    out_of_range = (index.data < 0) | (index.data >= size)
    return guard(out_of_range, index.data, harmless=0, fault=fault, before=index.faults)


def _bit(node: tree.Index, index: Value, field: Value, bindings: Bindings) -> Value:
    """Return bit `index` of a bit field, as bool.

    An index outside the field's bits is a fault (NS0303). Long fields are stored in chunks of
    `CHUNK_BITS` bits, which `bindings` has under names of their own."""
    bits = bindings[bit_count(node.base.text)].data
    position, faults = _position(node, index, bits, f"{bits} bits")
    if bits <= CHUNK_BITS:
        return Value((field.data >> position) & 1 != 0, either(field.faults, faults))
    chunk_count = -(-bits // CHUNK_BITS)  # rounded up
    chunks = [bindings[chunk_name(node.base.text, k)].data for k in range(chunk_count)]
    return Value(_bit_of_chunks(chunks, position), either(field.faults, faults))


def _bit_of_chunks(chunks: list[Data], position: Data) -> Data:
    """Return the bit at `position` of a field that is stored in several numbers, lowest bits first.

    `position` is within the chunks: the caller has replaced invalid ones by 0. `chunks` and
    `position` broadcast with each other."""
    if isinstance(position, int):
        return chunks[position // CHUNK_BITS] >> position % CHUNK_BITS & 1 != 0
    shape = np.broadcast_shapes(np.shape(chunks[0]), position.shape)
    bits = np.zeros(shape, np.bool_)
    for k in np.unique(position // CHUNK_BITS).tolist():
        in_chunk = np.broadcast_to(position // CHUNK_BITS == k, shape)
        # Positions in other chunks get the shift 0; `in_chunk` drops their bits.
        shifted = chunks[k] >> np.where(in_chunk, position % CHUNK_BITS, 0)
        bits |= in_chunk & (shifted & 1 != 0)
    return bits


def bit_count(field: str) -> str:
    """Return the key under which bindings have the number of bits of a bit field; no name of the
    language is like it."""
    return f"{field}[]"


def _digit(node: tree.Index, index: Value, book: Bools, slot: Value) -> Value:
    """Return the digit of row `index` of a codebook in a slot, as bool.

    `book` is bool (rows, N). A row outside the codebook is a fault (NS0303); the slot is within
    0..N - 1. Rows and slots broadcast with each other."""
    row, faults = _position(node, index, book.shape[0], f"{book.shape[0]} rows")
    n = slot.data
    if isinstance(row, int) and isinstance(n, int):
        return Value(bool(book[row, n]), faults)
    if isinstance(n, np.ndarray) and n.size == book.shape[1]:
        # All slots at once: take whole rows, which is much faster than single digits.
        if isinstance(row, int):
            return Value(book[row].reshape(n.shape), faults)
        if row.shape[-1] == 1:
            return Value(book[row[..., 0]], faults)
    return Value(book[row, n], faults)


_COMPARE: Mapping[str, Callable[[Data, Data], Data]] = {
    "<": lt,
    "<=": le,
    ">": gt,
    ">=": ge,
    "==": eq,
    "!=": ne,
}
