"""Lower bounds on the digital operations of a frame, for any encoding and gates.

The bounds assume the level lowering, one FLAG load per slot, and no code bits in analog registers.
In slot n the registers from which FLAG is loaded must be subsets of the open set, and some code
needs a register that no other slot can use. The content of a register serves one slot, and the M
registers provide only M contents at the start. A slot in which all shutters are open, or none,
needs no load.

The M registers must also distinguish all shutters at the start. If m of them hold the contents that
m slots load, shutters that are closed in all m slots are 0 in these registers, so the other M - m
registers must distinguish them. In class d the number of such shutters is smallest if the m slots
are evenly spaced."""

from __future__ import annotations

ASSUMES = (
    "level lowering with one FLAG load for each slot that some shutters share and others do not; "
    "codes held in digital registers only; every shutter of the class compiled"
)


def level_bound(class_name: str, shutters: int, slots: int, registers: int) -> int | None:
    """Return a lower bound on the digital operations per frame of a complete class; None if none is
    known.

    `class_name` is the letter of the shutter class, `shutters` the number of different shutters,
    `slots` the N slots of a frame, and `registers` the one-bit registers of a pixel. A complete
    class has these numbers of shutters; for any other number and for the classes a and e no bound
    is known. Class b: N with stops 0..N-1, one more with 0..N. Class c with starts 0..N-len: N -
    len + 1. Class d: all N (N + 1) / 2 bumps, with or without the shutter that never opens."""
    bumps = slots * (slots + 1) // 2
    loads = slots
    match class_name:
        case "b" if shutters == slots:
            # There are as many loads as different stops, because one slot is equal for all.
            loads = slots - 1
            contents = loads
        case "b" if shutters == slots + 1:
            contents = slots
        case "c" if 1 < shutters <= slots:
            contents = shutters
        case "d" if shutters in (bumps, bumps + 1):
            contents = slots
            registers = _loadable(slots, shutters - bumps, registers)
        case _:
            return None
    # A load is an operation. Each register has an initial content; every other content takes one
    # more operation.
    return loads + max(contents - registers, 0)


def _loadable(slots: int, never: int, registers: int) -> int:
    """Return the most of `registers` that can hold, at the start of a frame, what some slot of
    class d loads; 0 if none can.

    The other registers must still distinguish all shutters that are closed in the loaded slots.
    `slots` is N. `never` is 1 if some shutter never opens, else 0."""
    for loaded in range(min(registers, slots), 0, -1):
        gap, longer = divmod(slots - loaded, loaded + 1)
        # A gap of g slots between loaded ones contains g (g + 1) / 2 bumps that are closed in all
        # loaded slots.
        closed = gap * (gap + 1) // 2 * (loaded + 1) + longer * (gap + 1)
        if closed + never <= 1 << registers - loaded:
            return loaded
    return 0
