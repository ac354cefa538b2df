"""Fill pages with the output of the commands that compute their figures.

    make figures PAGES="docs/tradeoff.md docs/emulator.md"

A page names the command in a comment before the fenced block that shows its output. Clauses with
patterns choose lines: `from` the first matching line, `until` the next matching line, and `only`
matching lines in between:

    <!-- printed by: nscc effects --cost | from ^effect | until ^$ | only ^(effect|shot) -->
"""

from __future__ import annotations

import re
import shlex
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parent.parent
PRINTED = re.compile(r"^(<!-- printed by: ([^\n]+) -->\n+(`{3,})text\n)(.*?)^\3$", re.M | re.S)
"""Groups: the comment up to the block, the command with clauses, the fence, the lines."""
_CLAUSES = ("from", "until", "only")


def filled(page: str, output_of: Callable[[str], str]) -> str:
    """Return a page with the present output of its commands.

    Raises ValueError for an unknown clause, and if the clauses choose no line."""

    def fill(block: re.Match[str]) -> str:
        begin, named, fence, _ = block.groups()
        command, *clauses = named.split(" | ")
        return begin + "".join(f"{line}\n" for line in chosen(output_of(command), clauses)) + fence

    return PRINTED.sub(fill, page)


def chosen(output: str, clauses: list[str]) -> list[str]:
    """Return the lines of an output that clauses choose."""
    given = dict(clause.split(" ", 1) for clause in clauses)
    if not given.keys() <= set(_CLAUSES):
        raise ValueError(f"clauses are {', '.join(_CLAUSES)}, not {', '.join(given)}")
    lines = output.splitlines()
    if "from" in given:
        found = [bool(re.search(given["from"], line)) for line in lines]
        lines = lines[found.index(True) :] if any(found) else []
    if "until" in given:
        ends = (n for n, line in enumerate(lines) if n and re.search(given["until"], line))
        lines = lines[: next(ends, len(lines))]
    lines = [line.rstrip() for line in lines if re.search(given.get("only", ""), line)]
    if not any(lines):
        raise ValueError(f"nothing left by {clauses} of:\n{output}")
    while not lines[-1]:
        lines.pop()
    return lines


def printed(command: str) -> str:
    """Return the output of an nscc command or a Python file, run in the repository.

    Raises RuntimeError with the output if the exit status is not 0."""
    program, *arguments = shlex.split(command)
    started = {"nscc": ["-m", "nscc_cli"], "python": []}[program]
    ended = subprocess.run(
        [sys.executable, *started, *arguments],
        cwd=REPOSITORY,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    if ended.returncode != 0:
        raise RuntimeError(f"{command}: status {ended.returncode}\n{ended.stdout}")
    return ended.stdout


def main(pages: list[str]) -> None:
    """Fill pages; commands may write files into the folder `build`."""
    (REPOSITORY / "build").mkdir(exist_ok=True)
    for name in pages:
        page = REPOSITORY / name
        page.write_text(filled(page.read_text(), printed))
        print(f"printed into {name}")


if __name__ == "__main__":
    main(sys.argv[1:])
