"""Where the products of a tradeoff go."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from nscc.files import Product, refuse_same, write_together
from nscc_cli.support import done


def output_files(options: Mapping[str, Any], *more: str) -> dict[str, Path]:
    """The products that have a place, by name: `csv`, `png`, and those of `more` that belong to
    `-o`; NS0745 where two would be one file."""
    found: dict[str, Path | None] = {"csv": options["csv_path"], "png": options["png_path"]}
    out = options["out"]
    if out is not None:
        ends = {"csv": ".csv", "png": ".png", **{name: f"_{name}.png" for name in more}}
        found = {n: found.get(n) or out.with_name(out.name + end) for n, end in ends.items()}
    files = {name: path for name, path in found.items() if path is not None}
    refuse_same(files.values(), "--csv and --png")
    return files


def write_files(files: Mapping[str, Path], makers: Mapping[str, Callable[[], Product]]) -> None:
    """Make and write those products that have a place, and say so."""
    write_together({path: makers[name]() for name, path in files.items()})
    if files:
        done("wrote " + ", ".join(path.as_posix() for path in files.values()))
