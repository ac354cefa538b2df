"""Warnings about comparisons that no value of their variables makes true."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise, product
from operator import add, floordiv, mul, sub
from typing import NamedTuple

from nscc.program.expressions import Checked, operands
from nscc.program.problems import Problems, printable
from nscc.syntax import tree

Range = tuple[int, int]
"""The least and the greatest value, both included."""

_SWAPPED = {"<": ">", "<=": ">=", ">": "<", ">=": "<=", "==": "==", "!=": "!="}
_SAID = {"<": "below ", "<=": "at most ", ">": "above ", ">=": "at least ", "==": "", "!=": ""}
_OPERATIONS = {"+": add, "-": sub, "*": mul, "/": floordiv}


def judge_values(
    expressions: Sequence[Checked], ranges: Mapping[str, Range], problems: Problems
) -> None:
    """Warn about comparisons with a value that their variables never reach (NS0358).

    These are comparisons that are never true, and `!=` that is always true. `ranges` are the ranges
    of variables by name; an expression with another variable is not judged. The ranges of
    expressions are those of interval arithmetic, which may be too wide: what is reported is true,
    but not everything is found. Comparisons of constants are not judged, because a program may
    choose by them."""
    for checked in expressions:
        found: dict[int, _Value] = {}
        for node in checked.nodes:
            if isinstance(node, tree.Compare):
                sides = (node.first, *node.later_operands)
                for op, (left, right) in zip(node.ops, pairwise(sides), strict=True):
                    _judge(left, op, right, found, problems)
            parts = [found[id(part)] for part in operands(node)]
            range_ = _range(node, [part.range for part in parts], checked.constants, ranges)
            is_constant = all(part.is_constant for part in parts)
            if isinstance(node, tree.Name):
                is_constant = node.text in checked.constants
            found[id(node)] = _Value(range_, is_constant)


class _Value(NamedTuple):
    """What is known of an expression: its range, None if it is no number or not known, and whether
    no variable is in it."""

    range: Range | None
    is_constant: bool


def _judge(
    left: tree.Expr, op: str, right: tree.Expr, found: Mapping[int, _Value], problems: Problems
) -> None:
    """Warn if `left op right` is never true, or always true for `!=`.

    `found` has what is known of both, by identity."""
    if found[id(left)].is_constant:
        left, op, right = right, _SWAPPED[op], left
    first, second = found[id(left)], found[id(right)]
    if first.is_constant or first.range is None or second.range is None:
        return
    (low, high), (least, most) = first.range, second.range
    never = {
        "<": low >= most,
        "<=": low > most,
        ">": high <= least,
        ">=": high < least,
    }.get(op, high < least or low > most)
    if not never:
        return
    name, value = _text(left, problems), printable(least)
    label = f"{name} is in {low}..{high}"
    if not second.is_constant:
        value = _text(right, problems)
        label += f", {value} in {least}..{most}"
    problems.warning("NS0358", f"{name} is never {_SAID[op]}{value}", right.span, label)


def _text(node: tree.Expr, problems: Problems) -> str:
    """Return the text of an expression as the program writes it, in one line, in backquotes."""
    return f"`{' '.join(problems.source.text[node.span.start : node.span.end].split())}`"


def _range(
    node: tree.Expr,
    parts: Sequence[Range | None],
    constants: Mapping[str, int],
    ranges: Mapping[str, Range],
) -> Range | None:
    """Return the range of an expression from those of its operands; None if it is no number or not
    known."""
    if isinstance(node, tree.IfElse):
        parts = parts[1:]
    known = [part for part in parts if part is not None]
    if len(known) < len(parts):
        return None
    match node:
        case tree.Int(value=value):
            return value, value
        case tree.Name(text=name):
            return (constants[name], constants[name]) if name in constants else ranges.get(name)
        case tree.Unary(op="-"):
            values = [-end for end in known[0]]
        case tree.Binary(op="/" | "%") if known[1][0] <= 0:
            return None
        case tree.Binary(op="%"):
            (low, high), (least, most) = known
            values = [low, high] if low >= 0 and high < least else [0, most - 1]
        case tree.Binary(op="+" | "-" | "*" | "/" as op):
            values = [_OPERATIONS[op](a, b) for a, b in product(*known)]
        case tree.IfElse():
            values = [*known[0], *known[1]]
        case tree.Call(function=tree.Name(text="min" | "max" as function)):
            choose = min if function == "min" else max
            values = [choose(part[end] for part in known) for end in (0, 1)]
        case _:
            return None
    return min(values), max(values)
