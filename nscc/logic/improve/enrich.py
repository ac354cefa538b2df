"""Use of free registers for values that the host loads before the frame.

A plane that no word writes costs only its refresh, and can be in the masked register. So a free
register can hold any truth vector from the start."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import chain

from nscc.logic.cubes import Budget
from nscc.logic.improve.code import (
    REFRESH_WORDS,
    GateOp,
    Illegal,
    flatten,
    states_before,
    unflatten,
)
from nscc.logic.improve.recolour import recoloured
from nscc.logic.improve.rewrite import shrink
from nscc.logic.improve.tracked_run import TrackedRun
from nscc.logic.problem import GaveUp, Machine, Problem, Solution

# Number of promising vectors to try for each register; each try is a search.
TRIED = 12
# Most distance of operations dropped together, smaller than in `search`, which runs afterwards.
NEAR = 3
HOLDER = "computed before the frame"


def enrich(solution: Solution, problem: Problem, machine: Machine, budget: Budget) -> Solution:
    """Return a solution with more planes and fewer words; `solution` if none is found."""
    with suppress(GaveUp, Illegal):
        while (richer := _richer(solution, problem, machine, budget)) is not None:
            solution = richer
    return solution


def _richer(
    solution: Solution, problem: Problem, machine: Machine, budget: Budget
) -> Solution | None:
    """Return the best solution with one more plane; None if it is not better."""
    slim = _with_room(solution, problem, machine)
    if slim is None:
        return None
    frame, items = flatten(solution, problem, machine)
    run = TrackedRun(frame, items, budget)
    best: Solution | None = None
    least = run.words()
    for vector in _promising(run)[:TRIED]:
        planes = (*slim.planes, vector)
        wider = replace(slim, planes=planes, holders=(*slim.holders, HOLDER))
        try:
            run = TrackedRun(*flatten(wider, problem, machine), budget)
            shrink(run, NEAR)
            shorter = unflatten(run.frame, run.items)
            frame, items = flatten(shorter, problem, machine)
            states_before(frame, items)
        except GaveUp:
            break
        except Illegal:
            continue
        if frame.total(items) < least:
            best, least = shorter, frame.total(items)
    return best


def _with_room(solution: Solution, problem: Problem, machine: Machine) -> Solution | None:
    """Return the solution with a free register, obtained by recolouring if necessary; None if
    impossible."""
    used = len(solution.planes) + solution.states + solution.scratch
    if used < machine.registers:
        return solution
    least = 1 if machine.masked or solution.state_in_flag else 0
    if solution.scratch <= least:
        return None
    frame, items = flatten(solution, problem, machine)
    items = TrackedRun(frame, items, Budget(1)).items
    narrow = recoloured(frame, items, 1 << (frame.flag - 1))
    return None if narrow is None else unflatten(frame, narrow)


def _promising(run: TrackedRun) -> list[int]:
    """Return truth vectors that would save words if loaded before the frame, most words first."""
    frame = run.frame
    # The items that write each vector, the items whose values each item reads, and the number of
    # readers of each item. A plane that holds an item's value at the end counts as a reader.
    makers: dict[int, list[int]] = {}
    feeds: list[set[int]] = []
    writer = [-1] * (frame.flag + 1)
    for k, item in enumerate(run.items):
        read = item.sources if isinstance(item, GateOp) else (frame.flag,) * (item.need is not None)
        feeds.append({writer[r] for r in read if writer[r] >= 0})
        if isinstance(item, GateOp):
            value = run.before[k + 1][item.destination]
            assert value is not None
            makers.setdefault(value, []).append(k)
            writer[item.destination] = k
    readers = Counter(chain.from_iterable(feeds))
    readers.update(writer[r] for r in range(frame.planes) if writer[r] >= 0)
    stored = set(frame.start[: frame.planes])
    gains = {
        v: _saved(run, numbers, feeds, readers) for v, numbers in makers.items() if v not in stored
    }
    worth = [vector for vector, gain in gains.items() if gain > REFRESH_WORDS]
    return sorted(worth, key=lambda vector: -gains[vector])


def _saved(
    run: TrackedRun, numbers: Sequence[int], feeds: Sequence[set[int]], readers: Mapping[int, int]
) -> int:
    """Return the words of items that become unused if their results are available elsewhere.

    This is the fan-out-free cone of the items."""
    readers_left: dict[int, int] = {}
    # FLAG must be loaded in any case.
    written = [item.destination for k in numbers if isinstance(item := run.items[k], GateOp)]
    saved = -written.count(run.frame.flag)
    gone = list(numbers)
    visited = set(gone)
    while gone:
        k = gone.pop()
        saved += run.frame.words(run.items[k])
        for source in feeds[k]:
            readers_left[source] = readers_left.get(source, readers[source]) - 1
            if readers_left[source] == 0 and source not in visited:
                visited.add(source)
                gone.append(source)
    return saved
