"""Which part imports which: start-up stays short, and the packages keep their order."""

from __future__ import annotations

import ast
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

HEAVY = ("cv2", "matplotlib", "networkx", "numba", "PIL", "scipy", "serial", "torch")

# (a package, what nothing in it may import)
ORDER = (
    (
        "runtime/nscc_runtime",
        (
            "nscc_training",
            "nscc_cli",
            "nscc.pipeline",
            "nscc.emit",
            "nscc.prove",
            "nscc.logic",
            "nscc.lower",
            "nscc.program",
            "nscc.syntax",
        ),
    ),
    ("nscc/diagnostics", ("nscc.syntax", "nscc.program", "nscc_cli", "nscc.pipeline")),
    ("nscc/syntax", ("nscc.program", "nscc.lower", "nscc.logic", "nscc.pipeline", "nscc_cli")),
    ("nscc/target", ("nscc.program", "nscc.lower", "nscc.logic", "nscc.pipeline", "nscc_cli")),
    (
        "nscc/cache",
        ("nscc.syntax", "nscc.program", "nscc.lower", "nscc.prove", "nscc.pipeline", "nscc_cli"),
    ),
    ("nscc/words", ("nscc.program", "nscc.lower", "nscc.logic", "nscc.pipeline", "nscc_cli")),
    ("nscc/program", ("nscc.lower", "nscc.logic", "nscc.prove", "nscc.pipeline", "nscc_cli")),
    ("nscc/logic", ("nscc.syntax", "nscc.program", "nscc.prove", "nscc.pipeline", "nscc_cli")),
    ("nscc/lower", ("nscc.syntax", "nscc.prove", "nscc.pipeline", "nscc_cli")),
    ("nscc/prove", ("nscc.syntax", "nscc.program", "nscc.logic", "nscc.lower", "nscc_cli")),
)


@pytest.mark.parametrize(("package", "forbidden"), ORDER, ids=[name for name, _ in ORDER])
def test_order_of_packages(package: str, forbidden: tuple[str, ...], root: Path) -> None:
    wrong = [
        f"{path.relative_to(root)}: {name}"
        for path in sorted((root / package).rglob("*.py"))
        for name in imported(path)
        if f"{name}.".startswith(tuple(f"{other}." for other in forbidden))
    ]
    assert not wrong


@pytest.mark.parametrize("package", ["nscc_runtime", "nscc_training"])
def test_only_the_command_line_knows_the_others(package: str, root: Path) -> None:
    knowing = {
        path.relative_to(root).parts[1]
        for path in (root / "nscc").rglob("*.py")
        if any(name.split(".")[0] == package for name in imported(path))
    }
    assert knowing == {"cli"}


@pytest.mark.parametrize(
    "arguments",
    [
        ["--version"],
        ["--help"],
        ["check", "examples/hdr_2x2.nsl", "examples/class_d.nsl"],
        ["check", "tests/cases/fail/burst16.nsl"],
        ["build", "examples/class_c.nsl", "-O1", "--emit", "gates=-"],
        ["explain", "NS0214"],
        ["targets"],
    ],
    ids=lambda arguments: " ".join(arguments[:1]),
)
def test_start_up_imports_nothing_heavy(arguments: list[str], root: Path) -> None:
    code = (
        "import sys; from nscc_cli.main import main; main(sys.argv[1:]); "
        f"print([name for name in {HEAVY!r} if name in sys.modules])"
    )
    outcome = subprocess.run(
        [sys.executable, "-c", code, *arguments],
        cwd=root,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
        capture_output=True,
        text=True,
    )
    assert outcome.stdout.splitlines()[-1] == "[]", outcome.stderr


def imported(path: Path) -> Iterator[str]:
    """The modules that a file imports when it runs; imports for type checkers do not count."""
    waiting: list[ast.AST] = [ast.parse(path.read_bytes())]
    while waiting:
        node = waiting.pop()
        if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test):
            continue
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module:
            yield node.module
        waiting.extend(ast.iter_child_nodes(node))
