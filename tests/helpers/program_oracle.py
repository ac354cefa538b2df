"""What a program means, one code and one slot at a time, in plain Python integers.

It shares nothing with the compiler but the tree: names are looked up in a dict, operators are
Python's own, and laziness is Python's own.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import product
from pathlib import Path
from typing import Any

from nscc.chips.load import load_target
from nscc.program.analyse import analyse
from nscc.program.program import Codes, Program
from nscc.source import Source
from nscc.syntax import tree as t
from nscc.syntax.parse import parse


class NoNumber(Exception):
    """The expression has no value: `code` is the diagnostic it must raise."""

    def __init__(self, code: str) -> None:
        super().__init__(code)
        self.code = code


def program_of(text: str, codes: Codes = "fixed", base: Path = Path(), **more: Any) -> Program:
    """The checked program of a text without syntax errors."""
    source = Source("test.nsl", text)
    tree, problems = parse(source)
    assert not problems, problems
    more.setdefault("target", None if "target" in text else load_target("scamp5", base))
    return analyse(source, tree, base=base, codes=codes, **more)


def statements(text: str) -> tuple[t.Statement, ...]:
    """The statements of a text."""
    return parse(Source("test.nsl", text))[0].statements


def value(node: t.Expr, names: Mapping[str, Any]) -> Any:
    """The int or bool of `node`. `names` maps integers by name, bit counts as "NAME[]", and
    codebooks as sequences of strings of digits."""
    found = _value(node, names)
    if not isinstance(found, bool) and abs(found) >= 2**62:
        raise NoNumber("NS0305")
    return found


def _value(node: t.Expr, names: Mapping[str, Any]) -> Any:
    match node:
        case t.Int() | t.Bool():
            return node.value
        case t.Name():
            return names[node.text]
        case t.Unary():
            operand = value(node.operand, names)
            return not operand if node.op == "not" else -operand
        case t.Binary(op="and"):
            return value(node.left, names) and value(node.right, names)
        case t.Binary(op="or"):
            return value(node.left, names) or value(node.right, names)
        case t.Binary():
            return _arithmetic(node.op, value(node.left, names), value(node.right, names))
        case t.Compare():
            left = value(node.first, names)
            for op, part in zip(node.ops, node.later_operands, strict=True):
                right = value(part, names)
                if not _ordered(op, left, right):
                    return False
                left = right
            return True
        case t.IfElse():
            chosen = node.then if value(node.condition, names) else node.otherwise
            return value(chosen, names)
        case t.Index():
            return _digit(node.base.text, value(node.index, names), names)
        case t.Call():
            numbers = [value(a, names) for a in node.arguments]
            return min(numbers) if node.function.text == "min" else max(numbers)
    raise AssertionError(node)


def _arithmetic(op: str, a: Any, b: Any) -> Any:
    if op == "xor":
        return a != b
    if op in "/%" and b == 0:
        raise NoNumber("NS0302")
    if op == "<<" and not 0 <= b <= 61:
        raise NoNumber("NS0304")
    operations = {
        "+": lambda: a + b,
        "-": lambda: a - b,
        "*": lambda: a * b,
        "/": lambda: a // b,
        "%": lambda: a % b,
        "<<": lambda: a * 2**b,
    }
    return operations[op]()


def _ordered(op: str, a: Any, b: Any) -> bool:
    return {"<": a < b, "<=": a <= b, ">": a > b, ">=": a >= b, "==": a == b, "!=": a != b}[op]


def _digit(name: str, index: int, names: Mapping[str, Any]) -> bool:
    size = names[f"{name}[]"] if f"{name}[]" in names else len(names[name])
    if not 0 <= index < size:
        raise NoNumber("NS0303")
    if f"{name}[]" in names:
        return bool(names[name] // 2**index % 2)
    return bool(names[name][index][names["n"]] == "1")


def shutters(text: str, fields: Sequence[tuple[str, range]], **names: Any) -> dict[Any, Any]:
    """Every legal code of a program with constants `names`, and its shutters, bucket by bucket."""
    parts = statements(text)
    rules = [s.rule for s in parts if isinstance(s, t.Open | t.Bucket)]
    requires = [s.condition for s in parts if isinstance(s, t.Require)]
    found = {}
    for code in product(*(values for _, values in fields)):
        known = {**names, **dict(zip([name for name, _ in fields], code, strict=True))}
        if all(value(r, known) for r in requires):
            found[code] = tuple(
                tuple(value(r, {**known, "n": n}) for n in range(names["N"])) for r in rules
            )
    return found


def table_of(program: Program) -> dict[Any, Any]:
    """The decode table of a compiled program in the form of `shutters`."""
    table = program.table
    return {
        tuple(code): tuple(tuple(row) for row in table.shutters[shutter].tolist())
        for code, shutter in zip(table.codes.tolist(), table.shutter_of_code.tolist(), strict=True)
    }
