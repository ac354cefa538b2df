"""The experiment on a chip's assumed facts: what it says of a chip that does as assumed, or not."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from neighbour_facts import emulated, experiment, measured, verdict
from nscc.chips.load import builtin_target
from nscc_runtime.frame_file import Frame

TARGET = builtin_target("scamp5")


def frame() -> Frame:
    (found,) = emulated(experiment(TARGET, 3000.0), "builtin:hdr")
    return found


def test_the_emulator_keeps_the_documented_facts_of_neighbours() -> None:
    ratios = measured([frame()], TARGET.full_well_e)
    assert {name: round(ratio.value, 9) for name, ratio in ratios.items()} == {
        "half": 0.5,
        "divided": 0.5,
        "first": 1.0,
        "second": 1.0,
        "third": 1.0,
    }
    assert "news_read_keeps = true" in verdict(ratios)


def test_a_chip_whose_reads_empty_news_is_found_out() -> None:
    kept = frame()
    lost = {**kept.told, "image_third": np.full_like(kept.told["image_third"], 40.0)}
    ratios = measured([replace(kept, told=lost)], TARGET.full_well_e)
    assert "news_read_keeps = false" in verdict(ratios)
