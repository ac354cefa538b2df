"""Run one measurement in this checkout and in another one, in turns.

A benchmark with `--beside CHECKOUT` calls `in_turns`. The other checkout needs an environment of
its own in `.venv`. Both run the same script, this one's, with `--worker`, and print one JSON object
{name: number} as their last line. The script therefore uses only what both versions have, and
imports it only in the worker."""

from __future__ import annotations

import argparse
import json
import os
import subprocess
from collections.abc import Sequence
from pathlib import Path
from statistics import median

ROOT = Path(__file__).resolve().parents[2]


def add_option(parser: argparse.ArgumentParser) -> None:
    """Add `--beside` and `--worker` to the options of a benchmark."""
    parser.add_argument("--beside", type=Path, metavar="CHECKOUT", help="measure it in turns")
    parser.add_argument("--worker", action="store_true", help=argparse.SUPPRESS)


def in_turns(
    script: str, arguments: Sequence[str], beside: Path | None, rounds: int
) -> tuple[dict[str, float], dict[str, float]]:
    """Return the least numbers by name, of this checkout and of the other (empty without one)."""
    least: tuple[dict[str, float], dict[str, float]] = ({}, {})
    for _ in range(rounds):
        for root, found in zip((ROOT, beside), least, strict=True):
            if root is not None:
                for name, value in _worker(root.resolve(), script, arguments).items():
                    found[name] = min(value, found.get(name, value))
    return least


def _worker(root: Path, script: str, arguments: Sequence[str]) -> dict[str, float]:
    parts = [str(root / part) for part in ("", "runtime", "training", "cli", "tests/helpers")]
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(parts)}
    command = [str(root / ".venv/bin/python"), script, "--worker", *arguments]
    done = subprocess.run(
        command, cwd=root, env=environment, check=True, stdout=subprocess.PIPE, text=True
    )
    numbers: dict[str, float] = json.loads(done.stdout.splitlines()[-1])
    return numbers


def show(mine: dict[str, float], other: dict[str, float], unit: str) -> None:
    """Print the numbers side by side, and the median ratio."""
    for name, value in mine.items():
        line = f"  {name:<44}{value:10.2f} {unit}"
        if name in other:
            line += f"   other {other[name]:10.2f} {unit}   {value / other[name]:6.2f} x"
        print(line)
    ratios = [value / other[name] for name, value in mine.items() if other.get(name)]
    if ratios:
        print(f"median of {len(ratios)}: {median(ratios):.2f} x the other checkout")
