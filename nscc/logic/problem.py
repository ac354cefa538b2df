"""The interface of generators: problems (demands, machine) and solutions (encoding, gates).

A problem is a list of demands in time order: FLAG must hold the predicate of a demand before its
analog words run. A solution defines the content of every pixel's registers at the start of a frame
(the encoding, which the host computes) and the gates for each demand. At the end of the frame the
registers hold their initial content.

Solutions name virtual registers: p0, p1, .. contain code bits (planes), s0, .. state within a
frame, and t0, .. are scratch registers. `nscc.lower.schedule` maps them to the chip's registers."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray

from nscc.arrays import Indices, Ints
from nscc.chips.target import Target
from nscc.codec import HEX
from nscc.record import Record
from nscc.truth import union

MASK = "t0"
"""The scratch register that is the mask of the masked register."""


@dataclass(frozen=True, slots=True)
class Gate:
    """A digital operation on virtual registers.

    `name` is WHERE (destination FLAG), SET, CLR, MOV, NOT, OR or NOR: SET writes 1 and CLR 0,
    without sources; MOV and NOT have one source. A gate whose destination is among its sources is
    an in-place pair of words. A `masked` gate writes a state only where t0, the mask, is 1. FLAG is
    the bit that lets a pixel act."""

    name: str
    destination: str
    sources: tuple[str, ...]
    masked: bool = False

    def __str__(self) -> str:
        """Return the gate as text, such as `t0 = NOR(p1, p2)`."""
        where = f" where {MASK}" if self.masked else ""
        return f"{self.destination} = {self.name}({', '.join(self.sources)}){where}"

    @property
    def reads(self) -> tuple[str, ...]:
        """The registers on which the result depends."""
        return (*self.sources, MASK, self.destination) if self.masked else self.sources

    def result(self, contents: Mapping[str, int], everything: int) -> int:
        """Return the truth vector (an integer with one bit for each shutter) of the destination
        after the gate.

        `contents` has the truth vectors of at least the registers in `reads`, by name; `everything`
        is that of all shutters. A gate without sources is 0 (CLR) or 1 (SET) where it writes."""
        value = union(contents[name] for name in self.sources)
        if self.name in ("NOR", "NOT", "SET"):
            value ^= everything
        if self.masked:
            value = value & contents[MASK] | contents[self.destination] & ~contents[MASK]
        return value

    @property
    def words(self) -> int:
        """The number of words of the gate, without the SET of a mask.

        A word cannot read and write the same register: a gate in place is a pair of words that
        keeps the result on the bus."""
        return 2 if self.destination in self.sources else 1


Segment = tuple[Gate, ...]
"""Consecutive gates that may be stored as one kernel."""


class Demand(Record):
    """A requirement that FLAG equals the truth vector `predicate` at `boundary`.

    The predicate is neither empty nor all shutters. `edge` is "rise" (shutters that open), "fall"
    (that close) or "open" (all that are open), of bucket number `bucket`. `flag_kept` means that
    FLAG still holds the predicate of the previous demand (a set of shutters that FLAG must select
    at a boundary). `scratch_kept` means that no refresh happened since then, which only code and
    states survive. A truth vector is an integer with one bit for each shutter."""

    boundary: int
    edge: str
    bucket: int
    predicate: int
    flag_kept: bool
    scratch_kept: bool = True


class AllCodes(Record):
    """All codes of a program whose codes outnumber its shutters.

    `values` gives, for each field, the value in every code (codes,). `shutters` is the number of
    each code's shutter (codes,). `rows` is the number of one code of each shutter (shutters,)."""

    values: Mapping[str, Ints]
    shutters: NDArray[np.integer[Any]]
    rows: Indices


class Problem(Record):
    """Demands in time order over `shutters` distinct shutters.

    `opens[bucket][slot]` are the truth vectors (integers with one bit for each shutter) of the open
    shutters. `flag_lasts` means that FLAG and scratch registers do not decay within the frame.
    `values` gives, for each field of the code, the value of every shutter (shutters,), taken from
    one of its codes; predicates (sets of shutters) are often simple in these values. `codes` is
    None if every shutter has one code."""

    demands: tuple[Demand, ...]
    shutters: int
    opens: tuple[tuple[int, ...], ...]
    flag_lasts: bool
    values: Mapping[str, Ints]
    codes: AllCodes | None = None

    @property
    def everything(self) -> int:
        """The truth vector (an integer with one bit for each shutter) of all shutters."""
        return (1 << self.shutters) - 1

    def answered(self, index: int) -> bool:
        """Return whether FLAG already holds the predicate (a set of shutters) of demand `index`, so
        that it needs no gates. Demand 0 is never answered, if its `flag_kept` is False, as it must
        be. A demand is a set of shutters that FLAG must select at a boundary."""
        demand = self.demands[index]
        return demand.flag_kept and demand.predicate == self.demands[index - 1].predicate


class Machine(Record):
    """The costs and limits of gates on a target.

    `registers` is the number of one-bit registers of a pixel. `masked` means that one of them (R12
    on SCAMP-5) is written only where another (R0) is 1. `or_sources` and `where_sources` are the
    most sources of one OR or NOR, and of one WHERE; None for any number. `where_reads_flag` means
    that FLAG (the bit that lets a pixel act) may be a source of WHERE."""

    registers: int
    masked: bool
    or_sources: int | None
    where_sources: int | None
    where_reads_flag: bool

    @staticmethod
    def of(target: Target) -> Machine:
        """Return what gates may do on a target: registers, the masked register, limits on
        sources."""
        return Machine(
            len(target.digital_registers),
            target.masked_register is not None,
            target.or_sources,
            target.where_sources,
            target.where_reads_flag,
        )


class Solution(Record):
    """Gates and encoding that solve a problem.

    `encoding` names the encoding. `planes` are the truth vectors (integers with one bit for each
    shutter) of p0, p1, .. at the start of a frame; `holders` describe them in words. `states` and
    `scratch` are the numbers of registers s0, s1, .. and t0, t1, .. that the gates use. `answers`
    has one entry for each demand (a set of shutters that FLAG must select at a boundary), empty if
    FLAG already holds its predicate; `opening` runs at boundary 0 before any demand and `closing`
    at boundary N after the last."""

    encoding: str
    planes: tuple[Annotated[int, HEX], ...]
    holders: tuple[str, ...]
    states: int
    scratch: int
    opening: tuple[Segment, ...]
    answers: tuple[tuple[Segment, ...], ...]
    closing: tuple[Segment, ...]

    def segments(self) -> Sequence[Segment]:
        """Return all segments (groups of gates that run together) in execution order."""
        return [*self.opening, *chain.from_iterable(self.answers), *self.closing]

    def writes(self) -> list[int]:
        """Return how often a frame writes each plane (the content of a code register)."""
        times = Counter(gate.destination for segment in self.segments() for gate in segment)
        return [times[f"p{i}"] for i in range(len(self.planes))]

    def masked_state(self) -> str | None:
        """Return the state that masked gates write, which must be in the masked register; None if
        no gate is masked. Only one state may be written so; the first is returned."""
        return masked_destination(chain.from_iterable(self.segments()))

    def in_masked_register(self, registers: int) -> str | None:
        """Return the virtual register that the masked register holds on a chip with `registers`
        one-bit registers, of which one is masked.

        It is the masked state, or the plane (the content of a code register) with the fewest writes
        if all registers are used; None if the masked register is left empty."""
        used = len(self.planes) + self.states + self.scratch
        full = used >= registers and self.planes
        return self.masked_state() or (f"p{quietest(self.writes())}" if full else None)


def masked_destination(gates: Iterable[Gate]) -> str | None:
    """Return the register that the first masked one of `gates` writes; None if none is masked."""
    return next((gate.destination for gate in gates if gate.masked), None)


def quietest(writes: Sequence[int]) -> int:
    """Return the index of the plane (the content of a code register) to put in the masked register
    if all registers are needed: the one with the fewest writes.

    `writes[i]` is how often a frame writes plane i, for at least one plane. Each write costs the
    mask and one more word. Of equal planes, the first in the order of their names as text is taken
    (p10 before p2)."""
    return min(range(len(writes)), key=lambda i: (writes[i], f"p{i}"))


class GaveUp(Exception):
    """Raised if a generator found no solution; the text is the reason. This proves nothing. A
    generator is a method that finds gates."""


def words_of(sources: int, fan_in: int | None) -> int:
    """Return the words of a NOR or OR of `sources` registers into another register; at least 1.

    The first word reads `fan_in` sources (None: any number). Each further pair of words is in place
    and reads one source less, because the partial result is also a source. So `fan_in` must be 2 or
    more if `sources` exceeds it."""
    if fan_in is None or sources <= fan_in:
        return 1
    return 1 + 2 * -(-(sources - fan_in) // (fan_in - 1))


class Gates:
    """A list of gates under construction; gates with more sources than one word accepts are
    split."""

    def __init__(self, machine: Machine) -> None:
        """Begin without gates; `machine` gives the largest number of sources of a word."""
        self._machine = machine
        self._gates: list[Gate] = []

    def take(self) -> tuple[Gate, ...]:
        """Return the gates collected since the last call, in order, and remove them; an empty tuple
        if there are none."""
        gates = tuple(self._gates)
        self._gates.clear()
        return gates

    def add(self, gate: Gate) -> None:
        """Add a gate as it is; the caller ensures that it does not exceed the machine's limits on
        sources."""
        self._gates.append(gate)

    def nor(self, destination: str, sources: Sequence[str], masked: bool = False) -> None:
        """Add destination := NOR(sources), or 1 without sources; the destination may be a
        source."""
        self._gather("NOR", destination, sources, masked)

    def or_(self, destination: str, sources: Sequence[str], masked: bool = False) -> None:
        """Add destination := OR(sources), or 0 without sources; the destination may be a source."""
        self._gather("OR", destination, sources, masked)

    def invert(self, register: str) -> None:
        """Add register := NOT register."""
        self._gates.append(Gate("NOT", register, (register,)))

    def load_flag(self, sources: Sequence[str], scratch: str | None) -> None:
        """Add FLAG := OR(sources); `sources` must not be empty.

        If WHERE takes fewer sources, some are first gathered in the register `scratch`, which may
        be one of the sources. Raises ValueError if that is needed and `scratch` is None. FLAG is
        the bit that lets a pixel act."""
        limit = self._machine.where_sources
        if limit is not None and len(sources) > limit:
            if scratch is None:
                raise ValueError("no scratch register to gather the sources of WHERE")
            # If `scratch` is a source, the other sources are ORed into it.
            other_sources = [name for name in sources if name != scratch]
            head = [scratch] if scratch in sources else []
            spill = len(other_sources) - (limit - 1)
            self.or_(scratch, [*head, *other_sources[:spill]])
            sources = [scratch, *other_sources[spill:]]
        self._gates.append(Gate("WHERE", "FLAG", tuple(sources)))

    def _gather(self, name: str, destination: str, sources: Sequence[str], masked: bool) -> None:
        """Append the OR or NOR (`name`) of any number of sources, as several gates if the machine
        limits them; without sources a CLR or SET.

        Excess sources are gathered by OR in the destination first, so only the last gate inverts.
        The destination may be a source, and is overwritten."""
        if not sources:
            self.add(Gate("SET" if name == "NOR" else "CLR", destination, (), masked))
            return
        limit = self._machine.or_sources
        other_sources = [source for source in sources if source != destination]
        in_place = len(other_sources) < len(sources)
        # OR is associative, so excess sources are first gathered in the destination. NOR is not:
        # only the last gate inverts. In place, the destination is one of the sources.
        if limit is not None:
            room = limit - 1 if in_place else limit
            while len(other_sources) > room:
                head, other_sources = other_sources[:room], other_sources[room:]
                self._append("OR", destination, [destination] * in_place + head, masked)
                in_place, room = True, limit - 1
        self._append(name, destination, [destination] * in_place + other_sources, masked)

    def _append(self, name: str, destination: str, sources: Sequence[str], masked: bool) -> None:
        """Append the OR or NOR (`name`) of one or more sources, as many as the machine allows; one
        with a single source becomes NOT or MOV."""
        if len(sources) == 1:
            name = {"NOR": "NOT", "OR": "MOV"}[name]
        self._gates.append(Gate(name, destination, tuple(sources), masked))
