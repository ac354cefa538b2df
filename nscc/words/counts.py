"""Value ranges of counts, and the steps of IN that represent one count."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import floor, gcd, lcm

from nscc.chips.target import Target
from nscc.record import Record
from nscc.words import pictures as p


class CountRange(Record):
    """The values that a count can have: some of `low`, `low` + `stride`, `low` + 2 `stride`, ..,
    `high`.

    If `stride` is 0, the only value is `low`."""

    low: Fraction
    high: Fraction
    stride: Fraction

    @property
    def peak(self) -> Fraction:
        """The largest absolute value."""
        return max(-self.low, self.high)

    def half_way(self, level: Fraction, *, or_equal: bool) -> Fraction | None:
        """Return the level half-way between the lowest count above `level` and the next lower one.

        With `or_equal`, a count equal to `level` belongs to the upper counts. Return None if all
        counts are on the same side, as always with one value."""
        strides = (level - self.low) / self.stride if self.stride else Fraction(0)
        below = floor(strides)
        if or_equal and strides == below:
            below -= 1
        split = self.low + (below + Fraction(1, 2)) * self.stride
        return split if self.low < split < self.high else None


def counts_of(
    node: p.Value, known: Mapping[str, CountRange], weights: Mapping[str, p.Weights]
) -> CountRange | None:
    """Return the values that the image `node` can have if it is a count (an image of integers);
    None if it is in electrons.

    A sum of counts and electrons counts as in electrons. `known` has the ranges of the counts
    computed before, `weights` the convolution kernels, both by name."""
    match node:
        case p.Source():
            return known.get(node.name)
        case p.Agreement():
            number = len(weights[node.kernel].taps)
            # Each neighbour adds +1 or -1, so the sum changes in steps of 2.
            return CountRange(Fraction(-number), Fraction(number), Fraction(2))
        case p.Sum():
            return _total([(f, counts_of(value, known, weights)) for f, value in node.terms])
        case p.Filtered():
            inner = counts_of(node.value, known, weights)
            return _total([(weight, inner) for weight in weights[node.kernel].taps.values()])
        case p.Largest() | p.Shifted():
            return counts_of(node.value, known, weights)
        case p.Absolute():
            inner = counts_of(node.value, known, weights)
            if inner is None:
                return None
            # Values differ by multiples of the stride, a value and a negated one by these plus
            # or minus 2 `low`.
            stride = _common(inner.stride, 2 * inner.low)
            least = min(abs(inner.low), abs(inner.high))
            if inner.low <= 0 <= inner.high:  # the least value that is a whole number of steps away
                least = -inner.low % stride if stride else abs(inner.low)
            return CountRange(least, inner.peak, stride)
        case p.Chosen() | p.Larger():
            values = [value for value in p.operands(node) if not isinstance(value, p.Condition)]
            both = [counts_of(value, known, weights) for value in values]
            first, second = both
            if first is None or second is None:
                return None
            low, high = min(first.low, second.low), max(first.high, second.high)
            # All values of both counts must be whole steps apart.
            return CountRange(
                low, high, _common(first.stride, second.stride, first.low - second.low)
            )
    return None


def _total(terms: list[tuple[Fraction, CountRange | None]]) -> CountRange | None:
    """Return the range of a sum, whose `terms` are pairs (factor, range of a count or None).

    Return None if a term is not a count or there are no terms."""
    low, high, strides = Fraction(0), Fraction(0), []
    for factor, counts in terms:
        if counts is None:
            return None
        ends = factor * counts.low, factor * counts.high
        low, high = low + min(ends), high + max(ends)
        strides.append(factor * counts.stride)
    return CountRange(low, high, _common(*strides)) if terms else None


def _common(*numbers: Fraction) -> Fraction:
    """Return the greatest common divisor of fractions: the largest one of which all are integer
    multiples; 0 if all are 0."""
    divisor = lcm(*(number.denominator for number in numbers))
    return Fraction(gcd(*(int(number * divisor) for number in numbers)), divisor)


def counts_by_name(pictures: p.Pictures) -> dict[str, CountRange]:
    """Return the ranges of the images that are counts, by name; planes and images in electrons are
    left out."""
    known: dict[str, CountRange] = {}
    for item in pictures.items:
        if not isinstance(item.node, p.Condition):
            counts = counts_of(item.node, known, pictures.weights_by_name)
            if counts is not None:
                known[item.name] = counts
    return known


class CountUnit(Record):
    """How many steps of IN (the value that all pixels receive) represent a count of 1.

    `steps` is the largest multiple of `least` with which the largest count, `peak`, fits into
    `steps_available`; 0 if even `least` is too large. `name` is the image or plane in which `peak`
    occurs."""

    steps: int
    steps_available: int
    least: int
    peak: Fraction
    name: str


def count_unit(pictures: p.Pictures, target: Target) -> CountUnit | None:
    """Return how the counts of the images `pictures` are represented on `target`; None for a
    program without counts.

    The largest count must fit the registers and IN (the level sent to all pixels), and levels and
    factors must be whole steps. If the counts do not fit, `steps` of the result is 0."""
    known, weights = counts_by_name(pictures), pictures.weights_by_name
    # The largest count with the item in which it occurs, and the fewest steps of IN for a count.
    peak, name, least = Fraction(0), "", 1
    for item, expression in pictures.expressions.items():
        for node in p.subexpressions(expression):
            if isinstance(node, p.Exceeds):
                least = lcm(least, node.level.denominator)
            terms = node.terms if isinstance(node, p.Sum) else ((Fraction(1), node),)
            factors = [factor for factor, term in terms if isinstance(term, p.Agreement)]
            if factors:  # one word adds twice all factors of a bit
                least = lcm(least, *(factor.denominator for factor in factors))
                peak, name = max((peak, name), (2 * sum(map(abs, factors), Fraction(0)), item))
            if not isinstance(node, p.Condition):
                counts = counts_of(node, known, weights)
                if counts is not None:
                    peak, name = max((peak, name), (counts.peak, item))
    if not name:
        return None
    full_e = min(target.register_max_e, -target.register_min_e)
    most = min(target.in_high, -target.in_low, floor(full_e / target.electrons_per_step))
    return CountUnit(floor(most / peak) // least * least, most, least, peak, name)
