"""Gates at one boundary: predicates in FLAG, new values in the registers of states.

All values are truth vectors over the boundary's lanes. A lane is a node of the state machine
together with one outcome of the comparisons. A target is an OR of NORs of register contents
(`nscc.logic.cover`), or the complement of one. If the contents do not distinguish the lanes,
complements are computed in scratch registers."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import count
from math import inf

from nscc.logic.cover import Cover, Covers
from nscc.logic.cubes import Budget
from nscc.logic.problem import Gate, Gates, GaveUp, Machine
from nscc.record import Record

FLAG = "FLAG"
_STEPS = 4_000_000
"""Steps that one search for an OR of NORs may take."""
_MOST_CUBES = 24
"""Most NORs in the OR that a search considers."""
_MOST_ORDERED = 3
"""Most registers for which all orders are tried; if there are more, the cheapest is written
next."""


class GateSequence(Record):
    """Gates that compute a truth vector in a register: an integer with one bit for each lane (node
    of the state machine with one outcome of the look).

    `scratch` are pairs (scratch register that they write, truth vector that remains there). A
    scratch register holds an intermediate result."""

    gates: tuple[Gate, ...]
    scratch: tuple[tuple[str, int], ...]

    @cached_property
    def words(self) -> int:
        """The number of words of all gates."""
        return sum(gate.words for gate in self.gates)

    @property
    def price(self) -> tuple[int, int]:
        """The key that orders sequences: number of words, then number of scratch registers (for
        intermediate results)."""
        return self.words, len(self.scratch)


@dataclass
class RegisterContents:
    """The contents of registers at a boundary, while gates are chosen.

    A content is a truth vector: an integer with one bit for each lane (node of the state machine
    with one outcome of the look). `values` are the contents by name, with FLAG (the bit that lets a
    pixel act) if it is known and the scratch registers (t0, t1, ..) in use. `everything` is the
    vector of all lanes. `machine` has the limits of the chip's gates. `gates` are the gates chosen
    so far. With `few`, they take fewer scratch registers, and more words."""

    machine: Machine
    everything: int
    values: dict[str, int]
    gates: list[Gate] = field(default_factory=list)
    few: bool = False

    @property
    def words(self) -> int:
        """The number of words of all gates so far."""
        return sum(gate.words for gate in self.gates)

    def copy(self) -> RegisterContents:
        """Return a copy, to which other gates can be added without changing this one."""
        return RegisterContents(
            self.machine, self.everything, dict(self.values), list(self.gates), self.few
        )

    def first_unused_scratch(self) -> str:
        """Return the name of the first unused scratch register (for intermediate results)."""
        return next(self.unused_scratch())

    def unused_scratch(self, excluded: str = "") -> Iterator[str]:
        """Yield the names of unused scratch registers (for intermediate results), except
        `excluded`, without end."""
        scratch = (f"t{number}" for number in count())
        return (name for name in scratch if name not in self.values and name != excluded)

    def copy_to_scratch(self, name: str) -> None:
        """Append a gate that copies a register, or FLAG (the bit that lets a pixel act), to an
        unused scratch register (for intermediate results).

        Raises KeyError if the content of `name` is unknown."""
        scratch = self.first_unused_scratch()
        self.gates.append(Gate("MOV", scratch, (name,)))
        self.values[scratch] = self.values[name]

    def take(self, sequence: GateSequence, *changes: tuple[str, int]) -> None:
        """Append the gates of a sequence; set its scratch registers (for intermediate results), and
        those of `changes`, to their new values.

        `changes` are pairs (register, truth vector). A truth vector is an integer with one bit for
        each simulated pixel."""
        self.gates += sequence.gates
        self.values.update((*sequence.scratch, *changes))

    def pop_gates(self) -> tuple[Gate, ...]:
        """Return the gates chosen so far, and forget them; contents stay."""
        gates = tuple(self.gates)
        self.gates.clear()
        return gates

    def distinguishes(self, vectors: Iterable[int]) -> bool:
        """Return whether gates can compute each of the truth vectors `vectors` from the contents of
        registers.

        They can if no two lanes (nodes of the state machine, each with one outcome) have equal
        contents, but different bits in a vector. Without vectors, return True. A truth vector is an
        integer with one bit for each simulated pixel."""
        return all(map(self._distinguishes, vectors))

    def _distinguishes(self, vector: int) -> bool:
        """Return whether gates can compute the truth vector `vector` from the contents of
        registers.

        They can if no two lanes (simulated pixels) have equal contents, but different bits in
        `vector`. A truth vector is an integer with one bit for each simulated pixel."""
        # Groups of lanes with equal contents, of which some are in `vector` and some are not.
        mixed = [self.everything]
        # `everything` comes first, so that a constant vector needs no register.
        for v in (self.everything, *self.values.values()):
            halves = [half for group in mixed for half in (group & v, group & ~v)]
            mixed = [half for half in halves if half & vector not in (0, half)]
            if not mixed:
                return True
        return False

    def shortest_gates(
        self, target: int, destination: str, most: float = inf
    ) -> GateSequence | None:
        """Return the shortest gate sequence that writes the truth vector `target` to the register
        `destination`; of equals, one with the fewest scratch registers (for intermediate results).

        Return None if no sequence of at most `most` words is found. A truth vector is an integer
        with one bit for each simulated pixel."""
        if most < 1:
            return None
        ways = (
            sequence
            for sequence in self._sequences(target, destination, most)
            if sequence.words <= most
        )
        return min(ways, key=lambda sequence: sequence.price, default=None)

    def shortest_gates_to_flag(self, target: int) -> GateSequence | None:
        """Return the shortest gate sequence that writes the truth vector `target` to FLAG (the bit
        that lets a pixel act); None if none is found.

        The sequence is empty if FLAG has this value already. It may overwrite unused scratch
        registers (for intermediate results). A truth vector is an integer with one bit for each
        simulated pixel."""
        if self.values.get(FLAG) == target:
            return GateSequence((), ())
        name = self.first_unused_scratch()
        sequences = [
            self._through(sequence, name, target) for sequence in self._sequences(target, name, inf)
        ]
        return min(sequences, key=lambda sequence: sequence.price, default=None)

    def _through(self, sequence: GateSequence, name: str, target: int) -> GateSequence:
        """Return a sequence that writes the truth vector `target` to FLAG (the bit that lets a
        pixel act).

        `sequence` writes it to the scratch register `name`; a WHERE then copies that to FLAG. WHERE
        replaces a final OR or copy if it may read the sources of that gate. A truth vector is an
        integer with one bit for each simulated pixel. A scratch register holds an intermediate
        result."""
        last, limit = sequence.gates[-1], self.machine.where_sources
        reads = set(last.sources)
        if (
            last.name in ("OR", "MOV")
            and last.destination not in reads
            and (FLAG not in reads or self.machine.where_reads_flag)
            and (limit is None or len(reads) <= limit)
        ):
            return GateSequence(
                (*sequence.gates[:-1], Gate("WHERE", FLAG, last.sources)), sequence.scratch
            )
        return GateSequence(
            (*sequence.gates, Gate("WHERE", FLAG, (name,))), (*sequence.scratch, (name, target))
        )

    def _sequences(self, target: int, destination: str, most: float) -> Iterator[GateSequence]:
        """Yield gate sequences that write the truth vector `target` to the register `destination`,
        each an OR of NORs for it or for its complement.

        Some may have more than `most` words. None is yielded if the search finds none, for example
        because the contents do not distinguish the lanes (simulated pixels). A truth vector is an
        integer with one bit for each simulated pixel."""
        # Of registers with equal contents, the first: those of code and states before scratch.
        first = {v: name for name, v in reversed(self.values.items()) if v}
        names, values = list(first.values()), list(first)
        fewest = None
        # A word for each cube, and one for their OR unless a single cube is all.
        most_cubes = int(max(1, min(most - 1, _MOST_CUBES)))
        for sequence in self._covers(names, values, target, destination, most_cubes):
            fewest = sequence.words if fewest is None else min(fewest, sequence.words)
            yield sequence
            if sequence.price == (1, 0):  # nothing is shorter
                return
        # A complement takes one word, and its reader another; it takes a register also.
        if most >= 2 and (fewest is None or (fewest > 2 and not self.few)):
            for v, name in tuple(first.items()):
                if self.everything & ~v not in first:
                    names.append(f"~{name}")
                    values.append(self.everything & ~v)
            # With a complement and an OR, more cubes would take more words than are known.
            most_cubes = max(1, min(most_cubes, (fewest or most_cubes + 2) - 2))
            yield from self._covers(names, values, target, destination, most_cubes)

    def _covers(
        self,
        names: Sequence[str],
        values: Sequence[int],
        vector: int,
        destination: str,
        most_cubes: int,
    ) -> Iterator[GateSequence]:
        """Yield at most two gate sequences that write the truth vector `vector` to `destination`:
        an OR of at most `most_cubes` NORs, and the inverse of such an OR.

        `names` and `values` are the readable registers and their contents, in parallel; a name that
        begins with "~" is the complement of that register. `destination` is a register. A search
        that takes more than `_STEPS` steps counts as without result. A truth vector is an integer
        with one bit for each simulated pixel."""
        for inverted in (False, True):
            target = self.everything & ~vector if inverted else vector
            covers = Covers(self.everything, self.machine.or_sources, Budget(_STEPS))
            try:
                cover = covers.find(values, [True] * len(values), [target], most_cubes)
            except GaveUp:
                continue
            if cover is not None:
                yield self._emitted(cover, names, values, destination, inverted)

    def _emitted(
        self,
        cover: Cover,
        names: Sequence[str],
        values: Sequence[int],
        destination: str,
        inverted: bool,
    ) -> GateSequence:
        """Return the gates of an OR of NORs (`cover`): one NOR for each cube, then the gate that
        writes `destination`.

        If `inverted`, that gate writes the inverse. `names` and `values` are the registers that a
        cover may read and their contents, in parallel; a cube refers to them by index. Names that
        begin with "~" stand for complements, which are first computed in unused scratch registers
        (for intermediate results)."""
        gates = Gates(self.machine)
        scratch_values: dict[str, int] = {}
        complements: dict[int, str] = {}
        names_left = self.unused_scratch(destination)

        def scratch(vector: int) -> str:
            """Return the next scratch register (for intermediate results), and note that it holds
            the truth vector (an integer with one bit for each simulated pixel)."""
            name = next(names_left)
            scratch_values[name] = vector
            return name

        def source(index: int) -> str:
            """Return the register to read for the entry `index` of `names`; a complement is
            computed at its first use."""
            if not names[index].startswith("~"):
                return names[index]
            if index not in complements:
                complements[index] = scratch(values[index])
                gates.nor(complements[index], [names[index][1:]])
            return complements[index]

        if len(cover.cubes) == 1 and not cover.positive:
            # An OR of one NOR is a NOR, and its complement is an OR: one gate.
            cube = [source(i) for i in cover.cubes[0].sources]
            (gates.or_ if inverted else gates.nor)(destination, cube)
            return GateSequence(gates.take(), tuple(scratch_values.items()))
        positive: list[str] = []
        for cover_cube in cover.cubes:
            # Complements are computed just before their first reader, so fewer are alive at once.
            cube = [source(i) for i in cover_cube.sources]
            # A cube's register is free for the next one once the OR of both is known.
            if self.few and len(positive) > 1:
                gates.or_(positive[0], positive)
                last = positive.pop()
                scratch_values[positive[0]] |= scratch_values[last]
                scratch_values[last] = cover_cube.vector
                positive.append(last)
            else:
                positive.append(scratch(cover_cube.vector))
            gates.nor(positive[-1], cube)
        positive += [source(i) for i in cover.positive]
        (gates.nor if inverted else gates.or_)(destination, positive)
        return GateSequence(gates.take(), tuple(scratch_values.items()))


def write_simultaneously(contents: RegisterContents, new_values: dict[str, int]) -> None:
    """Append gates that write new values to registers simultaneously: all depend on the old values.

    `new_values` are truth vectors (integers with one bit for each lane) by register. Registers that
    have their new values already need no gates. Raises GaveUp if no gates are found, because
    registers do not distinguish lanes with different new values."""
    changes = {name: v for name, v in new_values.items() if contents.values[name] != v}
    best = _ordered(contents, changes, best=None)
    # A shared value must save at least one word, and each change still takes one.
    most = inf if best is None else best.words - contents.words - len(changes) - 1
    for begun in _with_changes(contents, changes, most):
        best = _ordered(begun, changes, best)
    if best is None:
        raise GaveUp("the registers do not tell the lanes of a look apart")
    contents.values, contents.gates = best.values, best.gates


def _with_changes(
    contents: RegisterContents, new_values: dict[str, int], most: float
) -> Iterator[RegisterContents]:
    """Yield copies of the contents, each with one more scratch register, with which at least two
    registers can be ORed to get their new values.

    The scratch register is 1 in the lanes (simulated pixels) in which these registers become 1.
    `new_values` are truth vectors (integers with one bit for each lane) by register. Computing the
    scratch register takes at most `most` words."""
    rises = [v & ~contents.values[name] for name, v in new_values.items()]
    for rise in dict.fromkeys(rises):
        if rises.count(rise) > 1 and rise not in contents.values.values():
            after = contents.copy()
            name = after.first_unused_scratch()
            sequence = after.shortest_gates(rise, name, most)
            if sequence is not None:
                after.take(sequence, (name, rise))
                yield after


def _ordered(
    contents: RegisterContents, new_values: dict[str, int], best: RegisterContents | None
) -> RegisterContents | None:
    """Return the contents after writing all new values, one after the other, in the order of fewest
    words.

    `new_values` are truth vectors (integers with one bit for each simulated pixel) by register.
    `best` are the contents that an earlier attempt reached, or None. Return `best` if no order
    takes fewer words, or if none works."""
    if best is not None and contents.words + len(new_values) >= best.words:
        return best  # every value takes at least one word
    if not new_values:
        return contents
    most = inf if best is None else best.words - len(new_values)
    greedy = len(new_values) > _MOST_ORDERED
    cheapest: tuple[str, RegisterContents] | None = None
    for name in new_values:
        after = _written(contents, name, new_values, most)
        if after is None:
            continue
        if greedy:
            cheapest, most = (name, after), after.words - 1  # the next must be shorter
            continue
        best = _ordered(after, _without(name, new_values), best)
        most = inf if best is None else best.words - len(new_values)
    if cheapest is not None:
        name, after = cheapest
        best = _ordered(after, _without(name, new_values), best)
    return best


def _without(name: str, new_values: dict[str, int]) -> dict[str, int]:
    """Return the truth vectors (integers with one bit for each simulated pixel) by register without
    that of the register `name`."""
    return {register: v for register, v in new_values.items() if register != name}


def _written(
    contents: RegisterContents, name: str, new_values: dict[str, int], most: float
) -> RegisterContents | None:
    """Return the contents after writing the new value of the register `name`; `contents` stay
    unchanged.

    `new_values` are truth vectors (integers with one bit for each simulated pixel) by register. The
    old value is saved first if the other new values need it. Return None if that exceeds `most`
    words in all, or no gates are found."""
    sequence = contents.shortest_gates(new_values[name], name, most - contents.words)
    if sequence is None:
        return None
    after = contents.copy()
    after.take(sequence, (name, new_values[name]))
    if after.distinguishes(_without(name, new_values).values()):
        return after
    after = contents.copy()
    after.copy_to_scratch(name)
    sequence = after.shortest_gates(new_values[name], name, most - after.words)
    if sequence is None:
        return None
    after.take(sequence, (name, new_values[name]))
    return after
