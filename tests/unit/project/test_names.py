"""Names say what they hold: no bare words, no class name twice, no module name four times."""

from __future__ import annotations

import ast
from collections import Counter, defaultdict
from collections.abc import Iterator
from pathlib import Path

from checkout import ROOT, trees

BARE_WORDS = frozenset((ROOT / "tests/data/bare_words.txt").read_text().split())
"""Words that do not say which quantity a variable holds."""
MOST_BARE_SHARE = 0.015
MOST_MODULES_OF_A_NAME = 3
_TREE = "a node of the syntax tree and what it stands for"
SHARED_CLASS_NAMES = {
    "Exposure": _TREE,
    "Frame": "the arrays of a frame, and the frame that a design is for: both public",
    "Image": _TREE,
    "Light": _TREE,
    "Name": _TREE,
    "Response": "public, and the part of an effect in it",
    "Scene": "public, and what effects see of it",
    "Source": "a text, and the node of that name in container files",
}
"""Public class names that two modules use, with the reason."""
PUBLIC_FUNCTIONS = {"part", "kept"}
"""Methods of the public classes Light and Plan."""


def bound_names(tree: ast.Module) -> Iterator[tuple[str, int]]:
    """Variables and parameters with their lines."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            yield node.id.lstrip("_"), node.lineno
        elif isinstance(node, ast.arg):
            yield node.arg.lstrip("_"), node.lineno


def test_variables_say_what_they_hold() -> None:
    names = [(path, *bound) for path, tree in trees().items() for bound in bound_names(tree)]
    bare = [f"{path}:{line}: {name}" for path, name, line in names if name in BARE_WORDS]
    assert len(bare) <= MOST_BARE_SHARE * len(names), "\n".join(bare)


def test_functions_say_what_they_do() -> None:
    assert not [
        f"{path}:{node.lineno}: {node.name}"
        for path, tree in trees().items()
        for node in ast.walk(tree)
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
        and node.name.lstrip("_") in BARE_WORDS - PUBLIC_FUNCTIONS
    ]


def test_public_class_names_are_unique() -> None:
    places = defaultdict(list)
    for path, tree in trees().items():
        for node in ast.walk(tree):
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                places[node.name].append(path)
    shared = {name: paths for name, paths in places.items() if len(paths) > 1}
    assert {name: shared[name] for name in shared if name not in SHARED_CLASS_NAMES} == {}
    assert set(SHARED_CLASS_NAMES) <= set(shared)
    assert len(SHARED_CLASS_NAMES) <= 10


def test_at_most_three_modules_share_a_name() -> None:
    counts = Counter(Path(path).stem for path in trees())
    del counts["__init__"]
    assert {name: count for name, count in counts.items() if count > MOST_MODULES_OF_A_NAME} == {}
