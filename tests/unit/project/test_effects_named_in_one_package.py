"""Nothing outside of `nscc_runtime.effects` names an effect: read from the source of everything."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

from checkout import ROOT

import nscc_runtime.effects
from nscc_runtime.effects import Effect, registered

EMULATOR = (
    "emulator",
    "reference",
    "planner",
    "sensor",
    "noise",
    "tradeoff",
    "exposing.py",
    "captured.py",
    "frame_file.py",
    "nscc_cli",
)
"""Where the name of an effect is not the name of a scene or of a message."""
INSIDE = Path(nscc_runtime.effects.__file__).parent
OTHERS = [
    *(path for path in ROOT.glob("runtime/nscc_runtime/**/*.py") if INSIDE not in path.parents),
    *ROOT.glob("cli/nscc_cli/*.py"),
    *ROOT.glob("training/nscc_training/**/*.py"),
]


def effect_modules() -> set[str]:
    """Return the full names of the modules that declare an effect: `NAME = Effect(..)` at the
    top."""
    found = set()
    for path in INSIDE.glob("*.py"):
        tree = ast.parse(path.read_text())
        if any(
            isinstance(each, ast.Assign)
            and isinstance(each.value, ast.Call)
            and getattr(each.value.func, "id", "") == Effect.__name__
            for each in tree.body
        ):
            found.add(f"nscc_runtime.effects.{path.stem}")
    return found


def imported(tree: ast.AST) -> Iterator[str]:
    """Yield the names of modules that a file imports, and of the objects that it takes from them,
    at the top or inside functions."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (each.name for each in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module:
            yield node.module
            yield from (f"{node.module}.{each.name}" for each in node.names)


def compared(tree: ast.AST) -> Iterator[str]:
    """Yield the texts by which a file decides: those in comparisons (`x == "shot"`), in patterns of
    `match`, and in brackets (`values["shot"]`)."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Compare | ast.Subscript | ast.MatchValue):
            yield from (
                each.value
                for each in ast.walk(node)
                if isinstance(each, ast.Constant) and isinstance(each.value, str)
            )


def test_every_effect_is_declared_in_the_module_of_its_name() -> None:
    modules = {name.rpartition(".")[2] for name in effect_modules()}
    names = {effect.name for effect in registered()}
    # The effects of comparators have one module, and so have those of the readout.
    owners = {name: name if name in modules else name.rpartition("_")[0] for name in names}
    assert {*(owners | {"column_noise": "readout"}).values()} == modules


def test_no_module_outside_the_package_of_effects_imports_or_names_an_effect() -> None:
    # These three are also names of what words do, so code may compare with them.
    names = {effect.name for effect in registered()} - {"read", "reset", "register"}
    modules = effect_modules()
    assert len(OTHERS) > 150  # the patterns above still find the source
    for path in OTHERS:
        tree = ast.parse(path.read_text())
        assert not modules & {*imported(tree)}, path
        if {*EMULATOR} & {*path.parts}:
            assert not names & {*compared(tree)}, path
