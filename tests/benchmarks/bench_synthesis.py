"""The words of decode logic, beside the best counts known for the same cases.

    python tests/benchmarks/bench_synthesis.py [--levels 2,3] [--parts b,d_long] [--workers N]
        [--out DIR] [--markdown]

The cases are the grid in synthesis.toml, computed by `nscc sweep`: ended and started again it goes
on, and what is known in DIR is not compiled again. A line for each: operations and words of a
frame, most words in one slot, registers, the proved bound on operations, seconds of the compilation
from text to proof, and what there is to reach: words, or operations where no words are known.
`x 1.03` is the ratio of the two, `OVER` marks what is above: 1 at -O3, 1.05 at -O2. The counts to
reach were found by search outside of this project's compiler.
"""

from __future__ import annotations

import argparse
import csv
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

from nscc_runtime.pool import processors
from nscc_training.command_settings import SweepSettings
from nscc_training.sweep.grid import Grid, read_grid
from nscc_training.sweep.run_sweep import TIMES, sweep

ROOM = {2: 1.05, 3: 1.0}
SET_R0 = 2
"""Words more than the known ones that those may take which write all registers."""

KNOWN: dict[tuple[str, int], tuple[int, int | None]] = {
    ("b", 8): (8, 8), ("b", 14): (14, 14), ("b", 16): (24, 24), ("b", 32): (63, 63),
    ("b", 64): (127, 127), ("b", 100): (200, 200), ("b", 128): (266, 276), ("b", 256): (558, 604),
    ("b", 512): (1195, 1364), ("b", 1024): (2814, 3582), ("b", 2048): (7166, 10238),
    ("b", 4096): (23952, 34724),
    ("c_4", 64): (144, 160), ("c_8", 64): (192, 256), ("c_16", 64): (373, 443),
    ("c_4", 128): (288, None), ("c_8", 256): (768, None), ("c_5", 65): (144, None),
    ("c_32", 1024): (6145, None), ("c_13", 64): (534, None),
    ("d", 4): (14, None), ("d", 8): (30, 36), ("d", 16): (94, 125), ("d", 32): (222, 317),
    ("d", 64): (571, 762), ("d_never", 64): (571, 762),
    ("e", 8): (8, 8), ("e", 13): (13, 13),
    ("codebook_1", 16): (150, 208), ("codebook_2", 16): (142, 208),
}  # fmt: skip
"""Operations and words of the level lowering."""

MASKED = {
    ("b", 1024),
    ("b", 2048),
    ("b", 4096),
    ("c_8", 256),
    ("c_32", 1024),
    ("d", 32),
    ("d", 64),
    ("d_never", 64),
}
"""Those that leave out SET R0."""

EDGES = {
    ("d", 64): 384,
    ("d_never", 64): 384,
    **{("b", n): 3 * n for n in (64, 256, 1024, 2048, 4096)},
}
"""Operations of the edge lowering: about."""

HEAD = ("case", "level", "ops", "words", "largest slot", "registers", "bound", "s", "to reach")
WIDTHS = (42, 5, 6, 6, 12, 9, 6, 7, 0)


def chosen_of(grid: Grid, levels: list[int], parts: list[str]) -> Grid:
    """The grid at these levels, of these parts or all of them."""
    points = [
        replace(point, name=f"{point.name}_O{level}", values={**point.values, "level": level})
        for point in grid.points
        for level in levels
        if not parts or point.grid_part in parts
    ]
    return grid._replace(points=tuple(points), columns=(*grid.columns, "level"))


def goal(row: dict[str, Any]) -> tuple[str, int | None]:
    """What to reach: ("ops" or "words", how many)."""
    part = row["part"].removesuffix("_flag").removesuffix("_long")
    case = (part, row["slots"])
    if row["lowering"] == "edges":
        return "ops", EDGES.get(case)
    ops, words = KNOWN[case]
    more = SET_R0 if case in MASKED else 0
    return ("ops", ops + more) if words is None else ("words", words + more)


def cells(row: dict[str, Any], seconds: str) -> tuple[str, ...]:
    """What the columns of HEAD hold; the reason alone where nothing fits."""
    store = row.get("chip.store_words")
    name = f"{row['part']} {row['slots']}, {row['lowering']}"
    name += ", larger store" if store and store > 1024 else ""
    if row["code"]:
        return (name, f"-O{row['level']}", *[""] * 5, seconds, f"{row['code']} {row['error']}")
    names = ("ops", "words", "largest_slot", "bound")
    ops, words, largest, bound = (row[f"logic_{figure}"] for figure in names)
    kind, most = goal(row)
    wanted = ""
    if most is not None:
        ratio = (words if kind == "words" else ops) / most
        over = " OVER" if ratio > ROOM.get(row["level"], 1.0) else ""
        wanted = f"{most} {kind} x {ratio:.2f}{over}"
    counts = ("" if n is None else str(n) for n in (ops, words, largest, row["registers"], bound))
    return (name, f"-O{row['level']}", *counts, seconds, wanted)


def lines(grid: Grid, out: Path, workers: int) -> Iterator[tuple[str, ...]]:
    """The cells of every point."""
    table = sweep(grid, out, SweepSettings(workers)).table
    with open(out / TIMES, newline="") as file:
        seconds = {row["key"]: f"{float(row['seconds']):.2f}" for row in csv.DictReader(file)}
    for values in table.rows():
        row = dict(zip(table.columns, values, strict=True))
        yield cells(row, seconds[row["key"]])


def text(cells: tuple[str, ...], markdown: bool) -> str:
    """A row of the table."""
    if markdown:
        return f"| {' | '.join(cells)} |"
    padded = (
        f"{cell:<{width}}" if column in (0, 1, 8) else f"{cell:>{width}}"
        for column, (cell, width) in enumerate(zip(cells, WIDTHS, strict=True))
    )
    return "  ".join(padded).rstrip()


def main() -> None:
    """Prints the table."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--levels", default="2", help="such as 2,3: -O3 takes a minute a row")
    parser.add_argument("--parts", default="", help="only these parts of synthesis.toml")
    parser.add_argument("--workers", type=int, default=processors())
    parser.add_argument("--out", type=Path, default=Path("build/synthesis"))
    parser.add_argument("--markdown", action="store_true")
    asked = parser.parse_args()
    grid = read_grid(Path(__file__).with_name("synthesis.toml"))
    parts = [part for part in asked.parts.split(",") if part]
    chosen = chosen_of(grid, [*map(int, asked.levels.split(","))], parts)
    print(text(HEAD, asked.markdown))
    if asked.markdown:
        print("|---|---|" + "--:|" * 6 + "---|")
    for each in lines(chosen, asked.out, asked.workers):
        print(text(each, asked.markdown))


if __name__ == "__main__":
    main()
