"""From lark's tree of a statement to ours, bottom up, so that nothing recurses."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from lark import Token
from lark.tree import Meta
from lark.visitors import Transformer_NonRecursive

from nscc.source import Span
from nscc.syntax import tree
from nscc.syntax.lexer import span_of

MOST_INTEGER = 10**18
_MOST_DECIMALS = 18
_UNIT_US = {"ns": Fraction(1, 1000), "us": Fraction(1), "ms": Fraction(1000), "s": Fraction(10**6)}


class Refused(Exception):
    """A statement that parses but says something that no program may say."""

    def __init__(self, code: str, message: str, span: Span, help_text: str) -> None:
        super().__init__(message)
        self.code = code
        self.message = message
        self.span = span
        self.help_text = help_text


class Builder(Transformer_NonRecursive[Token, Any]):
    """Makes the nodes of one statement from lark's tree of it, from the leaves up.

    Raises Refused: NS0111 for a number beyond 10^18, NS0112 for a time of zero.
    """

    def __init__(self) -> None:
        super().__init__(visit_tokens=False)

    def __default__(self, data: str, children: list[Any], meta: Meta) -> Any:
        if data in _NO_NODE:
            return children[0] if children else None
        return _NODES[data](Span(meta.start_pos, meta.end_pos), *children)


def _integer(span: Span, token: Token) -> tree.Int:
    return tree.Int(span, _whole_number(token.value, span))


def _time(span: Span, token: Token) -> tree.Time:
    return tree.Time(span, _microseconds(token.value, span))


def _call(span: Span, function: Token, *arguments: tree.Expr) -> tree.Call:
    return tree.Call(span, tree.Name(span_of(function), function.value), arguments)


def _compare(span: Span, first: tree.Expr, *rest: Any) -> tree.Compare:
    return tree.Compare(span, first, tuple(token.value for token in rest[::2]), rest[1::2])


_NO_NODE = frozenset(("brackets", "key", "sha256"))
"""Rules that stand for what is in them, or for nothing."""

_NODES: dict[str, Callable[..., Any]] = {
    "integer": _integer,
    "name": lambda span, token: tree.Name(span, token.value),
    "text": lambda span, token: tree.Text(span, token.value[1:-1]),
    "row": lambda span, token: tree.BookRow(span, token.value.replace("_", "")),
    "time": _time,
    "true": lambda span: tree.Bool(span, True),
    "false": lambda span: tree.Bool(span, False),
    "unary": lambda span, sign, operand: tree.Unary(span, sign.value, operand),
    "binary": lambda span, left, sign, right: tree.Binary(span, sign.value, left, right),
    "compare": _compare,
    "call": _call,
    "index": tree.Index,
    "if_else": tree.IfElse,
    "tile_row": lambda span, *values: tree.TileRow(span, values),
    "version": tree.Version,
    "target_by_name": lambda span, token: tree.TargetByName(
        span, tree.Name(span_of(token), token.value)
    ),
    "target_from_file": tree.TargetFromFile,
    "equal_slots": tree.EqualSlots,
    "listed_slots": lambda span, *lengths: tree.ListedSlots(span, lengths),
    "let": tree.Let,
    "code_range": tree.CodeRange,
    "code_bits": tree.CodeBits,
    "code_row": tree.CodeRow,
    "require": tree.Require,
    "book_inline": lambda span, name, *rows: tree.BookInline(span, name, rows),
    "book_from_file": tree.BookFromFile,
    "open": tree.Open,
    "bucket": tree.Bucket,
    "pixels_expr": tree.PixelsExpr,
    "pixels_tile": lambda span, field, *rows: tree.PixelsTile(span, field, rows),
    "pixels_from_file": tree.PixelsFromFile,
}
"""What each rule makes of its span and its parts: nodes, and the tokens that the grammar names."""


def _whole_number(text: str, span: Span) -> int:
    digits = text.lstrip("0")
    value = int(digits or "0") if len(digits) <= 19 else MOST_INTEGER + 1
    if value > MOST_INTEGER:
        raise Refused(
            "NS0111",
            "this number is larger than 10^18",
            span,
            "numbers count slots, codes and pixels: none of them comes near that",
        )
    return value


def _microseconds(text: str, span: Span) -> Fraction:
    number = text.rstrip("nums")
    whole, _, decimals = number.partition(".")
    if len(decimals) > _MOST_DECIMALS:
        raise Refused(
            "NS0111",
            f"this time has {len(decimals)} decimals",
            span,
            f"at most {_MOST_DECIMALS} decimals are read",
        )
    us = (_whole_number(whole, span) + Fraction(f"0.{decimals or 0}")) * _UNIT_US[
        text[len(number) :]
    ]
    if us == 0:
        raise Refused("NS0112", "this slot takes no time", span, "give it a time above zero")
    return us
