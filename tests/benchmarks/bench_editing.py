"""What an edit costs while one types: `Document.checked`, which is all that `nscc check` says.

    python tests/benchmarks/bench_editing.py [ROUNDS]

A program of a hundred lines, for fixed shutters and for pixels that look, is edited once a round
and checked anew; milliseconds are of the processor, not of the wall.
"""

from __future__ import annotations

import sys
from pathlib import Path
from statistics import median, quantiles
from time import process_time

from nscc.editing.document import Document

ROOT = Path(__file__).resolve().parents[2]
MOST_MS = 150.0
LINES = 100


def lengthened(text: str) -> str:
    """The program with lets and remarks in front of its rule, a hundred lines in all."""
    head, rule, rest = text.partition("\nopen when")
    lines = LINES - text.count("\n")
    lets = ["let k0 = 1"] + [
        f"let k{i} = (k{i - 1} * 7 + {i}) % 61" if i % 3 else f"let k{i} = k{i - 1}   # remark {i}"
        for i in range(1, lines)
    ]
    return head + "\n" + "\n".join(lets) + rule + rest


def taken_ms(text: str, rounds: int) -> list[float]:
    """The time of each check; the edit is a let's number, then a slip of the pen, then its end."""
    found = []
    for i in range(rounds):
        edit = (f"let extra = {i}\n", f"let extra = k{i} +\n", f"let extr = {i}\n")[i % 3]
        edited = text.replace("open when", f"{edit}open when", 1)
        begin = process_time()
        Document("a.nsl", edited, ROOT / "examples").checked  # noqa: B018
        found.append(1e3 * (process_time() - begin))
    return found


def main() -> int:
    """Measure and print; 1 if an edit is over what it may take."""
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 60
    slow = 0
    print(f"{rounds} edits of programs of {LINES} lines, Python {sys.version.split()[0]}")
    for name in ("hdr_2x2", "class_c", "class_d", "codebook", "float_pixel"):
        text = lengthened((ROOT / f"examples/{name}.nsl").read_text(encoding="utf-8"))
        taken_ms(text, 3)  # the first text of a kind loads and fills what the others find
        found = taken_ms(text, rounds)
        most = quantiles(found, n=20)[-1]
        mark = "  OVER" if most > MOST_MS else ""
        slow += bool(mark)
        print(
            f"{name:12} median {median(found):6.1f} ms, 95 % below {most:6.1f} ms of processor"
            f"  (at most {MOST_MS:g}){mark}"
        )
    return 1 if slow else 0


if __name__ == "__main__":
    sys.exit(main())
