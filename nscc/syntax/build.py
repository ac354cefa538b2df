"""From the parser's reductions to nodes of the tree, bottom up, so that nothing recurses.

A node's depth is known when it is built; too deep a tree is refused at once, so every later pass
may recurse.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from lark import Token, Transformer, v_args

from nscc.source import Span
from nscc.syntax import tree

MOST_DEPTH = 100
MOST_INTEGER = 10**18
_UNIT_US = {"ns": Fraction(1, 1000), "us": Fraction(1), "ms": Fraction(1000), "s": Fraction(10**6)}


class Refused(Exception):
    """A statement that parses but says something that no program may say."""

    def __init__(self, code: str, message: str, span: Span, help_text: str) -> None:
        super().__init__(message)
        self.code = code
        self.message = message
        self.span = span
        self.help_text = help_text


def span_of(token: Token) -> Span:
    """The place of a token."""
    assert token.start_pos is not None and token.end_pos is not None
    return Span(token.start_pos, token.end_pos)


def _name(token: Token) -> tree.Name:
    return tree.Name(span_of(token), str(token))


def _text(token: Token) -> tree.Text:
    return tree.Text(span_of(token), str(token)[1:-1])


@v_args(inline=True)
class Builder(Transformer):  # type: ignore[type-arg, misc]  # lark's generics are runtime only
    """Callbacks by rule name. Statements get the span of their parts; the parser widens it to the
    statement's first word."""

    def __init__(self) -> None:
        super().__init__()
        self._depth: dict[int, int] = {}
        self._alive: list[Any] = []

    def reset(self) -> None:
        """Forgets the nodes of the last statement."""
        self._depth.clear()
        self._alive.clear()

    def _deep(self, node: Any, *parts: Any) -> Any:
        depth = 1 + max((self._depth.get(id(part), 0) for part in parts), default=0)
        if depth > MOST_DEPTH:
            raise Refused(
                "NS0110",
                f"this expression is nested more than {MOST_DEPTH} deep",
                node.span,
                "name parts of it with `let`, or use `tile` or a file for data",
            )
        self._depth[id(node)] = depth
        self._alive.append(node)
        return node

    # Expressions.

    def int(self, token: Token) -> tree.Int:
        if len(token) > 19 or int(token) > MOST_INTEGER:
            raise Refused(
                "NS0111",
                "this number is larger than 10^18",
                span_of(token),
                "numbers of a program count slots, codes and pixels",
            )
        return tree.Int(span_of(token), int(token))

    def true(self, token: Token) -> tree.Bool:
        return tree.Bool(span_of(token), True)

    def false(self, token: Token) -> tree.Bool:
        return tree.Bool(span_of(token), False)

    def name(self, token: Token) -> tree.Name:
        return _name(token)

    def grouped(self, inner: Any, _close: Token) -> Any:
        return self._deep(inner, inner)

    def unary(self, operator: Token, operand: Any) -> Any:
        span = span_of(operator).to(operand.span)
        return self._deep(tree.Unary(span, str(operator), operand), operand)

    def binary(self, left: Any, operator: Token, right: Any) -> Any:
        span = left.span.to(right.span)
        return self._deep(tree.Binary(span, str(operator), left, right), left, right)

    def compare(self, first: Any, *rest: Any) -> Any:
        operators = tuple(str(token) for token in rest[::2])
        operands = tuple(rest[1::2])
        span = first.span.to(operands[-1].span)
        return self._deep(tree.Compare(span, first, operators, operands), first, *operands)

    def if_else(self, then: Any, condition: Any, otherwise: Any) -> Any:
        span = then.span.to(otherwise.span)
        return self._deep(
            tree.IfElse(span, then, condition, otherwise), then, condition, otherwise
        )

    def index(self, base: Token, _begin: Token, index: Any, end: Token) -> Any:
        return self._deep(tree.Index(span_of(base).to(span_of(end)), _name(base), index), index)

    def call(self, function: Token, *rest: Any) -> Any:
        arguments = rest[:-1]
        span = span_of(function).to(span_of(rest[-1]))
        return self._deep(tree.Call(span, _name(function), tuple(arguments)), *arguments)

    # Pieces of statements.

    def time(self, token: Token) -> tree.Time:
        text = str(token)
        digits = text.rstrip("num" + "s")
        if len(digits) > 30:
            raise Refused(
                "NS0111", "this time has too many digits", span_of(token), "write it in s or ns"
            )
        us = Fraction(digits) * _UNIT_US[text[len(digits) :]]
        if us <= 0:
            raise Refused(
                "NS0112", "a slot lasts longer than nothing", span_of(token), "give a positive time"
            )
        return tree.Time(span_of(token), us)

    def row(self, token: Token) -> tree.BookRow:
        return tree.BookRow(span_of(token), str(token).replace("_", ""))

    def tile_row(self, begin: Token, *rest: Any) -> tree.TileRow:
        return tree.TileRow(span_of(begin).to(span_of(rest[-1])), tuple(rest[:-1]))

    # Statements.

    def version(self, number: tree.Int) -> tree.Version:
        return tree.Version(number.span, number)

    def target_by_name(self, name: Token) -> tree.TargetByName:
        return tree.TargetByName(span_of(name), _name(name))

    def target_from_file(self, path: Token) -> tree.TargetFromFile:
        return tree.TargetFromFile(span_of(path), _text(path))

    def equal_slots(self, count: Any, length: tree.Time) -> tree.EqualSlots:
        return tree.EqualSlots(length.span, count, length)

    def listed_slots(self, begin: Token, *rest: Any) -> tree.ListedSlots:
        return tree.ListedSlots(span_of(begin).to(span_of(rest[-1])), tuple(rest[:-1]))

    def let(self, name: Token, value: Any) -> tree.Let:
        return tree.Let(span_of(name), _name(name), value)

    def code_range(self, name: Token, low: Any, high: Any) -> tree.CodeRange:
        return tree.CodeRange(span_of(name), _name(name), low, high)

    def code_bits(self, name: Token, _begin: Token, count: Any, end: Token) -> tree.CodeBits:
        return tree.CodeBits(span_of(name).to(span_of(end)), _name(name), count)

    def code_row(self, name: Token, book: Token) -> tree.CodeRow:
        return tree.CodeRow(span_of(name), _name(name), _name(book))

    def require(self, condition: Any) -> tree.Require:
        return tree.Require(condition.span, condition)

    def book_inline(self, name: Token, begin: Token, *rest: Any) -> tree.BookInline:
        return tree.BookInline(span_of(name).to(span_of(rest[-1])), _name(name), tuple(rest[:-1]))

    def book_from_file(
        self, name: Token, path: Token, key: Token | None, sha256: Token | None
    ) -> tree.BookFromFile:
        return tree.BookFromFile(
            span_of(name).to(span_of(path)),
            _name(name),
            _text(path),
            None if key is None else _name(key),
            None if sha256 is None else _text(sha256),
        )

    def open(self, rule: Any) -> tree.Open:
        return tree.Open(rule.span, rule)

    def bucket(self, name: Token, rule: Any) -> tree.Bucket:
        return tree.Bucket(span_of(name), _name(name), rule)

    def pixels_expr(self, field: Token, value: Any) -> tree.PixelsExpr:
        return tree.PixelsExpr(span_of(field), _name(field), value)

    def pixels_tile(self, field: Token, begin: Token, *rest: Any) -> tree.PixelsTile:
        return tree.PixelsTile(
            span_of(field).to(span_of(rest[-1])), _name(field), tuple(rest[:-1])
        )

    def pixels_from_file(self, path: Token, sha256: Token | None) -> tree.PixelsFromFile:
        return tree.PixelsFromFile(
            span_of(path), _text(path), None if sha256 is None else _text(sha256)
        )


def plain_tile(tokens: list[Token]) -> tree.PixelsTile | None:
    """The statement `pixels FIELD = tile [[1, 2], [3, 4]]` whose cells are plain numbers.

    Big files are tiles; the grammar would climb ten levels of precedence for every number. None for
    any other statement, right or wrong: the parser has the word then.
    """
    if [t.type for t in tokens[2:5]] != ["EQUAL", "TILE", "BEGIN"] or tokens[1].type != "NAME":
        return None
    rows: list[tree.TileRow] = []
    position, last = 5, len(tokens) - 1
    while position < last and tokens[position].type == "BEGIN":
        begin = tokens[position]
        cells: list[tree.Expr] = []
        while tokens[position].type in ("BEGIN", "COMMA") and position + 2 <= last:
            cell = tokens[position + 1]
            if cell.type != "INT" or len(cell) > 18:
                return None
            cells.append(tree.Int(span_of(cell), int(cell)))
            position += 2
        if tokens[position].type != "END":
            return None
        rows.append(tree.TileRow(span_of(begin).to(span_of(tokens[position])), tuple(cells)))
        position += 1
        if position < last and tokens[position].type == "COMMA":
            position += 1
    if not rows or position != last or tokens[last].type != "END" or tokens[last - 1].type == "COMMA":
        return None
    span = span_of(tokens[0]).to(span_of(tokens[last]))
    return tree.PixelsTile(span, _name(tokens[1]), tuple(rows))
