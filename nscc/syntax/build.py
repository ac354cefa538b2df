"""From the parser's reductions to nodes of the tree, bottom up, so that nothing recurses."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from nscc.source import Span
from nscc.syntax import tree
from nscc.syntax.lexer import Tokens

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


class Builder:
    """Makes the nodes of one text's rules (an `automaton.Build`).

    Raises Refused: NS0111 for a number beyond 10^18, NS0112 for a time of zero.
    """

    def __init__(self, tokens: Tokens) -> None:
        self._tokens = tokens
        self._integers: dict[str, int] = {}

    def __call__(self, action: str, span: Span, parts: list[Any]) -> Any:
        """The node of a rule; a part that is an int is a token's index."""
        plain = _PLAIN.get(action)
        if plain is not None:
            return plain(span, *parts)
        method: Callable[[Span, list[Any]], Any] = getattr(self, f"_{action}")
        return method(span, parts)

    # Leaves: their only part is a token.

    def _integer(self, span: Span, parts: list[Any]) -> tree.Int:
        text = self._tokens.text(parts[0])
        value = self._integers.get(text)
        if value is None:
            value = self._integers[text] = _integer(text, span)
        return tree.Int(span, value)

    def _name(self, span: Span, parts: list[Any]) -> tree.Name:
        return tree.Name(span, self._tokens.text(parts[0]))

    def _text(self, span: Span, parts: list[Any]) -> tree.Text:
        return tree.Text(span, self._tokens.text(parts[0])[1:-1])

    def _row(self, span: Span, parts: list[Any]) -> tree.BookRow:
        return tree.BookRow(span, self._tokens.text(parts[0]).replace("_", ""))

    def _time(self, span: Span, parts: list[Any]) -> tree.Time:
        return tree.Time(span, _microseconds(self._tokens.text(parts[0]), span))

    # Expressions with tokens among their parts.

    def _unary(self, span: Span, parts: list[Any]) -> tree.Unary:
        operator, operand = parts
        return tree.Unary(span, self._tokens.text(operator), operand)

    def _binary(self, span: Span, parts: list[Any]) -> tree.Binary:
        left, operator, right = parts
        return tree.Binary(span, self._tokens.text(operator), left, right)

    def _compare(self, span: Span, parts: list[Any]) -> tree.Compare:
        operators = tuple(map(self._tokens.text, parts[1::2]))
        return tree.Compare(span, parts[0], operators, tuple(parts[2::2]))

    def _call(self, span: Span, parts: list[Any]) -> tree.Call:
        token, *arguments = parts
        function = tree.Name(self._tokens.span(token), self._tokens.text(token))
        return tree.Call(span, function, tuple(arguments))

    # Statements with a token or an unknown number of parts.

    def _target_by_name(self, span: Span, parts: list[Any]) -> tree.TargetByName:
        token = parts[0]
        return tree.TargetByName(
            span, tree.Name(self._tokens.span(token), self._tokens.text(token))
        )


def _true(span: Span) -> tree.Bool:
    return tree.Bool(span, True)


def _false(span: Span) -> tree.Bool:
    return tree.Bool(span, False)


def _optional(_span: Span, part: Any = None) -> Any:
    return part


def _tile_row(span: Span, *values: Any) -> tree.TileRow:
    return tree.TileRow(span, values)


def _listed_slots(span: Span, *lengths: Any) -> tree.ListedSlots:
    return tree.ListedSlots(span, lengths)


def _book_inline(span: Span, name: Any, *rows: Any) -> tree.BookInline:
    return tree.BookInline(span, name, rows)


def _pixels_tile(span: Span, field: Any, *rows: Any) -> tree.PixelsTile:
    return tree.PixelsTile(span, field, rows)


_PLAIN: dict[str, Callable[..., Any]] = {
    "true": _true,
    "false": _false,
    "key": _optional,
    "sha256": _optional,
    "index": tree.Index,
    "if_else": tree.IfElse,
    "tile_row": _tile_row,
    "version": tree.Version,
    "target_from_file": tree.TargetFromFile,
    "equal_slots": tree.EqualSlots,
    "listed_slots": _listed_slots,
    "let": tree.Let,
    "code_range": tree.CodeRange,
    "code_bits": tree.CodeBits,
    "code_row": tree.CodeRow,
    "require": tree.Require,
    "book_inline": _book_inline,
    "book_from_file": tree.BookFromFile,
    "open": tree.Open,
    "bucket": tree.Bucket,
    "pixels_expr": tree.PixelsExpr,
    "pixels_tile": _pixels_tile,
    "pixels_from_file": tree.PixelsFromFile,
}
"""The rules whose parts are nodes already, in the order of the node's fields."""


def _integer(text: str, span: Span) -> int:
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
    us = (_integer(whole, span) + Fraction(f"0.{decimals or 0}")) * _UNIT_US[text[len(number) :]]
    if us == 0:
        raise Refused("NS0112", "this slot takes no time", span, "give it a time above zero")
    return us
