"""Which operator holds tighter, against Python's own parser where Python has the operator.

Python agrees but for two: its `^` is tighter than comparisons, and its `<<` is, too, as here. So
`xor` is tested by itself and everything else against `ast`.
"""

from __future__ import annotations

import ast
from itertools import product
from typing import Any

import pytest
from syntax_text import bare, statement

OPERATORS = ["or", "and", "<", "==", ">=", "<<", "+", "-", "*", "/", "%"]
_SIGNS: dict[type[ast.AST], str] = {
    ast.Or: "or", ast.And: "and", ast.Lt: "<", ast.Eq: "==", ast.GtE: ">=", ast.LShift: "<<",
    ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.Mod: "%", ast.Not: "not",
    ast.USub: "-",
}  # fmt: skip


def of_python(node: ast.AST) -> Any:
    """Python's tree in the shape of ours."""
    match node:
        case ast.Constant(value=value):
            return ("Int", value)
        case ast.Name(id=name):
            return ("Name", name)
        case ast.UnaryOp():
            return ("Unary", _SIGNS[type(node.op)], of_python(node.operand))
        case ast.BinOp():
            return (
                "Binary",
                _SIGNS[type(node.op)],
                of_python(node.left),
                of_python(node.right),
            )
        case ast.BoolOp():
            found = of_python(node.values[0])
            for value in node.values[1:]:
                found = ("Binary", _SIGNS[type(node.op)], found, of_python(value))
            return found
        case ast.Compare():
            signs = tuple(_SIGNS[type(op)] for op in node.ops)
            rest = tuple(map(of_python, node.comparators))
            return ("Compare", of_python(node.left), signs, rest)
        case ast.IfExp():
            parts = (node.body, node.test, node.orelse)
            return ("IfElse", *map(of_python, parts))
    raise TypeError(node)


def ours(text: str) -> Any:
    return bare(statement(f"require {text}").condition)


def pythons(text: str) -> Any:
    return of_python(ast.parse(text, mode="eval").body)


@pytest.mark.parametrize("first", OPERATORS)
def test_three_operators_in_a_row_bind_as_in_python(first: str) -> None:
    """For every three operators the tree is that of Python's own parser."""
    for second, third in product(OPERATORS, repeat=2):
        text = f"a {first} b {second} c {third} d"
        assert ours(text) == pythons(text), text


@pytest.mark.parametrize("operator", OPERATORS)
def test_unary_operators_bind_as_in_python(operator: str) -> None:
    texts = [
        f"- a {operator} b",
        f"a {operator} - b",
        f"- - a {operator} - - b",
        f"not a {operator} b",
        f"not not a {operator} b",
    ]
    if operator in ("or", "and"):
        texts.append(f"a {operator} not b")
    for text in texts:
        assert ours(text) == pythons(text), text


@pytest.mark.parametrize("operator", OPERATORS)
def test_choices_bind_loosest_as_in_python(operator: str) -> None:
    """`if` and `else` hold less tightly than any operator, and a second one belongs to the
    `else`."""
    for text in (
        f"a {operator} b if c {operator} d else e {operator} f",
        f"a if b else c if d {operator} e else f",
        f"(a if b else c) {operator} d",
    ):
        assert ours(text) == pythons(text), text


@pytest.mark.parametrize(
    ("text", "brackets"),
    [
        ("a xor b and c", "a xor (b and c)"),
        ("a and b xor c", "(a and b) xor c"),
        ("a xor b or c", "(a xor b) or c"),
        ("a or b xor c", "a or (b xor c)"),
        ("a xor b xor c", "(a xor b) xor c"),
        ("not a xor b", "(not a) xor b"),
        ("a xor not b", "a xor (not b)"),
        ("a < b xor c < d", "(a < b) xor (c < d)"),
        ("a if b xor c else d", "a if (b xor c) else d"),
        ("- a[0]", "-(a[0])"),
        ("1 << 2 + 3", "1 << (2 + 3)"),
        ("- 1 << 2", "(-1) << 2"),
        ("n < 1 << 3", "n < (1 << 3)"),
    ],
)
def test_operators_that_python_lacks_bind_as_documented(text: str, brackets: str) -> None:
    assert ours(text) == ours(brackets)
    assert text != brackets


def test_comparisons_chain_as_in_python() -> None:
    """`start <= n < stop != 3` is one node of three signs. Brackets make another tree."""
    assert ours("start <= n < stop != 3") == (
        "Compare",
        ("Name", "start"),
        ("<=", "<", "!="),
        (("Name", "n"), ("Name", "stop"), ("Int", 3)),
    )
    assert ours("(a < b) < c") != ours("a < b < c")
