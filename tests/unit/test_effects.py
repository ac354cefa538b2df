"""The list of effects, what `--effects` makes of it, and `nscc effects`."""

from __future__ import annotations

import json
from dataclasses import fields
from pathlib import Path

import numpy as np
import pytest
from nscc_command import invoke

from nscc.diagnostics.diagnostic import Rejected
from nscc.target.load import builtin_target
from nscc_runtime.effects import BY_NAME, EFFECTS, OPTIONAL, Statistics, selected
from nscc_runtime.effects.crosstalk import smeared
from nscc_runtime.effects.dark import current_e_per_s
from nscc_runtime.effects.photons import response
from nscc_runtime.effects.registers import soft
from nscc_runtime.sensor import PARAMETERS, default_sensor

SENSOR = default_sensor(builtin_target("scamp5"))
PIXELS = np.arange(200_000, dtype=np.int64)


def test_names_and_streams_are_unique_and_every_parameter_serves_an_effect() -> None:
    assert len({effect.name for effect in EFFECTS}) == len(EFFECTS)
    assert len({effect.stream for effect in EFFECTS}) == len(EFFECTS)
    used = {name for effect in EFFECTS for name in effect.parameters}
    assert used == {row.name for row in PARAMETERS}


@pytest.mark.parametrize(
    ("text", "on", "forced"),
    [
        ("none", set(), set()),
        ("all", set(OPTIONAL), set()),
        ("shot", {"shot"}, {"shot"}),
        ("shot, read", {"shot", "read"}, {"shot", "read"}),
        ("all,-lag,-adc_noise", set(OPTIONAL) - {"lag", "adc_noise"}, {"lag", "adc_noise"}),
        ("-lag", set(OPTIONAL) - {"lag"}, {"lag"}),
        ("+lag", {"lag"}, {"lag"}),
        ("none,+shot,-shot", set(), {"shot"}),
        ("adc", set(), set()),
    ],
)
def test_choices(text: str, on: set[str], forced: set[str]) -> None:
    found = selected(text)
    assert found.on == on | {"adc"}
    assert found.forced == forced
    assert found.noiseless == (not on)


@pytest.mark.parametrize("text", ["", ",", "shots", "all,none", "shot,all", "-adc", "all,-", "a b"])
def test_bad_choices(text: str) -> None:
    with pytest.raises(Rejected) as caught:
        selected(text)
    assert caught.value.diagnostics[0].code == "NS0756"
    assert caught.value.status == 2


def test_predictions_follow_the_formulas() -> None:
    scene = Statistics(mean_e=900.0, rms_e=1000.0, reads=4.0, resets=2.0, open_s=0.5, rms_open_s=1)
    sensor = SENSOR.changed(
        read_noise_e=3.0, reset_noise_e=5.0, prnu_fraction=0.02,
        dark_current_e_per_s=8.0, dark_spread_fraction=0.0,
        adc_noise_lsb=2.0, electrons_per_lsb=6.0,
    )  # fmt: skip
    expected = {
        "shot": 30.0, "prnu": 20.0, "read": 6.0, "reset": 50**0.5, "dark": 68**0.5,
        "adc_noise": 12.0, "adc": 3**0.5,
    }  # fmt: skip
    for name, rms in expected.items():
        assert BY_NAME[name].predict(scene, sensor).rms_e == pytest.approx(rms)
    assert BY_NAME["dark"].predict(scene, sensor).bias_e == 4.0


def test_a_scene_without_anything_contributes_nothing_before_the_adc() -> None:
    assert all(value.default == 0.0 for value in fields(Statistics))
    for effect in EFFECTS:
        found = effect.predict(Statistics(), SENSOR)
        assert (found.rms_e == 0.0) == (effect.kind != "after")


def test_fixed_patterns_have_the_stated_mean_and_spread() -> None:
    sensor = SENSOR.changed(prnu_fraction=0.02, dark_current_e_per_s=50, dark_spread_fraction=0.5)
    factor = response(sensor, 7, PIXELS)
    assert factor.mean() == pytest.approx(1.0, abs=5 * 0.02 / len(PIXELS) ** 0.5)
    assert factor.std() == pytest.approx(0.02, rel=0.01)
    current = current_e_per_s(sensor, 7, PIXELS)
    assert current.min() > 0
    assert current.mean() == pytest.approx(50.0, rel=0.006)
    assert current.std() == pytest.approx(25.0, rel=0.02)
    assert not np.array_equal(factor, response(sensor, 8, PIXELS))


def test_soft_saturation_is_exact_below_the_knee_monotone_and_bounded() -> None:
    values = np.linspace(-1e5, 1e5, 20001)
    held = soft(values, SENSOR)
    inside = np.abs(values) <= 27000
    np.testing.assert_array_equal(held[inside], values[inside])
    assert np.all(np.diff(held) >= 0)
    assert np.abs(held).max() <= 30000
    np.testing.assert_allclose(np.diff(held[12700:12703]), 10.0, rtol=0.01)
    hard = soft(values, SENSOR.changed(register_knee_fraction=1.0))
    np.testing.assert_array_equal(hard, np.clip(values, -30000, 30000))
    zero = np.array([-0.0, 0.0])
    assert soft(zero, SENSOR).tobytes() == zero.tobytes()


def test_crosstalk_moves_charge_and_loses_none() -> None:
    charge = np.zeros((1, 5, 4))
    charge[0, 2, 1] = 100.0
    charge[0, 0, 0] = 10.0
    found = smeared(charge, 0.01)
    assert found[0, 2, 1] == pytest.approx(96.0)
    assert found[0, 2, 0] == found[0, 1, 1] == found[0, 3, 1] == found[0, 2, 2] == 1.0
    assert found[0, 0, 0] == pytest.approx(9.8)
    assert found.sum() == pytest.approx(110.0)
    flat = np.full((3, 4), 7.0)
    np.testing.assert_array_equal(smeared(flat, 0.1), flat)


def test_the_command_lists_shows_and_prints(tmp_path: Path) -> None:
    listed = invoke(["effects"], tmp_path)
    assert listed.status == 0
    assert all(effect.title in listed.out for effect in EFFECTS)
    one = invoke(["effects", "dark"], tmp_path)
    assert "dark_current_e_per_s = 1000 e/s" in one.out
    found = json.loads(invoke(["effects", "--json"], tmp_path).out)["effects"]
    assert [row["name"] for row in found] == [effect.name for effect in EFFECTS]
    assert all(row["model"] and row["predicted"] and row["cost"] for row in found)
    printed = invoke(["effects", "--toml", "--sensor-set", "read_noise_e=3"], tmp_path).out
    (tmp_path / "s.toml").write_text(printed)
    assert invoke(["effects", "--toml", "--sensor", "s.toml"], tmp_path).out == printed


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (["darc"], "NS0756"),
        (["dark", "--json"], "NS0780"),
        (["--json", "--toml"], "NS0780"),
        (["--sensor", "none.toml"], "NS0751"),
        (["--sensor-set", "x"], "NS0755"),
        (["--target", "nonesuch"], "NS0230"),
    ],
)
def test_bad_arguments(arguments: list[str], code: str, tmp_path: Path) -> None:
    outcome = invoke(["effects", *arguments], tmp_path)
    assert outcome.status in (1, 2)
    assert outcome.out == ""
    assert code in outcome.codes
