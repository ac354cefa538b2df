"""Single changes of product code, and whether the tests notice them.

`python tests/helpers/mutants.py --seed S` draws 40 changes, runs the files of tests that run the
function that is changed, the most specific first, and prints each change that they let pass. The
first run
of a commit records which functions each file of tests runs; that takes as long as all tests do.
A change whose code does the same as before survives rightly: whoever reads the list decides that.
"""

from __future__ import annotations

import argparse
import ast
import json
import os
import shutil
import subprocess
import sys
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from random import Random

from checkout import ROOT

PRODUCT = ("nscc", "runtime", "training", "cli")
COUNT = 40
MOST_FILES = 24
"""Files of tests that are run for a change, besides those of `RECORDED_RESULTS`."""
RECORDED_RESULTS = (
    "tests/unit/cli/test_recorded_commands.py",
    "tests/unit/training/loop/test_recorded_runs.py",
    "tests/unit/runtime/pictures/test_sheets.py",
    "tests/unit/training/test_charts.py",
    "tests/e2e/test_cases.py",
    "tests/e2e/test_examples.py::test_examples_have_the_recorded_proved_words",
)
"""Tests that compare results with recorded ones; they run much, so they come last."""
SECONDS = 600
"""How long the tests of a change may take; a change that makes them hang is noticed."""

_OTHER_COMPARISON: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Lt: ast.LtE,
    ast.LtE: ast.Lt,
    ast.Gt: ast.GtE,
    ast.GtE: ast.Gt,
    ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq,
    ast.Is: ast.IsNot,
    ast.IsNot: ast.Is,
    ast.In: ast.NotIn,
    ast.NotIn: ast.In,
}
_OTHER_OPERATOR: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Div,
    ast.Div: ast.Mult,
    ast.FloorDiv: ast.Mult,
    ast.LShift: ast.RShift,
    ast.RShift: ast.LShift,
    ast.BitAnd: ast.BitOr,
    ast.BitOr: ast.BitAnd,
}


@dataclass(frozen=True)
class Change:
    """A change of one file: the text of `node` becomes `new`; `function` is its first line."""

    path: str
    function: int
    node: ast.expr | ast.stmt
    new: str

    def applied(self, text: str) -> str:
        """The file's text with the change."""
        lines = text.encode().splitlines(keepends=True)
        assert self.node.end_lineno is not None
        first, last = self.node.lineno - 1, self.node.end_lineno - 1
        before = b"".join(lines[:first]) + lines[first][: self.node.col_offset]
        after = lines[last][self.node.end_col_offset :] + b"".join(lines[last + 1 :])
        return (before + self.new.encode() + after).decode()

    def __str__(self) -> str:
        old = " ".join(ast.unparse(self.node).split())
        return (
            f"{self.path}:{self.node.lineno}: {old[:100]}  ->  {' '.join(self.new.split())[:100]}"
        )


def changes_of(path: str, text: str) -> Iterator[Change]:
    """All single changes of the functions of a file, docstrings and messages aside."""
    for outer in ast.walk(ast.parse(text)):
        if not isinstance(outer, ast.FunctionDef | ast.AsyncFunctionDef):
            continue
        line = min([outer.lineno, *(each.lineno for each in outer.decorator_list)])
        for node in _inside(outer):
            for new in _replacements(node):
                yield Change(path, line, node, new)


def _inside(function: ast.FunctionDef | ast.AsyncFunctionDef) -> Iterator[ast.expr | ast.stmt]:
    """The nodes of a function's body that are not of a function within it or of a message."""
    waiting: list[ast.AST] = list(function.body)
    while waiting:
        node = waiting.pop()
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef | ast.JoinedStr):
            continue
        if isinstance(node, ast.Raise | ast.Assert | ast.AnnAssign | ast.Import | ast.ImportFrom):
            continue
        if isinstance(node, ast.expr | ast.stmt):
            yield node
        waiting += ast.iter_child_nodes(node)


def _replacements(node: ast.expr | ast.stmt) -> Iterator[str]:
    """What may stand in place of a node."""
    match node:
        case ast.Constant(value=bool(value)):
            yield str(not value)
        case ast.Constant(value=int(value)):
            yield str(value + 1)
            if value:
                yield str(value - 1)
        case ast.Constant(value=float(value)) if value:
            yield repr(value * 2)
        case ast.Compare(left=left, ops=[operator], comparators=[right]):
            other = _OTHER_COMPARISON[type(operator)]()
            yield f"({ast.unparse(ast.Compare(left, [other], [right]))})"
        case ast.BoolOp(op=boolean, values=values):
            changed = ast.Or() if isinstance(boolean, ast.And) else ast.And()
            yield f"({ast.unparse(ast.BoolOp(changed, values))})"
        case ast.UnaryOp(op=ast.Not(), operand=operand):
            yield f"({ast.unparse(operand)})"
        case ast.BinOp(left=left, op=arithmetic, right=right):
            if type(arithmetic) in _OTHER_OPERATOR:
                swapped = ast.BinOp(left, _OTHER_OPERATOR[type(arithmetic)](), right)
                yield f"({ast.unparse(swapped)})"
        case ast.IfExp(body=body, orelse=orelse):
            yield f"({ast.unparse(body)})"
            yield f"({ast.unparse(orelse)})"
        case ast.Expr(value=ast.Call()) | ast.AugAssign():
            yield "pass"


def drawn(seed: int, count: int, run_by: Mapping[str, Sequence[str]]) -> list[Change]:
    """`count` changes of functions that some test runs, no two of one function."""
    by_place: dict[str, list[Change]] = defaultdict(list)
    for folder in PRODUCT:
        for path in sorted((ROOT / folder).rglob("*.py")):
            name = path.relative_to(ROOT).as_posix()
            for change in changes_of(name, path.read_text(encoding="utf-8")):
                place = f"{name}:{change.function}"
                if place in run_by:
                    by_place[place].append(change)
    choose = Random(seed)
    # A function is drawn as often as it has places to change.
    places = sorted(by_place)
    weights = [len(by_place[place]) for place in places]
    chosen: dict[str, Change] = {}
    while len(chosen) < min(count, len(places)):
        (place,) = choose.choices(places, weights)
        if place not in chosen:
            chosen[place] = choose.choice(by_place[place])
    return [*chosen.values()]


def recorded(folder: Path, tests: Sequence[str]) -> dict[str, list[str]]:
    """By function the files of tests that run it, those first that run the fewest functions."""
    if not list(folder.glob("*.json")):
        folder.mkdir(parents=True, exist_ok=True)
        print("recording which functions each file of tests runs", flush=True)
        _pytest(ROOT, [*tests, "-p", "covering", "--numprocesses", "auto"], COVERING=str(folder))
    run: dict[str, set[str]] = defaultdict(set)
    for path in folder.glob("*.json"):
        for name, places in json.loads(path.read_text()).items():
            run[name].update(places)
    found: dict[str, list[str]] = defaultdict(list)
    for name in sorted(run, key=lambda name: (len(run[name]), name)):
        for place in run[name]:
            found[place].append(name)
    return found


def _pytest(root: Path, arguments: Sequence[str], **more: str) -> int:
    """The exit status of pytest on a copy of the tree; 1 where it hangs."""
    folders = [
        str(root / name) for name in ("", "cli", "runtime", "training", "docs", "tests/helpers")
    ]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(folders), **more}
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *arguments]
    is_recording = "COVERING" in more
    output = None if is_recording else subprocess.DEVNULL
    seconds = None if is_recording else SECONDS
    try:
        done = subprocess.run(
            command, cwd=root, env=environment, timeout=seconds, stdout=output, stderr=output
        )
    except subprocess.TimeoutExpired:
        return 1
    return done.returncode


def _copied(folder: Path) -> Path:
    """A copy of the tree, with the machine code of compiled loops."""
    shutil.rmtree(folder, ignore_errors=True)
    listed = subprocess.run(
        ["git", "ls-files", "-co", "--exclude-standard"],
        cwd=ROOT,
        capture_output=True,
        check=True,
        text=True,
    )
    compiled = (path.relative_to(ROOT).as_posix() for path in ROOT.glob("*/**/__pycache__/*.o"))
    for name in [*listed.stdout.splitlines(), *compiled]:
        if not name.startswith((".venv", "build")) and (ROOT / name).is_file():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, folder / name)
    return folder


def main() -> int:
    """Print the changes that the tests let pass; status 1 where these are more than allowed."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--seed", type=int, required=True)
    options.add_argument("--count", type=int, default=COUNT)
    options.add_argument("--allowed", type=int, default=6, help="changes that may survive")
    options.add_argument("--build", type=Path, default=ROOT / "build")
    options.add_argument("tests", nargs="*", help="files of tests; default: all")
    asked = options.parse_args()
    commit = subprocess.run(
        ["git", "rev-parse", "--short", "HEAD"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    ).stdout.strip()
    run_by = recorded(asked.build / f"covering-{commit}", asked.tests)
    tree = _copied(asked.build / "mutants")
    survivors = []
    changes = drawn(asked.seed, asked.count, run_by)
    for number, change in enumerate(changes, 1):
        text = (ROOT / change.path).read_text(encoding="utf-8")
        (tree / change.path).write_text(change.applied(text), encoding="utf-8")
        files = run_by[f"{change.path}:{change.function}"]
        recorded_results = [name for name in RECORDED_RESULTS if name.split("::")[0] in files]
        noticed = any(
            _pytest(tree, [name, "-x", "-n", "0"])
            for name in (*files[:MOST_FILES], *recorded_results)
        )
        (tree / change.path).write_text(text, encoding="utf-8")
        print(f"{number:3} {'noticed ' if noticed else 'SURVIVED'} {change}", flush=True)
        if not noticed:
            survivors.append(change)
    print(f"{len(changes) - len(survivors)} of {len(changes)} changes noticed, seed {asked.seed}")
    return int(len(survivors) > asked.allowed)


if __name__ == "__main__":
    sys.exit(main())
