"""Repetition of the improvement passes, while they save words and steps are left; and the balance
of words between boundaries.

Between sweeps, a random walk among solutions of equal cost looks for a cheaper one nearby. Every
step drops one to three operations, or moves one, and keeps the repaired result unless it costs more
words. The random sequence is fixed. Most changes save nothing, but they move values to other
registers and times, so that another point of the plateau may have a cheaper neighbour."""

from __future__ import annotations

import random
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import count, islice

from nscc.logic.cubes import Budget
from nscc.logic.improve.code import (
    CLOSING,
    OPENING,
    Check,
    FrameContext,
    GateOp,
    Illegal,
    Item,
    flatten,
    states_before,
    unflatten,
)
from nscc.logic.improve.recolour import recoloured
from nscc.logic.improve.rewrite import Rewrite, Rewriter, shrink
from nscc.logic.improve.tracked_run import TrackedRun
from nscc.logic.problem import GaveUp, Machine, Problem, Solution

# Most distance of operations that are dropped together or exchanged, about the gates of one
# demand.
SPAN = 12


def wander(run: TrackedRun, seed: int, steps: int) -> int:
    """Change the code of `run` at random, in place, without adding words, for `steps` steps of the
    budget or until none are left; return the number of words saved.

    `seed` determines the random sequence. Raises GaveUp if the budget is used up within a change,
    which is then not made."""
    choose = random.Random(seed)
    until = max(run.budget.left - steps, 0)
    gained = 0
    while run.budget.left > until and run.items:
        rewriting = _try(run, choose)
        if rewriting is not None:
            run.splice(rewriting.start, rewriting.end, rewriting.items)
            gained += rewriting.gain
    return gained


def _try(run: TrackedRun, choose: random.Random) -> Rewrite | None:
    """Choose one random change of the code and repair it; return None if there is no such change,
    if the repaired code costs more words, or if it is equal to the old code.

    `choose` is the random generator. The caller applies the change. Spends one step of the budget,
    and those of the repair; raises GaveUp if none are left."""
    k = choose.randrange(len(run.items))
    item = run.items[k]
    run.budget.spend(1)
    if isinstance(item, Check):
        return None
    order = list(range(run.frame.flag + 1))
    choose.shuffle(order)
    # Half of the steps drop one to three operations; a quarter change the destination, an eighth
    # move an operation forward, and an eighth replace one or two operations by a NOR of some
    # registers.
    kind = choose.randrange(8)
    lead: tuple[GateOp, ...] = ()
    dropped = [k]
    start = k
    if kind <= 3:
        nearby = _nearby_operations(run, k)
        choose.shuffle(nearby)
        dropped += nearby[: choose.randrange(3)]
        start = min(dropped)
    elif kind <= 5:
        target = choose.choice(order)
        if target == run.frame.flag or item.destination == run.frame.flag:
            return None
        if target == item.destination or run.frame.masked in (target, item.destination):
            return None
        lead = (run.frame.op(item.inverted, target, item.sources, item.demand_index, item.segment),)
    elif kind == 6:
        if item.destination == run.frame.masked:
            return None
        # A random index before k among the gates of the same demand.
        low = k
        while low > 0 and k - low < SPAN and not isinstance(run.items[low - 1], Check):
            low -= 1
        start = choose.randrange(low, k + 1)
        if start == k:
            return None
        first = run.items[start]
        assert isinstance(first, GateOp)
        lead = (replace(item, segment=first.segment),)
    else:
        target = choose.randrange(run.frame.flag)
        if run.live[k] >> target & 1 or target == run.frame.masked:
            return None
        known = [r for r in order if run.before[k][r] is not None]
        sources = known[: choose.randrange(1, 4)]
        lead = (run.frame.op(True, target, sources, item.demand_index, item.segment),)
        dropped = _nearby_operations(run, k)
        choose.shuffle(dropped)
        dropped = dropped[: choose.randrange(1, 3)]
        start = min([k, *dropped])
    rewriter = Rewriter(run, start, least=0, deepen=True, order=order)
    rewriting = rewriter.rewrite(lead, dropped)
    if rewriting is None or (
        rewriting.gain == 0 and rewriting.items == run.items[rewriting.start : rewriting.end]
    ):
        return None
    return rewriting


def _nearby_operations(run: TrackedRun, k: int) -> list[int]:
    """Return the indices of the operations less than `SPAN` items before or after operation k that
    belong to the same demand, without k: those before it first, each side nearest first. A demand
    is a set of shutters that FLAG must select at a boundary."""
    operations: list[int] = []
    for indices in (
        range(k - 1, max(-1, k - SPAN), -1),
        range(k + 1, min(len(run.items), k + SPAN)),
    ):
        for j in indices:
            if isinstance(run.items[j], Check):
                break
            operations.append(j)
    return operations


# Most distance of operations dropped together: they belong to one demand or to two consecutive
# ones.
PAIR_SPAN = 8
# Steps of one walk, half a second, before the next sweeps.
WALK_STEPS = 50_000
# Number of consecutive walks without improvement after which the search ends.
PATIENCE = 6


def improve(solution: Solution, problem: Problem, machine: Machine, budget: Budget) -> Solution:
    """Return a solution of the same problem with at most as many words per frame; `solution` itself
    if it is not legal or nothing is gained.

    The encoding is unchanged. The result is deterministic: steps of `budget` are used until nothing
    is gained. Equal segments (groups of gates that run together) may become different, so a frame
    of fewer words may take more stored words."""
    frame, items = flatten(solution, problem, machine)
    try:
        items = _exhausted(TrackedRun(frame, items, budget))
    except Illegal:
        return solution
    return settled(frame, items)


def settled(frame: FrameContext, items: list[Item], *, as_long: bool = False) -> Solution:
    """Return the solution of `items` if it is valid and has fewer words than the frame's solution,
    else the latter.

    With `as_long`, a solution with equally many words is returned too."""
    solution = frame.solution
    try:
        candidate = unflatten(frame, items)
        checked, again = flatten(candidate, frame.problem, frame.machine)
        states_before(checked, again)
    except Illegal:
        return solution
    before, gates = flatten(solution, frame.problem, frame.machine)
    gain = before.total(gates) - checked.total(again)
    return candidate if gain > 0 or (as_long and gain == 0) else solution


def _exhausted(run: TrackedRun) -> list[Item]:
    """Return the items after alternating sweeps and walks, the best that were found.

    The search ends when the budget is used up, or after PATIENCE walks in a row without gain. It
    raises no GaveUp."""
    try:
        _sweep(run)
        idle = 0
        for seed in count():
            gained = wander(run, seed, WALK_STEPS)
            words = run.words()
            _sweep(run)
            idle = 0 if gained or run.words() < words else idle + 1
            if idle == PATIENCE:
                break
    except GaveUp:
        _recolour(run)
    return run.items


def _sweep(run: TrackedRun) -> None:
    """Remove operations of `run`, in place, and allocate its registers again, in rounds, until a
    round saves no word. Raises GaveUp if the budget is used up."""
    words = run.words() + 1
    while run.words() < words:
        words = run.words()
        shrink(run, PAIR_SPAN)
        _recolour(run)


def _recolour(run: TrackedRun) -> None:
    """Allocate the registers of `run` again, and keep the result if it has fewer words and is
    legal."""
    items = recoloured(run.frame, run.items)
    if items is not None and run.frame.total(items) < run.words():
        with suppress(Illegal):
            run.restart(items)


# How many demands a gate may move forward; its value needs a register in between.
REACH = 6


def balance(
    solution: Solution,
    problem: Problem,
    machine: Machine,
    budget: Budget,
    other_words: Sequence[int],
) -> Solution:
    """Return a solution in which gates have moved to earlier boundaries, without more words in the
    frame.

    `other_words` are the words at each boundary 0..N besides the solution's gates. The words of the
    largest boundary decrease, as far as gates can move and the budget lasts. Returns `solution` if
    no gate can move, or if it is not legal."""
    frame, items = flatten(solution, problem, machine)
    try:
        run = TrackedRun(frame, items, budget)
    except Illegal:
        return solution
    loads = _Loads(frame, items, other_words)
    with suppress(GaveUp):
        # All gates of the fullest boundaries must move, otherwise the largest stays as large.
        while (most := max(loads.words)) and all(
            _relieve(run, loads, n, most)
            for n in [n for n, words in enumerate(loads.words) if words >= most]
        ):
            pass
    # Compared with the gates where they were before.
    if max(loads.words) >= max(loads.counted(items)):
        return solution
    return settled(frame, run.items, as_long=True)


def words_at(solution: Solution, problem: Problem, machine: Machine, slots: int) -> list[int]:
    """Return the words of a solution's gates at each boundary 0..slots, as a list of slots + 1
    numbers, without refresh of planes. A plane is the content of a code register."""
    frame, items = flatten(solution, problem, machine)
    return _Loads(frame, items, [0] * (slots + 1)).words


class _Loads:
    """The number of words at each boundary 0..N (`words`), as of the last count."""

    def __init__(
        self, frame: FrameContext, items: Sequence[Item], other_words: Sequence[int]
    ) -> None:
        """Count the words at each boundary: those of `items`, and `other_words`, which are not
        gates and stay."""
        self._frame = frame
        self._boundaries = [demand.boundary for demand in frame.problem.demands]
        self._other_words = other_words
        self.words = self.counted(items)

    def boundary(self, demand_index: int) -> int:
        """Return the boundary of an operation: 0 for OPENING, N for CLOSING, else that of the
        demand (a set of shutters that FLAG must select at a boundary) with this index. FLAG is the
        bit that lets a pixel act."""
        if demand_index == OPENING:
            return 0
        return (
            len(self._other_words) - 1
            if demand_index == CLOSING
            else self._boundaries[demand_index]
        )

    def counted(self, items: Sequence[Item]) -> list[int]:
        """Return the number of words at each boundary 0..N if the gates are `items`, with the other
        words; `words` does not change."""
        words = list(self._other_words)
        for item in items:
            words[self.boundary(item.demand_index)] += self._frame.words(item)
        return words


def _relieve(run: TrackedRun, loads: _Loads, boundary: int, most: int) -> bool:
    """Move one operation of `run`, in place, from `boundary` to an earlier one; return whether this
    was possible.

    `boundary` then has fewer than `most` words, and no other boundary grows to `most` or more;
    `loads` is updated. The first operation that can move is taken; those that write FLAG (the bit
    that lets a pixel act) or the masked register stay."""
    for k, item in enumerate(run.items):
        if isinstance(item, Check) or loads.boundary(item.demand_index) != boundary:
            continue
        # FLAG must be loaded where it is needed, and a masked write overwrites its mask.
        if item.destination in (run.frame.flag, run.frame.masked):
            continue
        for start, demand_index, segment in _earlier(run, k, loads, most):
            for target in (item.destination, *run.free(start, {item.destination})):
                moved = replace(
                    item, destination=target, demand_index=demand_index, segment=segment
                )
                rewriting = Rewriter(run, start, least=0).rewrite((moved,), (k,))
                if rewriting is not None and _take(run, loads, rewriting, boundary, most):
                    return True
    return False


def _earlier(run: TrackedRun, k: int, loads: _Loads, most: int) -> list[tuple[int, int, int]]:
    """Return the ends of the gates of up to REACH earlier demands with room for another word, as
    (index of an item, place, segment), latest first; item k may move before that item.

    `loads` are the words at each boundary, of which none may grow to `most`. Demands at the
    boundary of item k are left out. A segment is a group of gates that run together. A demand is a
    set of shutters that FLAG must select at a boundary."""
    earlier_points = []
    own_boundary = loads.boundary(run.items[k].demand_index)
    checks = (at for at in range(k - 1, -1, -1) if isinstance(run.items[at], Check))
    for at in islice(checks, REACH):
        item = run.items[at]
        boundary = loads.boundary(item.demand_index)
        # An operation takes at least one word.
        if boundary == own_boundary or loads.words[boundary] + 1 >= most:
            continue
        before = run.items[at - 1] if at else item
        segment = before.segment if isinstance(before, GateOp) else 0
        earlier_points.append((at, item.demand_index, segment))
    return earlier_points


def _take(run: TrackedRun, loads: _Loads, rewriting: Rewrite, boundary: int, most: int) -> bool:
    """Apply a rewriting to the run, in place, if `boundary` then has fewer than `most` words, and
    no boundary grows to `most` or more; return whether it was applied.

    `loads` is then counted again; without a change it stays as it is."""
    words = loads.counted(
        [*run.items[: rewriting.start], *rewriting.items, *run.items[rewriting.end :]]
    )
    if words[boundary] >= most or any(
        now >= most and now > was for now, was in zip(words, loads.words, strict=True)
    ):
        return False
    run.splice(rewriting.start, rewriting.end, rewriting.items)
    loads.words = loads.counted(run.items)
    return True
