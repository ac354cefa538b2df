"""Compare the words of programs with those of published versions of the same programs.

    python docs/published_words.py

Words are those of a frame after the exposure, if parameters have their starts. The words that load
and refresh input planes are left out: two for each.
"""

from __future__ import annotations

import csv
from pathlib import Path

import nscc

LABORATORY = Path("tests/laboratory")


def main() -> None:
    """Print a line a program: its words, those of the published version, and what that omits."""
    print("program          nscc  public  not counted in the public version")
    with (LABORATORY / "public_words.csv").open() as file:
        for row in csv.DictReader(file):
            name, public_words, omitted = row.values()
            example = Path("examples") / f"{name}.nsl"
            path = example if example.exists() else LABORATORY / f"{name}.nsl"
            pictures = nscc.compile(path).container.pictures
            words = pictures.words - 2 * len(pictures.inputs)
            print(f"{name:15} {words:5} {public_words:>7}  {omitted}".rstrip())


if __name__ == "__main__":
    main()
