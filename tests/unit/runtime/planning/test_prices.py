"""What this machine takes beside what plans are chosen by; it enters no product."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from nscc_command import invoke
from plan_cases import CASES, case
from reference_programs import sensor_of

from nscc_runtime.effects import everything
from nscc_runtime.effects.parts import Leak
from nscc_runtime.light import Light
from nscc_runtime.planning import measure_prices
from nscc_runtime.planning.measure_prices import Price
from nscc_runtime.planning.planned_scene import PlannedScene
from nscc_runtime.planning.prices import Work

FOUND = [Price("sums", "a pixel", "ns", 137.5, 100.0)]


def test_effects_cost_shows_measured_prices(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """`nscc effects --cost` shows the prices measured here and those shipped. Beside `--toml` it is
    refused."""
    monkeypatch.setattr(measure_prices, "measure_prices", lambda: FOUND)
    shown = invoke(["effects", "--cost"], tmp_path).out
    assert "137.5" in shown
    assert "100" in shown
    assert "comparator_noise" in shown
    assert invoke(["effects", "--cost", "--toml"], tmp_path).status == 2


@pytest.mark.slow
def test_measuring_finds_prices_of_every_way() -> None:
    """Every way of exposing has a price above 0. Effects of comparators have none, and words cost
    over five times sums."""
    found = measure_prices.measure_prices()
    ways = {"trial", "sums", "words", "reference"}
    assert {e.name for e in found} > ways | {"shot", "dark", "crosstalk"}
    here = {each.name: each.measured for each in found if each.name in ways}
    assert all(value > 0 for value in here.values())
    assert all(each.measured >= 0 and each.shipped for each in found if each.name not in ways)
    assert not {e.name for e in found} & {"comparator_offset", "comparator_noise"}
    # A pixel through its words takes many times one by sums, whatever the machine.
    assert here["words"] > 5 * here["sums"]


@pytest.mark.parametrize("name", CASES)
def test_dropped_effects_save_predicted_time(name: str) -> None:
    container = case(name, rows=6, cols=9)
    light = Light.of_clip(np.full((8, 6, 9), 40000.0, np.float32))
    work = Work.of(PlannedScene(container, sensor_of(container), light))
    every = everything()
    # 6 x 9 pixels, all near saturation.
    assert work.near == 54
    for names in (["shot", "dark"], ["crosstalk"], ["read", "reset", "analog"]):
        assert work.milliseconds(every.without(*names)) < work.milliseconds(every)
    assert work.milliseconds(every, 20) < 20 * work.milliseconds(every)
    saturating = "full_well", "register"
    saved = work.milliseconds(every) - work.milliseconds(every.without(*saturating))
    assert saved == pytest.approx(1e-6 * work.near * work.loop_ns(every))


def test_prices_count_pixels_whose_leakage_is_far_from_the_mean() -> None:
    """In a frame of 4 s some pixels run through their words because they leak unlike most; without
    leakage none does."""
    container = case("b edges", slot="500ms", rows=32, cols=32)
    light = Light.of_clip(np.full((8, 32, 32), 100.0, np.float32))
    work = Work.of(PlannedScene(container, sensor_of(container), light))
    every, leakage = everything(), everything().names(Leak)
    assert (work.near, work.uneven > 0) == (0, True)
    saved_ms = work.saved_ms(every, leakage, 50)
    assert saved_ms > 50e-6 * work.uneven * work.loop_ns(every)
