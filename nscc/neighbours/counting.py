"""The words of counts: bits of neighbours, shifted one step at a time, add IN to accumulators.

Several images can be counted in one walk over the neighbourhood: they share the shifts, and FLAG.
A word adds to one register, so a weight of an image takes two words where FLAG is 1. Of two images
whose weights agree at a place, half their sum changes there and half their difference does not;
where the weights differ it is the other way round. Accumulators of such sums take two words a place
for both images.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

from nscc.neighbours.bits import Offset
from nscc.neighbours.held import Held
from nscc.operations import op
from nscc.words import pictures as p

if TYPE_CHECKING:
    from nscc.neighbours.lower import Lowering

WALKS = ((4, True), (4, False), (3, False), (2, False), (1, False))
"""Limits that are tried in turn, until everything fits the registers: the most images that are
counted in one walk, and whether they may share accumulators, which takes registers later."""

Place = tuple[p.Condition, Offset]
Direction = tuple[Fraction, ...]
"""How much of an accumulator each image of a walk contains."""


@dataclass(frozen=True)
class CountSum:
    """An image, or the part of one, that is a sum of agreements."""

    terms: tuple[tuple[Fraction, p.Agreement], ...]

    def weights(self, kernels: dict[str, p.Weights]) -> dict[Place, Fraction]:
        """By plane and place the factor of a bit that is +1 or -1; none that is 0."""
        total: dict[Place, Fraction] = {}
        for factor, agreement in self.terms:
            for at, weight in kernels[agreement.kernel].taps.items():
                key = agreement.condition, at
                total[key] = total.get(key, Fraction(0)) + factor * (1 if weight > 0 else -1)
        return {place: weight for place, weight in total.items() if weight}


def split(node: p.Value) -> tuple[CountSum, list[tuple[Fraction, p.Value]]]:
    """The agreements of an image, and the other terms of its sum."""
    terms = node.terms if isinstance(node, p.Sum) else ((Fraction(1), node),)
    agreements = tuple((f, term) for f, term in terms if isinstance(term, p.Agreement))
    return CountSum(agreements), [t for t in terms if not isinstance(t[1], p.Agreement)]


class Counting:
    """Counts of a lowering; `ready` are images that were counted before their turn, by name: of
    which accumulators they are made."""

    def __init__(self, lowering: Lowering, limits: tuple[int, bool]) -> None:
        self.lowering, self.limits = lowering, limits
        self.ready: dict[str, list[tuple[Fraction, Held]]] = {}
        self.walks = 0

    def prepare(self, position: int) -> None:
        """Counts the image at a position of the text, if all of it is a sum of agreements, with
        those behind it that can be counted in the same walk: as many as take the fewest words."""
        items = self.lowering.pictures.items
        most, may_share = self.limits
        together = [item for item in items[position:] if self._can_count(item)][:most]
        if items[position].name in self.ready or together[:1] != [items[position]]:
            return
        sums = [(item.name, split(item.node)[0]) for item in together]  # type: ignore[arg-type]
        makes = (_separate, _shared) if may_share else (_separate,)
        ways = [
            lambda n=n, make=make: self._count(sums[:n], make)
            for n in range(1, len(sums) + 1)
            for make in makes
        ]
        shares = [n for n in range(1, len(sums) + 1) for _ in makes]
        self.lowering.do_shortest(ways, shares)

    def _can_count(self, item: p.Picture) -> bool:
        """Whether an item is a sum of agreements of planes that are known by now."""
        if isinstance(item.node, p.Condition) or item.name in self.ready:
            return False
        agreements, others = split(item.node)
        known = self.lowering.bits.planes.keys() | self.lowering.held.keys()
        return bool(agreements.terms) and not others and all(
            node.name in known
            for node in p.subexpressions(item.node)
            if isinstance(node, p.Bit | p.Source)
        )  # fmt: skip

    def value(self, agreements: CountSum) -> Held:
        """The sum of agreements that stand in an expression, or that were counted before."""
        terms = self.ready.pop(self.lowering.now, None)
        if terms is None:
            ways = [lambda: self._count([("", agreements)], _separate)]
            self.lowering.do_shortest(ways, [1])
            terms = self.ready.pop("")
        return self._combined(terms)

    def _combined(self, terms: list[tuple[Fraction, Held]]) -> Held:
        """The sum of accumulators with their factors."""
        lowering = self.lowering
        factor, first = terms[0]
        if len(terms) == 1 and abs(factor) == 1 and lowering.uses[first.name or ""] == 1:
            del lowering.held[first.name or ""]
            sign = first.sign if factor > 0 else -first.sign
            return Held(first.register, sign, first.low, first.high, variance=first.variance)
        signed_terms = []
        for factor, accumulator in terms:
            term = lowering.filtered(accumulator, {(0, 0): abs(factor)})
            signed_terms.append((1 if factor > 0 else -1, term))
        return lowering.added(signed_terms)

    def _count(
        self, sums: Sequence[tuple[str, CountSum]],
        directions_of: Callable[[Iterable[Direction]], list[Direction]],
    ) -> None:  # fmt: skip
        """The walks that count some images, by accumulators of these directions."""
        lowering = self.lowering
        kernels = lowering.weights
        weights = [total.weights(kernels) for _, total in sums]
        places = list(dict.fromkeys(place for image in weights for place in image))
        vectors = {at: tuple(image.get(at, Fraction(0)) for image in weights) for at in places}
        directions = directions_of(vectors.values())
        parts = {at: _parts(vector, directions) for at, vector in vectors.items()}
        spans = [
            sum((abs(part[d]) for part in parts.values() if d in part), Fraction(0))
            for d in range(len(directions))
        ]
        accumulators = self._begin(parts.values(), len(directions))
        for condition in dict.fromkeys(condition for condition, _ in places):
            self._walk(condition, parts, accumulators)
        self._skip_repeated([term.condition for _, total in sums for _, term in total.terms])
        lowering.everywhere()
        unit_e = lowering.count_e
        held = []
        self.walks += 1
        for number, (register, most) in enumerate(zip(accumulators, spans, strict=True)):
            name = f"count {self.walks}.{number}"
            words = 1 + 2 * sum(number in part for part in parts.values())
            high = float(most) * unit_e
            lowering.checked(-high, high)
            held.append(Held(register, 1, -high, high, name, float(words)))
            lowering.held[name] = held[-1]
            lowering.uses[name] = sum(1 for d in range(len(sums)) if directions[number][d])
        for index, (name, _) in enumerate(sums):
            self.ready[name] = [
                (direction[index], accumulator)
                for direction, accumulator in zip(directions, held, strict=True)
                if direction[index]
            ]

    def _begin(self, parts: Iterable[dict[int, Fraction]], number: int) -> list[str]:
        """Accumulators of counts in which no bit is 1."""
        lowering = self.lowering
        start = [Fraction(0)] * number
        for part in parts:
            for accumulator, factor in part.items():
                start[accumulator] -= factor
        registers = []
        lowering.everywhere()
        for count in start:
            registers.append(lowering.take())
            level = -int(count * lowering.pictures.count_steps)
            lowering.word(op("bus", registers[-1:], ["IN"] if level else []), level or None)
        return registers

    def _walk(
        self, condition: p.Condition, parts: dict[Place, dict[int, Fraction]],
        accumulators: Sequence[str],
    ) -> None:  # fmt: skip
        """Adds the bits of one plane, place by place."""
        lowering, bits = self.lowering, self.lowering.bits
        bit = bits.bit(condition)
        offsets = {at for plane, at in parts if plane == condition}
        for at, register in bits.places(bit[0], offsets):
            lowering.word(op("WHERE", [], [register]))
            for number, factor in parts[condition, at].items():
                self._add(accumulators[number], int(2 * factor * lowering.pictures.count_steps))
        bits.give(bit)

    def _add(self, register: str, steps: int) -> None:
        """Adds steps of IN where FLAG is 1. A word inverts: IN is in the first or the second."""
        for number, (target, source) in enumerate([("NEWS", register), (register, "NEWS")]):
            adds = number == (steps < 0)
            sources = [source, "IN"] if adds else [source]
            self.lowering.word(op("bus", [target], sources), abs(steps) if adds else None)

    def _skip_repeated(self, conditions: Sequence[p.Condition]) -> None:
        """Planes that were walked over once are not read again for the other agreements."""
        lowering = self.lowering
        for number, condition in enumerate(conditions):
            if condition not in conditions[:number]:
                continue
            for node in p.subexpressions(condition):
                if isinstance(node, p.Bit):
                    lowering.bits.give((lowering.bits.planes[node.name], node.name))
                elif isinstance(node, p.Source):
                    lowering.give(lowering.held[node.name])


def _separate(vectors: Iterable[Direction]) -> list[Direction]:
    """An accumulator for each image."""
    size = len(next(iter(vectors)))
    return [tuple(Fraction(i == j) for j in range(size)) for i in range(size)]


def _shared(vectors: Iterable[Direction]) -> list[Direction]:
    """An accumulator for each ratio of the images' weights at a place."""
    return list(dict.fromkeys(_normal(vector)[1] for vector in vectors))


def _normal(vector: Direction) -> tuple[Fraction, Direction]:
    """A vector as a factor times one whose first number that is not 0 is 1."""
    first = next(number for number in vector if number)
    return first, tuple(number / first for number in vector)


def _parts(vector: Direction, directions: Sequence[Direction]) -> dict[int, Fraction]:
    """What is added to which accumulator, for a vector."""
    factor, direction = _normal(vector)
    if direction in directions:
        return {directions.index(direction): factor}
    return {number: factor for number, factor in enumerate(vector) if factor}
