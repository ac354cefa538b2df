"""Programs as somebody leaves them in the middle of writing: random edits of those in the tree."""

from __future__ import annotations

import re
from random import Random

from checkout import ROOT

_LONG = (
    "spike",
    "auto_exposure",
    "first_light",
    "slot_too_short",
    "burst16",
    "class_b_4096",
    "huge_number",
)
"""Checked in more than a tenth of a second, or full of numbers that make it so."""

PROGRAMS = [
    path.read_text(encoding="utf-8")
    for folder in ("examples", "tests/cases/pass", "tests/cases/fail")
    for path in sorted((ROOT / folder).glob("*.nsl"))
    if path.stem not in _LONG and path.stat().st_size < 4000
]

_PIECES = (
    "nsl 1\n", "nsl 2\n", "frame 8 slots of 1ms\n", "let a = 3\n", "code c : 0..7\n", "open when ",
    "bucket b open when ", "pixels c = ", "require ", "shutters s [ 1100, 0011 ]\n", "row of ",
    "state s : 0..3 = 0 kept\n", "sense d when light > 45% at n == 2\n", "next s = ", "read s\n",
    "reset when ", "target scamp7\n", "tile [[1, 2], [3]]", "n", "N", "x", "true", "min(1, 2)",
    "not ", " and ", " if ", " else ", "==", "<", "<<", "..", "[", "]", "(", ")", ",", "-", "1.5us",
    "# ä 💡\n", '"', '"codes.npz"', "@", "é", "💡", "\t", "\r\n", "\n", "\x0b", "\u2028", "0", "5",
)  # fmt: skip


def edited(choose: Random, text: str) -> str:
    """The text after one edit; now and then another program instead."""
    if choose.random() < 0.06:
        return choose.choice(PROGRAMS)
    begin = choose.randint(0, len(text))
    end = min(len(text), begin + choose.choice((0, 0, 1, 1, 2, 5, 12, 40)))
    kind = choose.random()
    if kind < 0.35:
        return text[:begin] + choose.choice(_PIECES) + text[end if kind < 0.1 else begin :]
    if kind < 0.6:
        return text[:begin] + text[end:]
    if kind < 0.7:
        place = choose.randint(0, len(text))
        return text[:place] + text[begin:end] + text[place:]
    numbers = [*re.finditer(r"\d+", text)]
    if kind < 0.85 and numbers:
        found = choose.choice(numbers)
        return text[: found.start()] + str(choose.randint(0, 40)) + text[found.end() :]
    names = [*re.finditer(r"[A-Za-z_]\w*", text)]
    if len(names) > 1:
        old, new = choose.choice(names), choose.choice(names)
        return text[: old.start()] + new.group() + text[old.end() :]
    return text + choose.choice(_PIECES)
