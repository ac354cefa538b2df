"""Hard case 28: a float32 uniform number from 32 random bits lies strictly inside (0, 1)."""

from __future__ import annotations

import numpy as np
import pytest

from nscc_runtime.loop import compiled, inlined

_SHIFT_23 = np.uint64(9)


@inlined
def unit32(random: np.uint32) -> np.float32:
    """The odd multiple of 2**-24 inside (0, 1) that the upper 23 of 32 bits pick, in float32."""
    index = np.float32(np.int32(np.uint64(random) >> _SHIFT_23))
    return (index + np.float32(0.5)) * np.float32(2.0**-23)


@compiled
def _all(first, out):
    for i in range(len(out)):
        out[i] = unit32(np.uint32(first + 256 * i))


@pytest.mark.parametrize("lowest", [0, 255], ids=["low bits 0", "low bits 1"])
def test_case_28_all_2_to_the_24_numbers_are_evenly_spread_inside_0_and_1(lowest):
    found = np.empty(2**24, np.float32)
    _all(lowest, found)
    assert found.min() == np.float32(2.0**-24)
    assert found.max() == np.float32(1) - np.float32(2.0**-24)
    assert np.isfinite(np.log(found)).all()
    steps = found.astype(np.float64) * 2.0**24
    # In order, evenly spread, and each number as often as every other.
    assert np.array_equal(steps, 2.0 * (np.arange(2**24) // 2) + 1)
