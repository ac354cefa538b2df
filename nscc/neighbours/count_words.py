"""The words of counts: bits of neighbours, shifted one step at a time, add IN to accumulators.

Several images can be counted in one walk over the neighbourhood: they share the shifts. A word
inverts, so each place takes two words to another register, one of them with IN: one in all pixels,
then one where the bit is 1. A pixel keeps the error of only one of them, and all pixels lose the
same share of a count to the gain of words. Of two images whose weights agree at a place, half their
sum changes there and half their difference does not; where the weights differ it is the other way
round. Accumulators of such sums take two words a place for both images.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial
from typing import TypeVar

from nscc.neighbours.bits import BitWords, Offset
from nscc.neighbours.held import Emitter, Held
from nscc.operations import op
from nscc.words import pictures as p

MOST_IMAGES = 4
"""So many images are counted in one walk at most."""

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


@dataclass
class Accumulator:
    """A register that holds a count times `sign`. It starts with `start` counts, in the word number
    `first_word`; the count lies within `span` of 0. `variance` is that of `Held`."""

    register: str
    first_word: int
    sign: int = 1
    start: Fraction = Fraction(0)
    span: Fraction = Fraction(0)
    variance: float = 1.0


Result = TypeVar("Result")


class CountEmitter(Emitter):
    """The counts of a lowering, `most_together` images in a walk.

    `ready` are images that were counted before their turn, by name: of which accumulators they are
    made. `count_e` are the electrons of a count.
    """

    bits: BitWords
    held: dict[str, Held]
    uses: dict[str, int]
    count_e: float

    def __init__(self, pictures: p.Pictures) -> None:
        super().__init__(pictures)
        self.ready: dict[str, list[tuple[Fraction, Held]]] = {}
        self.walks, self.spare, self.most_together = 0, "", MOST_IMAGES

    @abstractmethod
    def take(self) -> str:
        """A register that is free."""

    @abstractmethod
    def checked(self, low: float, high: float) -> None:
        """Refuses a value that a register does not hold."""

    @abstractmethod
    def filtered(self, value: Held, weights: dict[Offset, Fraction]) -> Held:
        """A value weighted by a kernel."""

    @abstractmethod
    def added(self, signed_terms: list[tuple[int, Held]]) -> Held:
        """The sum of values that are held, each with its sign in the sum."""

    @abstractmethod
    def do_shortest(self, ways: Sequence[Callable[[], Result]], shares: Sequence[int]) -> Result:
        """What that way gives which takes the fewest words for its share of the work."""

    def count_ahead(self, position: int) -> None:
        """Counts the image at a position of the text, if all of it is a sum of agreements, with
        those behind it that can be counted in the same walk: as many as take the fewest words."""
        items = self.pictures.items[position:]
        sums = [(item.name, total) for item in items if (total := self._countable(item))]
        if not sums or sums[0][0] != items[0].name:
            return
        numbers = range(1, min(len(sums), self.most_together) + 1)
        ways, shares = [], []
        for number in numbers:
            for directions_of in (_separate, _shared):
                ways.append(partial(self._count, sums[:number], directions_of))
                shares.append(number)
        self.do_shortest(ways, shares)

    def _countable(self, item: p.Picture) -> CountSum | None:
        """An item that is a sum of agreements of planes that are known by now; None for others."""
        if isinstance(item.node, p.Condition) or item.name in self.ready:
            return None
        agreements, others = split(item.node)
        known = self.bits.planes.keys() | self.held.keys()
        names = {
            node.name for node in p.subexpressions(item.node) if isinstance(node, p.Bit | p.Source)
        }
        counts = bool(agreements.weights(self.weights)) and not others
        return agreements if counts and names <= known else None

    def counted(self, agreements: CountSum) -> Held:
        """The sum of agreements that stand in an expression, or that were counted before."""
        terms = self.ready.pop(self.now, None)
        if terms is None:
            self._count([("", agreements)], _separate)
            terms = self.ready.pop("")
        factor, first = terms[0]
        assert first.name is not None
        if len(terms) == 1 and abs(factor) == 1 and self.uses[first.name] == 1:
            sign = first.sign if factor > 0 else -first.sign
            return replace(self.held.pop(first.name), name=None, sign=sign)
        signed_terms = []
        for factor, accumulator in terms:
            term = self.filtered(accumulator, {(0, 0): abs(factor)})
            signed_terms.append((1 if factor > 0 else -1, term))
        return self.added(signed_terms)

    def _count(
        self, sums: Sequence[tuple[str, CountSum]],
        directions_of: Callable[[Sequence[Direction], int], list[Direction]],
    ) -> None:  # fmt: skip
        """The walks that count some images, by accumulators of these directions."""
        weights = [total.weights(self.weights) for _, total in sums]
        places = list(dict.fromkeys(place for image in weights for place in image))
        vectors = {at: tuple(image.get(at, Fraction(0)) for image in weights) for at in places}
        directions = directions_of(list(vectors.values()), len(sums))
        steps = {at: _steps_along(vector, directions) for at, vector in vectors.items()}
        self.everywhere()
        accumulators = [self._begin() for _ in directions]
        self.spare = self.take()
        unread = [term.condition for _, total in sums for _, term in total.terms]
        for condition in dict.fromkeys(condition for condition, _ in places):
            self._walk(condition, steps, accumulators)
            unread.remove(condition)
        self._skip(unread)
        self.everywhere()
        self.give(Held(self.spare, 1, 0.0, 0.0))
        self.walks += 1
        self.ready |= {name: [] for name, _ in sums}
        for number, (direction, accumulator) in enumerate(
            zip(directions, accumulators, strict=True)
        ):
            name = f"count {self.walks}.{number}"
            self.uses[name] = sum(1 for factor in direction if factor)
            held = self.held[name] = self._finished(accumulator, name)
            for (image, _), factor in zip(sums, direction, strict=True):
                if factor:
                    self.ready[image].append((factor, held))

    def _begin(self) -> Accumulator:
        """An accumulator; its start is known when all bits are added."""
        register = self.take()
        self.word(op("bus", [register]))
        return Accumulator(register, len(self.words) - 1)

    def _finished(self, accumulator: Accumulator, name: str) -> Held:
        """What an accumulator holds after the last bit, now that its start is known."""
        level = -int(accumulator.start * self.pictures.count_steps)
        if level:
            first = self.words[accumulator.first_word][0]
            started = op("bus", first.destinations, ["IN"])
            self.words[accumulator.first_word] = started, level
        high_e = float(accumulator.span) * self.count_e
        self.checked(-high_e, high_e)
        sign, variance = accumulator.sign, accumulator.variance
        return Held(accumulator.register, sign, -high_e, high_e, name, variance)

    def _walk(
        self, condition: p.Condition, steps: dict[Place, dict[int, Fraction]],
        accumulators: Sequence[Accumulator],
    ) -> None:  # fmt: skip
        """Adds the bits of one plane, place by place."""
        bit = self.bits.bit(condition)
        offsets = {at for plane, at in steps if plane == condition}
        for at, register in self.bits.places(bit[0], offsets):
            for number, factor in steps[condition, at].items():
                self._add(accumulators[number], register, factor)
        self.bits.give(bit)

    def _add(self, accumulator: Accumulator, bit: str, factor: Fraction) -> None:
        """Adds a factor where a bit is 1, and takes it away where it is 0.

        IN comes to the pixels whose bit is 1 or to the others, as the sign requires that the
        accumulator has by now; the start makes up for the rest.
        """
        level = abs(int(2 * factor * self.pictures.count_steps))
        to_ones = factor * accumulator.sign > 0
        for is_flagged in (False, True):
            if is_flagged:
                self.word(op("WHERE", [], [bit]))
            else:
                self.everywhere()
            adds = is_flagged == to_ones
            sources = [accumulator.register, *(["IN"] if adds else [])]
            self.word(op("bus", [self.spare], sources), level if adds else None)
        self.spare, accumulator.register = accumulator.register, self.spare
        accumulator.sign = -accumulator.sign
        accumulator.start += -factor if to_ones else factor
        accumulator.span += abs(factor)
        accumulator.variance += 1

    def _skip(self, conditions: Iterable[p.Condition]) -> None:
        """Planes that were walked over are not read again for the other agreements."""
        nodes = (node for condition in conditions for node in p.subexpressions(condition))
        for node in nodes:
            if isinstance(node, p.Bit):
                self.bits.give((self.bits.planes[node.name], node.name))
            elif isinstance(node, p.Source):
                self.give(self.held[node.name])


def _separate(vectors: Sequence[Direction], images: int) -> list[Direction]:
    """An accumulator for each image."""
    return [_unit(image, images) for image in range(images)]


def _shared(vectors: Sequence[Direction], images: int) -> list[Direction]:
    """An accumulator for each way in which the images' weights at a place agree and differ; where
    their sizes differ, the images have accumulators of their own."""
    directions: dict[Direction, None] = {}
    for vector in vectors:
        direction = _normal(vector)[1]
        own = [_unit(image, images) for image, weight in enumerate(vector) if weight]
        alike = all(abs(part) in (0, 1) for part in direction)
        directions |= dict.fromkeys([direction] if alike else own)
    return list(directions)


def _unit(image: int, images: int) -> Direction:
    """The direction of one image alone."""
    return tuple(Fraction(number == image) for number in range(images))


def _normal(vector: Direction) -> tuple[Fraction, Direction]:
    """A vector as a factor times one whose first number that is not 0 is 1."""
    first = next(number for number in vector if number)
    return first, tuple(number / first for number in vector)


def _steps_along(vector: Direction, directions: Sequence[Direction]) -> dict[int, Fraction]:
    """How much of each accumulator, of these directions, adds up to a vector."""
    factor, direction = _normal(vector)
    if direction in directions:
        return {directions.index(direction): factor}
    own = ((_unit(image, len(vector)), weight) for image, weight in enumerate(vector) if weight)
    return {directions.index(unit): weight for unit, weight in own}
