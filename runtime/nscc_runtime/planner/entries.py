"""The words of a program as the loop over single pixels takes them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.planner.layout import Entry
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
            "acts": True,
            "seen": False,
        }
        rows.append(tuple(entry[name] for name in _ENTRY.names or ()))
        operands += [names.index(name) for name in sources + destinations]
    return np.array(rows, _ENTRY), np.array(operands, np.int64)


def seen_by(entries: NDArray[Any], entry_start: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Whether what falls on PIX before each word is read, by it or later, before PIX is reset."""
    count = len(entries)
    turns = entries["acts"].astype(bool) & (entries["resets"] | entries["reads_pix"]).astype(bool)
    # The next word that reads or resets PIX; none of another lane.
    here = np.where(turns, np.arange(count), count)
    next_turn = np.minimum.accumulate(here[::-1])[::-1]
    within = next_turn < np.repeat(entry_start[1:], np.diff(entry_start))
    return np.asarray(within & ~entries["resets"].astype(bool)[np.minimum(next_turn, count - 1)])
