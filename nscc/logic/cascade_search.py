"""Search for cascades of cubes that compute a predicate from code planes, from the last gate
backwards.

A value must be 1 at the points `on`, 0 at the points `off` and may be anything elsewhere. Its last
word is an OR or a NOR of cubes (each a NOR of planes, one word in a scratch register), single
planes, and an inner value of the same kind with fewer undecided points, held in FLAG or in a
scratch register. FLAG and scratch registers alternate, and complements are free. A beam search
keeps, for every number of words, the values with the fewest undecided points.

The backward direction yields don't-cares. A value that an OR reads must be 0 where the OR is 0, and
1 where the OR is 1 only because of this value; elsewhere it is free. So every link passes on fewer
points, and a cascade ends when planes and cubes decide all points."""

from __future__ import annotations

from bisect import bisect_right
from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache
from math import log

import numpy as np
from numpy.typing import NDArray

from nscc.arrays import Bools, Floats, Ints
from nscc.logic.cubes import Budget
from nscc.logic.point_sets import Planes, Points, disjoint, gains, sizes
from nscc.logic.problem import Machine
from nscc.truth import set_bits

# Words of 64 points for one step of the budget.
_WORDS_A_STEP = 640
# Steps for numpy's overhead for each batch of values.
_STEPS_A_BATCH = 8
# Words of 64 points in a batch, which fits the cache.
_BATCH = 1 << 18
# Numbers of best cubes to try as the first and as each further one of a link.
_FIRST_CUBES = 8
_NEXT_CUBES = 4


@dataclass(frozen=True)
class Link:
    """One link of a cascade: an OR, or a NOR if `negated`, of its inputs.

    Its value goes to FLAG if `to_flag`, else to a scratch register (for intermediate results).
    `cubes` are bit masks of planes, each computed as a NOR in its own scratch register; `planes`
    are numbers of planes that are read directly. A link that `reads_flag` also reads FLAG as it was
    before the cascade (a chain of gates, each of which reads the one before). Every link except the
    innermost also reads the value of the next link in the list."""

    to_flag: bool
    negated: bool
    cubes: tuple[int, ...]
    planes: tuple[int, ...]
    reads_flag: bool


@dataclass(frozen=True)
class Cascade:
    """The links of a cascade, the last executed link first, and its number of words. A cascade
    without links does not occur: its last word loads FLAG (the bit that lets a pixel act)."""

    links: tuple[Link, ...]
    words: int


# Largest number of points.
MOST_POINTS = 4096

# The estimate of the bits that a value leaves to decide: which of its points are on (log of a
# binomial, from a table of log n!), plus a little for each point and for having points of both
# kinds. The last words decide _LAST_BITS of them, others rarely more than _MOST_BITS_A_WORD. The
# weights are empirical; they only order the beam.
_CHOICES = np.cumsum([0.0, *(log(n, 2) for n in range(1, MOST_POINTS + 1))])
_A_POINT = 0.2
_LAST_BITS = 16.0
_MOST_BITS_A_WORD = 4.0
_A_PAIR = 0.5


@dataclass(frozen=True)
class _Values:
    """The values in a beam: their undecided points, and how each value is reached. All arrays have
    one row for each value.

    `on` and `off`, (n, words of 64 points), are the points at which the value must be 1 and 0; all
    others are free. `task` is the index of the predicate (a set of shutters). `via` is the number
    of the value that reads this value (-1: none, it is the predicate itself), as a source of a NOR
    if `negated`, else of an OR. `cubes` (n, scratch) are masks of the cubes (NORs of registers) of
    the same link, 0 if there are fewer."""

    on: Points
    off: Points
    task: Ints
    via: Ints
    negated: Bools
    cubes: Ints

    def __len__(self) -> int:
        """Return the number of values."""
        return len(self.on)

    def take(self, indices: Ints | Bools) -> _Values:
        """Return some of the values, as copies: by index, in the order of `indices`, or by a mask
        (n,) that is True for those to keep."""
        return _Values(*(array[indices] for array in vars(self).values()))

    def swapped(self) -> _Values:
        """Return the complements of the values."""
        return _Values(self.off, self.on, self.task, self.via, ~self.negated, self.cubes)

    def undecided_bits(self) -> Floats:
        """Return an estimate (n,) of the information, in bits, that is undecided in each value:
        which of its points are 1, and a little for each point. It only orders values."""
        ones, zeros = sizes(self.on), sizes(self.off)
        bits: Floats = _CHOICES[ones + zeros] - _CHOICES[ones] - _CHOICES[zeros]
        return bits + _A_POINT * (ones + zeros) + _A_PAIR * np.minimum(ones, zeros)

    def best(self, width: int) -> _Values:
        """Return for every task the `width` distinct values with the least undecided information;
        all values of a task that has fewer.

        The result is sorted by task, then by undecided information. Equal values of a task count
        once; the first of them stays."""
        undecided = self.undecided_bits()
        # Equal values have equal digests; a collision only loses a value.
        factors = _factors()[: 2 * self.on.shape[1]].reshape(2, -1)
        digest = (self.on * factors[0] + self.off * factors[1]).sum(axis=1, dtype=np.uint64)
        order = np.lexsort((digest, undecided, self.task))
        task, digest = self.task[order], digest[order]
        new = np.ones(len(order), dtype=np.bool_)
        new[1:] = (digest[1:] != digest[:-1]) | (task[1:] != task[:-1])
        order, task = order[new], task[new]
        rank = np.arange(len(order)) - np.searchsorted(task, task)
        return self.take(order[rank < width])

    @staticmethod
    def joined(groups: Sequence[_Values]) -> _Values:
        """Return all rows of one or more groups of values as one group, in order."""
        if len(groups) == 1:
            return groups[0]
        alike = zip(*(vars(group).values() for group in groups), strict=True)
        return _Values(*(np.concatenate(group) for group in alike))


_Way = tuple[int, bool, tuple[int, ...], bool]
"""How a value is reached: the parent value, whether complemented, the link's cubes, and whether it
is in FLAG.

At the end of a cascade, the last item says whether the old FLAG is read."""


class Search:
    """A search for cascades over one set of planes, with `scratch` registers for cubes (NORs of
    registers) and values of links. One search may be used for several predicates (sets of
    shutters), one call of `find` after the other."""

    def __init__(self, planes: Planes, machine: Machine, scratch: int, budget: Budget) -> None:
        """Prepare a search with the cubes (NORs of registers) of `planes`, `scratch` registers for
        intermediate results and a limit on steps.

        `machine` gives the limits on sources; None, for no limit, becomes a number that no gate
        reaches."""
        self._table = planes
        self._scratch = scratch
        self._budget = budget
        self._reads_flag = machine.where_reads_flag
        self._or_limit = machine.or_sources or 1 << 30
        self._where_limit = machine.where_sources or 1 << 30

    def find(
        self,
        on: Points,
        flag_before: Points,
        most_words: Sequence[int],
        width: int,
        most_total: int,
    ) -> list[Cascade | None]:
        """Return for each predicate (a set of shutters) of `on` a cascade that computes it in FLAG,
        or None if the beam found none.

        `on` and `flag_before` are sets of points, uint64 (n, words of 64 points), one row for each
        predicate. Cascade i has at most `most_words[i]` words. FLAG holds `flag_before` before the
        cascade (a chain of gates, each of which reads the one before), the empty set if its content
        is unknown. `width` is the number of values of each predicate that the beam keeps. The
        search ends early when all cascades together are unlikely to have as few as `most_total`
        words; predicates without a cascade so far then have None. Raises GaveUp if the budget is
        used up."""
        count = len(on)
        none = np.zeros(count, dtype=np.int64)
        # One value for each task, with no link yet: `via` is -1, nothing is negated, no cubes.
        start = _Values(
            on,
            self._table.everything & ~on,
            np.arange(count),
            none - 1,
            none > 0,
            np.zeros((count, self._scratch), dtype=np.int64),
        )
        self._recorded: list[tuple[int, _Values, bool]] = []
        self._flag_before = flag_before
        self._ends: list[tuple[int, _Way] | None] = [None] * count
        self._most = np.array(most_words, dtype=np.int64)
        waiting: dict[tuple[int, bool], list[_Values]] = defaultdict(list)
        waiting[0, True].append(start)
        words = 0
        undecided = np.zeros(count)
        while waiting and (self._most > words).any():
            open_still = self._most > words
            finished_words = sum(
                end[0]
                for end, is_open in zip(self._ends, open_still, strict=True)
                if end is not None and not is_open
            )
            # Estimated final words of the open tasks; not a strict bound.
            ahead = words + 1 + np.maximum(undecided - _LAST_BITS, 0) / _MOST_BITS_A_WORD
            if finished_words + float(ahead[open_still].sum()) > most_total:
                break
            undecided = np.full(count, np.inf)
            for in_flag in (True, False):
                groups = waiting.pop((words, in_flag), None)
                if groups is None:
                    continue
                joined = _Values.joined(groups)
                joined = joined.take(open_still[joined.task])
                if len(joined):
                    values = joined.best(width)
                    np.minimum.at(undecided, values.task, values.undecided_bits())
                    values = self._numbered(values, in_flag)
                    # WHERE can only OR; a register can also take a NOR.
                    forms = (values,) if in_flag else (values, values.swapped())
                    for form in forms:
                        for link_words, inner_in_flag, inner in self._links(
                            form, in_flag, words, width
                        ):
                            waiting[words + link_words, inner_in_flag].append(inner)
            undecided[np.isinf(undecided)] = 0.0
            words += 1
        return [self._traced(end, on[i]) for i, end in enumerate(self._ends)]

    def _numbered(self, values: _Values, in_flag: bool) -> _Values:
        """Record the values as starting points of further links, and return them as parents: `via`
        is their own number, and nothing is negated or decided by cubes yet.

        `in_flag` says whether the values are in FLAG (the bit that lets a pixel act). Numbers
        continue after those recorded before. A cube is a NOR of registers."""
        first = 0
        if self._recorded:
            before, last, _ = self._recorded[-1]
            first = before + len(last)
        self._recorded.append((first, values, in_flag))
        via, none = np.arange(first, first + len(values)), np.zeros(len(values), dtype=np.bool_)
        return replace(values, via=via, negated=none, cubes=np.zeros_like(values.cubes))

    def _links(
        self, values: _Values, in_flag: bool, words: int, width: int
    ) -> Iterator[tuple[int, bool, _Values]]:
        """Yield the links (gates of a cascade) that may write `values`, to FLAG if `in_flag`, else
        to a scratch register, as (words of the link, whether its inner value is in FLAG, inner
        values).

        An inner value is what the link before must compute; it lacks the points that the link's
        planes and cubes decide. `words` is the number of words of later links, and `width` the
        number of values that the beam keeps. Values without undecided points are recorded as ends
        of cascades. Raises GaveUp if no steps are left. A cube is a NOR of registers. A scratch
        register holds an intermediate result."""
        scratch = self._scratch
        most = self._most_cubes(in_flag)
        # First links without cubes, which read planes only.
        alone = self._without_planes(values, self._room(in_flag, cubes=False, inner=False))
        self._finish(alone, in_flag, words + 1, inner=False)
        alone = self._without_planes(values, self._room(in_flag, cubes=False, inner=True))
        self._finish(alone, in_flag, words + 1, inner=True)
        yield 1, not in_flag, alone
        # Values by the number of cubes and their words; each round adds a cube.
        grown: dict[tuple[int, int], list[_Values]] = defaultdict(list)
        grown[0, 0].append(
            self._without_planes(values, self._room(in_flag, cubes=True, inner=True))
        )
        for used in range(most + 1):
            for spent in sorted(s for u, s in grown if u == used):
                current = _Values.joined(grown.pop((used, spent)))
                if used:
                    current = current.best(2 * width)
                # If every scratch register holds a cube, the link is in place, which takes one more
                # word.
                link_words = spent + 1 + (not in_flag and used == scratch)
                if used:
                    self._finish(current, in_flag, words + link_words, inner=False)
                    if not in_flag or used < self._where_limit:
                        self._finish(current, in_flag, words + link_words, inner=True)
                    if not in_flag:
                        yield link_words, True, current
                    else:
                        if used < scratch and used < self._where_limit:
                            yield link_words, False, current
                        if self._reads_flag and used < self._where_limit:
                            yield link_words, True, current
                if used < most:
                    for price, wider in self._with_cube(current, used):
                        grown[used + 1, spent + price].append(wider)

    def _most_cubes(self, to_flag: bool) -> int:
        """Return the most cubes (NORs of registers) in one link; a link to a scratch register (for
        intermediate results) can be in place."""
        return min(self._scratch, self._where_limit if to_flag else self._or_limit - 1)

    def _room(self, to_flag: bool, *, cubes: bool, inner: bool) -> int:
        """Return the number of planes (contents of code registers) that a link can read besides its
        cubes (NORs of registers) and its inner value; 0 or more.

        `to_flag`: the link is a WHERE. `cubes`: sources are reserved for as many cubes as a link
        may have. `inner`: a WHERE without cubes reserves a source for the inner value; all other
        links always do."""
        if not to_flag:
            return self._or_limit - 1 - (self._most_cubes(to_flag) if cubes else 0)
        if not cubes:
            return self._where_limit - inner
        # An inner value in a scratch register takes the source of a cube, which needs a register
        # too; one in FLAG is one more source.
        return max(0, self._where_limit - self._most_cubes(to_flag) - self._reads_flag)

    def _without_planes(self, values: _Values, room: int) -> _Values:
        """Return the values without the points of `on` that at most `room` single planes decide;
        unchanged if `room` is 0 or less.

        Only planes (contents of code registers) that are 0 on all of `off` may be read. They are
        chosen greedily, most newly decided points first."""
        planes = self._table.planes
        if room <= 0:
            return values
        self._budget.spend(_STEPS_A_BATCH)
        # A plane that avoids `off` can be a source of the OR, which costs only its place.
        pure = disjoint(planes[None], values.off[:, None])
        on = values.on
        if room >= len(planes):
            read = np.where(pure[..., None], planes[None], np.uint64(0))
            on = on & ~np.bitwise_or.reduce(read, axis=1)
        else:
            value_numbers = np.arange(len(on))
            for _ in range(room):
                gain = np.where(pure, sizes(planes[None] & on[:, None]), 0)
                choice = gain.argmax(axis=1)
                useful = (gain[value_numbers, choice] > 0)[:, None]
                on = np.where(useful, on & ~planes[choice], on)
        return replace(values, on=on)

    def _with_cube(self, values: _Values, used: int) -> Iterator[tuple[int, _Values]]:
        """Yield (words of the cube, values after one more cube) for the cubes that decide most
        points of each value, at most _FIRST_CUBES or _NEXT_CUBES of each price.

        A cube (a NOR of registers) must be 0 on `off` and decide at least one point. `used` is the
        number of cubes that the link already has. Raises GaveUp if no steps are left."""
        top = _FIRST_CUBES if used == 0 else _NEXT_CUBES
        for price, cubes, masks in self._table.groups:
            batch = max(1, _BATCH // cubes.size)
            for start in range(0, len(values), batch):
                batch_values = values.take(np.arange(start, min(len(values), start + batch)))
                self._budget.spend(_STEPS_A_BATCH + len(batch_values) * cubes.size // _WORDS_A_STEP)
                gain = gains(cubes, batch_values.on, batch_values.off)
                found: list[Ints] = []
                # `argmax` takes the first of equal cubes; a cube that is taken gains no more.
                for _ in range(min(top, len(cubes))):
                    best = gain.argmax(axis=1)
                    rows = np.flatnonzero(gain[np.arange(len(best)), best])
                    found.append(rows * len(cubes) + best[rows])
                    gain[rows, best[rows]] = 0
                rows, chosen = np.divmod(np.sort(np.concatenate(found)), len(cubes))
                if len(rows):
                    wider = batch_values.take(rows)
                    wider.cubes[:, used] = masks[chosen]
                    yield price, replace(wider, on=wider.on & ~cubes[chosen])

    def _finish(self, values: _Values, in_flag: bool, words: int, *, inner: bool) -> None:
        """Record, for every task, the first value without undecided points as the end of its
        cascade of `words` words, unless a cascade as short is known.

        With `inner`, the content of FLAG (the bit that lets a pixel act) before the cascade is also
        read and may decide points. `in_flag` says whether the link writes FLAG."""
        undecided = values.on
        if inner:
            if in_flag and not self._reads_flag:
                return
            flag_before = self._flag_before[values.task]
            pure = disjoint(flag_before, values.off)
            undecided = np.where(pure[:, None], undecided & ~flag_before, undecided)
        decided = np.flatnonzero(~undecided.any(axis=1) & (self._most[values.task] >= words))
        for i, task in zip(decided.tolist(), values.task[decided].tolist(), strict=True):
            if words <= self._most[task]:
                cubes = tuple(c for c in values.cubes[i].tolist() if c)
                way = (int(values.via[i]), bool(values.negated[i]), cubes, inner)
                self._ends[task] = (words, way)
                self._most[task] = words - 1

    def _traced(self, end: tuple[int, _Way] | None, on: Points) -> Cascade | None:
        """Return the cascade whose end, (words, way), was found for the predicate `on`, with the
        planes (contents of code registers) that each link reads; None if `end` is None.

        `on`, uint64 (W,), has one bit for each point (shutters that no demand tells apart). The
        links are the last executed first. A predicate is a set of shutters."""
        if end is None:
            return None
        words, way = end
        ways = [way]
        while (way := self._way(way[0]))[0] >= 0:
            ways.append(way)
        off = self._table.everything & ~on
        links = []
        for i, (via, negated, cubes, reads_flag) in reversed(list(enumerate(ways))):
            to_flag = self._way(via)[3]
            # The last member of `ways[0]` says that the old FLAG is read; of other ways, that the
            # value is in FLAG.
            reads_flag = reads_flag and i == 0
            if negated:
                on, off = off, on
            room = self._room(to_flag, cubes=bool(cubes), inner=reads_flag or i > 0)
            planes, on = self._read(on, off, cubes, room)
            links.append(Link(to_flag, negated, cubes, planes, reads_flag))
        return Cascade(tuple(links), words)

    def _way(self, number: int) -> _Way:
        """Return how the recorded value with this number was made: from which value (-1: it is a
        predicate), negated or not, with which cubes (NORs of registers), and whether it is in FLAG.
        A predicate is a set of shutters."""
        at = bisect_right(self._recorded, number, key=lambda entry: entry[0]) - 1
        first, values, in_flag = self._recorded[at]
        i = number - first
        cubes = tuple(c for c in values.cubes[i].tolist() if c)
        return int(values.via[i]), bool(values.negated[i]), cubes, in_flag

    def _read(
        self, on: Points, off: Points, cubes: tuple[int, ...], room: int
    ) -> tuple[tuple[int, ...], Points]:
        """Return the numbers, ascending, of the planes that a link reads besides its cubes (NORs of
        registers), and the points of `on` left undecided.

        A link is one gate of the cascade (a chain of gates, each of which reads the one before).
        `on` and `off` are the sets of points at which it must be 1 and 0; `cubes` are masks of
        planes. At most `room` planes are read, chosen greedily; one that decides no point besides
        the cubes and earlier planes is left out."""
        target = on
        table = self._table.planes
        pure = disjoint(table, off[None])
        picked: list[int] = []
        for _ in range(min(room, len(table))):
            gain = np.where(pure, sizes(table & on), 0)
            choice = int(gain.argmax())
            if gain[choice] == 0:
                break
            picked.append(choice)
            on = on & ~table[choice]
        covered = np.zeros_like(on)
        for mask in cubes:
            read = table[list(set_bits(mask))]
            covered |= self._table.everything & ~np.bitwise_or.reduce(read, axis=0)
        planes = []
        for choice in picked:
            if (table[choice] & target & ~covered).any():
                planes.append(choice)
                covered |= table[choice]
        return tuple(sorted(planes)), target & ~covered


@cache
def _factors() -> NDArray[np.uint64]:
    """Return odd numbers for hashing, two for each word of the largest set.

    They are computed on first use, because importing numpy.random is slow."""
    numbers = np.random.default_rng(0).integers(1 << 63, size=128, dtype=np.uint64)
    return numbers * 2 + 1
