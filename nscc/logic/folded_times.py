"""Encoding of pairs of event times in too few planes for both: the pairs are folded into a square.

A rise time and a later fall time are a pair of points in time, and half of the planes hold each.
The cells (rise, fall) above the diagonal of the square hold all pairs of as many points as it has
rows. If a frame has more points, the pairs of the first points are moved to rows below the
diagonal. Most events are then still one cube, because cells without a shutter are don't-cares.
Pairs without a cell of their own go to free cells beside others of the same rise or fall, which
joins their cubes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from nscc.arrays import Ints
from nscc.logic.cubes import Budget, Encoding, cover
from nscc.logic.digits import binary_planes, gray
from nscc.logic.encodings import event_fields
from nscc.logic.problem import GaveUp, Machine, Problem

# A free cell is better by _FREE for each free neighbour, because cubes may contain both, and worse
# by _FAR for each plane that differs from the pair's own row and column, because cubes then need
# inversions. A neighbour with the same rise or fall counts 1. The weights are empirical.
_FREE, _FAR = 0.2, 0.3

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
    halves = np.divmod(_codes(points_of_shutter, 1 << bits), 1 << bits)
    planes = []
    for name, numbers in zip(("row", "column"), halves, strict=True):
        planes += binary_planes(f"{name} of both times, Gray bit", numbers, bits)
    covering = Budget(_COVER_STEPS)
    vectors = [plane for plane, _ in planes]
    cubes = tuple(
        tuple(cover(demand.predicate, vectors, problem.everything, covering))
        for demand in problem.demands
    )
    return Encoding("both event times folded into a square, Gray codes", planes, cubes)


def _codes(pairs: Sequence[tuple[int, int]], side: int) -> Ints:
    """Return the code of the cell of each of `pairs` of points in time (start, stop): `side` times
    the Gray code of the row, plus that of the column. (-1, -1) is the pair of a shutter without
    events.

    The square has `side` rows. Raises GaveUp if a pair finds no free cell. A frame of four slots
    has five points in time, one more than the rows of a square with two planes a side. The bump
    from 0 to 1 begins at the point without a row, so its cell is below the diagonal, in row 3 and
    column 0:

        >>> [divmod(code, 4) for code in _codes([(0, 1), (1, 3), (2, 4)], side=4).tolist()]
        [(2, 0), (0, 3), (1, 2)]
    """
    # The first `moved` points in time have no row of their own. Their pairs go to cells below the
    # diagonal, which are otherwise empty: one row for each point.
    moved = max(0, max(stop for _, stop in pairs) + 1 - side)
    grays = gray(np.arange(side))
    # The code of each pair, -1 if it has none yet; the pair in each cell, -2 if the cell is free.
    codes = np.full(len(pairs), -1, dtype=np.int64)
    starts, stops = np.full((2, side * side), -2)

    def place(number: int, code: int) -> None:
        """Put the pair with this number into the cell with this code."""
        codes[number] = code
        starts[code], stops[code] = pairs[number]

    for number, (start, stop) in enumerate(pairs):
        row, column = start - moved, stop - moved
        if row >= 0 or 0 <= column < side - start <= side:
            place(number, grays[row if row >= 0 else side - 1 - start] * side + grays[column])
    rows, columns = np.tril_indices(side)
    lower = grays[rows] * side + grays[columns]
    # The row of a start has room for two moved points if no bump is that long.
    for number, (start, stop) in enumerate(pairs):
        if 0 <= start < stop < min(moved, side):
            code = grays[side - 1 - start] * side + grays[side - 1 - stop]
            if starts[code] == -2:
                place(number, code)
    neighbours = lower[:, None] ^ 1 << np.arange(int(side * side - 1).bit_length())
    homeless = [number for number, code in enumerate(codes) if code < 0]
    # Late starts have the fewest good cells, and pairs of two moved points come last.
    for number in sorted(homeless, key=lambda i: (pairs[i][1] < moved, *(-x for x in pairs[i]))):
        start, stop = pairs[number]
        row, column = side - 1 - start, side - 1 - stop if stop < moved else stop - moved
        own = grays[row % side] * side + grays[column % side]
        free = np.flatnonzero(starts[lower] == -2)
        if not len(free):
            raise GaveUp(f"no cell is left for a pair of times in {side} rows")
        beside = neighbours[free]
        score = (starts[beside] == start).sum(axis=1) + (stops[beside] == stop).sum(axis=1)
        score = score + _FREE * (starts[beside] == -2).sum(axis=1)
        score -= _FAR * np.bitwise_count(lower[free] ^ own)
        place(number, lower[free[score.argmax()]])
    return codes
