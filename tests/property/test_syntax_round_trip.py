"""A random tree, written out, is read back as the same tree, every node at its own text."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st
from syntax_text import EXPRESSIONS, PROGRAMS, bare, expression_text, nodes, read, statement_text

from nscc.emit.listing import print_tree
from nscc.source import Source
from nscc.syntax import tree as t

BLANKS = st.sampled_from(["\n", " ", "\t\n", "\r\n", " # let x = 1\n", "\n\n#\n"])


@given(PROGRAMS, BLANKS)
def test_a_program_is_read_as_it_was_written(program: list[t.Statement], blank: str) -> None:
    text = blank.join(["nsl 1", *map(statement_text, program)])
    file, errors = read(text)
    assert not errors
    assert bare(file.statements[1:]) == bare(tuple(program))


@given(EXPRESSIONS)
def test_every_node_stands_at_its_own_text(expression: t.Expr) -> None:
    text = f"nsl 1 require {expression_text(expression)}"
    file, errors = read(text)
    assert not errors
    for node in nodes(file.statements[1].condition):  # type: ignore[union-attr]
        own = text[node.span.start : node.span.end]
        again, wrong = read(f"nsl 1 require {own}")
        if isinstance(node, t.Name) and own in ("min", "max"):
            continue
        assert not wrong, own
        assert bare(again.statements[1].condition) == bare(node)  # type: ignore[union-attr]


@given(EXPRESSIONS)
def test_more_brackets_change_nothing(expression: t.Expr) -> None:
    plain, _ = read(f"nsl 1 require {expression_text(expression)}")
    bracketed, errors = read(f"nsl 1 require ({_all_brackets(expression)})")
    assert not errors
    assert bare(bracketed) == bare(plain)


@given(PROGRAMS)
def test_the_printed_tree_names_every_statement(program: list[t.Statement]) -> None:
    text = "\n".join(["nsl 1", *map(statement_text, program)])
    file, _ = read(text)
    lines = print_tree(file, Source("test.nsl", text)).split("\n")
    heads = [line.split()[0] for line in lines if line and line[0] != " "]
    assert heads == ["Version", *(type(s).__name__ for s in program)]


def _all_brackets(node: t.Expr) -> str:
    match node:
        case t.Unary():
            return f"{node.op} ({_all_brackets(node.operand)})"
        case t.Binary():
            return f"({_all_brackets(node.left)}) {node.op} ({_all_brackets(node.right)})"
        case t.Compare():
            rest = zip(node.ops, node.later_operands, strict=True)
            links = "".join(f" {op} ({_all_brackets(value)})" for op, value in rest)
            return f"({_all_brackets(node.first)}){links}"
        case t.IfElse():
            then, condition = _all_brackets(node.then), _all_brackets(node.condition)
            return f"({then}) if ({condition}) else ({_all_brackets(node.otherwise)})"
    return expression_text(node)
