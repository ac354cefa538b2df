"""Generator for arbitrary shutters: store some predicates, and compute the others by cascades.

A demand with a stored predicate costs one word. Fast searches compare sets of stored predicates;
the best set gets the full search for cascades. If the stored predicates do not distinguish all
shutters, a few bits of the last ones are changed, and short cascades compute the original
predicates."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

import numpy as np

from nscc.arrays import Bools, Ints
from nscc.logic.cascade_search import MOST_POINTS, Cascade, Search
from nscc.logic.cubes import Budget
from nscc.logic.encodings import describe_demand
from nscc.logic.point_sets import Planes, Points, packed
from nscc.logic.problem import Gates, GaveUp, Machine, Problem, Segment, Solution
from nscc.truth import columns, rows, set_bits

# More scratch registers leave too few planes.
_MOST_SCRATCH = 3
# Beam width of the searches that compare choices of planes; thousands of them run.
_QUICK_WIDTH = 6
# The fraction of steps for choosing planes, and the beam widths of the search afterwards.
_CHOOSING = 0.6
_WIDTHS = (30, 100, 300, 1000)
# Limit on the words of a cascade; effectively none.
_LONGEST = 4096
# The share of changes of a choice that exchange a predicate (the others invert one), and the
# initial tolerance for more words.
_EXCHANGED = 0.8
_SLACK = 0.03
# So many predicates for each plane may come in by an exchange: those with the fewest ones.
_CANDIDATES = 1.6
# Steps for a choice of planes before any search.
_STEPS_A_CHOICE = 100


@dataclass(frozen=True)
class _Points:
    """Points: groups of shutters that no demand distinguishes.

    `bits`, bool (predicates, points), are the distinct predicates that planes may hold; the first
    `demanded` of them are demands (sets of shutters that FLAG must select at boundaries). `names`
    describe the predicates in words. `shutters` (shutters,) is the number of each shutter's point.
    FLAG is the bit that lets a pixel act."""

    bits: Bools
    demanded: int
    names: tuple[str, ...]
    shutters: Ints


_Choice = tuple[tuple[int, bool], ...]
"""For each plane its predicate (an index into `_Points.bits`), and whether it is inverted."""


@dataclass(frozen=True)
class _Plan:
    """Chosen predicates (sets of shutters) to store, and how the others are computed.

    `choice` names the predicates; `planes`, bool (planes, points), are what is stored, which may
    differ from them in places. `scratch` is the number of scratch registers, and `cascades` has the
    cascade of every task. `words` are those of all gates of a frame. A cascade is a chain of gates,
    each of which reads the one before."""

    choice: _Choice
    planes: Bools
    scratch: int
    cascades: dict[_Task, Cascade]
    words: int


_Task = tuple[int, int]
"""The index of a predicate, and of the predicate that FLAG holds before it, -1 if unknown."""


def cascade(problem: Problem, machine: Machine, steps: int) -> Iterator[Solution]:
    """Yield a solution that stores some predicates and computes the others by cascades of cubes.

    Raises GaveUp if the steps do not suffice for a first solution. The remaining steps improve it.

    Four shutters over four slots, open in the slots 0 and 1; 1, 2 and 3; 2; 3. A pixel with four
    registers stores which of them are open in the slots 1, 3 and 2. In slot 0, those are open that
    p1 and p2 leave out:

        >>> opens = (0b0001, 0b0011, 0b0110, 0b1010)
        >>> from nscc.logic.problem import Demand
        >>> demands = tuple(Demand(n, "open", 0, p, False) for n, p in enumerate(opens, 1))
        >>> problem = Problem(demands, 4, (opens,), flag_lasts=False, values={})
        >>> (solution,) = cascade(problem, Machine(4, False, None, None, False), steps=10_000)
        >>> solution.holders
        ('open in slot 1', 'open in slot 3', 'open in slot 2')
        >>> [[str(gate) for gate in segment] for (segment,) in solution.answers[:2]]
        [['t0 = NOR(p1, p2)', 'FLAG = WHERE(t0)'], ['FLAG = WHERE(p0)']]
    """
    finder = _Finder(problem, machine, Budget(steps))
    best: _Plan | None = None
    try:
        for plan in finder.plans():
            best = plan
    except GaveUp:
        if best is None:
            raise
    if best is not None:
        yield finder.solution(best)


class _Finder:
    """The search for plans of one problem. A plan says which predicates (sets of shutters) are
    stored, and how cascades of gates compute the others. Points, tasks and how often each task
    occurs are computed once; then plans are searched until the budget is used up."""

    def __init__(self, problem: Problem, machine: Machine, budget: Budget) -> None:
        """Reduce the problem's demands (sets of shutters that FLAG must select at boundaries) to
        tasks on distinct points, and count equal tasks.

        Raises GaveUp if the budget of steps is used up. FLAG is the bit that lets a pixel act."""
        self._problem = problem
        self._machine = machine
        self._budget = budget
        # Reducing the demands costs time, too. A step stands for 512 shutters of one truth vector.
        budget.spend(len(problem.demands) * problem.shutters // 512)
        self._points = _points(problem)
        self._sets = packed(self._points.bits)
        # All predicates as planes, inverted if they are 1 at most points. Planes with few ones come
        # first, because their NORs are cubes of many points.
        count = self._points.bits.shape[1]
        ones = self._points.bits.sum(axis=1)
        sparse = np.argsort(np.minimum(ones, count - ones), kind="stable").tolist()
        self._orders = [[(number, bool(2 * ones[number] > count)) for number in sparse]]
        demanded = self._points.demanded
        if demanded < len(sparse):
            # First those without a demand: edges can be computed from levels.
            self._orders.insert(0, sorted(self._orders[0], key=lambda plane: plane[0] < demanded))
        self._tasks = self._tasks_of_demands()
        # How often each task occurs in a frame.
        self._times = Counter(task for task in self._tasks if task is not None)

    def plans(self) -> Iterator[_Plan]:
        """Yield plans, each with fewer words than the previous one; end when no search finds a
        better one. A plan says which predicates (sets of shutters) are stored, and how cascades of
        gates compute the others.

        Raises GaveUp at once if there are more than MOST_POINTS points, or if the planes that
        distinguish them leave no register for results; later when no steps are left. A plane is the
        content of a code register."""
        count = self._points.bits.shape[1]
        least = max(1, (count - 1).bit_length())
        # One register is left for intermediate results.
        widest = min(self._machine.registers - 1, len(self._points.bits))
        if count > MOST_POINTS:
            raise GaveUp(f"{count} kinds of shutters, more than {MOST_POINTS}")
        if least > widest:
            raise GaveUp(f"{count} kinds of shutters leave no register to compute with")
        allowed = self._budget.left
        # Estimated steps of a quick search: links of a cascade (each decides two or more points),
        # times cubes per link, times words of 64 points per cube. The beam of fast searches is
        # narrower if a single search takes many steps.
        cascades = max(1, self._points.demanded - self._machine.registers + 2)
        cubes = min(count * 8, 1 << (self._machine.registers - 2))
        steps = cascades * (1 + count // 2) * (20 + cubes * self._sets.shape[1] * 8 // 640)
        # One search of width 1 takes about `steps`; none may take more than an eighth of the
        # budget.
        quick = int(max(1, min(_QUICK_WIDTH, allowed // (8 * steps))))
        best: _Plan | None = None
        # With two scratch registers and FLAG, a link can use a cube besides the inner value; one
        # scratch register allows one more plane.
        for scratch in (2, 1, *range(3, _MOST_SCRATCH + 1)):
            width = min(self._machine.registers - scratch, widest)
            if width < least or scratch > self._machine.registers - width:
                continue
            for order in self._orders:
                choice = tuple(order[:width])
                most = best.words - 1 if best is not None else _LONGEST * len(self._tasks)
                plan = self._quick(choice, scratch, quick, most)
                if plan is not None:
                    best = plan
                    yield plan
        # One word a task is the least, so nothing can be better.
        if best is None or best.words == self._times.total():
            return
        for plan in self._chosen(best, int(allowed * (1 - _CHOOSING)), quick):
            best = plan
            yield plan
        for width in _WIDTHS:
            for plan in self._widened(best, width):
                best = plan
                yield plan

    def solution(self, plan: _Plan) -> Solution:
        """Return the solution that stores a plan's predicates and computes the others by its
        cascades (chains of gates, each of which reads the one before).

        `plan` must have a cascade for every task. The solution has one answer for each demand (a
        set of shutters that FLAG must select at a boundary); it is empty if FLAG already holds the
        predicate."""
        points = self._points
        answers: list[tuple[Segment, ...]] = []
        for task in self._tasks:
            gates = Gates(self._machine)
            if task is not None:
                # A link writes t0, so its cubes take the other registers first.
                registers = [*(f"t{i}" for i in range(1, plan.scratch)), "t0"]
                inner: list[str] = []
                # The innermost link, the last of the list, runs first.
                for link in reversed(plan.cascades[task].links):
                    sources = inner + ["FLAG"] * link.reads_flag
                    free = [register for register in registers if register not in sources]
                    for register, mask in zip(free[: len(link.cubes)], link.cubes, strict=True):
                        gates.nor(register, _names(set_bits(mask)))
                        sources.append(register)
                    sources += _names(link.planes)
                    if link.to_flag:
                        # The search counted the sources of WHERE, so none must be gathered in
                        # scratch.
                        gates.load_flag(sources, None)
                    elif link.negated:
                        gates.nor("t0", sources)
                    else:
                        gates.or_("t0", sources)
                    inner = ["FLAG" if link.to_flag else "t0"]
            segment = gates.take()
            answers.append((segment,) if segment else ())
        shutters = plan.planes[:, points.shutters]
        holders = [
            points.names[number]
            + (", inverted" if turned else "")
            + ("" if (plane == (points.bits[number] ^ turned)).all() else ", changed in places")
            for (number, turned), plane in zip(plan.choice, plan.planes, strict=True)
        ]
        name, planes = "predicates stored, the rest by cascades of cubes", columns(shutters.T)
        return Solution(
            name, tuple(planes), tuple(holders), 0, plan.scratch, (), tuple(answers), ()
        )

    def _tasks_of_demands(self) -> list[_Task | None]:
        """Return the task of every demand (a set of shutters that FLAG must select at a boundary),
        in order; None where FLAG already holds the demand's predicate.

        Predicates are numbered in the order of their first demands, as in `_Points.bits`. FLAG is
        the bit that lets a pixel act."""
        problem = self._problem
        number: dict[int, int] = {}
        for demand in problem.demands:
            number.setdefault(demand.predicate, len(number))
        tasks: list[_Task | None] = []
        for i, demand in enumerate(problem.demands):
            before = problem.demands[i - 1].predicate if demand.flag_kept else None
            flag_predicate = -1 if before is None else number[before]
            tasks.append(
                None if problem.answered(i) else (number[demand.predicate], flag_predicate)
            )
        return tasks

    def _quick(self, choice: _Choice, scratch: int, width: int, most: int) -> _Plan | None:
        """Search with a beam of `width` values for cascades that complete a choice of stored
        predicates. Return the plan if it takes at most `most` words per frame; None if the search
        found none.

        `scratch` is the number of registers for intermediate results. Raises GaveUp if no steps are
        left. A predicate is a set of shutters."""
        planes = _separating(self._points.bits, choice)
        times = self._times
        # The search counts each distinct task once; every repetition costs at least one word more.
        repeats = times.total() - len(times)
        optional_cascades = self._search(planes, scratch).find(
            *self._predicates_and_flag(list(times)),
            [min(most, _LONGEST)] * len(times),
            width,
            most - repeats,
        )
        cascades = {
            task: cascade
            for task, cascade in zip(times, optional_cascades, strict=True)
            if cascade is not None
        }
        if len(cascades) < len(times):
            return None
        words = sum(count * cascades[task].words for task, count in times.items())
        return _Plan(choice, planes, scratch, cascades, words) if words <= most else None

    def _search(self, planes: Bools, scratch: int) -> Search:
        """Return a search for gates that reads these stored predicates (sets of shutters) and
        `scratch` free registers.

        `planes`, bool (planes, points), are the contents of the stored predicates. Spends steps of
        the budget; raises GaveUp if none are left. A plane is the content of a code register."""
        sets = packed(planes)
        self._budget.spend(_STEPS_A_CHOICE + (sets.shape[1] << len(planes)) // 64)
        table = Planes(sets, planes.shape[1], self._machine)
        return Search(table, self._machine, scratch, self._budget)

    def _predicates_and_flag(self, tasks: list[_Task]) -> tuple[Points, Points]:
        """Return two arrays of sets, uint64 (tasks, words of 64 points): the predicate (a set of
        shutters) of every task, and the content of FLAG before it (the empty set if unknown). FLAG
        is the bit that lets a pixel act."""
        predicates, flag_predicates = np.array(tasks).T
        known = np.where((flag_predicates >= 0)[:, None], self._sets[flag_predicates], np.uint64(0))
        return self._sets[predicates], known

    def _chosen(self, best: _Plan, until: int, width: int) -> Iterator[_Plan]:
        """Improve the choice of stored predicates (sets of shutters) by exchanging or inverting one
        at random; yield each plan with fewer words than all before. A plan adds to the stored
        predicates the cascades (chains of gates) that compute the others.

        `best` is the plan to begin with, `width` the width of the beam. Ends when only `until`
        steps of the budget are left."""
        choose = random.Random(0)
        current = best
        span = max(1, self._budget.left - until)
        count = round(_CANDIDATES * len(best.choice))
        candidates = dict.fromkeys(plane for order in self._orders for plane in order[:count])
        while self._budget.left > until:
            neighbour = list(current.choice)
            index = choose.randrange(len(neighbour))
            number, turned = neighbour[index]
            chosen_planes = dict(neighbour)
            unchosen_planes = [plane for plane in candidates if plane[0] not in chosen_planes]
            if unchosen_planes and choose.random() < _EXCHANGED:
                neighbour[index] = choose.choice(unchosen_planes)
            else:
                neighbour[index] = number, not turned
            # Slightly worse choices are accepted, less and less (threshold accepting; Dueck and
            # Scheuer, 1990), because most choices have no better neighbour.
            slack = round(_SLACK * current.words * (self._budget.left - until) / span)
            plan = self._quick(tuple(neighbour), current.scratch, width, current.words + slack)
            if plan is not None:
                current = plan
                if plan.words < best.words:
                    best = plan
                    yield plan

    def _widened(self, best: _Plan, width: int) -> Iterator[_Plan]:
        """Search for shorter cascades of the plan `best`, with the same planes and a beam of
        `width` values; replace the longest cascade first. Yield each plan with fewer words.

        Raises GaveUp if no steps are left. A cascade is a chain of gates, each of which reads the
        one before. A plane is the content of a code register."""
        search = self._search(best.planes, best.scratch)
        for task, times in sorted(self._times.items(), key=lambda t: -best.cascades[t[0]].words):
            old = best.cascades[task].words
            (shorter,) = search.find(*self._predicates_and_flag([task]), [old - 1], width, _LONGEST)
            if shorter is not None:
                cascades = {**best.cascades, task: shorter}
                words = best.words - times * (old - shorter.words)
                best = replace(best, cascades=cascades, words=words)
                yield best


def _points(problem: Problem) -> _Points:
    """Return the points of a problem: shutters that are equal in all demands (sets of shutters that
    FLAG must select at boundaries) are one point.

    The open shutters of each slot of each bucket are added as candidates for planes, except where
    all or none are open, because such a plane distinguishes nothing. FLAG is the bit that lets a
    pixel act."""
    names: dict[int, str] = {}
    for demand in problem.demands:
        names.setdefault(demand.predicate, describe_demand(demand))
    demanded = len(names)
    for bucket in problem.opens:
        for slot, level in enumerate(bucket):
            if level not in (0, problem.everything):
                names.setdefault(level, f"open in slot {slot}")
    bits = rows(list(names), problem.shutters)
    rows_asked = np.packbits(bits[:, :demanded], axis=1)
    _, first, shutters = np.unique(rows_asked, axis=0, return_index=True, return_inverse=True)
    return _Points(
        np.ascontiguousarray(bits[first].T), demanded, tuple(names.values()), shutters.reshape(-1)
    )


def _separating(bits: Bools, choice: _Choice) -> Bools:
    """Return the planes of a choice, bool (planes, points), changed at as few points as needed so
    that no two points are equal in all planes.

    `bits` (predicates, points) are the candidates of `_Points`. The caller ensures that there are
    at most 2^planes points. A predicate is a set of shutters. A plane is the content of a code
    register."""
    stored, inverted = np.array(choice).T
    planes: Bools = bits[stored] ^ (inverted[:, None] == 1)
    count = planes.shape[1]
    # `kinds` numbers the classes that the planes so far distinguish; a plane may split each in two.
    # If the remaining planes cannot distinguish the members of a half, its surplus moves to the
    # other half.
    kinds = np.zeros(count, dtype=np.int64)
    for index, plane in enumerate(planes):
        room = 1 << (len(planes) - 1 - index)
        halves = np.bincount(2 * kinds + plane, minlength=2 * (int(kinds.max()) + 1))
        for half in np.flatnonzero(halves > room):
            inside = np.flatnonzero((kinds == half >> 1) & (plane == (half & 1)))
            plane[inside[room:]] ^= True
        _, kinds = np.unique(2 * kinds + plane, return_inverse=True)
        kinds = kinds.reshape(-1)
    return planes


def _names(planes: Iterable[int]) -> list[str]:
    """Return the names of code planes (contents of code registers) by number."""
    return [f"p{plane}" for plane in planes]
