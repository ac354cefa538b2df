"""Lower bounds on digital operations a frame: what no encoding and no program can beat.

Proved for the level lowering with one FLAG load a slot and no code bit in analog registers: at slot
n the loaded registers are contained in the open set, some code needs a register that no other slot
can use, a content serves one slot, and only M contents exist at the start. A slot in which all
shutters are open, or none is, needs no load.

The M registers must also tell all shutters apart at the start. If m of them hold what m slots load,
the shutters that are closed in all of these slots are 0 in them, so the other M - m registers tell
these shutters apart. In class d the fewest are closed if the m slots are evenly spaced.
"""

from __future__ import annotations

ASSUMES = (
    "level lowering with one FLAG load for each slot that some shutters share and others do not; "
    "codes held in digital registers only; every shutter of the class compiled"
)


def level_bound(class_name: str, shutters: int, slots: int, registers: int) -> int | None:
    """Fewest operations a frame for a whole class, None where no bound is proved.

    b with stops 0..N-1 has N shutters, with 0..N one more; c with starts 0..N-len has N - len + 1;
    d has all N (N + 1) / 2 bumps, with or without the never-open shutter.
    """
    bumps = slots * (slots + 1) // 2
    loads = slots
    match class_name:
        case "b" if shutters == slots:
            # As many loads as stops that differ: one slot is the same for all.
            loads = slots - 1
            contents = loads
        case "b" if shutters == slots + 1:
            contents = slots
        case "c" if 1 < shutters <= slots:
            contents = shutters
        case "d" if shutters in (bumps, bumps + 1):
            contents = slots
            registers = _loadable_at_first(slots, shutters - bumps, registers)
        case _:
            return None
    # A load is an operation. The registers start with a content each; every other content that is
    # needed takes one more to be made.
    return loads + max(contents - registers, 0)


def _loadable_at_first(slots: int, never: int, registers: int) -> int:
    """The most registers that can hold at the start what a slot of class d loads; `never` is 1 if
    a shutter never opens."""
    for loaded in range(min(registers, slots), 0, -1):
        gap, longer = divmod(slots - loaded, loaded + 1)
        # A gap of g slots between loaded ones has g (g + 1) / 2 bumps that are closed in all.
        closed = gap * (gap + 1) // 2 * (loaded + 1) + longer * (gap + 1)
        if closed + never <= 1 << registers - loaded:
            return loaded
    return 0
