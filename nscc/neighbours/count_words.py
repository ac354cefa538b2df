"""Emit the words of counts, which add IN to accumulators for the bits of neighbours.

A walk over the neighbourhood shifts the bits of a plane by one pixel at a time. At each place, two
words copy the accumulator to another register, and one of them adds IN. The first word acts in all
pixels, the second overwrites the result where the bit is 1. A pixel therefore keeps the error of
one word a place, and the gain of words reduces the counts of all pixels by the same factor.

Images that are counted in one walk share the shifts. Where two images have equal weights, only half
the sum of their counts changes; where their weights have opposite signs, only half the difference.
Accumulators of the two halves need two words a place for both images."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial

from nscc.neighbours.bits import BitWords, Offset
from nscc.neighbours.held import Emitter, Held
from nscc.operations import op
from nscc.record import Record
from nscc.words import pictures as p

MOST_IMAGES = 4
"""Largest number of images that are counted in one walk."""

Place = tuple[p.Condition, Offset]
"""A plane, and the offset of the pixel whose bit is counted."""
Direction = tuple[Fraction, ...]
"""The factor of an accumulator in each image of a walk."""


class CountSum(Record):
    """A sum of counts (calls of `agree`), which is an image or a part of one.

    `terms` are pairs (factor, count)."""

    terms: tuple[tuple[Fraction, p.Agreement], ...]

    def weights(self, kernels: dict[str, p.Weights]) -> dict[Place, Fraction]:
        """Return how often each bit is added (or subtracted, if negative), by (plane, offset of the
        pixel), without zeros.

        `kernels` has the convolution kernels by name. Only the sign of a kernel's weight counts."""
        total: dict[Place, Fraction] = {}
        for factor, agreement in self.terms:
            for at, weight in kernels[agreement.kernel].taps.items():
                key = agreement.condition, at
                total[key] = total.get(key, Fraction(0)) + factor * (1 if weight > 0 else -1)
        return {offset: weight for offset, weight in total.items() if weight}


def split(node: p.Value) -> tuple[CountSum, list[tuple[Fraction, p.Value]]]:
    """Return the counts (calls of `agree`) of an image, and the other terms as pairs (factor,
    image).

    An image that is not a sum is a single term with the factor 1. Without counts, the first result
    has no terms; without other terms, the second is []."""
    terms = node.terms if isinstance(node, p.Sum) else ((Fraction(1), node),)
    agreements = tuple((f, term) for f, term in terms if isinstance(term, p.Agreement))
    return CountSum(agreements), [t for t in terms if not isinstance(t[1], p.Agreement)]


@dataclass
class Accumulator:
    """A register to which words add the bits of neighbours, and which holds a count times `sign`, 1
    or -1.

    The word with the index `first_word` writes its initial value, `start` counts. The count is at
    most `span` away from 0. `variance` is that of its error, in units of the variance of one word's
    error."""

    register: str
    first_word: int
    sign: int = 1
    start: Fraction = Fraction(0)
    span: Fraction = Fraction(0)
    variance: float = 1.0


class CountEmitter(Emitter):
    """Emits the words of counts, for at most `most_together` images at once.

    `ready` has, for each image that was counted ahead, pairs (factor, accumulator), whose sum is
    the image. `walks` is the number of walks over a neighbourhood so far, `spare` the register to
    which an accumulator is copied next. `count_e` is the number of electrons per count."""

    bits: BitWords
    count_e: float

    def __init__(self, pictures: p.Pictures) -> None:
        """Begin without words of `pictures` and without counted images."""
        super().__init__(pictures)
        self.ready: dict[str, list[tuple[Fraction, Held]]] = {}
        self.walks, self.spare, self.most_together = 0, "", MOST_IMAGES

    @abstractmethod
    def take(self) -> str:
        """Return a free analog register, which is then occupied; raise PictureRefused if there is
        none."""

    @abstractmethod
    def checked(self, low: float, high: float) -> None:
        """Raise PictureRefused if a register cannot hold the values from `low` to `high`
        electrons."""

    @abstractmethod
    def filtered(self, value: Held, weights: dict[Offset, Fraction]) -> Held:
        """Emit the words that apply a convolution kernel to a value, and return the register of the
        result.

        `weights` are by offset (columns right, rows down). The value has then been read once.
        Raises PictureRefused if no program fits the chip."""

    @abstractmethod
    def added(self, signed_terms: list[tuple[int, Held]]) -> Held:
        """Emit the words that add values, each with its sign 1 or -1, and return the register of
        the sum.

        The values have then been read once. Raises PictureRefused if the sum does not fit the chip.
        """

    def count_ahead(self, position: int) -> None:
        """Count the item at index `position`, if it is a sum of `agree` and nothing else, together
        with later images; else do nothing.

        Images that are counted together share the shifts of bits. Their number is the one with the
        fewest words an image. Raises PictureRefused if not even one fits the chip."""
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
        """Return an item's sum of `agree`.

        Return None for a plane, for an item that has other terms or no counts, for one counted
        ahead already, and for one that reads something not computed yet."""
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
        """Emit the words of a sum of counts and return the register of the result.

        If the image `now` was counted ahead, only its accumulators are combined. Raises
        PictureRefused if the words do not fit the chip."""
        terms = self.ready.pop(self.now, None)
        if terms is None:
            # "" stands for this image, which need not have a name of its own.
            self._count([("", agreements)], _separate)
            terms = self.ready.pop("")
        factor, first = terms[0]
        assert first.name is not None
        if len(terms) == 1 and abs(factor) == 1 and self.uses[first.name] == 1:
            # The only reader takes the accumulator's register; a factor of -1 is its sign.
            sign = first.sign if factor > 0 else -first.sign
            return replace(self.held.pop(first.name), name=None, sign=sign)
        return self.weighted_sum(terms)

    def weighted_sum(self, terms: Iterable[tuple[Fraction, Held]]) -> Held:
        """Emit the words of a sum of values, each with its factor, and return the register of the
        result.

        Each term is multiplied before the next one is taken from `terms`, which may emit words.
        Raises PictureRefused if the words do not fit the chip."""
        return self.added(
            [
                (1 if factor > 0 else -1, self.filtered(value, {(0, 0): abs(factor)}))
                for factor, value in terms
            ]
        )

    def _count(
        self,
        sums: Sequence[tuple[str, CountSum]],
        directions_of: Callable[[Sequence[Direction], int], list[Direction]],
    ) -> None:
        """Emit the words that count several images at once, and record their accumulators in
        `ready`.

        The words shift the bits of each plane through all offsets and add them. `sums` are pairs
        (name of an image, its sum of counts). `directions_of` gets the weights of all images at
        each place, and the number of images. It returns the factors of each accumulator in the
        images. Raises PictureRefused if registers or their range do not suffice."""
        weights = [total.weights(self.weights) for _, total in sums]
        taps = list(dict.fromkeys(tap for image in weights for tap in image))
        vectors = {at: tuple(image.get(at, Fraction(0)) for image in weights) for at in taps}
        directions = directions_of(list(vectors.values()), len(sums))
        steps = {at: _steps_along(vector, directions) for at, vector in vectors.items()}
        self.everywhere()
        accumulators = []
        for _ in directions:
            register = self.take()
            self.word(op("bus", [register]))  # `_finished` replaces this word
            accumulators.append(Accumulator(register, len(self.words) - 1))
        self.spare = self.take()
        unread = [term.condition for _, total in sums for _, term in total.terms]
        for condition in dict.fromkeys(condition for condition, _ in taps):
            bit = self.bits.bit(condition)
            offsets = {at for plane, at in steps if plane == condition}
            for at, register in self.bits.neighbour_bits(bit[0], offsets):
                for number, factor in steps[condition, at].items():
                    self._add(accumulators[number], register, factor)
            self.bits.give(bit)
            unread.remove(condition)
        # One walk serves all agreements of a plane: what the others would read counts as read.
        for condition in unread:
            self.bits.skip(condition)
        self.everywhere()
        self.give(Held(self.spare, sign=1, low=0.0, high=0.0))
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

    def _finished(self, accumulator: Accumulator, name: str) -> Held:
        """Make the accumulator's first word write its initial value, and return the count as a
        value that is called `name`.

        The value's range is the span of the count. Raises PictureRefused if a register cannot hold
        it."""
        # The word inverts IN, so it writes minus this level. `count_unit` chose the steps of a
        # count so that levels are whole.
        level = -int(accumulator.start * self.pictures.count_steps)
        if level:
            first = self.words[accumulator.first_word][0]
            started = op("bus", first.destinations, ["IN"])
            self.words[accumulator.first_word] = started, level
        high_e = float(accumulator.span) * self.count_e
        self.checked(-high_e, high_e)
        sign, variance = accumulator.sign, accumulator.variance
        return Held(
            accumulator.register, sign, low=-high_e, high=high_e, name=name, variance=variance
        )

    def _add(self, accumulator: Accumulator, bit: str, factor: Fraction) -> None:
        """Emit words that add `factor` (in counts, may be negative) where a bit is 1, and subtract
        it where the bit is 0.

        `bit` is the register of the bit. Depending on the accumulator's sign, twice the factor is
        added where the bit is 1 or where it is 0. The initial value, which is written later,
        corrects the constant difference."""
        level = abs(int(2 * factor * self.pictures.count_steps))
        # The level of IN is positive: it raises the count if the accumulator's sign is 1, else it
        # lowers it.
        to_ones = factor * accumulator.sign > 0
        # One word copies in all pixels, another in those whose bit is 1; one of them adds.
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


def _separate(vectors: Sequence[Direction], images: int) -> list[Direction]:
    """Return an accumulator for each of `images` images, as its factors in all images: 1 in its
    own, else 0.

    `vectors` are ignored; `_shared` needs them."""
    return [_unit(image, images) for image in range(images)]


def _shared(vectors: Sequence[Direction], images: int) -> list[Direction]:
    """Return accumulators that images share, as their factors in each of the `images` images.

    `vectors` has the weights of all images for each place, not all 0. There is an accumulator for
    each ratio (1, 0 or -1) of the images' weights. Images whose weights at a place have different
    sizes get separate accumulators."""
    directions: dict[Direction, None] = {}
    for vector in vectors:
        direction = _normal(vector)[1]
        own = [_unit(image, images) for image, weight in enumerate(vector) if weight]
        alike = all(abs(part) in (0, 1) for part in direction)
        directions |= dict.fromkeys([direction] if alike else own)
    return list(directions)


def _unit(image: int, images: int) -> Direction:
    """Return the factors of an accumulator that serves one of `images` images only: 1 for the one
    with the index `image`, else 0."""
    return tuple(Fraction(number == image) for number in range(images))


def _normal(vector: Direction) -> tuple[Fraction, Direction]:
    """Return the first nonzero number of a vector, and the vector divided by it.

    Raises StopIteration if all numbers are 0."""
    first = next(number for number in vector if number)
    return first, tuple(number / first for number in vector)


def _steps_along(vector: Direction, directions: Sequence[Direction]) -> dict[int, Fraction]:
    """Return how much is added to each accumulator so that the images get the weights `vector`.

    `vector` has a weight for each image, not all 0. `directions` are the accumulators' factors in
    each image; the keys of the result are their indices. If no accumulator has the ratio of the
    weights, there must be one for each image alone."""
    factor, direction = _normal(vector)
    if direction in directions:
        return {directions.index(direction): factor}
    own = ((_unit(image, len(vector)), weight) for image, weight in enumerate(vector) if weight)
    return {directions.index(unit): weight for unit, weight in own}
