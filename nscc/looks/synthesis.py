"""Gates at one boundary: predicates into FLAG, new values into the registers of states.

Everything is a truth vector over the boundary's lanes. What is wanted is an OR of NORs of what
stands in registers (`nscc.logic.cover`), or the complement of one; where values as they stand do
not tell lanes apart, complements are made in scratch.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from math import inf

from nscc.logic.cover import Cover, Covers
from nscc.logic.cubes import Budget
from nscc.logic.gates import Gates
from nscc.logic.problem import Gate, GaveUp, Machine

FLAG = "FLAG"
_STEPS = 4_000_000
_MOST_CUBES = 24
_MOST_ORDERED = 3
"""So many registers are tried in every order in which their new values may be written; of more, the
next one is always that which is cheapest then."""


@dataclass(frozen=True)
class Made:
    """Gates that bring a vector into a register, and what they leave in scratch."""

    gates: tuple[Gate, ...]
    scratch: tuple[tuple[str, int], ...]

    @property
    def words(self) -> int:
        """Words of the gates."""
        return sum(gate.words for gate in self.gates)

    @property
    def price(self) -> tuple[int, int]:
        """Words, then scratch registers."""
        return self.words, len(self.scratch)


@dataclass
class Board:
    """The registers of a pixel at a boundary, while gates are chosen.

    `values` are what registers hold, by name; FLAG is among them where it is known, and scratch
    (t0, t1, ..) while it holds something. `gates` are those chosen so far.
    """

    machine: Machine
    everything: int
    values: dict[str, int]
    gates: list[Gate] = field(default_factory=list)

    @property
    def words(self) -> int:
        """Words of the gates."""
        return sum(gate.words for gate in self.gates)

    def copy(self) -> Board:
        """A board to try something on."""
        return replace(self, values=dict(self.values), gates=list(self.gates))

    def fresh(self, taken: Collection[str] = ()) -> str:
        """A scratch register that holds nothing and is not among those `taken`."""
        number = 0
        while f"t{number}" in self.values or f"t{number}" in taken:
            number += 1
        return f"t{number}"

    def keep(self, name: str) -> None:
        """Copies a register, or FLAG, into scratch."""
        scratch = self.fresh()
        self.gates.append(Gate("MOV", scratch, (name,)))
        self.values[scratch] = self.values[name]

    def take(self, made: Made, *changes: tuple[str, int]) -> None:
        """Runs gates: scratch and `changes` have new values."""
        self.gates += made.gates
        self.values.update((*made.scratch, *changes))

    def taken(self) -> tuple[Gate, ...]:
        """The gates since the last call."""
        found = tuple(self.gates)
        self.gates.clear()
        return found

    def tells(self, wanted: Iterable[int]) -> bool:
        """Whether what stands in registers tells the lanes of each vector from the others."""
        parts = [self.everything]
        for v in self.values.values():
            parts = [p for part in parts for p in (part & v, part & ~v) if p]
        return all(not part & each or not part & ~each for each in wanted for part in parts)

    def make(self, wanted: int, destination: str, most: float = inf) -> Made | None:
        """The fewest words found, at most `most`, that leave `wanted` in a register, whatever it
        held."""
        if most < 1:
            return None
        ways = (made for made in self._ways(wanted, destination, most) if made.words <= most)
        return min(ways, key=lambda made: made.price, default=None)

    def load(self, wanted: int) -> Made | None:
        """The fewest words found that bring `wanted` into FLAG."""
        if self.values.get(FLAG) == wanted:
            return Made((), ())
        name = self.fresh()
        found = [self._through(made, name, wanted) for made in self._ways(wanted, name, inf)]
        return min(found, key=lambda made: made.price, default=None)

    def _through(self, made: Made, name: str, wanted: int) -> Made:
        """`made`, which leaves `wanted` in the register `name`, with the WHERE that reads it; WHERE
        takes the place of an OR if it may read what that reads."""
        last, limit = made.gates[-1], self.machine.where_sources
        reads = set(last.sources)
        if (
            last.name in ("OR", "MOV")
            and last.destination not in reads
            and (FLAG not in reads or self.machine.where_reads_flag)
            and (limit is None or len(reads) <= limit)
        ):
            return Made((*made.gates[:-1], Gate("WHERE", FLAG, last.sources)), made.scratch)
        return Made((*made.gates, Gate("WHERE", FLAG, (name,))), (*made.scratch, (name, wanted)))

    def _ways(self, wanted: int, destination: str, most: float) -> Iterator[Made]:
        """Several ways to make a vector, by a cover of it and of its complement; those of at most
        `most` words are among them."""
        # Of registers that hold the same, the first: those of code and states stand before scratch.
        first = {v: name for name, v in reversed(self.values.items()) if v}
        names, values = list(first.values()), list(first)
        fewest = None
        for made in self._covers(names, values, wanted, destination):
            fewest = made.words if fewest is None else min(fewest, made.words)
            yield made
            if made.price == (1, 0):
                return
        # A complement takes a word, and what reads it another.
        if most >= 2 and (fewest is None or fewest > 2):
            for v, name in tuple(first.items()):
                if self.everything & ~v not in first:
                    names.append(f"~{name}")
                    values.append(self.everything & ~v)
            yield from self._covers(names, values, wanted, destination)

    def _covers(
        self, names: Sequence[str], values: Sequence[int], wanted: int, destination: str
    ) -> Iterator[Made]:
        for inverted in (False, True):
            target = self.everything & ~wanted if inverted else wanted
            covers = Covers(self.everything, self.machine.or_sources, Budget(_STEPS))
            try:
                cover = covers.find(values, [True] * len(values), [target], _MOST_CUBES)
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
    ) -> Made:
        gates = Gates(self.machine)
        made: dict[str, int] = {}
        complements: dict[int, str] = {}

        def scratch(vector: int) -> str:
            name = self.fresh((*made, destination))
            made[name] = vector
            return name

        def source(index: int) -> str:
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
            return Made(gates.take(), tuple(made.items()))
        positive = []
        for found in cover.cubes:
            # Complements are made where they are read first: fewer are alive at once.
            cube = [source(i) for i in found.sources]
            positive.append(scratch(found.vector))
            gates.nor(positive[-1], cube)
        positive += [source(i) for i in cover.positive]
        (gates.nor if inverted else gates.or_)(destination, positive)
        return Made(gates.take(), tuple(made.items()))


def update(board: Board, wanted: dict[str, int]) -> None:
    """Gives registers new values, all at once: no new value is read as if it were the old one.

    Raises GaveUp where the registers do not tell lanes apart that are to differ.
    """
    left = {name: v for name, v in wanted.items() if board.values[name] != v}
    best: Board | None = None
    for begun in (board, *_with_changes(board, left)):
        best = _ordered(begun, left, best)
    if best is None:
        raise GaveUp("the registers do not tell the lanes of a look apart")
    board.values, board.gates = best.values, best.gates


def _with_changes(board: Board, wanted: dict[str, int]) -> Iterator[Board]:
    """Boards on which scratch holds the lanes in which several registers become 1: each of them
    then takes an OR."""
    rises = [v & ~board.values[name] for name, v in wanted.items()]
    for rise in dict.fromkeys(rises):
        if rises.count(rise) > 1 and rise not in board.values.values():
            after = board.copy()
            name = after.fresh()
            made = after.make(rise, name)
            if made is not None:
                after.take(made, (name, rise))
                yield after


def _ordered(board: Board, wanted: dict[str, int], best: Board | None) -> Board | None:
    """The board with all new values, written in the order of the fewest words; `best` if no order
    takes fewer than that."""
    if best is not None and board.words + len(wanted) >= best.words:
        return best  # every value takes a word at least
    if not wanted:
        return board
    # Every value takes a word at least.
    most = inf if best is None else best.words - len(wanted)
    greedy = len(wanted) > _MOST_ORDERED
    cheapest: tuple[str, Board] | None = None
    for name in wanted:
        after = _written(board, name, wanted, most)
        if after is None:
            continue
        if greedy:
            cheapest, most = (name, after), after.words - 1
            continue
        best = _ordered(after, _without(name, wanted), best)
        most = inf if best is None else best.words - len(wanted)
    if cheapest is not None:
        name, after = cheapest
        best = _ordered(after, _without(name, wanted), best)
    return best


def _without(name: str, wanted: dict[str, int]) -> dict[str, int]:
    return {other: v for other, v in wanted.items() if other != name}


def _written(board: Board, name: str, wanted: dict[str, int], most: float) -> Board | None:
    """The board with one new value, and the old one saved if others need it; None: it cannot be
    had in at most so many words in all."""
    made = board.make(wanted[name], name, most - board.words)
    if made is None:
        return None
    after = board.copy()
    after.take(made, (name, wanted[name]))
    if after.tells(_without(name, wanted).values()):
        return after
    after = board.copy()
    after.keep(name)
    made = after.make(wanted[name], name, most - after.words)
    if made is None:
        return None
    after.take(made, (name, wanted[name]))
    return after
