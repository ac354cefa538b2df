"""Repetition of the improvement passes, while they save words and steps are left."""

from __future__ import annotations

from contextlib import suppress
from itertools import count

from nscc.logic.cubes import Budget
from nscc.logic.improve.code import FrameContext, Illegal, Item, flatten, states_before, unflatten
from nscc.logic.improve.kernels import improve_kernels
from nscc.logic.improve.recolour import recoloured
from nscc.logic.improve.shrink import shrink
from nscc.logic.improve.tracked_run import TrackedRun
from nscc.logic.improve.wander import wander
from nscc.logic.problem import GaveUp, Machine, Problem, Solution

# Most distance of operations dropped together: they belong to one answer or to two consecutive
# ones.
PAIR_SPAN = 8
# Steps of one walk, half a second, before the next sweeps.
WALK_STEPS = 50_000
# Number of consecutive walks without improvement after which the search ends.
PATIENCE = 6
# Steps of a walk over one kernel.
KERNEL_STEPS = 2_000


def improve(
    solution: Solution,
    problem: Problem,
    machine: Machine,
    budget: Budget,
    *,
    keep_kernels: bool = False,
    room: int = 0,
) -> Solution:
    """Return a solution of the same problem with at most as many words per frame.

    The encoding is unchanged. The result is deterministic: steps of `budget` are used until nothing
    is gained. Equal segments may become different. With `keep_kernels` they stay equal: kernels are
    rewritten in all places, and repeated sequences of kernels together while all distinct segments
    take at most `room` words."""
    frame, items = flatten(solution, problem, machine)
    try:
        if keep_kernels:
            items = _kernels(frame, items, budget, room)
        else:
            items = _exhausted(TrackedRun(frame, items, budget), WALK_STEPS, PATIENCE)
    except Illegal:
        return solution
    return settled(frame, items)


def _kernels(frame: FrameContext, items: list[Item], budget: Budget, room: int) -> list[Item]:
    """Shorten kernels until nothing is gained, because shorter kernels leave more room."""
    words = frame.total(items) + 1
    while frame.total(items) < words and budget.left > 0:
        words = frame.total(items)
        items = improve_kernels(frame, items, budget, _kernel, room)
    return items


def _kernel(frame: FrameContext, items: list[Item], budget: Budget) -> list[Item]:
    """Shorten the items of one kernel by sweeps and a short walk."""
    return _exhausted(TrackedRun(frame, items, budget), KERNEL_STEPS, patience=1)


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


def _exhausted(run: TrackedRun, steps: int, patience: int) -> list[Item]:
    """Return the items after alternating sweeps and walks of `steps` steps.

    The search ends with the budget or after `patience` walks without gain."""
    try:
        _sweep(run)
        idle = 0
        for seed in count():
            gained = wander(run, seed, steps)
            words = run.words()
            _sweep(run)
            idle = 0 if gained or run.words() < words else idle + 1
            if idle == patience:
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
