"""Syntax trees in tests: random ones, their text, and what they say without places."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from hypothesis import strategies as st

from nscc.diagnostics.diagnostic import Diagnostic
from nscc.diagnostics.render import render
from nscc.source import Source, Span
from nscc.syntax import tree as t
from nscc.syntax.parse import parse

NOWHERE = Span(0, 0)
LOOKING = frozenset(
    ("sense", "state", "kept", "next", "reset", "read", "at", "in", "light", "exposure")
)
RESERVED = frozenset(
    (
        "nsl",
        "target",
        "frame",
        "let",
        "code",
        "require",
        "shutters",
        "open",
        "bucket",
        "pixels",
        "slots",
        "of",
        "when",
        "tile",
        "from",
        "bit",
        "row",
        "key",
        "sha256",
        "if",
        "else",
        "and",
        "or",
        "xor",
        "not",
        "true",
        "false",
        "min",
        "max",
    )
)
_LEVEL = {"or": 1, "xor": 2, "and": 3, "<<": 6, "+": 7, "-": 7, "*": 8, "/": 8, "%": 8}
_COMPARISONS = ("<", "<=", ">", ">=", "==", "!=")
_NOT, _COMPARE, _SHIFT, _NEGATION, _ATOM = 4, 5, 6, 9, 10

PIECES = (
    "(", "[", "let ", "nsl 1 ", '"', '"\n', "#", "#\n", "# ", "\n", "a", "1", "1_", "1.", "- ",
    "not ", "fram\n", "let 1 ", "let a = 1;\n", "let a = 1\n", "code code : ", "bucket open ",
    "module x\n", "target a-b ", ";", "\u00e9", "\v", "pixels a = tile [[1,\n",
)  # fmt: skip
"""What a parser may have to read over and over, and in proportion to how much it is."""


def over_and_over(piece: str, size: int) -> str:
    """As many pieces as fit into so many bytes."""
    return piece * (size // len(piece.encode()))


def tile(cells: str, size: int) -> str:
    """A program with a tile of so many bytes, its rows of 65 cells or so."""
    row = "[" + cells * 64 + "1]"
    return "nsl 1\npixels a = tile [" + ",\n".join([row] * max(1, size // len(row))) + "]"


def read(text: str) -> tuple[t.File, tuple[Diagnostic, ...]]:
    """The tree and errors of a text."""
    return parse(Source("test.nsl", text))


def check(text: str) -> None:
    """All that is said of a text, in two forms."""
    _, errors = read(text)
    render(errors, "human")
    render(errors, "json")


def codes(text: str) -> list[str]:
    """The codes of a text's errors, in their order."""
    return [d.code for d in read(text)[1]]


def statement(text: str) -> Any:
    """The one statement after `nsl 1`; the text must be right."""
    file, errors = read("nsl 1\n" + text)
    assert not errors, errors
    assert len(file.statements) == 2
    return file.statements[1]


def bare(value: Any) -> Any:
    """A node as nested tuples without its places."""
    if isinstance(value, t.Node):
        return (type(value).__name__, *(bare(getattr(value, f)) for f in value.field_names[1:]))
    if isinstance(value, tuple):
        return tuple(map(bare, value))
    return value


def nodes(value: Any) -> list[t.Node]:
    """A node and all nodes under it."""
    if isinstance(value, tuple):
        return [node for item in value for node in nodes(item)]
    if not isinstance(value, t.Node):
        return []
    return [value, *(node for f in value.field_names[1:] for node in nodes(getattr(value, f)))]


def expression_text(node: Any, loosest: int = 0) -> str:
    """The text of an expression, with brackets only where precedence asks for them."""
    text, level = _with_level(node)
    return f"({text})" if level < loosest else text


def _with_level(node: Any) -> tuple[str, int]:
    match node:
        case t.Int():
            return str(node.value), _ATOM
        case t.Bool():
            return ("true" if node.value else "false"), _ATOM
        case t.Name():
            return node.text, _ATOM
        case t.Index():
            return f"{node.base.text}[{expression_text(node.index)}]", _ATOM
        case t.Call():
            return f"{node.function.text}({', '.join(map(expression_text, node.arguments))})", _ATOM
        case t.Unary(op="-"):
            return f"- {expression_text(node.operand, _NEGATION)}", _NEGATION
        case t.Unary():
            return f"not {expression_text(node.operand, _NOT)}", _NOT
        case t.Compare():
            text = expression_text(node.first, _SHIFT)
            for op, operand in zip(node.ops, node.later_operands, strict=True):
                text += f" {op} {expression_text(operand, _SHIFT)}"
            return text, _COMPARE
        case t.Binary():
            level = _LEVEL[node.op]
            left, right = expression_text(node.left, level), expression_text(node.right, level + 1)
            return f"{left} {node.op} {right}", level
        case t.IfElse():
            parts = [expression_text(part, 1) for part in (node.then, node.condition)]
            return f"{parts[0]} if {parts[1]} else {expression_text(node.otherwise)}", 0
    raise TypeError(node)


def statement_text(node: Any) -> str:
    """The text of a statement."""
    e = expression_text
    match node:
        case t.Version():
            return f"nsl {node.number.value}"
        case t.TargetByName():
            return f"target {node.name.text}"
        case t.TargetFromFile():
            return f'target "{node.path.value}"'
        case t.EqualSlots():
            return f"frame {e(node.count)} slots of {_time_text(node.length)}"
        case t.ListedSlots():
            return f"frame slots [{', '.join(map(_time_text, node.lengths))}]"
        case t.Let():
            return f"let {node.name.text} = {e(node.value)}"
        case t.CodeRange():
            return f"code {node.name.text} : {e(node.low)}..{e(node.high)}"
        case t.CodeBits():
            return f"code {node.name.text} : bit[{e(node.count)}]"
        case t.CodeRow():
            return f"code {node.name.text} : row of {node.book.text}"
        case t.Require():
            return f"require {e(node.condition)}"
        case t.BookInline():
            return f"shutters {node.name.text} [{', '.join(r.digits for r in node.rows)},]"
        case t.BookFromFile():
            key = f" key {node.key.text}" if node.key else ""
            return f'shutters {node.name.text} from "{node.path.value}"{key}{_digest(node)}'
        case t.Open():
            return f"open when {e(node.rule)}"
        case t.Bucket():
            return f"bucket {node.name.text} open when {e(node.rule)}"
        case t.PixelsExpr():
            return f"pixels {node.field.text} = {e(node.value)}"
        case t.PixelsTile():
            rows = [f"[{', '.join(map(e, row.values))}]" for row in node.rows]
            return f"pixels {node.field.text} = tile [{', '.join(rows)}]"
        case t.PixelsFromFile():
            return f'pixels from "{node.path.value}"{_digest(node)}'
        case t.Sense():
            bucket = f" {node.signal.bucket.text}" if getattr(node.signal, "bucket", None) else ""
            signal = "light" if isinstance(node.signal, t.Light) else f"exposure{bucket}"
            level = _level_text(node.level)
            return f"sense {node.name.text} when {signal} {node.comparison} {level} at {e(node.at)}"
        case t.StateRange():
            low, high, start = e(node.low), e(node.high), e(node.start)
            return f"state {node.name.text} : {low}..{high} = {start}{' kept' * node.kept}"
        case t.StateBit():
            return f"state {'kept ' * node.kept}{node.name.text} : bit = {e(node.start)}"
        case t.Next():
            condition = f" when {e(node.condition)}" if node.condition else ""
            return f"next {node.name.text} = {e(node.value)}{condition}"
        case t.Reset():
            return f"reset when {e(node.condition)}"
        case t.Read():
            return f"read {', '.join(name.text for name in node.names)}"
    raise TypeError(node)


def _level_text(level: Any) -> str:
    match level:
        case t.Amount():
            return f"{level.value}{level.unit}"
        case t.Levels():
            return f"[{', '.join(map(_level_text, level.items))},]"
    return expression_text(level)


def _digest(node: Any) -> str:
    return f' sha256 "{node.sha256.value}"' if node.sha256 else ""


def _time_text(time: t.Time) -> str:
    return f"{time.us}us" if time.us.denominator == 1 else f"{time.us * 1000}ns"


NAMES = st.from_regex(r"[A-Za-z_][A-Za-z0-9_]{0,6}", fullmatch=True).filter(
    lambda name: name not in RESERVED
)
"""Some are words of version 2; programs of that version have none of those."""
_PATHS = st.text(st.characters(exclude_characters='"\n\r\0', codec="utf-8"), max_size=8)
_names = NAMES.map(lambda text: t.Name(NOWHERE, text))
_texts = _PATHS.map(lambda text: t.Text(NOWHERE, text))


def _branch(inner: st.SearchStrategy[Any]) -> st.SearchStrategy[Any]:
    def chain(parts: tuple[Any, list[tuple[str, Any]]]) -> t.Compare:
        first, rest = parts
        return t.Compare(NOWHERE, first, tuple(o for o, _ in rest), tuple(v for _, v in rest))

    links = st.lists(st.tuples(st.sampled_from(_COMPARISONS), inner), min_size=1, max_size=3)
    function = st.sampled_from(["min", "max"]).map(lambda text: t.Name(NOWHERE, text))
    return st.one_of(
        st.builds(t.Unary, st.just(NOWHERE), st.sampled_from(["-", "not"]), inner),
        st.builds(t.Binary, st.just(NOWHERE), st.sampled_from(sorted(_LEVEL)), inner, inner),
        st.tuples(inner, links).map(chain),
        st.builds(t.IfElse, st.just(NOWHERE), inner, inner, inner),
        st.builds(t.Index, st.just(NOWHERE), _names, inner),
        st.builds(
            t.Call,
            st.just(NOWHERE),
            function,
            st.lists(inner, min_size=1, max_size=3).map(tuple),
        ),
    )


_leaves = st.one_of(
    st.integers(0, 2**62 - 1).map(lambda value: t.Int(NOWHERE, value)),
    st.booleans().map(lambda value: t.Bool(NOWHERE, value)),
    _names,
)
EXPRESSIONS = st.recursive(_leaves, _branch, max_leaves=12)

_times = st.one_of(
    st.integers(1, 10**6).map(lambda us: t.Time(NOWHERE, Fraction(us))),
    st.integers(1, 999).map(lambda ns: t.Time(NOWHERE, Fraction(ns, 1000))),
)
_rows = st.from_regex(r"[01]{1,12}", fullmatch=True).map(lambda d: t.BookRow(NOWHERE, d))
_tile_rows = st.lists(EXPRESSIONS, min_size=1, max_size=3).map(
    lambda values: t.TileRow(NOWHERE, tuple(values))
)


def _many(items: st.SearchStrategy[Any]) -> st.SearchStrategy[Any]:
    return st.lists(items, min_size=1, max_size=4).map(tuple)


def _make(kind: type[t.Node], *parts: st.SearchStrategy[Any]) -> st.SearchStrategy[Any]:
    return st.builds(kind, st.just(NOWHERE), *parts)


STATEMENTS = st.one_of(
    _make(t.TargetByName, _names),
    _make(t.TargetFromFile, _texts),
    _make(t.EqualSlots, EXPRESSIONS, _times),
    _make(t.ListedSlots, _many(_times)),
    _make(t.Let, _names, EXPRESSIONS),
    _make(t.CodeRange, _names, EXPRESSIONS, EXPRESSIONS),
    _make(t.CodeBits, _names, EXPRESSIONS),
    _make(t.CodeRow, _names, _names),
    _make(t.Require, EXPRESSIONS),
    _make(t.BookInline, _names, _many(_rows)),
    _make(t.BookFromFile, _names, _texts, st.none() | _names, st.none() | _texts),
    _make(t.Open, EXPRESSIONS),
    _make(t.Bucket, _names, EXPRESSIONS),
    _make(t.PixelsExpr, _names, EXPRESSIONS),
    _make(t.PixelsTile, _names, _many(_tile_rows)),
    _make(t.PixelsFromFile, _texts, st.none() | _texts),
)
PROGRAMS = st.lists(STATEMENTS, max_size=5)

_amounts = st.builds(
    t.Amount,
    st.just(NOWHERE),
    st.integers(0, 999).map(Fraction),
    st.sampled_from(["%", "e", "lsb"]),
)
_levels = st.one_of(_amounts, EXPRESSIONS)
_signals = st.one_of(_make(t.Light), _make(t.Exposure, st.none() | _names))
LOOKING_STATEMENTS = st.one_of(
    _make(
        t.Sense,
        _names,
        _signals,
        st.sampled_from(_COMPARISONS),
        _levels | _make(t.Levels, _many(_levels)),
        EXPRESSIONS,
    ),
    _make(t.StateRange, _names, EXPRESSIONS, EXPRESSIONS, EXPRESSIONS, st.booleans()),
    _make(t.StateBit, _names, EXPRESSIONS, st.booleans()),
    _make(t.Next, _names, EXPRESSIONS, st.none() | EXPRESSIONS),
    _make(t.Reset, EXPRESSIONS),
    _make(t.Read, _many(_names)),
)
LOOKING_PROGRAMS = st.lists(st.one_of(LOOKING_STATEMENTS, STATEMENTS), max_size=5).filter(
    lambda program: LOOKING.isdisjoint(n.text for n in nodes(tuple(program)) if type(n) is t.Name)
)
"""Programs of version 2."""
