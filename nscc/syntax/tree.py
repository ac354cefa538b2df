"""The syntax tree of a program: nodes with the places of their text.

Nodes are frozen values; equality compares all fields."""

from __future__ import annotations

from fractions import Fraction

from nscc.record import Record
from nscc.source import Span


class Node(Record):
    """A node with a place in the source."""

    span: Span


MOST_INTEGER = 2**62 - 1
"""Largest magnitude of a literal and of any value, so that the sum of two values fits 64 bits."""


class Int(Node):
    """A whole number from 0 to MOST_INTEGER."""

    value: int


class Bool(Node):
    """`true` or `false`."""

    value: bool


class Name(Node):
    """A name."""

    text: str


class Unary(Node):
    """A negation: `op` is "-" or "not"."""

    op: str
    operand: Expr


class Binary(Node):
    """An operation on two operands: `op` is one of * / % + - << and xor or."""

    op: str
    left: Expr
    right: Expr


class Compare(Node):
    """A chain `first ops[0] later_operands[0] ops[1] ...`, such as `a < b == c`; each of `ops` is <
    <= > >= == or !=."""

    first: Expr
    ops: tuple[str, ...]
    later_operands: tuple[Expr, ...]


class IfElse(Node):
    """The expression `then if condition else otherwise`."""

    then: Expr
    condition: Expr
    otherwise: Expr


class Index(Node):
    """The expression `base[index]`: bit number `index` of a bit field, from 0, or digit n (the
    slot) of a codebook's row number `index`."""

    base: Name
    index: Expr


class Call(Node):
    """The expression `min(...)` or `max(...)`; in version 3 also a convolution kernel or a function
    of images and planes.

    `most`: the number of steps after `at most`, in version 4; None without."""

    function: Name
    arguments: tuple[Expr, ...]
    most: Expr | None = None


class Place(Node):
    """The expression `plane[right, down]`: the bit of the pixel that lies `right` columns to the
    right and `down` rows down; in version 4 also the value of an image."""

    base: Name
    right: Expr
    down: Expr


class Amount(Node):
    """A level with its unit: "%" of a full well, "e" (electrons) or "lsb" (converter codes)."""

    value: Fraction
    unit: str


Expr = Int | Bool | Name | Unary | Binary | Compare | IfElse | Index | Call | Place | Amount
"""Any expression."""


# --- pieces of statements -----------------------------------------------------------------------


class Time(Node):
    """A length of time in microseconds (`us`), exact."""

    us: Fraction


class Text(Node):
    """A quoted string, without its quotes."""

    value: str


class BookRow(Node):
    """The digits of a codebook's row without underscores; the first digit is slot 0."""

    digits: str


class TileRow(Node):
    """One row of a tile of codes, or of the weights of a kernel, from left to right."""

    values: tuple[Expr, ...]


class Light(Node):
    """The expression `light`: the charge since the frame's start or the pixel's last reset, with
    shutter open or closed."""


class Exposure(Node):
    """The expression `exposure [BUCKET]`: the light of the completed open slots. `bucket` is None
    if none is named, which only programs with one bucket may do."""

    bucket: Name | None


class Levels(Node):
    """The expression `[LEVEL, ...]`: a level for each look of a sense, in the order of
    boundaries."""

    items: tuple[Amount | Expr, ...]


# --- statements ---------------------------------------------------------------------------------


class Version(Node):
    """The statement `nsl 1`."""

    number: Int


class TargetByName(Node):
    """`target NAME`: a built-in chip."""

    name: Name


class TargetFromFile(Node):
    """`target "FILE"`: the table of a chip."""

    path: Text


class EqualSlots(Node):
    """The statement `frame COUNT slots of LENGTH`."""

    count: Expr
    length: Time


class ListedSlots(Node):
    """The statement `frame slots [TIME, ...]`."""

    lengths: tuple[Time, ...]


class Let(Node):
    """`let NAME = VALUE`: a constant."""

    name: Name
    value: Expr


class CodeRange(Node):
    """The statement `code NAME : LO..HI`, both included."""

    name: Name
    low: Expr
    high: Expr


class CodeBits(Node):
    """The statement `code NAME : bit[COUNT]`."""

    name: Name
    count: Expr


class CodeRow(Node):
    """The statement `code NAME : row of BOOK`."""

    name: Name
    book: Name


class Require(Node):
    """`require CONDITION`: which codes are legal."""

    condition: Expr


class BookInline(Node):
    """The statement `shutters NAME [ROW, ...]`."""

    name: Name
    rows: tuple[BookRow, ...]


class FromFile(Node):
    """A statement `KEYWORD NAME from "FILE" [key KEY] [sha256 "..."]`. `key` is the array's name in
    the file, None for NAME; without `sha256` (None), the file's content is not checked."""

    name: Name
    path: Text
    key: Name | None
    sha256: Text | None


class BookFromFile(FromFile):
    """The statement `shutters NAME from ..`."""


class Open(Node):
    """The statement `open when RULE`."""

    rule: Expr


class Bucket(Node):
    """The statement `bucket NAME open when RULE`."""

    name: Name
    rule: Expr


class Sense(Node):
    """The statement `sense NAME when SIGNAL COMPARISON LEVEL at WHEN`; `comparison` is the sign as
    written, which a later pass checks. A `level` that is a Name may be a field of the code."""

    name: Name
    signal: Light | Exposure
    comparison: str
    level: Amount | Levels | Expr
    at: Expr


class StateRange(Node):
    """The statement `state NAME : LO..HI = START [kept]`."""

    name: Name
    low: Expr
    high: Expr
    start: Expr
    kept: bool


class StateBit(Node):
    """The statement `state NAME : bit = START [kept]`."""

    name: Name
    start: Expr
    kept: bool


class Next(Node):
    """The statement `next NAME = EXPR [when CONDITION]`; `condition` is None without `when`."""

    name: Name
    value: Expr
    condition: Expr | None


class Reset(Node):
    """The statement `reset when EXPR`."""

    condition: Expr


class Read(Node):
    """The statement `read NAME, ...`."""

    names: tuple[Name, ...]


class Kernel(Node):
    """The statement `kernel NAME = [[..], ..] / DIVISOR`; `divisor` is None if there is none."""

    name: Name
    rows: tuple[TileRow, ...]
    divisor: Expr | None


class KernelFromFile(FromFile):
    """The statement `kernel NAME from ..`."""


class Image(Node):
    """The statement `image NAME = EXPR`."""

    name: Name
    value: Expr


class Plane(Node):
    """The statement `plane NAME = CONDITION`."""

    name: Name
    condition: Expr


class Repeated(Node):
    """A name of a `repeat` with its kind ("image" or "plane"), its start and its step."""

    kind: str
    name: Name
    start: Expr
    step: Expr


class Repeat(Node):
    """The statement `image NAME = START repeat COUNT STEP [with image NAME = START repeat STEP]`;
    also of planes.

    `items` are the names that step together."""

    count: Expr
    items: tuple[Repeated, ...]

    @property
    def name(self) -> Name:
        """The name that the statement declares first."""
        return self.items[0].name


class Input(Node):
    """The statement `input plane NAME`."""

    name: Name


class Param(Node):
    """The statement `param NAME : LOW .. HIGH = START`."""

    name: Name
    low: Expr
    high: Expr
    start: Expr


class StateImage(Node):
    """The statement `state NAME : image kept [= START]`; without a `start` (None), the image starts
    at 0."""

    name: Name
    start: Expr | None
    kept: bool


class Outside(Node):
    """The statement `outside 0` or `outside 1`."""

    bit: Int


class Assume(Node):
    """The statement `assume exposure [BUCKET] <= LEVEL`; `comparison` is the sign as written."""

    bucket: Name | None
    comparison: str
    level: Amount


class Report(Node):
    """The statement `report KIND PLANE [at most COUNT]`; `most` is the word before COUNT, which a
    later pass checks; both are None without `at most`."""

    kind: Name
    plane: Name
    most: Name | None
    count: Expr | None


class PixelsExpr(Node):
    """The statement `pixels FIELD = EXPR`."""

    field: Name
    value: Expr


class PixelsTile(Node):
    """The statement `pixels FIELD = tile [[..], ..]`."""

    field: Name
    rows: tuple[TileRow, ...]


class PixelsFromFile(Node):
    """The statement `pixels from "FILE" [sha256 "..."]`; without `sha256` (None), the file's
    content is not checked."""

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
    | Sense
    | StateRange
    | StateBit
    | Next
    | Reset
    | Read
    | Kernel
    | KernelFromFile
    | Image
    | Plane
    | Outside
    | Assume
    | Report
    | PixelsExpr
    | PixelsTile
    | PixelsFromFile
    | Repeat
    | Input
    | Param
    | StateImage
)


class File(Node):
    """A program: its statements in the order of the text."""

    statements: tuple[Statement, ...]
