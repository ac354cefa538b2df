"""The words of a program as the loop over single pixels takes them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.execution.layout import ACTS, SEEN, Entry
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


class Turns:
    """The words of lanes, those of lane l from start[l] to start[l + 1] - 1, and which of them read
    or reset PIX: its turns."""

    def __init__(
        self, entries: NDArray[Any], acts: NDArray[np.bool_], start: NDArray[np.int64]
    ) -> None:
        self._acts, self._count = acts, len(entries)
        self._resets = acts & entries["resets"].astype(bool)
        self._turns = self._resets | acts & entries["reads_pix"].astype(bool)
        self._end = np.repeat(start[1:], np.diff(start))

    @property
    def unread(self) -> NDArray[np.bool_]:
        """Resets after which PIX is reset again before it is read: nothing hangs on them."""
        return np.asarray(self._resets & self._then(self._resets, 1))

    @property
    def flags(self) -> NDArray[np.uint8]:
        """`ACTS` and `SEEN` of each word: whether it acts, and whether what falls on PIX before it
        is read, by it or later, before PIX is reset."""
        seen = self._then(self._turns & ~self._resets, 0)
        return np.asarray(ACTS * self._acts + SEEN * seen, np.uint8)

    def _then(self, kind: NDArray[np.bool_], after: int) -> NDArray[np.bool_]:
        """Whether the next turn, so many words after each or later, is of a kind; one of another
        lane is none."""
        if not self._count:
            return np.zeros(0, np.bool_)
        here = np.where(self._turns, np.arange(self._count), self._count)
        coming = np.minimum.accumulate(here[::-1])[::-1]
        coming = np.append(coming, np.full(after, self._count))[after:]
        return np.asarray((coming < self._end) & kind[np.minimum(coming, self._count - 1)])
