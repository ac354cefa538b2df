"""The words of a program as the loop over single pixels takes them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.planner.layout import ACTS, SEEN, Entry
from nscc_runtime.reference.capture import Reference

_ENTRY = np.dtype(Entry)


def entries_of(program: Reference) -> tuple[NDArray[Any], NDArray[np.int64]]:
    """The words as they are where they act, and the registers of all of them."""
    container = program.container
    names = (*container.target.analog_registers, "PIX", "reset level", "IN")
    rows: list[tuple[float, ...]] = []
    operands: list[int] = []
    for word in program.words:
        sources, destinations = word.op.sources, word.op.destinations
        if word.resets:
            sources = destinations = ()
        last = word.boundary == container.slots
        end = word.after_us / container.slot_us[min(word.boundary, container.slots - 1)]
        entry = {
            "boundary": word.boundary,
            "resets": word.resets,
            "number": word.number,
            "reads_pix": "PIX" in sources,
            "sources": len(sources),
            "destinations": len(destinations),
            "operands": len(operands),
            "end": end if last else min(end, 1.0),
            "divisor": word.op.operation.divisor,
        }
        rows.append(tuple(entry[name] for name in _ENTRY.names or ()))
        operands += [names.index(name) for name in sources + destinations]
    return np.array(rows, _ENTRY), np.array(operands, np.int64)


def flags_of(
    entries: NDArray[Any], acts: NDArray[np.bool_], start: NDArray[np.int64]
) -> NDArray[np.uint8]:
    """`ACTS` and `SEEN` of the words of lanes, those of lane l from start[l] to start[l + 1] - 1:
    whether each acts, and whether what falls on PIX before it is read, by it or later, before PIX
    is reset."""
    count, resets = len(entries), entries["resets"].astype(bool)
    turns = acts & (resets | entries["reads_pix"].astype(bool))
    # The next word that reads or resets PIX; none of another lane.
    here = np.where(turns, np.arange(count), count)
    next_turn = np.minimum.accumulate(here[::-1])[::-1]
    within = next_turn < np.repeat(start[1:], np.diff(start))
    seen = within & ~resets[np.minimum(next_turn, count - 1)]
    return np.asarray(ACTS * acts + SEEN * seen, np.uint8)
