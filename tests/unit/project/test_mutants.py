"""The changes that `make mutants` draws: single, by seed, and only of code that tests run."""

from __future__ import annotations

import ast

from mutants import ROOT, changes_of, drawn

TEXT = '''def f(a, b):
    """Text 1."""
    if a < b and not a:
        return a + 1
    raise ValueError(f"{a} < {b}")
'''


def test_each_change_changes_one_thing() -> None:
    changed = {change.applied(TEXT) for change in changes_of("f.py", TEXT)}
    bodies = {ast.unparse(ast.parse(text).body[0].body[1]) for text in changed}  # type: ignore[attr-defined]
    assert bodies == {
        "if a <= b and (not a):\n    return a + 1",
        "if a < b or not a:\n    return a + 1",
        "if a < b and a:\n    return a + 1",
        "if a < b and (not a):\n    return a - 1",
        "if a < b and (not a):\n    return a + 2",
        "if a < b and (not a):\n    return a + 0",
    }


def test_changes_are_drawn_by_seed_from_functions_that_are_run() -> None:
    path = "nscc/files.py"
    text = (ROOT / path).read_text(encoding="utf-8")
    places = {
        f"{path}:{change.function}": ["tests/unit/nscc/test_files.py"]
        for change in changes_of(path, text)
    }
    changes = drawn(3, 5, places)
    assert len({change.function for change in changes}) == 5
    assert [str(change) for change in drawn(3, 5, places)] == [str(change) for change in changes]
    assert [str(change) for change in drawn(4, 5, places)] != [str(change) for change in changes]
    assert {change.path for change in changes} == {path}
    for change in changes:
        assert change.applied(text) != text
        ast.parse(change.applied(text))


def test_nothing_is_drawn_from_code_that_no_test_runs() -> None:
    assert drawn(1, 40, {}) == []
