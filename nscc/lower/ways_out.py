"""Ways out of a program that cannot fit: nearby programs, each compiled before it is offered.

A nearby program keeps target and slot time and asks for less: only the codes in use, fewer slots,
one bump a pixel, or a codebook of few shutters. A codebook needs data that only its author has:
a stand-in is compiled, rows of a fixed pseudo-random sequence that no gate sharing makes cheap.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from nscc.lower.lowered import Lowered
from nscc.program.model import Codes, Program
from nscc.program.problems import counted
from nscc.source import Source

Attempt = Callable[[Source, Codes], Lowered | None]
"""Compiles a program for the target at hand; None if it does not fit."""

MOST_SHOWN = 3
_BOOK_ROWS = 64
_LONGEST_BOOK = 256
_WORD = 1 << 64


def ways_out(program: Program, attempt: Attempt) -> list[str]:
    """Descriptions of nearby programs that were compiled and fit, with their words a slot."""
    found: list[str] = []
    if program.mode == "open" and program.pixel_codes is not None:
        lowered = attempt(program.source, "fixed")
        if lowered is not None:
            in_use = counted(len(lowered.program.table.shutters), "shutter")
            found.append(_way_out("`--codes fixed`", f"only the {in_use} in use", lowered))
    for body, what, why in _nearby(program):
        lowered = attempt(Source("way-out.nsl", f"nsl 1\n{body}\n"), "open")
        if lowered is not None:
            found.append(_way_out(what, why, lowered))
        if len(found) == MOST_SHOWN:
            break
    return found


def _way_out(what: str, why: str, lowered: Lowered) -> str:
    words = lowered.schedule.words_total / len(lowered.program.frame.slot_us)
    return f"{what:<24}{why}: {words:.3g} words a slot"


def _nearby(program: Program) -> Iterator[tuple[str, str, str]]:
    """Candidates: (program text without its first line, what to write, what it means)."""
    slots = len(program.frame.slot_us)
    registers = len(program.target.digital_registers)
    slot_us = sum(program.frame.slot_us) / slots

    def frame(count: int) -> str:
        return f"frame {count} slots of {max(slot_us, 0.001):.3f}us\n"

    if program.class_name == "e" and slots > registers:
        yield (
            frame(registers) + f"code bits : bit[{registers}]\nopen when bits[n]",
            f"frame {registers} slots",
            f"{slots - registers} slots fewer, every shutter still possible",
        )
    elif program.class_name == "d":
        fewer = 1 << (registers - 1) // 2
        if fewer < slots:
            yield frame(fewer) + _bump("N"), f"frame {fewer} slots", "every bump still possible"
    rows = _book(slots)
    if slots <= _LONGEST_BOOK and len(rows) < len(program.table.shutters):
        yield (
            frame(slots) + f"shutters book [{', '.join(rows)}]\n"
            "code id : row of book\nopen when book[id]",
            "`code id : row of book`",
            f"{slots} slots kept, {len(rows)} shutters instead of {len(program.table.shutters)} "
            "(compiled with pseudo-random rows)",
        )
    if program.class_name not in ("b", "c", "d"):
        yield (
            frame(slots) + _bump("N"),
            "`start <= n < stop`",
            f"{slots} slots kept, one bump a pixel",
        )
    if program.class_name != "b":
        yield (
            frame(slots) + "code stop : 1..N\nopen when n < stop",
            "`n < stop`",
            f"{slots} slots kept, open from the start to a stop of each pixel",
        )


def _bump(last: str) -> str:
    return (
        f"code start : 0..{last} - 1\ncode stop : 1..{last}\nrequire start < stop\n"
        "open when start <= n < stop"
    )


def _book(slots: int) -> list[str]:
    """Distinct pseudo-random rows, the same on every machine."""
    rows: dict[str, None] = {}
    words = -(-slots // 64)
    count = 0
    while len(rows) < min(_BOOK_ROWS, 1 << slots):
        digits = "".join(f"{_mixed(count + word):064b}" for word in range(words))
        rows.setdefault(digits[:slots])
        count += words
    return list(rows)


def _mixed(number: int) -> int:
    """64 bits that look random: a counter through the mixer of SplitMix64 (Steele et al., 2014)."""
    bits = number * 0x9E3779B97F4A7C15 % _WORD
    bits = (bits ^ bits >> 30) * 0xBF58476D1CE4E5B9 % _WORD
    bits = (bits ^ bits >> 27) * 0x94D049BB133111EB % _WORD
    return bits ^ bits >> 31
