"""Moving of work to earlier boundaries, because the boundary with most words limits the
slot time."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import islice

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
)
from nscc.logic.improve.rewrite import Rewrite, Rewriter
from nscc.logic.improve.search import settled
from nscc.logic.improve.tracked_run import TrackedRun
from nscc.logic.problem import GaveUp, Machine, Problem, Solution

# How many answers a gate may move forward; its value needs a register in between.
REACH = 6


def balance(
    solution: Solution,
    problem: Problem,
    machine: Machine,
    budget: Budget,
    other_words: Sequence[int],
) -> Solution:
    """Move gates to earlier boundaries without adding words to the frame.

    `other_words` are the words at each boundary 0..N besides the solution's gates. The words of the
    largest boundary decrease. Returns `solution` if no gate can move."""
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
    if max(loads.words) >= max(loads.counted(items)):
        return solution
    return settled(frame, run.items, as_long=True)


def words_at(solution: Solution, problem: Problem, machine: Machine, slots: int) -> list[int]:
    """Return the words of a solution's gates at each boundary 0..slots."""
    frame, items = flatten(solution, problem, machine)
    return _Loads(frame, items, [0] * (slots + 1)).words


class _Loads:
    """The number of words at each boundary."""

    def __init__(
        self, frame: FrameContext, items: Sequence[Item], other_words: Sequence[int]
    ) -> None:
        self._frame = frame
        self._boundaries = [demand.boundary for demand in frame.problem.demands]
        self._other_words = other_words
        self.words = self.counted(items)

    def boundary(self, place: int) -> int:
        """Return the boundary of a place."""
        if place == OPENING:
            return 0
        return len(self._other_words) - 1 if place == CLOSING else self._boundaries[place]

    def counted(self, items: Sequence[Item]) -> list[int]:
        """Return the words at each boundary for these items."""
        words = list(self._other_words)
        for item in items:
            words[self.boundary(item.place)] += self._frame.words(item)
        return words


def _relieve(run: TrackedRun, loads: _Loads, boundary: int, most: int) -> bool:
    for k, item in enumerate(run.items):
        if isinstance(item, Check) or loads.boundary(item.place) != boundary:
            continue
        if item.destination in (run.frame.flag, run.frame.masked):
            continue
        for start, place, segment in _earlier(run, k, loads, most):
            for target in (item.destination, *run.free(start, {item.destination})):
                moved = replace(item, destination=target, place=place, segment=segment)
                rewriting = Rewriter(run, start, least=0).rewrite((moved,), (k,))
                if rewriting is not None and _take(run, loads, rewriting, boundary, most):
                    return True
    return False


def _earlier(run: TrackedRun, k: int, loads: _Loads, most: int) -> list[tuple[int, int, int]]:
    """Return (item, place, segment) at the ends of earlier answers with room for another word."""
    places = []
    own_boundary = loads.boundary(run.items[k].place)
    checks = (at for at in range(k - 1, -1, -1) if isinstance(run.items[at], Check))
    for at in islice(checks, REACH):
        item = run.items[at]
        boundary = loads.boundary(item.place)
        if boundary == own_boundary or loads.words[boundary] + 1 >= most:
            continue
        before = run.items[at - 1] if at else item
        segment = before.segment if isinstance(before, GateOp) else 0
        places.append((at, item.place, segment))
    return places


def _take(run: TrackedRun, loads: _Loads, rewriting: Rewrite, boundary: int, most: int) -> bool:
    """Apply a rewriting if the boundary then has fewer than `most` words and no other reaches
    `most`."""
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
