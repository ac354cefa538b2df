"""Hard case 35: places that no mask opens divide nothing by zero, in any iterative decoder."""

from __future__ import annotations

import numpy as np
import pytest

pytest.importorskip("torch")

from nscc_training.baselines.sci import admm_tv, gap_tv

FRAMES, SIZE = 4, 24


@pytest.mark.parametrize("decode", [gap_tv, admm_tv])
@pytest.mark.parametrize("where", ["a hole", "everywhere"])
def test_case_35_decoders_return_finite_values_for_masks_of_zeros(decode, where: str) -> None:
    rng = np.random.default_rng(5)
    mask = rng.integers(0, 2, (FRAMES, SIZE, SIZE)).astype(np.float32)
    if where == "everywhere":
        mask[:] = 0
    else:
        mask[:, 8:12, 8:12] = 0
    clip = rng.uniform(0, 255, (FRAMES, SIZE, SIZE)).astype(np.float32)
    measurement = (mask * clip).sum(axis=0)
    with np.errstate(all="raise", under="ignore"):
        found = decode(measurement, mask, 10)
    assert np.isfinite(found).all()
    assert np.abs(found).max() < 1000
    # Without an open pixel the only right answer is 0.
    if where == "everywhere":
        assert not found.any(), "nothing was seen"
