"""Print the tables of docs/networks.md: `python docs/cell_tables.py [direction]`.

Resume the sweep of training/grids/cells.toml in build/cells, and print its rows.
"""

from __future__ import annotations

import csv
import sys
from collections.abc import Mapping
from pathlib import Path

ACCURACIES = {
    "real": "real weights, torch", "binary": "binary, torch", "noisy": "binary, torch with noise",
    "exact": "emulated, no effects", "effects": "emulated, every effect",
    "tuned": "the same, decoder fitted to emulated films",
}  # fmt: skip
COLUMNS = {
    "kernel": "kernel", "outputs": "outputs", "noise": "noise", "words": "words", "us": "us",
    "bits_per_frame": "bits", "binary_accuracy": "binary", "effects_accuracy": "effects",
    "tuned_accuracy": "tuned",
}  # fmt: skip


def swept(parts: list[str]) -> list[Mapping[str, str]]:
    """Run the named parts of the grid, or all parts, and return the rows of the sweep."""
    from nscc_training.sweep.grid import read_grid
    from nscc_training.sweep.run_sweep import TABLE, How, sweep

    repository = Path(__file__).resolve().parent.parent
    out = repository / "build/cells"
    out.mkdir(parents=True, exist_ok=True)
    sweep(read_grid(repository / "training/grids/cells.toml"), out, How(), grid_parts=parts)
    with open(out / TABLE, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def accuracies(row: Mapping[str, str]) -> str:
    """Return the accuracies, words and bits of one cell as text."""
    lines = [f"{text:<44}{100 * float(row[f'{name}_accuracy']):6.1f} %"
             for name, text in ACCURACIES.items()]  # fmt: skip
    bits, full = int(row["bits_per_frame"]), int(row["full_frame_bits"])
    lines += [
        f"{'bits that differ, emulated without effects':<44}{row['different_bits']:>6}",
        f"{'words of a frame':<44}{row['words']:>6}, {float(row['us']):.0f} us",
        f"{'bits that are read out of a frame':<44}{bits:>6}, 1/{full / bits:.0f} of a full frame",
    ]
    return "\n".join(lines)


def table(rows: list[Mapping[str, str]]) -> str:
    """Return a table with a line for each cell."""
    lines = ["".join(f"{title:>9}" for title in COLUMNS.values())]
    for row in rows:
        texts = (f"{100 * float(row[name]):.1f} %" if name.endswith("accuracy")
                 else f"{float(row[name]):g}" for name in COLUMNS)  # fmt: skip
        lines.append("".join(f"{text:>9}" for text in texts))
    return "\n".join(lines)


if __name__ == "__main__":
    chosen = sys.argv[1:]
    found = swept(chosen)
    print(accuracies(found[0]) if chosen else table(found))
