"""Where the checkout is, wherever a test lies in it, and the syntax trees of its product files."""

from __future__ import annotations

import ast
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PACKAGES = ("nscc", "runtime/nscc_runtime", "training/nscc_training", "cli/nscc_cli")


@cache
def trees() -> dict[str, ast.Module]:
    """The syntax tree of each product file, by its path."""
    files = (path for package in PACKAGES for path in sorted((ROOT / package).rglob("*.py")))
    return {path.relative_to(ROOT).as_posix(): ast.parse(path.read_text()) for path in files}
