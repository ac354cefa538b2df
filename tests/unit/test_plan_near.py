"""Which pixels are found to be near saturation, beside sums over neighbours in numpy."""

from __future__ import annotations

import numpy as np
import pytest

from nscc_runtime.planner.near_loop import Asked, may_saturate


@pytest.mark.parametrize("shape", [(1, 1), (1, 6), (5, 1), (2, 2), (7, 19)])
def test_neighbours_give_a_part_and_the_border_gets_less(shape: tuple[int, int]) -> None:
    rng = np.random.default_rng(sum(shape))
    total, current = rng.uniform(0.0, 9.0, shape), rng.uniform(0.0, 3.0, shape)
    scale, lanes = rng.uniform(0.5, 2.0, shape), rng.integers(0, 3, shape).astype(np.int32)
    limit, fraction, frame_s = np.array([4.0, 9.0, np.inf]), 0.05, 0.5
    found, inflow = np.empty(shape, np.uint8), np.empty(shape)
    may_saturate(
        asked=Asked(rows=shape[0], cols=shape[1], fraction=fraction, frame_s=frame_s),
        total=total, scale=scale, current=current, lanes=lanes, limit=limit, found=found,
        inflow=inflow,
    )  # fmt: skip
    lit = total * scale
    framed = np.pad(lit, 1)
    beside = framed[:-2, 1:-1] + framed[2:, 1:-1] + framed[1:-1, :-2] + framed[1:-1, 2:]
    np.testing.assert_allclose(inflow, fraction * beside, rtol=1e-12, atol=1e-15)
    charge = lit + fraction * beside + current * frame_s
    np.testing.assert_array_equal(found, charge >= limit[lanes])
