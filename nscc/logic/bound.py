"""Lower bounds on digital operations a frame: what no encoding and no program can beat.

Proved for the level lowering with one FLAG load a slot and no code bit in analog registers: at slot
n the loaded registers are contained in the open set, some code needs a register that no other slot
can use, a content serves one slot, and only M contents exist at the start.
"""

from __future__ import annotations

ASSUMES = (
    "level lowering with one FLAG load a slot; codes held in digital registers only; "
    "every shutter of the class compiled"
)


def level_bound(class_name: str, shutters: int, slots: int, registers: int) -> int | None:
    """Fewest operations a frame for a whole class, None where no bound is proved.

    b with stops 0..N-1 has N shutters, with 0..N one more; c with starts 0..N-len has N - len + 1;
    d has all N (N + 1) / 2 bumps, with or without the never-open shutter.
    """
    bumps = slots * (slots + 1) // 2
    match class_name:
        case "b" if shutters == slots:
            bound = 2 * slots - 1 - registers
        case "b" if shutters == slots + 1:
            bound = 2 * slots - registers
        case "c" if 1 < shutters <= slots:
            bound = slots + shutters - registers
        case "d" if shutters in (bumps, bumps + 1):
            bound = 2 * slots - registers
        case _:
            return None
    return max(bound, 0)
