"""Pixels of a program that looks, while words run over them: every code, state and answer at once.

A lane is one way in which a pixel can have come so far. Bits are 0, 1 or unknown; analog values are
numbers for one random light, with what they owe: a value is `owes` times the exposure that each
bucket should hold by now, plus a rest. Lanes that agree in node, bits, what they owe and rests go
on alike whatever exposure they have gathered: they are merged, or accumulating programs would have
2^looks histories. A merged lane carries the numbers of one of its histories, and `exact` says
whether all of them had the same exposures.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Bits = NDArray[np.int8]
UNKNOWN = 2
_DIGITS = 1e8
"""Rests that differ by less than a part in so many of the frame's light are the same."""


@dataclass(frozen=True, eq=False)
class Lanes:
    """`node`, `outcome` int64 (lanes,); `bits` int8 (registers, lanes); `analog` (analog registers,
    lanes) and `owes` (analog registers, buckets, lanes), PIX the last of the analog registers;
    `due` (buckets, lanes): the exposure that the program wants; `since` (lanes,): its `light`.
    """

    node: NDArray[np.int64]
    outcome: NDArray[np.int64]
    bits: Bits
    analog: Floats
    owes: Floats
    due: Floats
    since: Floats
    exact: NDArray[np.bool_]

    @property
    def count(self) -> int:
        """How many lanes there are."""
        return len(self.node)

    def rests(self) -> Floats:
        """What analog values are beside what they owe (analog registers, lanes)."""
        found: Floats = self.analog - (self.owes * self.due[None]).sum(axis=1)
        return found

    def chosen(self, lanes: NDArray[np.intp]) -> Lanes:
        """Some of the lanes."""
        return Lanes(
            self.node[lanes], self.outcome[lanes], self.bits[:, lanes], self.analog[:, lanes],
            self.owes[:, :, lanes], self.due[:, lanes], self.since[lanes], self.exact[lanes],
        )  # fmt: skip

    def merged(self, readouts: dict[int, int], scale: float) -> Lanes:
        """The lanes that differ. `readouts` names the bucket that an analog register ends up as:
        where all histories have the same exposures, what it holds can be told by them."""
        lanes = self
        for register, bucket in readouts.items():
            lanes = replace(lanes, owes=_owed(lanes, register, bucket))
        rests = np.rint(lanes.rests() * (_DIGITS / scale)).astype(np.int64)
        since = np.rint(lanes.since * (_DIGITS / scale)).astype(np.int64)
        owes = np.rint(lanes.owes * 1024).astype(np.int64).reshape(-1, lanes.count)
        rows = np.concatenate(
            [lanes.node[None], lanes.outcome[None], since[None], rests, owes, _packed(lanes.bits)]
        )
        keys = np.ascontiguousarray(rows.T).view(f"V{rows.shape[0] * 8}")[:, 0]
        _, first, group = np.unique(keys, return_index=True, return_inverse=True)
        exact = np.ones(len(first), np.bool_)
        same = np.abs(lanes.due - lanes.due[:, first[group]]) <= scale / _DIGITS
        np.logical_and.at(exact, group, same.all(axis=0) & lanes.exact)
        return replace(lanes.chosen(first), exact=exact)


def _owed(lanes: Lanes, register: int, bucket: int) -> Floats:
    """`owes` with a register said as the exposure of its bucket and a rest, where that is known."""
    owes = lanes.owes.copy()
    owes[register][:, lanes.exact] = 0.0
    owes[register, bucket, lanes.exact] = 1.0
    return owes


def _packed(bits: Bits) -> NDArray[np.int64]:
    """Bits as numbers: (numbers, lanes)."""
    rows = []
    for start in range(0, len(bits), 31):
        part = bits[start : start + 31].astype(np.int64)
        rows.append((part << (2 * np.arange(len(part)))[:, None]).sum(axis=0))
    return np.array(rows)
