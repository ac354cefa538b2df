"""A random walk among solutions of equal cost, in search of a cheaper one nearby.

Every step drops one to three operations, or moves one, and keeps the repaired result unless it
costs more words. The random sequence is fixed.

Most changes save nothing, but they move values to other registers and times, so that another point
of the plateau may have a cheaper neighbour. Costlier neighbours are never accepted."""

from __future__ import annotations

import random
from dataclasses import replace

from nscc.logic.improve.code import Check, GateOp
from nscc.logic.improve.rewrite import Rewrite, rewrite
from nscc.logic.improve.tracked_run import TrackedRun

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
        start = _earlier(run, k, choose)
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
    rewriting = rewrite(run, start, lead, dropped, least=0, deepen=True, order=order)
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


def _earlier(run: TrackedRun, k: int, choose: random.Random) -> int:
    """Return a random place before k in the same answer."""
    low = k
    while low > 0 and k - low < SPAN and not isinstance(run.items[low - 1], Check):
        low -= 1
    return choose.randrange(low, k + 1)
