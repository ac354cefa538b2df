"""The emulator's frames agree with public frames of a chip, by the same estimators."""

from __future__ import annotations

import json
import sys

import pytest
from checkout import ROOT

BENCHMARKS = ROOT / "tests" / "benchmarks"
sys.path.insert(0, str(BENCHMARKS))

from bench_silicon import CHIP, emulated  # noqa: E402

WITHIN = {
    "white part, codes^2": 0.2,
    "temporal std at zero, codes": 0.15,
    "fixed pattern of pixels, codes": 0.25,
    "fixed pattern in all, codes": 0.25,
    "frame level, codes": 0.3,
    "last step, codes": 0.1,
    "mean of the square, codes": 0.03,
}
"""Relative differences that are allowed."""


@pytest.fixture(scope="module")
def found() -> dict[str, float]:
    return {name: value for name, (value, _) in emulated(48, {}).items()}


@pytest.mark.parametrize("name", WITHIN)
def test_measured_properties_of_emulated_frames_are_near_those_of_the_chip(
    found: dict[str, float], name: str
) -> None:
    value, _ = json.loads(CHIP.read_text())[name]
    assert found[name] == pytest.approx(value, rel=WITHIN[name])


def test_taps_grow_and_codes_are_clipped_as_on_the_chip(found: dict[str, float]) -> None:
    assert 0.020 < found["growth a step, regression"] < 0.038
    assert 0.020 < found["clipped low"] + found["clipped high"] < 0.035
    assert -0.4 < found["correlation down columns, lag 1"] < -0.2
    assert found["clipped low"] < found["clipped high"]


def test_frames_without_pattern_level_column_noise_and_gain_lack_the_errors_of_the_chip() -> None:
    ideal = {
        "adc_pattern_lsb": 0.0,
        "adc_smooth_lsb": 0.0,
        "adc_level_lsb": 0.0,
        "adc_column_strength": 0.0,
        "analog_gain": 1.0,
    }
    found = {name: value for name, (value, _) in emulated(24, ideal).items()}
    assert found["fixed pattern in all, codes"] < 0.3
    assert found["frame level, codes"] < 0.05
    assert abs(found["correlation down columns, lag 1"]) < 0.02
    assert abs(found["growth a step, regression"]) < 0.005
