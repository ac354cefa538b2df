"""The tree of a shutter program: what was written, where, and nothing else.

Every node carries the span of its text. Nodes are frozen values; equality ignores nothing.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from nscc.source import Span


@dataclass(frozen=True, slots=True)
class Node:
    """Anything with a place in the source."""

    span: Span


# --- expressions --------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Int(Node):
    value: int


@dataclass(frozen=True, slots=True)
class Bool(Node):
    value: bool


@dataclass(frozen=True, slots=True)
class Name(Node):
    text: str


@dataclass(frozen=True, slots=True)
class Unary(Node):
    """`op` is "-" or "not"."""

    op: str
    operand: Expr


@dataclass(frozen=True, slots=True)
class Binary(Node):
    """`op` is one of * / % + - << and xor or."""

    op: str
    left: Expr
    right: Expr


@dataclass(frozen=True, slots=True)
class Compare(Node):
    """A chain `first op0 rest0 op1 rest1 ...`; ops are < <= > >= == !=."""

    first: Expr
    ops: tuple[str, ...]
    rest: tuple[Expr, ...]


@dataclass(frozen=True, slots=True)
class IfElse(Node):
    """`then if condition else otherwise`."""

    then: Expr
    condition: Expr
    otherwise: Expr


@dataclass(frozen=True, slots=True)
class Index(Node):
    """`base[index]`: bit of a bit field, or digit n of a codebook's row."""

    base: Name
    index: Expr


@dataclass(frozen=True, slots=True)
class Call(Node):
    """`min(...)` or `max(...)`."""

    function: Name
    arguments: tuple[Expr, ...]


Expr = Int | Bool | Name | Unary | Binary | Compare | IfElse | Index | Call


# --- pieces of statements -----------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Time(Node):
    """A length of time, exact, in microseconds."""

    us: Fraction


@dataclass(frozen=True, slots=True)
class Text(Node):
    """A quoted string, without its quotes."""

    value: str


@dataclass(frozen=True, slots=True)
class BookRow(Node):
    """The digits of a codebook's row with the underscores taken out, first digit slot 0."""

    digits: str


@dataclass(frozen=True, slots=True)
class TileRow(Node):
    values: tuple[Expr, ...]


# --- statements ---------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Version(Node):
    """`nsl 1`."""

    number: Int


@dataclass(frozen=True, slots=True)
class TargetByName(Node):
    name: Name


@dataclass(frozen=True, slots=True)
class TargetFromFile(Node):
    path: Text


@dataclass(frozen=True, slots=True)
class EqualSlots(Node):
    """`frame COUNT slots of LENGTH`."""

    count: Expr
    length: Time


@dataclass(frozen=True, slots=True)
class ListedSlots(Node):
    """`frame slots [TIME, ...]`."""

    lengths: tuple[Time, ...]


@dataclass(frozen=True, slots=True)
class Let(Node):
    name: Name
    value: Expr


@dataclass(frozen=True, slots=True)
class CodeRange(Node):
    """`code NAME : LO..HI`, both included."""

    name: Name
    low: Expr
    high: Expr


@dataclass(frozen=True, slots=True)
class CodeBits(Node):
    """`code NAME : bit[COUNT]`."""

    name: Name
    count: Expr


@dataclass(frozen=True, slots=True)
class CodeRow(Node):
    """`code NAME : row of BOOK`."""

    name: Name
    book: Name


@dataclass(frozen=True, slots=True)
class Require(Node):
    condition: Expr


@dataclass(frozen=True, slots=True)
class BookInline(Node):
    """`shutters NAME [ROW, ...]`."""

    name: Name
    rows: tuple[BookRow, ...]


@dataclass(frozen=True, slots=True)
class BookFromFile(Node):
    """`shutters NAME from "FILE" [key KEY] [sha256 "..."]`."""

    name: Name
    path: Text
    key: Name | None
    sha256: Text | None


@dataclass(frozen=True, slots=True)
class Open(Node):
    """`open when RULE`."""

    rule: Expr


@dataclass(frozen=True, slots=True)
class Bucket(Node):
    """`bucket NAME open when RULE`."""

    name: Name
    rule: Expr


@dataclass(frozen=True, slots=True)
class PixelsExpr(Node):
    """`pixels FIELD = EXPR`."""

    field: Name
    value: Expr


@dataclass(frozen=True, slots=True)
class PixelsTile(Node):
    """`pixels FIELD = tile [[..], ..]`."""

    field: Name
    rows: tuple[TileRow, ...]


@dataclass(frozen=True, slots=True)
class PixelsFromFile(Node):
    """`pixels from "FILE" [sha256 "..."]`."""

    path: Text
    sha256: Text | None


Statement = (
    Version
    | TargetByName
    | TargetFromFile
    | EqualSlots
    | ListedSlots
    | Let
    | CodeRange
    | CodeBits
    | CodeRow
    | Require
    | BookInline
    | BookFromFile
    | Open
    | Bucket
    | PixelsExpr
    | PixelsTile
    | PixelsFromFile
)


@dataclass(frozen=True, slots=True)
class File(Node):
    """A whole program, its statements in the order written."""

    statements: tuple[Statement, ...]
