"""Errors of plans stay within the tolerance for random programs, scenes and sensors."""

from __future__ import annotations

import numpy as np
import pytest
from random_sensors import Draw, promises

pytestmark = pytest.mark.filterwarnings("ignore:warning.NS0793")


def check(found: list[Draw]) -> None:
    assert [each.said for each in found if not each.found.kept] == []
    judged = [each.found for each in found if each.found.counts]
    ratio = np.median([each.plan.predicted_e / each.err for each in judged])
    assert 0.85 < ratio < 1.15


def test_errors_of_random_plans_stay_within_the_tolerance() -> None:
    check([each for seed in range(3) for each in promises(seed, plans=3, side=32)])


def test_plans_account_for_a_pixel_that_almost_fills_its_well_beside_a_sun() -> None:
    """The scene has a sun. One pixel near it almost fills its well, and has by far the largest
    error of the frame."""
    assert [each.said for each in promises(95130) if not each.found.kept] == []


@pytest.mark.slow
def test_errors_of_a_thousand_random_plans_stay_within_the_tolerance() -> None:
    check([each for seed in range(250) for each in promises(seed)])
