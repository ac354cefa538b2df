"""Conversion of lark's tree of a statement to nscc's tree, from the leaves up, without
recursion."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import partial
from typing import Any, NamedTuple

from lark import Token, Tree
from lark.tree import Meta
from lark.visitors import Transformer_NonRecursive

from nscc.diagnostics.diagnostic import Label, Rejected, rejected
from nscc.source import Span
from nscc.syntax import tree
from nscc.syntax.lexer import span_of

MOST_DEPTH = 200
"""Most levels of nodes and brackets in a statement, because later passes recurse over the tree.

Python's limit of a thousand calls then allows each pass four calls per level."""

_MOST_DECIMALS = 18
"""Most digits behind the decimal point of a number."""
_UNIT_US = {"ns": Fraction(1, 1000), "us": Fraction(1), "ms": Fraction(1000), "s": Fraction(10**6)}


class _Part(NamedTuple):
    """A node under construction (`value`), its depth, and its first and last token, with brackets
    outside the node's span."""

    value: Any
    depth: int
    first: Token
    last: Token


class Builder(Transformer_NonRecursive[Token, _Part]):
    """Converts lark's tree of a statement to nscc's node, from the leaves up.

    Raises Rejected, without a source, for statements that parse but exceed a limit: NS0110 for more
    than MOST_DEPTH levels, NS0111 for a number beyond 2^62 - 1, or too many decimals, NS0112 for a
    time of zero."""

    def __init__(self) -> None:
        """Begin; tokens are not converted one by one."""
        super().__init__(visit_tokens=False)

    def build(self, statement: Tree[Token]) -> tree.Statement:
        """Return the node of a statement, of which lark's tree is given."""
        node: tree.Statement = self.transform(statement).value
        return node

    def __default__(self, data: str, children: list[Token | _Part], meta: Meta) -> _Part:
        """Return the node of a grammar rule (`data`) from its parts, the `children`: tokens, and
        nodes that are made already; lark calls this for each rule.

        Raises Rejected (NS0110) for expressions nested more than `MOST_DEPTH` deep."""
        begin, end = children[0], children[-1]
        first = begin.first if isinstance(begin, _Part) else begin
        last = end.last if isinstance(end, _Part) else end
        nodes = [child for child in children if isinstance(child, _Part)]
        # A node without parts has depth 0.
        depth = 1 + max([node.depth for node in nodes], default=-1)
        if depth > MOST_DEPTH:
            raise rejected(
                "NS0110",
                f"this expression is nested more than {MOST_DEPTH} deep",
                label=Label(span_of(last), "the limit is exceeded here"),
                notes=("brackets and every operator of a chain count",),
                helps=(
                    "name parts of the expression with `let`, or put data into a `tile` or a file",
                ),
            )
        make = _OF_NODES.get(data)
        arguments: list[Token | _Part] | list[_Part] = nodes
        if make is None:
            make, arguments = _OF_ALL[data], children
        span = Span(span_of(first).start, span_of(last).end)
        return _Part(make(span, *[node.value for node in arguments]), depth, first, last)


def _from_file(
    make: Callable[..., Any],
    span: Span,
    name: tree.Name,
    path: tree.Text,
    *options: tree.Name | tree.Text,
) -> Any:
    """Make the statement `make` with a file and its options in any order: a Name is the `key`, a
    Text the `sha256`; each may be missing."""
    key = next((option for option in options if isinstance(option, tree.Name)), None)
    sha256 = next((option for option in options if isinstance(option, tree.Text)), None)
    return make(span, name, path, key, sha256)


def _kernel(span: Span, name: tree.Name, *rows_and_divisor: Any) -> tree.Kernel:
    """Make the convolution kernel `name` from its rows and, as the last value, an optional
    divisor."""
    has_divisor = not isinstance(rows_and_divisor[-1], tree.TileRow)
    rows, divisor = (
        (rows_and_divisor[:-1], rows_and_divisor[-1]) if has_divisor else (rows_and_divisor, None)
    )
    return tree.Kernel(span, name, rows, divisor)


def _assume(span: Span, *children: Any) -> tree.Assume:
    """Make an `assume` statement. `children` are an optional bucket (a Name), then the texts of the
    comparison and of the level."""
    bucket = next((child for child in children if isinstance(child, tree.Name)), None)
    comparison, level = children[-2:]
    return tree.Assume(span, bucket, comparison, _amount(level, span))


def _among(span: Span, value: tree.Expr, *items: tree.Expr) -> tree.Expr:
    """Return `value in [a, b, ..]` as `value == a or value == b or ..`.

    There is at least one item. The chain is a balanced tree, because later passes recurse over it.
    """
    tests: list[tree.Expr] = [tree.Compare(span, value, ("==",), (item,)) for item in items]
    while len(tests) > 1:
        pairs = [tests[i : i + 2] for i in range(0, len(tests), 2)]
        tests = [p[0] if len(p) == 1 else tree.Binary(span, "or", *p) for p in pairs]
    return tests[0]


def _state(span: Span, *children: Any) -> tree.StateRange | tree.StateBit:
    """Make a state at `span` from `children`: its name and values, and True for the word `kept`.

    With one value, the start, it is a bit; with three, a range and its start."""
    name, *values = [child for child in children if child is not True]
    is_kept = len(values) + 1 < len(children)
    if len(values) == 1:
        return tree.StateBit(span, name, values[0], is_kept)
    low, high, start = values
    return tree.StateRange(span, name, low, high, start, kept=is_kept)


def _state_image(span: Span, *children: Any) -> tree.StateImage:
    """Make a state that is an image from `children`: its name, its start if it has one, and True
    for the word `kept`."""
    name, *values = [child for child in children if child is not True]
    return tree.StateImage(span, name, values[0] if values else None, True in children)


def _repeat(span: Span, *children: Any) -> tree.Repeat:
    """Make a repeated image or plane, with those that step together with it, from nodes and
    tokens.

    `children` are the word `image` or `plane`, the name, `=`, the start, `repeat`, the count and
    the step. The other names of the statement, as `Repeated`, follow."""
    kind, name, _equals, start, _repeat_token, count, step, *others = children
    leader = tree.Repeated(span, str(kind), name, start, step)
    return tree.Repeat(span, count, (leader, *others))


def _with(span: Span, *children: Any) -> tree.Repeated:
    """Make a name of a `repeat` statement that steps together with the first, from nodes and
    tokens.

    `children` are `with`, the word `image` or `plane`, the name, `=`, the start, `repeat` and the
    step."""
    _with_token, kind, name, _equals, start, _repeat_token, step = children
    return tree.Repeated(span, str(kind), name, start, step)


def _amount(text: str, span: Span) -> tree.Amount:
    """Return the level `text`, such as `10%`, `3lsb` or `500e`, as a number with its unit.

    Raises Rejected (NS0111) at `span` for too large a number or too many decimals."""
    unit = next(unit for unit in ("%", "lsb", "e") if text.endswith(unit))
    integer_digits, _, decimals = text.removesuffix(unit).partition(".")
    return tree.Amount(span, _whole_number(integer_digits, span) + _decimals(decimals, span), unit)


_OF_ALL: dict[str, Callable[..., Any]] = {
    "integer": lambda span, text: tree.Int(span, _whole_number(text, span)),
    "name": tree.Name,
    "text": lambda span, text: tree.Text(span, text[1:-1]),
    "row": lambda span, text: tree.BookRow(span, text.replace("_", "")),
    "time": lambda span, text: tree.Time(span, _microseconds(text, span)),
    "true": lambda span, _word: tree.Bool(span, True),
    "false": lambda span, _word: tree.Bool(span, False),
    "unary": tree.Unary,
    "binary": lambda span, first, sign, second: tree.Binary(span, sign, first, second),
    "compare": lambda span, first, *later: tree.Compare(span, first, later[::2], later[1::2]),
    "amount": lambda span, text: _amount(text, span),
    "assume": _assume,
    "repeat": _repeat,
    "with": _with,
    "place": lambda span, base, _open, right, _comma, down, _close: tree.Place(
        span, base, right, down
    ),
    "sense": lambda span, _sense, name, _when_token, signal, sign, level, _at, at: tree.Sense(
        span, name, signal, comparison=sign, level=level, at=at
    ),
}
"""For each grammar rule a function of its span, its nodes and the texts of its tokens."""

_OF_NODES: dict[str, Callable[..., Any]] = {
    "brackets": lambda _span, node: node,
    "index": tree.Index,
    "call": lambda span, function, *arguments: tree.Call(span, function, arguments),
    "call_at_most": lambda span, function, *arguments: tree.Call(
        span, function, arguments[:-2], arguments[-1]
    ),
    "if_else": tree.IfElse,
    "key": lambda _span, name: name,
    "sha256": lambda _span, text: text,
    "tile_row": lambda span, *values: tree.TileRow(span, values),
    "version": tree.Version,
    "target_by_name": tree.TargetByName,
    "target_from_file": tree.TargetFromFile,
    "equal_slots": tree.EqualSlots,
    "listed_slots": lambda span, *lengths: tree.ListedSlots(span, lengths),
    "let": tree.Let,
    "code_range": tree.CodeRange,
    "code_bits": tree.CodeBits,
    "code_row": tree.CodeRow,
    "require": tree.Require,
    "book_inline": lambda span, name, *rows: tree.BookInline(span, name, rows),
    "book_from_file": partial(_from_file, tree.BookFromFile),
    "kernel": _kernel,
    "kernel_from_file": partial(_from_file, tree.KernelFromFile),
    "image": tree.Image,
    "plane": tree.Plane,
    "input": tree.Input,
    "param": tree.Param,
    "state_image": _state_image,
    "outside": tree.Outside,
    "report": lambda span, kind, plane, most=None, count=None: tree.Report(
        span, kind, plane, most, count
    ),
    "open": tree.Open,
    "bucket": tree.Bucket,
    "among": _among,
    "light": tree.Light,
    "exposure": lambda span, bucket=None: tree.Exposure(span, bucket),
    "levels": lambda span, *items: tree.Levels(span, items),
    "kept": lambda _span: True,
    "state_range": _state,
    "state_bit": _state,
    "next": lambda span, name, value, condition=None: tree.Next(span, name, value, condition),
    "reset": tree.Reset,
    "read": lambda span, *names: tree.Read(span, names),
    "pixels_expr": tree.PixelsExpr,
    "pixels_tile": lambda span, field, *rows: tree.PixelsTile(span, field, rows),
    "pixels_from_file": lambda span, path, sha256=None: tree.PixelsFromFile(span, path, sha256),
}
"""For the other rules a function of the rule's span and nodes."""


def _whole_number(text: str, span: Span) -> int:
    """Return the number of a text of digits.

    Raises Rejected (NS0111) at `span` above 2^62 - 1, without converting many digits."""
    digits = text.lstrip("0")
    # 2^62 has 19 digits; any number of more digits counts as the smallest that is too large.
    value = int(digits or "0") if len(digits) <= 19 else tree.MOST_INTEGER + 1
    if value > tree.MOST_INTEGER:
        help_text = (
            "write a smaller number; codes of more than 62 bits are bit fields, "
            "`code NAME : bit[K]`, whose values come from a file"
        )
        raise _refused("NS0111", "this number is larger than 2^62 - 1", span, help_text)
    return value


def _microseconds(text: str, span: Span) -> Fraction:
    """Return a time such as `125us` in microseconds, exactly. `text` ends in ns, us, ms or s.

    Raises Rejected at `span`: NS0112 if it is zero, NS0111 for too many digits."""
    number = text.rstrip("nums")  # the letters of ns, us, ms and s
    integer_digits, _, decimals = number.partition(".")
    unit_us = _UNIT_US[text[len(number) :]]
    us = (_whole_number(integer_digits, span) + _decimals(decimals, span)) * unit_us
    if us == 0:
        raise _refused("NS0112", "the slot length is zero", span, "give a time above zero")
    return us


def _decimals(digits: str, span: Span) -> Fraction:
    """Return the digits after a decimal point as an exact fraction below 1; "" is 0.

    Raises Rejected (NS0111) at `span` for more than `_MOST_DECIMALS`."""
    if len(digits) > _MOST_DECIMALS:
        help_text = f"at most {_MOST_DECIMALS} decimals are allowed"
        raise _refused("NS0111", f"this number has {len(digits)} decimals", span, help_text)
    return Fraction(f"0.{digits or 0}")


def _refused(code: str, message: str, span: Span, help_text: str) -> Rejected:
    """Return the exception for a syntax error at `span` with one help, for the caller to raise."""
    return rejected(code, message, label=Label(span), helps=(help_text,))
