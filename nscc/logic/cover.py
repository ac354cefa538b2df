"""Covers of a predicate: an OR of NORs (cubes) over values in registers.

This is two-level logic minimisation: find prime cubes (Quine and McCluskey), then the cheapest
choice of them (Petrick). It differs in two points. A cube can read only values that are in
registers, not their inverses. The cost of a cube is shared by all demands that use it.

NOR(A) is 1 where every value of A is 0. So the cube lies inside a predicate if the values of A
cover all shutters outside of it. A cube costs one word. If it lies inside later predicates, too, it
may stay in its register, and these demands share its word."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from nscc.logic.cubes import Budget
from nscc.logic.problem import words_of
from nscc.truth import union


class Nor(NamedTuple):
    """A cube NOR(sources): its truth vector, and `life`, the number of consecutive demands, from
    the present one on, inside which it lies (at least 1).

    `sources` are indices of the values that it reads. `words` is its cost, more than one if it has
    more sources than one word accepts. A demand is a set of shutters that FLAG must select at a
    boundary. A truth vector is an integer with one bit for each shutter."""

    sources: tuple[int, ...]
    vector: int
    life: int
    words: int

    @property
    def cost(self) -> float:
        """The number of words per served demand (a set of shutters that FLAG must select at a
        boundary). FLAG is the bit that lets a pixel act."""
        return self.words / self.life


class Cover(NamedTuple):
    """A cover of a predicate: it is the OR of the values with the indices `positive` and of
    `cubes`.

    `cost` is in words; the words of reused cubes (NORs of registers) are divided by the number of
    demands that they serve. A demand is a set of shutters that FLAG must select at a boundary."""

    positive: tuple[int, ...]
    cubes: tuple[Nor, ...]
    cost: float


# Numbers of demands for which cubes are tried. A longer-lived cube is smaller and shared by more
# demands; neighbouring lengths rarely give different cubes.
_HORIZONS = (1, 2, 4, 8, 16, 32, 64)
# Each seed adds at least one cube; a demand that needs more is too expensive.
_MOST_SEEDS = 40


class Covers(NamedTuple):
    """A search for covers within `budget`, the steps for all calls together.

    `everything` is the truth vector of all shutters, `fan_in` the number of sources that one word
    accepts (None: any number). A truth vector is an integer with one bit for each shutter."""

    everything: int
    fan_in: int | None
    budget: Budget

    def find(
        self, values: Sequence[int], usable: Sequence[bool], ahead: Sequence[int], most_cubes: int
    ) -> Cover | None:
        """Return a cheap cover of ahead[0] by values and at most `most_cubes` cubes (NORs of
        registers); None if not found.

        `values` are truth vectors; `usable[i]` says whether value i may be a source of the OR
        (cubes may read all values). `ahead` are the predicates of this demand (a set of shutters
        that FLAG must select at a boundary) and the next ones; cubes that the next ones can reuse
        are preferred. Raises GaveUp if the budget is used up."""
        predicate = ahead[0]
        positive = [i for i, v in enumerate(values) if usable[i] and v and not v & ~predicate]
        uncovered = predicate & ~union(values[i] for i in positive)
        if not uncovered:
            return Cover(_fewest(positive, values, predicate), (), 0.0)
        if most_cubes < 1:
            return None
        outside = self.everything & ~predicate
        if most_cubes == 1 and outside & ~union(v for v in values if not v & uncovered):
            return None  # one cube for all of `uncovered` reads only values that are 0 there
        # A single register is not used for lasting cubes.
        cubes = self._candidates(values, ahead if most_cubes > 1 else ahead[:1], uncovered)
        chosen = cubes and _select(cubes, uncovered, most_cubes, self.budget)
        if not chosen:
            return None
        uncovered_by_cubes = predicate & ~union(cube.vector for cube in chosen)
        cost = sum(cube.cost for cube in chosen)
        return Cover(_fewest(positive, values, uncovered_by_cubes), tuple(chosen), cost)

    def _candidates(
        self, values: Sequence[int], ahead: Sequence[int], uncovered: int
    ) -> list[Nor] | None:
        """Return cubes (NORs of registers) of `values` inside ahead[0] that together cover the
        shutters `uncovered`; None if they cannot, or would take more than _MOST_SEEDS rounds.

        Of equal cubes, the one with the fewest sources is kept."""
        nor_by_vector: dict[int, Nor] = {}
        unreached = uncovered
        outside = [self.everything & ~ahead[0]]
        for predicate in ahead[1 : _HORIZONS[-1]]:
            outside.append(outside[-1] | (self.everything & ~predicate))
        for _ in range(_MOST_SEEDS):
            if not unreached:
                return list(nor_by_vector.values())
            # A cube that reaches `seed` can only read values that are 0 there.
            seed = unreached & -unreached
            zeros = [i for i, v in enumerate(values) if not v & seed]
            before = unreached
            for horizon in _HORIZONS:
                if horizon > len(outside) or outside[horizon - 1] & seed:
                    break
                cube = self._prime(zeros, values, outside[horizon - 1], uncovered)
                if cube is None:
                    break
                sources, vector = cube
                unreached &= ~vector
                known = nor_by_vector.get(vector)
                if known is None or len(sources) < len(known.sources):
                    served = max(1, life(vector, ahead))
                    words = words_of(len(sources), self.fan_in)
                    nor_by_vector[vector] = Nor(sources, vector, served, words)
            if unreached == before:
                return None
        return None

    def _prime(
        self, zeros: Sequence[int], values: Sequence[int], outside: int, uncovered: int
    ) -> tuple[tuple[int, ...], int] | None:
        """Return (sources, truth vector) of a prime cube over the literals `zeros` that avoids
        `outside`; None if even all literals together do not avoid it.

        `zeros` are indices into `values`, `outside` and `uncovered` are truth vectors (integers
        with one bit for each shutter). The cube starts with all literals and drops one after
        another, each time the literal whose removal adds most of `uncovered`. If several literals
        add equally much, the first is dropped. A cube is prime if no literal can be dropped."""
        if outside & ~union(values[i] for i in zeros):
            return None
        # A literal that alone keeps out a part of `outside` can never be dropped.
        free, once, twice = [(values[i], i) for i in zeros], 0, 0
        required: list[int] = []
        spent, steps = 0, 1 + self.everything.bit_length() // 512
        while True:
            spent += (len(free) + len(required)) * steps
            covered, again = once, twice  # by at least one literal, and by at least two
            for vector, _ in free:
                again |= covered & vector
                covered |= vector
            # Shutters that a single literal keeps out of the cube: those in `outside` need it, and
            # those in `uncovered` are gained if it is dropped.
            alone = covered & ~again
            needed, gained = alone & outside, alone & uncovered
            may_go: list[tuple[int, int]] = []
            most, gone = -1, 0
            for literal in free:
                vector = literal[0]
                if vector & needed:
                    required.append(literal[1])
                    twice |= once & vector
                    once |= vector
                    continue
                count = (vector & gained).bit_count()
                if count > most:
                    most, gone = count, len(may_go)
                may_go.append(literal)
            if not may_go:
                self.budget.spend(spent)
                return tuple(sorted(required)), self.everything & ~covered
            del may_go[gone]
            free = may_go


def life(vector: int, ahead: Sequence[int]) -> int:
    """Return the number of consecutive predicates (sets of shutters), from ahead[0] on, that
    contain the truth vector `vector`: 0 if ahead[0] does not, all for an empty vector. A truth
    vector is an integer with one bit for each shutter."""
    for count, predicate in enumerate(ahead):
        if vector & ~predicate:
            return count
    return len(ahead)


def _fewest(positive: Sequence[int], values: Sequence[int], uncovered: int) -> tuple[int, ...]:
    """Return the indices, ascending, of a small set of `values` whose OR contains `uncovered`,
    chosen greedily among the indices `positive`, whose OR must contain it."""
    chosen: list[int] = []
    while uncovered:
        best = max(positive, key=lambda i: (values[i] & uncovered).bit_count())
        chosen.append(best)
        uncovered &= ~values[best]
    return tuple(sorted(chosen))


def _select(cubes: Sequence[Nor], uncovered: int, most: int, budget: Budget) -> list[Nor] | None:
    """Return the cheapest set of at most `most` cubes that covers the shutters `uncovered`, a truth
    vector, by branch and bound; None if it finds no such set.

    The cost of a cube is its words per served demand (a set of shutters that FLAG must select at a
    boundary). After 2000 visits the best set so far counts. A truth vector is an integer with one
    bit for each shutter."""
    ordered = sorted(cubes, key=lambda c: (-(c.vector & uncovered).bit_count(), len(c.sources)))
    best: list[Nor] | None = None
    best_cost = float("inf")
    visits = 0

    def descend(remaining: int, chosen: list[Nor], cost: float) -> None:
        """Extend `chosen` by cubes (NORs of registers) until no shutter is left in `remaining`;
        keep the cheapest choice found in `best`.

        `cost` is that of `chosen`, which is as before when the call returns. A branch that costs at
        least the best choice so far is cut."""
        nonlocal best, best_cost, visits
        if not remaining:
            # Costs are sums of fractions: smaller differences are rounding errors.
            if cost < best_cost - 1e-9:
                best, best_cost = list(chosen), cost
            return
        # Some cube must contain the first uncovered shutter, so the branching is complete. Most
        # choices have two or three cubes; the limit is for the others.
        visits += 1
        if len(chosen) == most or visits > 2000:
            return
        seed = remaining & -remaining
        for cube in ordered:
            if cube.vector & seed and cost + cube.cost < best_cost - 1e-9:
                chosen.append(cube)
                descend(remaining & ~cube.vector, chosen, cost + cube.cost)
                chosen.pop()

    descend(uncovered, [], 0.0)
    budget.spend(visits)
    return best
