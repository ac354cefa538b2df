"""Random programs, scenes, sensors and tolerances: every promise of every plan holds."""

from __future__ import annotations

import numpy as np
import pytest
from random_sensors import Draw, promises


def check(found: list[Draw]) -> None:
    assert [each.said for each in found if each.found.broken] == []
    judged = [each.found for each in found if each.found.counts]
    ratio = np.median([each.plan.predicted_e / each.err for each in judged])
    assert 0.85 < ratio < 1.15


@pytest.mark.parametrize("seed", [0, 1, 2])
def test_some_promises(seed: int) -> None:
    check(promises(seed, plans=3, side=32))


@pytest.mark.slow
def test_a_thousand_promises() -> None:
    check([each for seed in range(250) for each in promises(seed)])
