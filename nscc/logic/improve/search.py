"""The passes over a finished solution, in turn for as long as they gain and steps are left."""

from __future__ import annotations

from itertools import count

from nscc.logic.cubes import Budget
from nscc.logic.improve.code import Frame, Illegal, Item, flatten, states_before, unflatten
from nscc.logic.improve.kernels import improve_kernels
from nscc.logic.improve.recolour import recoloured
from nscc.logic.improve.run import Run
from nscc.logic.improve.shrink import drop_pairs, drop_singles
from nscc.logic.improve.wander import wander
from nscc.logic.problem import GaveUp, Machine, Problem, Solution

# Operations this far apart are dropped together: what belongs together lies within an answer or in
# the next one.
PAIR_SPAN = 8
# Steps of one walk, half a second; after it the sweeps follow.
WALK_STEPS = 50_000
# So many walks in vain are the last.
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
    """A solution of the same problem in as many words a frame or fewer.

    The encoding stays as it is. Steps of `budget` are taken until nothing seems left to gain; the
    same input gives the same result. Segments that were equal may no longer be so, and then share
    no kernel. With `keep_kernels` they stay equal: kernels are rewritten in all places alike, and
    sequences of kernels that come again are rewritten as one while all distinct segments together
    take no more than `room` words.
    """
    try:
        frame, items = flatten(solution, problem, machine)
        states_before(frame, items)
    except Illegal:
        return solution
    if keep_kernels:
        items = _kernels(frame, items, budget, room)
    else:
        search = _Search(frame, items, budget)
        search.exhaust(WALK_STEPS, patience=PATIENCE)
        items = search.run.items
    return settled(solution, problem, machine, frame, items)


def _kernels(frame: Frame, items: list[Item], budget: Budget, room: int) -> list[Item]:
    """Kernels made shorter until that gains nothing: what is shorter leaves room for more."""
    words = frame.total(items) + 1
    while frame.total(items) < words and budget.left > 0:
        words = frame.total(items)
        items = improve_kernels(frame, items, budget, _kernel, room)
    return items


def _kernel(frame: Frame, items: list[Item], budget: Budget) -> list[Item]:
    """Shorter items, found by sweeps and a short walk."""
    search = _Search(frame, items, budget)
    search.exhaust(KERNEL_STEPS, patience=1)
    return search.run.items


def settled(
    solution: Solution,
    problem: Problem,
    machine: Machine,
    frame: Frame,
    items: list[Item],
    *,
    as_long: bool = False,
) -> Solution:
    """`items` as a solution if they are one and take fewer words than `solution` (`as_long`: or as
    many), which otherwise comes back itself."""
    try:
        found = unflatten(frame, items)
        checked, again = flatten(found, problem, machine)
        states_before(checked, again)
    except Illegal:
        return solution
    before, gates = flatten(solution, problem, machine)
    gain = before.total(gates) - checked.total(again)
    return found if gain > 0 or (as_long and gain == 0) else solution


class _Search:
    """The run as it gets shorter."""

    def __init__(self, frame: Frame, items: list[Item], budget: Budget) -> None:
        self.frame = frame
        self.budget = budget
        self.run = Run(frame, items, budget)

    def exhaust(self, steps: int, *, patience: int) -> None:
        """Sweeps until they gain nothing, then walks of so many steps and sweeps, until no step is
        left or `patience` walks gained nothing."""
        try:
            self._sweep()
            idle = 0
            for seed in count():
                gained = wander(self.run, seed, steps)
                words = self.run.words()
                self._sweep()
                idle = 0 if gained or self.run.words() < words else idle + 1
                if idle == patience:
                    return
        except GaveUp:
            self._recolour()

    def _sweep(self) -> None:
        words = self.run.words()
        while True:
            drop_singles(self.run)
            drop_pairs(self.run, PAIR_SPAN)
            self._recolour()
            now = self.run.words()
            if now >= words:
                return
            words = now

    def _recolour(self) -> None:
        items = recoloured(self.frame, self.run.items)
        if items is None or self.frame.total(items) >= self.run.words():
            return
        try:
            self.run = Run(self.frame, items, self.budget)
        except Illegal:
            return
