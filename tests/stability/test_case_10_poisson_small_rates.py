"""Hard case 10: rate 1e-8 on 65536 pixels and 4096 slots: 2.68 events expected."""

from __future__ import annotations

import math

import numpy as np
import pytest
from drawn_counts import BOTH
from scipy.stats import poisson as law

from nscc_runtime.noise import key, poisson
from nscc_runtime.noise.poisson_law import poisson_exact

PIXELS = np.arange(65536)
SLOTS = 4096
EXPECTED = 65536 * SLOTS * 1e-8


@pytest.mark.parametrize("drawn", BOTH)
def test_case_10_rare_counts_are_right_if_slots_are_summed_first(drawn):
    rate = np.full(65536, SLOTS * 1e-8)
    seeds = 200
    events = sum(drawn(key(seed, 1), PIXELS, rate).sum() for seed in range(seeds))
    assert abs(events - seeds * EXPECTED) < 5 * math.sqrt(seeds * EXPECTED)


def test_case_10_rare_counts_are_right_slot_by_slot():
    rate = np.full(65536, 1e-8)
    events = sum(poisson(key(0, 1, group=slot), PIXELS, rate)[0].sum() for slot in range(SLOTS))
    assert 0 < events < EXPECTED + 5 * math.sqrt(EXPECTED)


@pytest.mark.parametrize("rate", [1e-12, 1e-11, 1e-8, 1e-4])
def test_case_10_the_chance_of_an_event_is_right_down_to_1e_12(rate):
    """Bisects the uniform number at which the count becomes 1."""
    chance = -math.expm1(-rate)
    steps = [0, 2**52 - 1]
    while steps[1] - steps[0] > 1:
        middle = sum(steps) // 2
        steps[poisson_exact((2 * middle + 1) * 2.0**-53, rate) > 0] = middle
    found = (2**52 - steps[1]) * 2.0**-52
    assert abs(found - chance) <= 2.0**-51
    assert abs(found / chance - 1) < 5e-4
    last = poisson_exact(1 - 2.0**-53, rate)
    assert law.sf(last, rate) <= 2.0**-52 < law.sf(last - 1, rate)
