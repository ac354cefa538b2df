"""Random rules, pixels and files: the compiler agrees with plain Python, or refuses as it would."""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from program_oracle import NoNumber, program_of, shutters, statements, table_of, value

from nscc.chips.load import load_target
from nscc.diagnostics.diagnostic import Rejected
from nscc.syntax import tree as t

NUMBERS = st.one_of(
    st.integers(0, 9), st.sampled_from([61, 62, 2**31, 2**32 + 1, 2**53 + 1, 10**18, 2**62 - 1])
).map(str)


def expressions(names: list[str], bits: str | None = None) -> tuple[st.SearchStrategy[str], ...]:
    """Texts of integers and of booleans over `names` and, if given, the bit field `bits`."""
    leaves = NUMBERS | st.sampled_from(names)
    numbers = st.deferred(lambda: leaves | number_nodes)
    booleans = st.deferred(lambda: boolean_leaves | boolean_nodes)
    boolean_leaves = st.sampled_from(["true", "false"])
    if bits is not None:
        boolean_leaves |= numbers.map(lambda i: f"{bits}[{i}]")
    order = st.sampled_from(["<", "<=", ">", ">=", "==", "!="])

    def two(a: st.SearchStrategy[str], ops: list[str]) -> st.SearchStrategy[str]:
        return st.tuples(a, st.sampled_from(ops), a).map(lambda p: f"({p[0]} {p[1]} {p[2]})")

    number_nodes = (
        two(numbers, ["+", "-", "*", "/", "%", "<<"])
        | numbers.map(lambda a: f"-({a})")
        | st.tuples(st.sampled_from(["min", "max"]), numbers, numbers).map(
            lambda p: f"{p[0]}({p[1]}, {p[2]})"
        )
        | st.tuples(numbers, booleans, numbers).map(lambda p: f"({p[0]} if {p[1]} else {p[2]})")
    )
    boolean_nodes = (
        two(booleans, ["and", "or", "xor", "==", "!="])
        | st.tuples(numbers, order, numbers).map(lambda p: f"({p[0]} {p[1]} {p[2]})")
        | st.tuples(numbers, order, numbers, order, numbers).map(lambda p: f"({' '.join(p)})")
        | booleans.map(lambda a: f"(not {a})")
        | st.tuples(booleans, booleans, booleans).map(lambda p: f"({p[0]} if {p[1]} else {p[2]})")
    )
    return numbers, booleans


RULES = expressions(["n", "a", "bits", "N", "k"], "bits")[1]
VALUES = expressions(["n", "s", "N", "3"])[0].filter(lambda text: "if" not in text)
PLANES = expressions(["x", "y", "rows", "cols", "k"])[0]


@settings(max_examples=80, deadline=None)
@given(rule=RULES, require=RULES.filter(lambda r: "n" not in r.replace("min", "")))
def test_expressions_of_rules_equal_python(rule: str, require: str) -> None:
    text = (
        "nsl 1 frame 5 slots of 1ms let k = 7 - N code a : -2..3 code bits : bit[3] "
        f"require {require} open when {rule}"
    )
    names = {"N": 5, "k": 2, "bits[]": 3}
    fields = [("a", range(-2, 4)), ("bits", range(8))]
    try:
        expected = shutters(text, fields, **names)
    except NoNumber:
        with pytest.raises(Rejected, match=r"NS030[2-5]"):
            program_of(text)
        return
    # No code satisfies the rule, which is an error.
    if not expected:
        with pytest.raises(Rejected, match=r"NS0317"):
            program_of(text)
        return
    assert table_of(program_of(text)) == expected


@settings(max_examples=60, deadline=None)
@given(expr=PLANES)
def test_expressions_of_pixels_equal_python(expr: str) -> None:
    text = (
        f"nsl 1 frame 2 slots of 1ms let k = 3 code a : -50..50 open when n < a pixels a = {expr}"
    )
    target = _small_target()
    (node,) = [s.value for s in statements(text) if isinstance(s, t.PixelsExpr)]
    expected: list[list[int]] | None = []
    try:
        for y in range(target.rows):
            names = {"rows": target.rows, "cols": target.cols, "k": 3, "y": y}
            row = [value(node, {**names, "x": x}) for x in range(target.cols)]
            expected = None if expected is None else [*expected, row]
            if any(abs(v) > 50 for v in row):
                expected = None
    except NoNumber:
        expected = None
    if expected is None:
        with pytest.raises(Rejected, match=r"NS030|NS0311"):
            program_of(text, target=target)
        return
    program = program_of(text, target=target)
    assert program.pixel_codes is not None
    assert program.table.codes[program.pixel_codes][..., 0].tolist() == expected


@settings(max_examples=150, deadline=None)
@given(
    sides=st.tuples(VALUES, VALUES),
    op=st.sampled_from(["<", "<=", ">", ">=", "==", "!="]),
)
def test_a_comparison_that_is_called_never_true_is_so_in_every_slot(
    sides: tuple[str, str], op: str
) -> None:
    """NS0358 stands only at comparisons that Python finds false for all values (`!=`: true)."""
    comparison = f"({sides[0]}) {op} ({sides[1]})"
    text = f"nsl 1 frame 5 slots of 1ms code s : 1..4 open when {comparison}"
    try:
        messages = program_of(text).messages
    except Rejected:
        return  # a division by zero, or numbers that are too large
    (rule,) = [s.rule for s in statements(text) if isinstance(s, t.Open)]
    names = [{"N": 5, "n": n, "s": s} for n in range(5) for s in range(1, 5)]
    found = {bool(value(rule, each)) for each in names}
    if any(m.code == "NS0358" for m in messages):
        assert found == {op == "!="}


def _small_target() -> object:
    from dataclasses import replace

    return replace(load_target("scamp5", Path()), rows=3, cols=4)


@settings(max_examples=100, deadline=None)
@given(data=st.data())
def test_damaged_files_are_refused_or_read(data: st.DataObject) -> None:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "f.npz"
        np.savez_compressed(path, a=np.arange(12, dtype=data.draw(st.sampled_from(["i1", "i8"]))))
        content = bytearray(path.read_bytes())
        for _ in range(data.draw(st.integers(1, 4))):
            content[data.draw(st.integers(0, len(content) - 1))] = data.draw(st.integers(0, 255))
        cut = data.draw(st.integers(0, len(content)) | st.just(len(content)))
        path.write_bytes(bytes(content[:cut]))
        text = 'nsl 1 frame 2 slots of 1ms code a : 0..9 open when n < a pixels from "f.npz"'
        with pytest.raises(Rejected, match=r"NS0313|NS0314|NS0311"):
            program_of(text, base=Path(folder), target=_small_target())
