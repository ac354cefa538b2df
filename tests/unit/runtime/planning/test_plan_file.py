"""Tolerances in words, plans as JSON: what is written comes back, and nothing else is taken."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from plan_cases import plan_of

from nscc.chips.load import builtin_target
from nscc.codec import InvalidRecord, from_plain
from nscc.diagnostics.diagnostic import Rejected
from nscc_runtime.effects import everything
from nscc_runtime.effects.effect import MOST_E
from nscc_runtime.effects.registry import optional
from nscc_runtime.planning.plan import Plan
from nscc_runtime.planning.plan_file import plan_text, read_plan
from nscc_runtime.planning.tolerance import LEAST_E, Tolerance, mean_signal_e, tolerance_of
from nscc_runtime.sensor import default_sensor

SENSOR = default_sensor(builtin_target("scamp5")).changed(electrons_per_lsb=100.0)


@dataclass(frozen=True)
class SceneOf:
    """Where a signal is asked for that is not given, the test fails."""

    signal: float | None
    noise: float = 120.0

    def signal_e(self) -> float:
        assert self.signal is not None
        return self.signal

    def noise_e(self) -> float:
        return self.noise


def scene_tolerance(given: str | float | Tolerance, scene: SceneOf) -> Tolerance:
    return tolerance_of(given, SENSOR, scene.signal_e, scene.noise_e)


def tolerance(given: str | float, signal_e: float | None = None) -> Tolerance:
    return scene_tolerance(given, SceneOf(signal_e))


@given(st.floats(LEAST_E, MOST_E))
def test_a_tolerance_in_electrons_keeps_its_value(value: float) -> None:
    """A number, with `e` or without, with blanks or without, keeps its value to the bit."""
    assert tolerance(f"{value!r}e").electrons == tolerance(value).electrons == value
    assert tolerance(f" {value!r} e ").electrons == value


@given(st.floats(LEAST_E, MOST_E / 100))
def test_tolerances_in_codes_are_converted_to_electrons(value: float) -> None:
    assert tolerance(f"{value!r}lsb").electrons == value * 100.0


@given(st.floats(1e-3, 1e3), st.floats(1e-3, 1e9))
def test_percentages_are_parts_of_the_signal(value: float, signal_e: float) -> None:
    """A percentage is that part of the signal in electrons, and its text keeps the percentage."""
    found = tolerance(f" {value!r} %", signal_e)
    assert found.electrons == pytest.approx(signal_e * value / 100)
    assert found == Tolerance(f"{value!r}%", found.electrons)
    assert f"of the mean signal, {signal_e:.4g} e" in str(found)


@given(st.floats(LEAST_E, MOST_E) | st.floats(1e-3, 1e3).map(lambda x: f"{x!r}%"))
def test_the_printed_tolerance_can_be_entered_again(given: str | float) -> None:
    """The text of a tolerance gives an equal one. In electrons or percent it needs no scene a
    second time."""
    found = tolerance(given, 700.0)
    assert tolerance(found.text, 700.0) == found
    assert scene_tolerance(found, SceneOf(math.nan)) is found


@given(st.floats(1e-3, 1e3), st.floats(1e-3, 1e9))
def test_a_tolerance_in_noise_is_a_part_of_the_frames_noise(value: float, noise_e: float) -> None:
    """A value with `noise` is that part of the frame's noise, and it is printed with both."""
    found = scene_tolerance(f"{value!r} noise", SceneOf(None, noise_e))
    assert found.electrons == pytest.approx(noise_e * value)
    assert str(found) == f"{value!r} of the frame's own noise = {found.electrons:.4g} e"
    assert scene_tolerance(found.text, SceneOf(None, noise_e)) == found


@pytest.mark.parametrize("signal_e", [0.0, -1.0, math.nan])
def test_a_part_of_no_signal_is_refused_and_electrons_are_offered(signal_e: float) -> None:
    """A percentage of 0, of a negative number and of NaN gives NS0746 with a help to name
    electrons."""
    with pytest.raises(Rejected) as caught:
        tolerance("1%", signal_e)
    [said] = caught.value.diagnostics
    assert (said.code, caught.value.status) == ("NS0746", 2)
    assert "1% of this scene is 0" in said.message
    assert "--tolerance 5e" in said.helps[0]


def test_a_signal_is_the_mean_size_within_the_well() -> None:
    """Values are taken without sign and cut off at a full well. NaN does not count, and without
    values the signal is 0."""
    full_e = SENSOR.values["full_well_e"]
    found = mean_signal_e(np.array([[100.0, -300.0, math.inf], [10 * full_e, math.nan, 0]]), SENSOR)
    # Five values count, because NaN does not; two are cut off at a full well.
    assert found == pytest.approx((100 + 300 + 2 * full_e) / 5)
    assert mean_signal_e(np.full((1, 2), math.nan), SENSOR) == 0.0


@pytest.mark.parametrize("text", ["5e", "5.e", ".5e1e", "5e0e", "05e", "1e2lsb", "5E0e", "5e1%"])
def test_tolerances_with_every_unit_are_read(text: str) -> None:
    """Points without digits, exponents and leading zeros are numbers before `e`, `lsb` and `%`."""
    [unit] = [unit for unit in ("lsb", "%", "e") if text.endswith(unit)]
    # A code is 100 electrons here, and a percent of 700 electrons is 7.
    size = {"e": 1.0, "lsb": 100.0, "%": 7.0}[unit]
    assert tolerance(text, 700.0).electrons == float(text.removesuffix(unit)) * size


@pytest.mark.parametrize("text", ["5E", "0.5LSB", "0.1Noise"])
def test_a_unit_may_be_written_large(text: str) -> None:
    """`5E`, `0.5LSB` and `0.1Noise` are read as in small letters."""
    assert tolerance(text, 700.0) == tolerance(text.lower(), 700.0)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "e",
        "lsb",
        "5",
        "5 electrons",
        "-5e",
        "+5e",
        "0e",
        "0.0lsb",
        "nan e",
        "inf e",
        "infe",
        "1e999e",
        "5e5e5e",
        "1..2e",
        ".e",
        "5,5e",
        "0x5e",
        "5 LS B",
        "5e\x00",
        "\u0665e",
        "5e lsb",
        "1e-400e",
        "1e-10e",
        "1e16e",
        "1e200e",
        "1e14lsb",
        "%",
        "0%",
        "-1%",
        "1 %%",
        "1%e",
        "1e-99%",
        "1e99%",
        "1e999%",
        "noise",
        "0noise",
        "-1noise",
        "1e99noise",
        "1noises",
        1e-320,
        1e200,
        0,
        -1,
        math.nan,
        math.inf,
        "9" * 5000 + "e",
    ],
)
def test_invalid_tolerances_are_refused(text: str | float) -> None:
    with pytest.raises(Rejected) as caught:
        tolerance(text, 700.0)
    [said] = caught.value.diagnostics
    assert (said.code, caught.value.status) == ("NS0746", 2)
    # Long texts are cut.
    assert len(said.message) < 120


@given(st.text())
def test_any_text_is_a_tolerance_or_is_refused(text: str) -> None:
    """Any text gives a finite tolerance above 0 or NS0746, and no other error."""
    try:
        found = tolerance(text, 700.0).electrons
    except Rejected as rejected:
        assert [said.code for said in rejected.diagnostics] == ["NS0746"]  # noqa: PT017
    else:
        assert 0 < found < math.inf


numbers = st.floats(0, 1e9)


@st.composite
def plans(draw: st.DrawFn) -> Plan:
    base = plan_of("all")
    decisions = tuple(
        replace(
            each,
            decision=draw(st.sampled_from(["kept", "dropped", "absent"])),
            forced=draw(st.booleans()),
            reason=draw(st.text(max_size=20)),
            predicted_rms_e=draw(st.none() | numbers),
            predicted_bias_e=draw(st.none() | st.floats(-1e9, 1e9)),
            predicted_if_dropped_e=draw(st.none() | numbers),
            cost_ms_model=draw(numbers),
        )
        for each in base.decisions
    )
    return replace(
        base,
        decisions=decisions,
        tolerance=draw(st.sampled_from(["5e", "0.1lsb", "1%"])),
        predicted_e=draw(st.none() | numbers),
        worst_e=draw(st.none() | numbers),
        slot_loop_reasons=tuple(draw(st.lists(st.text(max_size=9)))),
        other_states=draw(st.none() | st.floats(0, 1)),
        reused=draw(st.booleans()),
    )


@given(plans())
def test_json_is_read_as_it_was_written(plan: Plan) -> None:
    """A plan with any values is equal after it was written and read, and it can be printed."""
    text = json.dumps(plan.as_json(), allow_nan=False)
    assert from_plain(Plan, json.loads(text)) == plan
    assert str(plan)
    assert plan.line


def test_the_table_shows_the_worst_pixel() -> None:
    """The text names the worst pixel's error and the share of other states. Without a prediction it
    says that none was measured."""
    plan = replace(plan_of("shot"), predicted_e=3.0, worst_e=6.25, other_states=0.0025)
    text = str(plan)
    assert "predicted error 3 e (at most 0), tolerance 5 e, worst pixel 6.25 e" in text
    assert "in other states: 0.25% of the pixels" in text
    assert plan.as_json()["worst_e"] == 6.25
    assert "no error was measured; tolerance 5 e" in str(replace(plan, predicted_e=None))


def test_a_plan_simulates_kept_forced_and_present_effects() -> None:
    plan = plan_of("shot,full_well")
    assert plan.kept.on == {"shot", "full_well", "adc"}
    assert plan.requested_effects.on == {"shot", "full_well", "adc"}
    free = replace(plan, decisions=tuple(replace(each, forced=False) for each in plan.decisions))
    assert free.kept.on == {"shot", "full_well", "adc"}
    assert free.requested_effects.on == {*optional(), "adc"}
    absent = replace(
        plan,
        decisions=tuple(
            replace(each, decision="absent") if each.name == "register" else each
            for each in plan.decisions
        ),
    )
    assert "register" in absent.kept.on  # the next scene may saturate


@pytest.mark.parametrize(
    ("name", "value", "words"),
    [
        ("tolerance_e", 0.0, "tolerance_e"),
        ("tolerance_e", 1e99, "tolerance_e"),
        ("predicted_e", "3", "predicted_e"),
        ("effects", [], None),
        ("effects", [{}], r"effects\[0\]"),
        ("unknown", 1, "unknown"),
    ],
)
def test_damaged_plans_are_refused_by_field(name: str, value: Any, words: str | None) -> None:
    values = plan_of("shot").as_json() | {name: value}
    if words is None:
        assert from_plain(Plan, values).kept.on == everything().on
    else:
        with pytest.raises(InvalidRecord, match=words):
            from_plain(Plan, values)


def test_a_plan_of_an_earlier_version_says_to_make_it_again(tmp_path: Path) -> None:
    """A file of `nscc-plan-2` gives NS0747 with the help to make it again."""
    text = plan_text(plan_of("shot"), "digest", SENSOR)
    (tmp_path / "p.json").write_text(text.replace("nscc-plan-3", "nscc-plan-2"))
    with pytest.raises(Rejected) as caught:
        read_plan(tmp_path / "p.json", "digest", SENSOR)
    [said] = caught.value.diagnostics
    assert said.code == "NS0747"
    assert "nscc-plan-2" in said.notes[0]
    assert "make it again" in said.helps[0]
