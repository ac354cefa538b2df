"""Random programs, scenes, sensors and tolerances: every promise of every plan holds."""

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


def test_random_plans_keep_their_promise() -> None:
    check([each for seed in range(3) for each in promises(seed, plans=3, side=32)])


def test_pixels_at_the_edge_of_a_full_well_are_foreseen() -> None:
    """A sun beside whose neighbours one pixel is at the edge, and the worst of the frame by far."""
    assert [each.said for each in promises(95130) if not each.found.kept] == []


@pytest.mark.slow
def test_a_thousand_random_promises_hold() -> None:
    check([each for seed in range(250) for each in promises(seed)])
