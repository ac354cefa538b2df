"""Signatures can be read: few arguments, and results whose type has a name."""

from __future__ import annotations

import ast

from checkout import ROOT, trees

MOST_ARGUMENTS = 7
OPTIONS = {
    "compile": "nscc.compile: its arguments are the options of `nscc build`",
    "capture": "nscc_runtime.capture: its arguments are the options of `nscc run`",
    "scene": "nscc_runtime.scene: its arguments are the options of a scene",
    "film": "nscc_runtime.film: as capture",
    "parameter": "the declaration of a parameter in an effect, also of other packages",
    "frames": "nscc_runtime.reference.frames, and frames of pixels that look: the same options",
    "prepare_pixels": "pixels of a scene: threads and known means are options",
    "picture_light": "a picture of a file: how its samples are read are options",
}
"""Functions with more arguments; most arguments are keywords with defaults."""
LOOPS = {"compiled", "inlined", "loop"}
"""Decorators of compiled loops, which take arrays and numbers."""
MIXED = "dict[str, Any]"
"""A dict of mixed values has a name in `nscc.mappings`, or is a record."""


def decorators(function: ast.FunctionDef) -> set[str]:
    """The names of the function's decorators without arguments."""
    return {node.id for node in function.decorator_list if isinstance(node, ast.Name)}


def test_functions_take_few_arguments() -> None:
    long = {}
    for path, tree in trees().items():
        for node in ast.walk(tree):
            if isinstance(node, ast.FunctionDef) and not decorators(node) & LOOPS:
                arguments = (*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs)
                names = {argument.arg for argument in arguments} - {"self", "cls"}
                if len(names) > MOST_ARGUMENTS:
                    long[node.name] = f"{path}:{node.lineno}: {node.name} takes {len(names)}"
    assert not [text for name, text in long.items() if name not in OPTIONS]
    assert OPTIONS.keys() == long.keys(), "an exception is not needed any more"


def test_dicts_of_mixed_values_have_a_name() -> None:
    lines = [
        (path, number, line)
        for path in trees()
        for number, line in enumerate((ROOT / path).read_text().splitlines(), 1)
    ]
    unnamed = [row for row in lines if MIXED in row[2] and not row[2].endswith(f" = {MIXED}")]
    assert unnamed == []
