"""Texts with numbers, compared with recorded ones. `pytest --update-cases` records them again."""

from __future__ import annotations

import re

import numpy as np
from checkout import ROOT

RECORDED = ROOT / "tests" / "data"
_NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?")


def compare_with_recorded(
    shown: str, name: str, update: bool, share: float = 1e-5, spare: float = 0.0
) -> None:
    """Assert that a text is the one of `tests/data/NAME.txt`; each of its numbers may differ by
    `spare` and by a share of it."""
    path = RECORDED / f"{name}.txt"
    if update:
        path.parent.mkdir(exist_ok=True)
        path.write_text(shown, encoding="utf-8")
    lines, recorded_lines = shown.splitlines(), path.read_text(encoding="utf-8").splitlines()
    for line, recorded_line in zip(lines, recorded_lines, strict=False):
        assert _alike(line, recorded_line, share, spare), (
            f"{name}: run with --update-cases if this is meant\n{line}\ninstead of\n{recorded_line}"
        )
    assert len(lines) == len(recorded_lines), name


def _alike(line: str, recorded_line: str, share: float, spare: float) -> bool:
    if _NUMBER.split(line) != _NUMBER.split(recorded_line):
        return False
    numbers, recorded = ([*map(float, _NUMBER.findall(text))] for text in (line, recorded_line))
    return bool(np.allclose(numbers, recorded, rtol=share, atol=spare))
