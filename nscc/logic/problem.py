"""What a generator is asked for and what it answers: (predicates, machine) -> (program, encoding).

A problem is a list of demands in time: before each one's analog words run, FLAG must hold its
predicate. A solution says what every pixel's registers hold when a frame starts (the encoding;
f runs on the host, so this may be anything) and which gates answer each demand. When the frame
ends the registers hold what they held at its start.

Solutions name virtual registers: p0, p1, .. carry code, s0, .. carry state inside a frame, t0, ..
are scratch. `nscc.lower.allocate` gives them places.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import chain

import numpy as np
from numpy.typing import NDArray

from nscc.chips.target import Target


@dataclass(frozen=True, slots=True)
class Gate:
    """A digital operation on virtual registers.

    `name` is WHERE (destination FLAG), SET, CLR, MOV, NOT, OR or NOR. A gate whose destination is
    among its sources is an in-place pair of words. With a `mask`, the gate writes its destination
    only where the register `mask` is 1; elsewhere the destination keeps its content.
    """

    name: str
    destination: str
    sources: tuple[str, ...]
    mask: str | None = None

    def __str__(self) -> str:
        mask_text = f" where {self.mask}" if self.mask is not None else ""
        return f"{self.destination} = {self.name}({', '.join(self.sources)}){mask_text}"

    @property
    def words(self) -> int:
        """How many ICWs the gate takes, before the masked register's rule.

        A register cannot be read and written in one word: in place, the result waits on the bus.
        """
        return 2 if self.destination in self.sources else 1


Segment = tuple[Gate, ...]
"""Gates that run one after the other and are worth storing as one kernel."""


@dataclass(frozen=True, slots=True)
class Demand:
    """FLAG must equal `predicate`, neither nothing nor everything, at `boundary`.

    `edge` is "rise", "fall" or "open", `bucket` whose it is. `flag_kept`: FLAG still holds what the
    demand before this one asked for. `scratch_kept`: no refresh in between, which only code and
    states outlast.
    """

    boundary: int
    edge: str
    bucket: int
    predicate: int
    flag_kept: bool
    scratch_kept: bool = True


@dataclass(frozen=True)
class Problem:
    """Demands in the order in which they come, over `shutters` distinct shutters.

    `opens[bucket][slot]` are the truth vectors of the open shutters; `flag_lasts`: FLAG does not
    decay within the frame, so a solution may keep state in it (`Solution.state_in_flag`).
    `values` names each field of the code and, for every shutter, its value (shutters,) in one of
    the codes that mean that shutter: predicates tend to be simple in them.
    """

    demands: tuple[Demand, ...]
    shutters: int
    opens: tuple[tuple[int, ...], ...]
    flag_lasts: bool
    values: Mapping[str, NDArray[np.int64]]

    @property
    def everything(self) -> int:
        """The truth vector of all shutters."""
        return (1 << self.shutters) - 1

    def answered(self, index: int) -> bool:
        """Whether FLAG already holds what demand `index` asks for."""
        demand = self.demands[index]
        return demand.flag_kept and demand.predicate == self.demands[index - 1].predicate


@dataclass(frozen=True)
class Machine:
    """What gates cost and may do: the digital half of a target.

    `registers` is how many one-bit registers a pixel has; `masked` says that one of them (R12 on
    SCAMP-5) takes a write only where another (R0) is 1. Masked gates need such a pair.
    """

    registers: int
    masked: bool
    or_sources: int | None
    where_sources: int | None
    where_reads_flag: bool

    @staticmethod
    def of(target: Target) -> Machine:
        """The machine of a target."""
        return Machine(
            len(target.digital_registers),
            target.masked_register is not None,
            target.or_sources,
            target.where_sources,
            target.where_reads_flag,
        )


@dataclass(frozen=True)
class Solution:
    """Gates and encoding that meet a problem.

    `planes` are the truth vectors of p0, p1, .. at the start of a frame, `holders` says in words
    what each one carries. `answers` has one entry for each demand; `opening` runs at boundary 0
    before any demand and `closing` at boundary N after the last. With `state_in_flag`, FLAG is 1
    everywhere before the opening and keeps the solution's state until the frame ends: whoever
    needs it for something else meanwhile puts it back, and may use t0 to do so.
    """

    encoding: str
    planes: tuple[int, ...]
    holders: tuple[str, ...]
    states: int
    scratch: int
    opening: tuple[Segment, ...]
    answers: tuple[tuple[Segment, ...], ...]
    closing: tuple[Segment, ...]
    state_in_flag: bool = False

    def segments(self) -> Sequence[Segment]:
        """All segments in the order in which they run."""
        return [*self.opening, *chain.from_iterable(self.answers), *self.closing]

    def masked_pair(self) -> tuple[str, str] | None:
        """The register that masked gates write and the register that masks it.

        There is one such pair in a pixel. A solution with masked gates holds these two registers
        in it; every write to the first one is a masked gate. None without masked gates.
        """
        gates = chain.from_iterable(self.segments())
        return next(((g.destination, g.mask) for g in gates if g.mask is not None), None)

    def writes(self) -> list[int]:
        """How often a frame writes each plane."""
        times = Counter(gate.destination for segment in self.segments() for gate in segment)
        return [times[f"p{i}"] for i in range(len(self.planes))]


def quietest(writes: Sequence[int]) -> int:
    """The plane that gets the masked register where every register is needed.

    `writes[i]` is how often a frame writes plane i: each write costs the mask and a word more.
    """
    return min(range(len(writes)), key=lambda i: (writes[i], f"p{i}"))


class GaveUp(Exception):
    """A generator found no solution: the reason in words. It proves nothing."""
