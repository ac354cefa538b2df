"""Repetition of the improvement passes, while they save words and steps are left.

Between sweeps, a random walk among solutions of equal cost looks for a cheaper one nearby. Every
step drops one to three operations, or moves one, and keeps the repaired result unless it costs more
words. The random sequence is fixed. Most changes save nothing, but they move values to other
registers and times, so that another point of the plateau may have a cheaper neighbour."""

from __future__ import annotations

import random
from contextlib import suppress
from dataclasses import replace
from itertools import count

from nscc.logic.cubes import Budget
from nscc.logic.improve.code import (
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

# Most distance of operations that are dropped together or exchanged, about one answer.
SPAN = 12


def wander(run: TrackedRun, seed: int, steps: int) -> int:
    """Walk at most `steps` steps of the budget; return the number of words saved."""
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
        lead = (run.frame.op(item.inverted, target, item.sources, item.place, item.segment),)
    elif kind == 6:
        # A random place before k in the same answer.
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
        lead = (run.frame.op(True, target, sources, item.place, item.segment),)
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
    """Return operations of the same answer near k, without k."""
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


# Most distance of operations dropped together: they belong to one answer or to two consecutive
# ones.
PAIR_SPAN = 8
# Steps of one walk, half a second, before the next sweeps.
WALK_STEPS = 50_000
# Number of consecutive walks without improvement after which the search ends.
PATIENCE = 6


def improve(solution: Solution, problem: Problem, machine: Machine, budget: Budget) -> Solution:
    """Return a solution of the same problem with at most as many words per frame.

    The encoding is unchanged. The result is deterministic: steps of `budget` are used until nothing
    is gained. Equal segments may become different."""
    frame, items = flatten(solution, problem, machine)
    try:
        items = _exhausted(TrackedRun(frame, items, budget))
    except Illegal:
        return solution
    return settled(frame, items)


def settled(frame: FrameContext, items: list[Item], *, as_long: bool = False) -> Solution:
    """Return the solution of `items` if it is valid and shorter than the frame's solution, else the
    latter.

    With `as_long`, an equally long solution is returned too."""
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
    """Return the items after alternating sweeps and walks.

    The search ends with the budget or after PATIENCE walks without gain."""
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
    words = run.words() + 1
    while run.words() < words:
        words = run.words()
        shrink(run, PAIR_SPAN)
        _recolour(run)


def _recolour(run: TrackedRun) -> None:
    items = recoloured(run.frame, run.items)
    if items is not None and run.frame.total(items) < run.words():
        with suppress(Illegal):
            run.restart(items)
