"""Ways out of a program that cannot fit: nearby programs, each compiled before it is offered.

A nearby program keeps the frame's time and target and asks for less: fewer slots, one bump a
pixel, or a codebook of few shutters. A codebook needs data that only its author has, so a stand-in
is compiled: rows of a fixed pseudo-random sequence, which no gate sharing can make cheap.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from nscc.lower.lowered import Lowered
from nscc.program.model import Program

Attempt = Callable[[str], Lowered | None]
"""Compiles a program's text for the target at hand; None if it does not fit."""

MOST_SHOWN = 3
_BOOK_ROWS = 64


def ways_out(program: Program, attempt: Attempt) -> list[str]:
    """Descriptions of nearby programs that were compiled and fit, with their words a slot."""
    found: list[str] = []
    for body, what, why in _nearby(program):
        slots = _slots_of(body)
        lowered = attempt(f"nsl 1\n{body}\n")
        if lowered is not None:
            words = lowered.schedule.words_total / slots
            found.append(f"{what:<24}{why}: {words:.3g} words a slot")
        if len(found) == MOST_SHOWN:
            break
    return found


def _slots_of(body: str) -> int:
    return int(body.split()[1])


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
    yield (
        frame(slots) + f"shutters book [{', '.join(rows)}]\n"
        "code id : row of book\nopen when book[id]",
        "`code id : row of book`",
        f"{slots} slots kept, {_BOOK_ROWS} shutters instead of {len(program.table.shutters)} "
        "(compiled with pseudo-random rows)",
    )
    if program.class_name not in ("b", "c", "d"):
        yield (
            frame(slots) + _bump("N"),
            "`start <= n < stop`",
            f"{slots} slots kept, one bump a pixel",
        )
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
    """Distinct rows of a linear congruential sequence's high bits, the same on every machine."""
    rows: list[str] = []
    state = 1
    while len(rows) < min(_BOOK_ROWS, 1 << slots):
        digits = ""
        for _ in range(slots):
            state = (state * 6364136223846793005 + 1442695040888963407) % (1 << 64)
            digits += str(state >> 63)
        if digits not in rows:
            rows.append(digits)
    return rows
