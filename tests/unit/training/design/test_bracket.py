"""An ordinary bracket in one exposure time: its readouts, and their merging."""

from __future__ import annotations

import numpy as np
import pytest

from nscc.chips.load import builtin_target
from nscc_runtime.sensor import default_sensor
from nscc_training.design.bracket import bracket_slots, camera, merged_bracket
from nscc_training.design.chip import DesignChip


@pytest.mark.parametrize("slots", [3, 16, 256, 4096])
def test_readouts_fill_the_frame_and_the_shortest_is_first(slots: int) -> None:
    """The lengths of the readouts ascend and sum to the slots. For 256 slots they are 4, 36 and
    216, one after the other."""
    lengths = bracket_slots(slots)
    assert sum(lengths) == slots
    assert min(lengths) >= 1
    assert sorted(lengths) == list(lengths)
    if slots == 256:
        assert lengths == (4, 36, 216)
        shutters = camera(slots, 125.0, lengths=lengths).table.shutters[0]
        assert shutters.sum(axis=1).tolist() == [4, 36, 216]
        assert (shutters.sum(axis=0) == 1).all()
        assert shutters.argmax(axis=1).tolist() == [0, 4, 40]


def test_merging_takes_the_most_precise_readouts_that_are_not_saturated() -> None:
    target = builtin_target("scamp5")
    chip = DesignChip.of(target, default_sensor(target))
    light = np.geomspace(100, 4e6, 30 * 400).reshape(30, 400)
    share = np.array([4, 36, 216]) / 256
    generator = np.random.default_rng(1)
    clean = light * share.reshape(-1, 1, 1)
    noisy = chip.gain * generator.normal(clean, chip.exposed_sd_e(clean))
    saturated = clean > 0.8 * chip.full_e
    merged = merged_bracket(noisy, share, saturated, chip)
    spread = chip.exposed_sd_e(clean) / share.reshape(-1, 1, 1)
    # Precisions (1 / variance) of independent readouts add up.
    ideal = 1 / np.sqrt(np.where(saturated, 0, spread**-2.0).sum(axis=0).clip(min=1e-30))
    known = ~saturated.all(axis=0)
    errors = ((merged - light) / ideal)[known]
    assert errors.mean() == pytest.approx(0, abs=0.05)
    assert errors.std() == pytest.approx(1, abs=0.1)
    full = saturated.all(axis=0)
    assert full.any()
    np.testing.assert_allclose(merged[full], (noisy[0] / share[0] / chip.gain)[full])
