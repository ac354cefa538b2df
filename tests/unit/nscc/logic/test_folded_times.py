"""Pairs of event times in a square, for any numbers of slots and registers, run as gates."""

from __future__ import annotations

import numpy as np
import pytest
from gates_oracle import asked_of
from improve_oracle import chip, words_of

from nscc.logic.cubes import Budget, emit
from nscc.logic.folded_times import folded_times
from nscc.logic.problem import GaveUp, Machine

SCAMP = chip()


def bumps(slots, longest=None, never=False):
    """All bumps up to a length, and if `never` a shutter that stays closed."""
    n = np.arange(slots)
    ends = [(a, b) for a in n for b in range(a + 1, slots + 1) if b - a <= (longest or slots)]
    return np.array([(a <= n) & (n < b) for a, b in ends] + [n < 0] * never)


def words(table, target):
    """Words of the gates, which are run for every shutter on pixels of the chip."""
    asked, machine = asked_of(table, "edges"), Machine.of(target)
    encoding = folded_times(asked, machine, Budget(0))
    return words_of(emit(asked, machine, encoding), asked, target)


@pytest.mark.parametrize("never", [False, True])
@pytest.mark.parametrize(("slots", "most"), [(65, 590), (66, 670), (72, 1210)])
def test_bumps_of_many_slots_take_few_words(slots, most, never):
    # `most` are recorded numbers of words. A shutter that never opens may cost 60 more.
    assert words(bumps(slots, never=never), SCAMP) <= most + 60 * never


@pytest.mark.parametrize(("slots", "longest"), [(65, 20), (100, 20), (110, 33)])
def test_bumps_of_limited_length_fold_in_longer_frames(slots, longest):
    # Fifty words a slot.
    assert words(bumps(slots, longest), SCAMP) <= 50 * slots


@pytest.mark.parametrize("registers", [5, 7, 9])
def test_bumps_fold_exactly_if_the_square_has_a_cell_for_each_bump(registers):
    side = 1 << (registers - 1) // 2
    target = chip(registers, masked=False, or_sources=3, where_sources=2)
    for slots in range(side + 1, 2 * side):
        table = bumps(slots)
        if len(table) <= side * side:
            words(table, target)
        else:
            with pytest.raises(GaveUp, match="no cell is left"):
                words(table, target)


@pytest.mark.parametrize(
    "table",
    [
        np.arange(8) < np.arange(1, 9)[:, None],  # only falls
        np.eye(9, dtype=bool)[:, :8],  # the fall follows from the rise
        np.array([[1, 0, 1, 0], [0, 1, 0, 0], [0, 0, 1, 1]], dtype=bool),  # opens twice
        bumps(16),  # both times have planes
    ],
)
def test_other_shutters_are_refused(table):
    with pytest.raises(GaveUp):
        words(table, SCAMP)
