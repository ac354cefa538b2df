"""The list of effects, what `--effects` makes of it, and `nscc effects`."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from nscc_command import invoke

from nscc.chips.load import builtin_target
from nscc.diagnostics.diagnostic import Rejected
from nscc_runtime.effects import (
    CannotHave,
    InLoop,
    Mark,
    marks,
    named,
    optional,
    register,
    registered,
    selected,
)
from nscc_runtime.effects.crosstalk import smeared
from nscc_runtime.effects.dark import current_e_per_s
from nscc_runtime.effects.parts import Errors
from nscc_runtime.effects.prnu import response
from nscc_runtime.effects.register import soft
from nscc_runtime.sensor import default_sensor, parameter, parameters

SENSOR = default_sensor(builtin_target("scamp5"))
PIXELS = np.arange(200_000, dtype=np.int64)


def test_names_and_streams_are_unique_and_every_parameter_serves_an_effect() -> None:
    """No two effects share a name or a stream of random numbers. No sensor parameter is without an
    effect."""
    assert len({effect.name for effect in registered()}) == len(registered())
    assert len({effect.stream for effect in registered()}) == len(registered())
    used = {row.name for effect in registered() for row in effect.parameters}
    assert used == {row.name for row in parameters()}


@pytest.mark.parametrize(
    ("text", "on", "forced"),
    [
        ("none", set(), set()),
        ("all", set(optional()), set()),
        ("shot", {"shot"}, {"shot"}),
        ("shot, read", {"shot", "read"}, {"shot", "read"}),
        ("all,-lag,-adc_noise", set(optional()) - {"lag", "adc_noise"}, {"lag", "adc_noise"}),
        ("-lag", set(optional()) - {"lag"}, {"lag"}),
        ("+lag", {"lag"}, {"lag"}),
        ("none,+shot,-shot", set(), {"shot"}),
        ("adc", set(), set()),
    ],
)
def test_effects_option_selects_the_named_effects(
    text: str, on: set[str], forced: set[str]
) -> None:
    found = selected(text)
    assert found.on == on | {"adc"}
    assert found.forced == forced
    assert found.without_effects == (not on)


@pytest.mark.parametrize("text", ["", ",", "shots", "all,none", "shot,all", "-adc", "all,-", "a b"])
def test_effects_option_refuses_unknown_choices(text: str) -> None:
    """An empty, unknown or contradictory choice, and one that only removes effects, gives NS0756
    and status 2."""
    with pytest.raises(Rejected) as caught:
        selected(text)
    assert caught.value.diagnostics[0].code == "NS0756"
    assert caught.value.status == 2


INCOMPLETE = [
    ({"name": ""}, "a text"),
    ({"name": "shot"}, "there is an effect `shot`"),
    ({"stream": 1}, "1 is that of `shot`"),
    ({"stream": 0}, "`stream`, a number"),
    ({"kind": "odd"}, "`kind`, one of"),
    ({"absent": None}, "`absent`, a text"),
    ({"reference": {}}, "`reference`, a function"),
    ({"reference": {"nowhere": abs}}, "`reference`, a function"),
    ({"reference": {"codes": abs}}, "it is that of `adc`"),
    ({"size": ""}, "`size`, a text"),
    ({"sums": None}, "`sums`, its parts"),
    ({"sums": (1,)}, "`sums` with known parts only"),
    ({"sums": named("lag").sums}, "that of `lag`"),
    ({"words": None}, "`words`, InLoop"),
    ({"words": InLoop()}, "`words` that is CannotHave"),
    ({"parameters": (1,)}, "`parameters`, each a parameter"),
    ({"parameters": (parameter("lag_fraction", "light", 0, "1", 0, 1, "?"),)}, "`lag_fraction`"),
    ({"name": "all"}, "a `name` of small letters"),
    ({"name": "a,b"}, "a `name` of small letters"),
    ({"always": True}, "`always` that is False"),
    ({"sums": ()}, "`sums` that match `reference`"),
    ({"sums": (Errors("reads", abs),)}, "`sums` that match `reference`"),
    ({"cost_ns": -1}, "`cost_ns`, a number"),
    ({"light_ns": math.nan}, "`light_ns`, a number"),
    ({"marks": None}, "`marks` of well, subtracted"),
    ({"marks": {"light": Mark(16, "tilt")}}, "`marks` of well, subtracted"),
    ({"marks": {"well": Mark(16, "tilt")}}, "`marks` of well, subtracted"),
    (
        {"marks": {"well": Mark(16, "tilt")}, "reference": {"well": abs}},
        "it is that of `full_well`",
    ),
    ({"marks": {"well": Mark(2, "tilt")}, "reference": {"well": abs}}, "bits of their own"),
    ({"marks": {"well": Mark(3, "tilt")}, "reference": {"well": abs}}, "bits of their own"),
]


@pytest.mark.parametrize(("changes", "text"), INCOMPLETE, ids=[text for _, text in INCOMPLETE])
def test_effects_with_missing_parts_are_refused_by_name(
    changes: dict[str, object], text: str
) -> None:
    """An effect that lacks a part gives NS0905 with the name of the effect. The list of effects
    stays as it was."""
    whole = replace(
        named("lag"),
        name="tilt",
        stream=99,
        parameters=(),
        sums=CannotHave("so"),
        words=CannotHave("so"),
    )
    before = registered()
    with pytest.raises(Rejected) as caught:
        register(replace(whole, **changes))
    found = caught.value.diagnostics[0]
    assert found.code == "NS0905"
    assert text in " ".join((found.message, *found.notes))
    assert str(changes.get("name", "tilt") or "Effect") in found.message
    assert registered() == before


def test_effects_declare_their_saturation_marks() -> None:
    """A frame file's bits are a contract."""
    found = {mark.name: mark.bit for mark in marks().values()}
    assert found == {
        "well": 1,
        "register": 2,
        "converter": 4,
        "reset level": 8,
        "black sun": 16,
    }
    least_e = marks()["registers"].least_e
    # Where a register keeps half of what is added: tanh' = 1/2.
    x = np.arccosh(np.sqrt(2.0))
    assert least_e(SENSOR) == pytest.approx(0.1 * SENSOR.register_max_e * (x - np.tanh(x)))
    assert least_e(SENSOR.changed(register_knee_fraction=1.0)) == 0


def test_objects_that_are_not_effects_are_refused() -> None:
    with pytest.raises(Rejected, match="it is not an Effect"):
        register("columns")


def test_fixed_patterns_have_the_stated_mean_and_spread() -> None:
    """The response has mean 1 and the spread of `prnu_fraction`. Dark current is positive and has
    the stated mean and spread."""
    sensor = SENSOR.changed(prnu_fraction=0.02, dark_current_e_per_s=50, dark_spread_fraction=0.5)
    factor = response(sensor, 7, PIXELS)
    assert factor.mean() == pytest.approx(1.0, abs=5 * 0.02 / len(PIXELS) ** 0.5)
    assert factor.std() == pytest.approx(0.02, rel=0.01)
    current = current_e_per_s(sensor, 7, PIXELS)
    assert current.min() > 0
    assert current.mean() == pytest.approx(50.0, rel=0.006)
    # Half of the mean of 50, as `dark_spread_fraction` says.
    assert current.std() == pytest.approx(25.0, rel=0.02)
    assert not np.array_equal(factor, response(sensor, 8, PIXELS))


def test_soft_saturation_is_exact_below_the_knee_monotone_and_bounded() -> None:
    """Values up to 90 % of the register's range (the knee) pass unchanged. Beyond it they rise to
    at most 30 000 electrons; a knee of 1 clips."""
    values = np.linspace(-1e5, 1e5, 20001)
    sensor = SENSOR.changed(register_min_e=-30000.0, register_max_e=30000.0)
    held = soft(values, sensor)
    # The knee is at 90 % of the range.
    inside = np.abs(values) <= 27000
    np.testing.assert_array_equal(held[inside], values[inside])
    assert np.all(np.diff(held) >= 0)
    assert np.abs(held).max() <= 30000
    # Values are 10 apart; at the knee (27 000, number 12 700) the slope is still that of a line.
    np.testing.assert_allclose(np.diff(held[12700:12703]), 10.0, rtol=0.01)
    hard = soft(values, sensor.changed(register_knee_fraction=1.0))
    np.testing.assert_array_equal(hard, np.clip(values, -30000, 30000))
    zero = np.array([-0.0, 0.0])
    assert soft(zero, SENSOR).tobytes() == zero.tobytes()


def test_crosstalk_moves_charge_and_loses_none() -> None:
    """Each neighbour gets 1 % of a pixel's charge, the sum of 110 electrons stays, and a flat
    picture does not change."""
    charge = np.zeros((1, 5, 4))
    charge[0, 2, 1] = 100.0
    charge[0, 0, 0] = 10.0
    found = smeared(charge, 0.01)
    # A pixel gives 1 % to each of four neighbours; one in a corner to two.
    assert found[0, 2, 1] == pytest.approx(96.0)
    assert found[0, 2, 0] == found[0, 1, 1] == found[0, 3, 1] == found[0, 2, 2] == 1.0
    assert found[0, 0, 0] == pytest.approx(9.8)
    assert found.sum() == pytest.approx(110.0)
    flat = np.full((3, 4), 7.0)
    np.testing.assert_array_equal(smeared(flat, 0.1), flat)


def test_the_command_lists_shows_and_prints(tmp_path: Path) -> None:
    """`nscc effects` lists every effect and shows one with its values. Its TOML, read as a sensor
    file, prints itself again."""
    listed = invoke(["effects"], tmp_path)
    assert listed.status == 0
    assert all(effect.title in listed.out for effect in registered())
    one = invoke(["effects", "dark"], tmp_path)
    assert "dark_current_e_per_s = 1000 e/s" in one.out
    found = json.loads(invoke(["effects", "--json"], tmp_path).out)["effects"]
    assert [row["name"] for row in found] == [effect.name for effect in registered()]
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
def test_effects_command_refuses_wrong_arguments(
    arguments: list[str], code: str, tmp_path: Path
) -> None:
    """A wrong name, two formats at once, or a bad sensor or target gives the code of its fault and
    prints nothing on stdout."""
    outcome = invoke(["effects", *arguments], tmp_path)
    assert outcome.status in (1, 2)
    assert outcome.out == ""
    assert code in outcome.codes
