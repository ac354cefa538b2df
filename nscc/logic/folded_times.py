"""Encoding of pairs of event times in too few planes for both: the pairs are folded into a square.

A rise time and a later fall time are a pair of points in time, and half of the planes hold each.
The cells (rise, fall) above the diagonal of the square hold all pairs of as many points as it has
rows. If a frame has more points, the pairs of the first points are moved to rows below the
diagonal. Most events are then still one cube, because cells without a shutter are don't-cares."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from nscc.logic.cubes import Budget, Encoding, cover
from nscc.logic.digits import binary_planes, gray
from nscc.logic.encodings import event_fields
from nscc.logic.problem import GaveUp, Machine, Problem

Cell = tuple[int, int]
"""A row and a column of the square."""

# Steps for the covers of all events; those of all bumps of 90 slots take half of them.
_COVER_STEPS = 20_000_000


def folded_times(problem: Problem, machine: Machine, budget: Budget) -> Encoding:
    """Return the encoding of shutters that have one rise and a later fall, or no event.

    A shutter that is open from the start rises at boundary 0. `budget` is not used; covers have a
    budget of their own. Raises GaveUp for other shutters, for more shutters than the square has
    cells, and where folding gains nothing: one time follows from the other, or each time has enough
    planes (contents of code registers) of its own."""
    events = event_fields(problem, 2)
    if [edge for edge, _, _ in events] != ["fall", "rise"]:
        raise GaveUp("the events are not one rise and one fall")
    boundaries = np.full((2, problem.shutters), -1, dtype=np.int64)
    for times, field in zip(boundaries, events.values(), strict=True):
        for demand, shutters in field:
            times[shutters] = problem.demands[demand].boundary
    falls, rises = boundaries
    rises[(rises < 0) & (falls >= 0)] = 0  # open from the start of the frame
    if np.any(rises >= falls, where=rises >= 0):
        raise GaveUp("some shutter does not rise before it falls")
    counts = [len(set(times.tolist())) for times in boundaries]
    if len(set(zip(*boundaries.tolist(), strict=True))) in counts:
        raise GaveUp("one time of each shutter follows from the other")
    if sum((count - 1).bit_length() for count in counts) < machine.registers:
        raise GaveUp("each time has planes of its own")
    # The rank of each boundary among those that occur; -1 (no event) is appended so that it always
    # has rank 0, and points begin at 0 after subtracting 1. The reversal puts rises before falls.
    _, points = np.unique(np.append(boundaries, -1), return_inverse=True)
    points_of_shutter = [*zip(*(points[:-1].reshape(2, -1)[::-1] - 1).tolist(), strict=True)]
    bits = (machine.registers - 1) // 2
    cells = np.array(_cells(points_of_shutter, 1 << bits))
    planes = []
    for name, numbers in zip(("row", "column"), cells.T, strict=True):
        planes += binary_planes(f"{name} of both times, Gray bit", gray(numbers), bits)
    covering = Budget(_COVER_STEPS)
    vectors = [plane for plane, _ in planes]
    cubes = tuple(
        tuple(cover(demand.predicate, vectors, problem.everything, covering))
        for demand in problem.demands
    )
    return Encoding("both event times folded into a square, Gray codes", planes, cubes)


def _cells(pairs: Sequence[tuple[int, int]], side: int) -> list[Cell]:
    """Return a cell (row, column) for each of `pairs` of points in time (start, stop), in order;
    (-1, -1) is the pair of a shutter without events.

    The square has `side` rows. Raises GaveUp if a pair finds no free cell. A frame of four slots
    has five points in time, one more than the rows of a square with two planes a side. The bump
    from 0 to 1 begins at the point without a row, so its cell is below the diagonal:

        >>> _cells([(0, 1), (1, 3), (2, 4), (0, 4)], side=4)
        [(3, 0), (0, 2), (1, 3), (3, 3)]
    """
    moved = max(0, max(stop for _, stop in pairs) + 1 - side)
    taken: dict[Cell, int] = {}
    # The first choice of a pair may be free because it is placed before pairs with several choices.
    for number in sorted(range(len(pairs)), key=lambda number: _order(*pairs[number], moved, side)):
        for cell in _choices(*pairs[number], moved, side):
            if cell not in taken and min(cell) >= 0:
                taken[cell] = number
                break
        else:
            raise GaveUp(f"no cell is left for a pair of times in {side} rows")
    return sorted(taken, key=taken.__getitem__)


def _order(start: int, stop: int, moved: int, side: int) -> tuple[bool, bool, bool]:
    """Return the sort key of a pair: pairs that have only one good cell come first. The arguments
    are those of `_choices`: the pair's points, the number of points without a row, and the rows."""
    return stop < moved, start < 0, 0 <= start < moved and stop - moved > side - 1 - start


def _choices(start: int, stop: int, moved: int, side: int) -> Iterator[Cell]:
    """Yield cells of the square for a bump from `start` to `stop`, best first; coordinates below 0
    mean that there is no such cell.

    The square has `side` rows. The first `moved` points in time have no row of their own, so their
    pairs go to cells below the diagonal that are otherwise empty. The last cells are all those on
    and below the diagonal, for pairs without a good cell."""
    row, column = side - 1 - start, stop - moved
    if start >= moved:
        yield start - moved, column  # above the diagonal
    elif 0 <= column <= row:
        yield row, column
    elif column > row:
        yield from ((column - moved, left) for left in range(start, column - moved + 1))
    elif start >= 0:  # two moved points: the cell is free if few bumps are that long
        yield row, side - 1 - stop
        yield from ((row - 2 * moved, left) for left in range(stop, row - 2 * moved + 1))
    yield from ((below, left) for below in range(side) for left in range(below + 1))
