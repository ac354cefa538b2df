"""How long commands take from start to end, beside `python -c "import numpy"` in the same run.

    python tests/benchmarks/bench_start.py [--rounds 7] [--json FILE]

Commands are taken in turn, round by round, each in a process of its own; the fastest of each counts,
being the one that was disturbed least. The limits are the project's goals: `check` of any example
at most 3 times the import, a cold `run` of 64 slots at most 8 times, and `build -O1` of class b with
4096 slots, for every legal code, at most 10 times `check` of class a. "Cold" is a new process: the
emulator's compiled loops are in their cache, as after any earlier run.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path
from time import perf_counter
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent.parent
EXAMPLES = ROOT / "examples"
NSCC = ("-m", "nscc")
IMPORT = "import numpy"
BASE_CHECK = "check class_a.nsl"


class Task(NamedTuple):
    """A command (arguments of Python), what it is compared with, and the most it may take."""

    name: str
    arguments: tuple[str, ...]
    beside: str = IMPORT
    most: float | None = None


def tasks() -> list[Task]:
    """All commands, the two yardsticks first."""
    checks = [
        Task(f"check {path.name}", (*NSCC, "check", str(path)), IMPORT, 3.0)
        for path in sorted(EXAMPLES.glob("*.nsl"))
    ]
    run = ("run", str(EXAMPLES / "class_c.nsl"), "--scene", "builtin:hdr", "-o", "frame.npz")
    build = ("build", str(EXAMPLES / "class_b_4096.nsl"), "--codes", "open", "-O", "1")
    return [
        Task(IMPORT, ("-c", IMPORT)),
        *checks,
        Task("run class_c.nsl, builtin:hdr", (*NSCC, *run), IMPORT, 8.0),
        Task("build -O1, 4096 stops", (*NSCC, *build, "-o", "b.icw"), BASE_CHECK, 10.0),
    ]


def seconds(arguments: Sequence[str], folder: str) -> float:
    """Wall time of one process, which must succeed."""
    path = os.pathsep.join(str(ROOT / part) for part in (".", "runtime", "training"))
    begin = perf_counter()
    done = subprocess.run(
        [sys.executable, *arguments],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": path},
        capture_output=True,
        text=True,
    )
    elapsed = perf_counter() - begin
    if done.returncode:
        raise SystemExit(f"{' '.join(arguments)}\n{done.stderr}")
    return elapsed


def measure(rounds: int) -> dict[str, float]:
    """The fastest time of each command, after one round that only warms caches."""
    best: dict[str, float] = {}
    with tempfile.TemporaryDirectory() as folder:
        for number in range(rounds + 1):
            for task in tasks():
                elapsed = seconds(task.arguments, folder)
                if number:
                    best[task.name] = min(elapsed, best.get(task.name, elapsed))
    return best


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--json", type=Path, help="also write the times to a file")
    options = parser.parse_args()
    best = measure(options.rounds)
    print(f"{'command':<32}{'ms':>8}{'ratio':>8}{'goal':>6}   beside")
    for task in tasks():
        ratio = best[task.name] / best[task.beside]
        goal = "" if task.most is None else f"{task.most:g}"
        verdict = "" if task.most is None or ratio <= task.most else "   over"
        line = f"{task.name:<32}{best[task.name] * 1e3:>8.0f}{ratio:>8.2f}{goal:>6}"
        print(f"{line}   {task.beside}{verdict}")
    if options.json:
        options.json.write_text(json.dumps(best, indent=2) + "\n")


if __name__ == "__main__":
    main()
