"""The files that a program consists of."""

from __future__ import annotations

from pathlib import Path

from nscc.diagnostics.diagnostic import Rejected
from nscc.syntax import tree
from nscc.syntax.parse import parse, read_source


def files_of(program: Path) -> set[Path]:
    """Return the program's path and the paths of the targets, codebooks and pixel codes that it
    names."""
    files = {program}
    try:
        statements = parse(read_source(program))[0].statements
    except Rejected:
        return files
    for statement in statements:
        if isinstance(statement, tree.TargetFromFile | tree.FromFile | tree.PixelsFromFile):
            files.add(program.parent / statement.path.value)
    return files
