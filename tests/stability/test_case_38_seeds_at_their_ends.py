"""Hard case 38: seeds of any size name frames of their own, and the same seed the same frame."""

from __future__ import annotations

import numpy as np
import pytest
from reference_programs import STOPS, flat, program, sensor_of

from nscc.diagnostics.diagnostic import Rejected
from nscc_runtime import capture

ROWS, COLS = 8, 20
SEEDS = (0, 1, 2**31 - 1, 2**31, 2**32 - 1, 2**32, 2**63 - 1)


@pytest.mark.parametrize("which", ["seed", "device_seed"])
@pytest.mark.parametrize("fidelity", ["planned", "reference"])
def test_case_38_frames_of_all_seeds_differ(which: str, fidelity: str) -> None:
    container = program(STOPS, "edges", ROWS, COLS)
    taken = {}
    for seed in SEEDS:
        options = {"sensor": sensor_of(container), "effects": "all", "fidelity": fidelity}
        first, again = (
            capture(container, flat(3000, ROWS, COLS), **options, **{which: seed}) for _ in range(2)
        )
        assert np.array_equal(first.exposure_e, again.exposure_e)
        taken[seed] = first.exposure_e
    found = list(taken.values())
    for i, one in enumerate(found):
        for other in found[i + 1 :]:
            assert (one != other)[:, :, np.arange(COLS) % 5 > 0].mean() > 0.9


@pytest.mark.parametrize("seed", [-1, 2**200, 1.5, float("nan")])
def test_case_38_invalid_seeds_are_refused(seed: float) -> None:
    container = program(STOPS, "edges", ROWS, COLS)
    with pytest.raises((Rejected, TypeError)) as refused:
        capture(container, flat(3000, ROWS, COLS), effects="all", seed=seed)  # type: ignore[arg-type]
    assert "seed" in str(refused.value)
