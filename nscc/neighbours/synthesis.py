"""Find short programs for a kernel: rotate, mirror, chain and add programs of a table.

The search is deterministic and limited to a number of steps. For each part of a kernel it keeps the
shortest programs; it keeps a longer program only if its intermediate values are smaller."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from fractions import Fraction
from functools import cached_property, lru_cache
from math import gcd, inf

from nscc.cache.digest import digest, package_digest
from nscc.cache.results import Results
from nscc.neighbours.addition import additions, halvings_of
from nscc.neighbours.digit_planes import digit_plane_programs
from nscc.neighbours.factors import Key, box_of, quotients, rows
from nscc.neighbours.held import PictureRefused
from nscc.neighbours.programs import (
    IDENTITY,
    UNIT,
    BusWord,
    Polynomial,
    Program,
    Taps,
    added,
    chained,
    kernel_of,
    renamed,
    values_of,
)
from nscc.neighbours.table import WordForms
from nscc.operations import NEIGHBOURS
from nscc.record import Record

STEPS_OF_LEVEL = (100, 400, 2_500, 20_000)
"""Number of kernels that a search may decompose, by level of optimisation."""
_MOST_KEPT = 6
"""Most programs kept for each part of a convolution kernel."""
_MOST_DEPTH = 7
"""Most nested decompositions of a convolution kernel."""
_MOST_SOURCES, _MOST_HALVED = 4, 2
"""Most sources of a word, and of a word that halves."""
_MOST_ADDED = 20
"""Most weights of a kernel for which orders of adding neighbours one by one are searched."""

_BEAM_OF_PARTS = 20
"""Number of partial orders that the addition of a part's neighbours keeps after each word."""
_LEAST_WOVEN = 5
"""Least number of weights of a kernel for which a search weaves the pixel's own multiple in."""

_NEWS = {"NEWS", *NEIGHBOURS}
"""NEWS of the pixel itself, and of each neighbour."""
_HALVE: Program = (BusWord(("h", "NEWS"), ("x",)),)
"""The program of minus half the input: a second destination makes a word halve."""
_NEGATE: Program = (BusWord(("m",), ("x",)),)


class Ranged(Record):
    """A program and, computed when first used, the largest gain of its intermediate values
    (`peak`)."""

    program: Program

    @cached_property
    def peak(self) -> int:
        """The largest sum of the positive weights, or of the negative ones with their sign
        inverted, of any value that a word writes.

        It is at least 1, in units of 1 / UNIT."""
        return max((UNIT, *(max(pair) for pair in self.weights)))

    @cached_property
    def weights(self) -> set[tuple[int, int]]:
        """The sums (of the positive weights, of the negative ones with their sign inverted) of each
        value that a word writes, in units of 1 / UNIT."""
        return {_weights_by_sign(taps) for taps in values_of(self.program)}


def _names(values: list[object]) -> tuple[str, ...]:
    """Return values as text, because names of registers in a damaged cache may be of any type."""
    return tuple(map(str, values))


class Synthesis:
    """Finds programs for convolution kernels; decomposes at most `most_steps` kernels for each.

    Each request takes 1 from `budget`, and so does each decomposition; it is infinite unless it is
    set. Programs that an earlier compilation found come from the cache `results`."""

    def __init__(self, steps: int, forms: WordForms, results: Results | None = None) -> None:
        """Prepare to search; at most `steps` kernels are decomposed for each convolution kernel.

        `forms` are the words that the chip allows; `results` is the cache of earlier searches, None
        without one."""
        self.most_steps, self.forms, self.results = steps, forms, results
        self.steps: float = 0
        self.budget = inf
        self._known: dict[Key, tuple[int, list[Ranged]]] = {}
        self._variants: dict[Key, list[Ranged]] = {}

    def variants(self, taps: Taps) -> list[Ranged]:
        """Return programs for a convolution kernel, the shortest first; each is proved to compute
        it.

        `taps` are the nonzero weights by offset, in units of 1 / UNIT, at least one. There is at
        least one program. Raises PictureRefused ("steps") if the budget of all searches is used up.
        """
        self.budget -= 1
        if self.budget < 0:
            raise PictureRefused("steps", "", needed=1, available=0)
        key = frozenset(taps.items())
        if key not in self._variants:
            # The kernel and its inverse share a search, which no other kernel affects.
            kernels = sorted(
                [dict(taps), added((-1, taps))], key=lambda kernel: sorted(kernel.items())
            )
            for kernel, programs in zip(kernels, self._stored(kernels), strict=True):
                variants = [Ranged(program) for program in sorted(programs, key=len)]
                self._variants[frozenset(kernel.items())] = variants
        return self._variants[key]

    def _stored(self, kernels: list[Polynomial]) -> list[list[Program]]:
        """Return the programs of each convolution kernel from the cache; else search for them and
        store them.

        The programs of all `kernels` are stored together, in their order. Cached programs are
        checked by running them; if one is wrong or cannot be read, all are searched for again. So a
        damaged cache cannot give a wrong program."""
        import json

        items = [sorted(taps.items()) for taps in kernels]
        key = digest((package_digest("nscc.neighbours"), items, self.most_steps, self.forms))
        data = self.results.entry(key) if self.results else None
        with suppress(LookupError, RecursionError, TypeError, ValueError):
            stored = [
                [tuple(BusWord(*map(_names, word)) for word in program) for program in programs]
                for programs in json.loads(data or b"[]")
            ]
            pairs = zip(kernels, stored, strict=True)
            if all(p and all(self._right(program, taps) for program in p) for taps, p in pairs):
                if self.results:
                    self.results.read += 1
                return stored
        self._known.clear()
        proved = [self._proved(taps) for taps in kernels]
        if self.results:
            self.results.store.write(key, json.dumps(proved).encode())
        return proved

    def _proved(self, taps: Taps) -> list[Program]:
        """Return all programs found for a convolution kernel, each checked by running it on exact
        polynomials.

        `taps` are the weights by offset, in units of 1 / UNIT. Decompositions take from the budget.
        """
        self.steps = allowed = min(self.most_steps, self.budget)
        candidates = [ranged.program for ranged in self._programs(dict(taps), _MOST_DEPTH)]
        self.budget -= allowed - self.steps
        if not self.forms.news_keeps:
            candidates = list(filter(reads_news_once, candidates))
        if len(taps) <= _MOST_ADDED:
            candidates += additions(taps, self.forms)
        candidates += digit_plane_programs(taps, self.forms)
        candidates += self._digit_planes_of_lines(taps)
        assert all(self._right(program, dict(taps)) for program in candidates)
        return candidates

    def _digit_planes_of_lines(self, taps: Taps) -> Iterator[Program]:
        """Yield programs that apply the digit planes of a row, then those of a column, if their
        product is the convolution kernel `taps`; they need five or four registers."""
        chains = []
        for lines in separated(taps):
            found = [digit_plane_programs(line, self.forms) for line in lines]
            both = min(map(len, found))
            pairs = zip(*(programs[:both] for programs in found), strict=True)
            chains.append([chained(*pair) for pair in pairs])
        for number in (0, 1):  # with five registers, then with four
            programs = [Ranged(program) for chain in chains for program in chain[number::2]]
            yield from (ranged.program for ranged in _best(programs, _peak(taps)))

    def _right(self, program: Program, taps: Polynomial) -> bool:
        """Return whether a program computes the convolution kernel `taps`, by words that the chip
        has."""
        return kernel_of(program) == taps and all(map(self.forms.allow, program))

    def _programs(self, taps: Polynomial, depth: int) -> list[Ranged]:
        """Return the best known programs for a convolution kernel, by at most `depth` nested
        decompositions, the shortest first.

        A search spends one step. Without steps or depth left, return what is known, possibly [].
        Longer programs are kept only if their values are smaller."""
        key = frozenset(taps.items())
        if taps == IDENTITY:
            return [Ranged(())]
        at_depth, known = self._known.get(key, (0, []))
        if at_depth >= depth:
            return known
        if self.steps <= 0 or depth <= 0:
            return known
        self.steps -= 1
        self._known[key] = depth, known
        candidates = [
            Ranged(self.forms.allowed(program)) for program in self._candidates(taps, key, depth)
        ]
        best = _best([*known, *candidates], _peak(taps))
        self._known[key] = depth, best
        return best

    def _candidates(self, taps: Polynomial, key: Key, depth: int) -> Iterator[Program]:
        """Yield programs for a convolution kernel, not yet checked for words that the chip allows.

        `key` are the items of `taps` as a frozenset; `depth` is the number of nested decompositions
        that are left. The programs come from the table, or from smaller kernels: halved, separated
        in rows and columns, as a product, or with the centre added."""
        if key in rows(self.forms):
            yield rows(self.forms)[key]
        if taps == {(0, 0): -UNIT}:
            yield _NEGATE
            return
        if halvings_of(taps):
            # A halving word also inverts. It comes first, last, or is part of the last word.
            doubled = added((-2, taps))
            for remaining in self._programs(doubled, depth - 1):
                yield chained(_HALVE, remaining.program)
                if remaining.program:
                    yield chained(remaining.program, _HALVE)
            for remaining in self._programs(added((2, taps)), depth - 1):
                yield from _with_last_halved(remaining.program)
        for row, column in separated(taps):
            for first in self._programs_of_part(row, depth - 1):
                for second in self._programs_of_part(column, depth - 1):
                    yield chained(first, second)
            for line, across in ((row, column), (column, row)):
                # The last word of this program is left out, which inverts its result: hence the
                # negated line.
                first = rows(self.forms).get(frozenset(added((-1, line)).items()), ())
                for second in self._programs_of_part(across, depth - 1):
                    yield from _joined(first, second)
        for factor, quotient in quotients(taps, self.forms):
            for remaining in self._programs(quotient, depth - 1):
                yield chained(factor.program, remaining.program)
        yield from self._with_centre(added((-1, taps)), depth)
        yield from self._with_centre_woven_in(taps, depth)

    def _programs_of_part(self, taps: Polynomial, depth: int) -> list[Program]:
        """Return programs for a part of a convolution kernel, by at most `depth` nested
        decompositions.

        There is always one: if the search finds none, a program adds neighbour after neighbour."""
        found = [ranged.program for ranged in self._programs(taps, depth)]
        return found or [_addition(frozenset(taps.items()), self.forms)]

    def _with_centre(self, inverse: Polynomial, depth: int) -> Iterator[Program]:
        """Yield programs whose last word adds a multiple of the pixel itself; none if the kernel
        has fewer than two weights or no weight of the pixel itself.

        `inverse` is the negated convolution kernel, which the sources of the last word add up to.
        `depth` is the number of nested decompositions that are left."""
        if len(inverse) < 2:
            return
        middle = inverse.get((0, 0), 0)
        centre_weights: set[int] = set()
        if middle:
            least = min(map(abs, inverse.values()))
            # Multiples that may leave a simpler kernel: small ones and, below, those after which
            # the pixel's own weight is 0 or equals another weight.
            centre_weights = {UNIT, least, 2 * least, -least, -2 * least}
            centre_weights |= {middle - weight for weight in (0, *inverse.values())}
        for centre_weight in sorted(centre_weights - {0}):
            centre_only: Taps = {(0, 0): centre_weight}
            remainder = added((1, inverse), (-1, centre_only))
            # Only a smaller weight of the pixel itself makes the remaining kernel simpler.
            if remainder and abs(remainder.get((0, 0), 0)) < abs(middle):
                seconds = self._programs_of_part(dict(centre_only), depth - 2)
                for first in self._programs(remainder, depth - 2):
                    for second in seconds:
                        yield _summed(first.program, second)

    def _with_centre_woven_in(self, taps: Polynomial, depth: int) -> Iterator[Program]:
        """Yield programs of the neighbours in which several words also add a multiple of the pixel
        itself; none if its weight is 0, or the kernel has fewer than `_LEAST_WOVEN` weights.

        Words that read a neighbour may have room for one more source. `depth` is the number of
        nested decompositions that are left."""
        middle = taps.get((0, 0), 0)
        if not middle or len(taps) < _LEAST_WOVEN:
            return
        around = {at: weight for at, weight in taps.items() if at != (0, 0)}
        for first in self._programs(around, depth - 2):
            word_indices = _words_to_extend(first.program, self.forms.sources)
            for count in range(1, len(word_indices) + 1):
                if middle % count == 0:
                    for second in self._programs_of_part({(0, 0): middle // count}, depth - 2):
                        yield _woven(first.program, second, word_indices[:count])


@lru_cache(maxsize=1 << 12)
def _addition(key: Key, forms: WordForms) -> Program:
    """Return the shortest program that adds one neighbour after another.

    `key` has pairs (offset, nonzero weight in units of 1 / UNIT), at least one. `forms` are the
    words that the chip allows."""
    return additions(dict(key), forms, beam=_BEAM_OF_PARTS)[0]


def separated(taps: Taps) -> Iterator[tuple[Polynomial, Polynomial]]:
    """Yield pairs of a row and a column kernel whose product is the convolution kernel `taps`.

    All are weights by offset, in units of 1 / UNIT. The halvings are in the column, divided between
    both, in the row, or such that the row has no gain. Yield nothing if `taps` is not a product, or
    has only one row or one column."""
    (left, top), size = box_of(taps)
    if 0 in size:
        return
    corner = taps.get((left, top))
    if not corner:
        return
    top_row = {x: weight for (x, y), weight in taps.items() if y == top}
    left_column = {y: weight for (x, y), weight in taps.items() if x == left}
    common = gcd(*top_row.values())
    # A kernel is a product if its weights times the corner's are those of its first row and column.
    outer = {(x, y): a * b for x, a in top_row.items() for y, b in left_column.items()}
    if outer != {at: weight * corner for at, weight in taps.items()}:
        return
    halvings = halvings_of(taps)
    in_row_alone = (sum(map(abs, top_row.values())) // common - 1).bit_length()
    for in_row in sorted({0, halvings // 2, min(in_row_alone, halvings), halvings}):
        scale = 2**in_row * common
        if all(weight * scale % corner == 0 for weight in left_column.values()):
            yield (
                {(x, 0): weight * UNIT // scale for x, weight in top_row.items()},
                {(0, y): weight * scale // corner for y, weight in left_column.items()},
            )


def _with_last_halved(program: Program) -> Iterator[Program]:
    """Yield the program whose last word also halves the result.

    Yield nothing for an empty program, or if the last word halves already or has more than
    `_MOST_HALVED` sources."""
    if program and not program[-1].halves and len(program[-1].sources) <= _MOST_HALVED:
        last = program[-1]
        # A second destination, which nothing reads, makes the word halve.
        yield (*program[:-1], BusWord((*last.destinations, "h_"), last.sources))


def _joined(first: Program, second: Program) -> Iterator[Program]:
    """Yield the program that applies `second` to the negated result of `first`, if it needs no
    further word; else nothing.

    The last word of `first` is left out: its sources replace the input of `second`. That is
    impossible if it halves or reads NEWS or a neighbour, or if a word would have too many sources.
    """
    if not first or first[-1].halves or not _NEWS.isdisjoint(first[-1].sources):
        return
    # Registers get different prefixes, so that the two programs do not share any but the input x.
    words = [*renamed(first[:-1], {"x": "x"}, prefix="a")]
    inputs = renamed(first[-1:], {"x": "x"}, prefix="a")[0].sources
    for word in renamed(second, {"x": "x"}, prefix="b"):
        sources = tuple(
            name for source in word.sources for name in (inputs if source == "x" else (source,))
        )
        if len(sources) > (_MOST_HALVED if word.halves else _MOST_SOURCES):
            return
        words.append(BusWord(word.destinations, sources))
    yield tuple(words)


def _summed(first: Program, second: Program) -> Program:
    """Return both programs, followed by a word that writes minus the sum of their results.

    An empty program gives the input itself."""
    a, b = renamed(first, {"x": "x"}, "a"), renamed(second, {"x": "x"}, "b")
    results = [program[-1].destinations[0] if program else "x" for program in (a, b)]
    return (*a, *b, BusWord(("s",), tuple(results)))


def _words_to_extend(program: Program, directed_sources: int) -> list[int]:
    """Return the indices of words that can add one more source, and whose results only the last
    word reads, once.

    `directed_sources` is the most sources of a word that reads a neighbour. Words that write NEWS
    (the register that neighbours can read) are left out: it is written several times, and
    neighbours read it. Nor can a word add a source if it or the last word halves."""
    read = [name for word in program for name in word.sources]
    return [
        number
        for number, word in enumerate(program[:-1])
        if not (word.halves or program[-1].halves)
        and word.destinations[0] not in _NEWS
        and word.destinations[0] in program[-1].sources
        and read.count(word.destinations[0]) == 1
        and len(word.sources)
        < (directed_sources if NEIGHBOURS.keys() & word.sources else _MOST_SOURCES)
    ]


def _woven(first: Program, second: Program, word_indices: list[int]) -> Program:
    """Return the words of `second`, then those of `first`, where the words of `first` with the
    indices `word_indices` also add the result of `second`.

    An empty `second` gives the input itself."""
    # Registers get different prefixes, so that the two programs do not share any but the input x.
    first = renamed(first, {"x": "x"}, prefix="a")
    second = renamed(second, {"x": "x"}, prefix="b")
    result = second[-1].destinations[0] if second else "x"
    words = [
        BusWord(word.destinations, (*word.sources, result)) if number in word_indices else word
        for number, word in enumerate(first)
    ]
    return (*second, *words)


# --- choosing -------------------------------------------------------------------------------------


def _peak(taps: Taps) -> int:
    """Return the sum of the positive or of the negative weights of a convolution kernel, whichever
    is larger.

    It is at least 1, and in units of 1 / UNIT."""
    return max(UNIT, *_weights_by_sign(taps))


def gains(taps: Taps) -> tuple[Fraction, Fraction]:
    """Return the sum of the positive weights of a convolution kernel, and that of the negative ones
    with their sign inverted.

    `taps` are in units of 1 / UNIT; the results are in units of 1."""
    added_weight, subtracted = _weights_by_sign(taps)
    return Fraction(added_weight, UNIT), Fraction(subtracted, UNIT)


def _weights_by_sign(taps: Taps) -> tuple[int, int]:
    """Return the sum of the positive weights, and that of the negative ones with their sign
    inverted, both at least 0, in the units of `taps`."""
    total = sum(taps.values())
    added_weight = sum(weight for weight in taps.values() if weight > 0)
    return added_weight, added_weight - total


def _best(candidates: list[Ranged], least_peak: int) -> list[Ranged]:
    """Return the shortest of `candidates`, and longer ones that each have a smaller peak (largest
    gain of a value) than all shorter ones, at most `_MOST_KEPT`.

    Of equally long programs, the one with the smallest peak counts. No program has a peak below
    `least_peak`, so none is sought after that. Without candidates, return []."""
    best: list[Ranged] = []
    for candidate in sorted(candidates, key=lambda candidate: len(candidate.program)):
        if best and best[-1].peak == least_peak:
            break
        if not best or candidate.peak < best[-1].peak:
            # An equally long program with a smaller peak replaces the other.
            if best and len(candidate.program) == len(best[-1].program):
                best.pop()
            best.append(candidate)
    return best[:_MOST_KEPT]


def reads_news_once(program: Program) -> bool:
    """Return whether NEWS (the register that neighbours can read) is written between each word that
    reads a neighbour and the next word that reads NEWS, its own or a neighbour's.

    Chips whose NEWS loses its value when a neighbour reads it need this."""
    is_read = False
    for word in program:
        reads = NEIGHBOURS.keys() & word.sources
        if is_read and (reads or "NEWS" in word.sources):
            return False
        is_read = is_read or bool(reads)
        if "NEWS" in word.destinations or NEIGHBOURS.keys() & word.destinations:
            is_read = False
    return True
