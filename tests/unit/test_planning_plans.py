"""Tolerances in words, plans as JSON: what is written comes back, and nothing else is taken."""

from __future__ import annotations

import copy
import json
import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from plan_cases import plan_of

from nscc.chips.load import builtin_target
from nscc.diagnostics.diagnostic import Rejected
from nscc_runtime.effects import optional, registered
from nscc_runtime.effects.parameters import MOST_E
from nscc_runtime.planning.plan import Plan
from nscc_runtime.planning.plan_parts import Approximation, Cost
from nscc_runtime.planning.tolerance import (
    LEAST_E,
    OPTION_MAX,
    Tolerance,
    mean_signal_e,
    tolerance_of,
)
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


def tolerance(given: str | float, signal_e: float | None = None) -> Tolerance:
    return tolerance_of(given, SENSOR, SceneOf(signal_e))


@given(st.floats(LEAST_E, MOST_E))
def test_electrons_are_electrons(value: float) -> None:
    assert tolerance(f"{value!r}e").electrons == tolerance(value).electrons == value
    assert tolerance(f" {value!r} e ").electrons == value


@given(st.floats(LEAST_E, MOST_E / 100))
def test_codes_are_so_many_electrons(value: float) -> None:
    assert tolerance(f"{value!r}lsb").electrons == value * 100.0


@given(st.floats(1e-3, 1e3), st.floats(1e-3, 1e9))
def test_percentages_are_parts_of_the_signal(value: float, signal_e: float) -> None:
    found = tolerance(f" {value!r} %", signal_e)
    assert found.electrons == pytest.approx(signal_e * value / 100)
    assert found == Tolerance(f"{value!r}%", found.electrons, signal_e)


@given(st.floats(LEAST_E, MOST_E) | st.floats(1e-3, 1e3).map(lambda x: f"{x!r}%"))
def test_what_is_told_of_a_tolerance_is_a_way_to_ask_for_it(given: str | float) -> None:
    found = tolerance(given, 700.0)
    assert tolerance(found.text, 700.0) == found
    assert tolerance_of(found, SENSOR, SceneOf(math.nan)) is found


@given(st.floats(1e-3, 1e3), st.floats(1e-3, 1e9))
def test_parts_of_the_noise(value: float, noise_e: float) -> None:
    found = tolerance_of(f"{value!r} noise", SENSOR, SceneOf(None, noise_e))
    assert found.electrons == pytest.approx(noise_e * value)
    assert found.noise_part == pytest.approx(value)
    assert str(found) == f"{value!r} of the frame's own noise = {found.electrons:.4g} e"
    assert tolerance_of(found.text, SENSOR, SceneOf(None, noise_e)) == found


@pytest.mark.parametrize("signal_e", [0.0, -1.0, math.nan])
def test_a_part_of_no_signal_is_refused_and_electrons_are_offered(signal_e: float) -> None:
    with pytest.raises(Rejected) as caught:
        tolerance("1%", signal_e)
    [said] = caught.value.diagnostics
    assert (said.code, caught.value.status) == ("NS0746", 2)
    assert "1% of this scene is 0" in said.message
    assert "--tolerance 5e" in said.helps[0]


def test_a_signal_is_the_mean_size_within_the_well() -> None:
    full_e = SENSOR.values["full_well_e"]
    found = mean_signal_e(np.array([[100.0, -300.0, math.inf], [10 * full_e, math.nan, 0]]), SENSOR)
    assert found == pytest.approx((100 + 300 + 2 * full_e) / 5)
    assert mean_signal_e(np.full((1, 2), math.nan), SENSOR) == 0.0


@pytest.mark.parametrize("text", ["5e", "5.e", ".5e1e", "5e0e", "05e", "1e2lsb", "5E0e", "5e1%"])
def test_ways_to_write_it(text: str) -> None:
    [unit] = [unit for unit in ("lsb", "%", "e") if text.endswith(unit)]
    size = {"e": 1.0, "lsb": 100.0, "%": 7.0}[unit]
    assert tolerance(text, 700.0).electrons == float(text.removesuffix(unit)) * size


@pytest.mark.parametrize("text", ["5E", "0.5LSB", "0.1Noise"])
def test_a_unit_may_be_written_large(text: str) -> None:
    assert tolerance(text, 700.0) == tolerance(text.lower(), 700.0)


@pytest.mark.parametrize(
    "text",
    [
        "", "e", "lsb", "5", "5 electrons", "-5e", "+5e", "0e", "0.0lsb", "nan e", "inf e", "infe",
        "1e999e", "5e5e5e", "1..2e", ".e", "5,5e", "0x5e", "5 LS B", "5e\x00", "\u0665e", "5e lsb",
        "1e-400e", "1e-10e", "1e16e", "1e200e", "1e14lsb", "%", "0%", "-1%", "1 %%", "1%e",
        "1e-99%", "1e99%", "1e999%", "noise", "0noise", "-1noise", "1e99noise", "1noises", 1e-320,
        1e200, 0, -1, math.nan, math.inf, "9" * 5000 + "e",
    ],
)  # fmt: skip
def test_what_is_no_tolerance(text: str | float) -> None:
    with pytest.raises(Rejected) as caught:
        tolerance(text, 700.0)
    [said] = caught.value.diagnostics
    assert (said.code, caught.value.status) == ("NS0746", 2)
    assert len(said.message) < 120


@pytest.mark.parametrize("text", ["5", "1e20e", "1%"])
def test_the_option_that_was_wrong_is_named(text: str) -> None:
    with pytest.raises(Rejected) as caught:
        tolerance_of(text, SENSOR, SceneOf(0.0), OPTION_MAX)
    [said] = caught.value.diagnostics
    assert "--tolerance-max" in said.message or "of this scene is 0" in said.message
    assert "--tolerance-max 5e" in said.helps[0]


@given(st.text())
def test_any_text_is_a_tolerance_or_is_refused(text: str) -> None:
    try:
        found = tolerance(text, 700.0).electrons
    except Rejected as rejected:
        assert [said.code for said in rejected.diagnostics] == ["NS0746"]  # noqa: PT017
    else:
        assert 0 < found < math.inf


numbers = st.floats(0, 1e9)


@st.composite
def plans(draw: st.DrawFn) -> Plan:
    base, asked = plan_of("all"), draw(st.sampled_from(["", "5e", "0.1lsb", "1%", "0.1noise"]))
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
    return Plan(
        draw(st.floats(0.01, 1e6)), draw(st.none() | numbers), draw(st.none() | numbers),
        draw(st.sampled_from(["none", "some", "all"])), tuple(draw(st.lists(st.text(max_size=9)))),
        draw(st.floats(0, 1)),
        tuple(draw(st.lists(
            st.builds(Approximation, st.text(max_size=9), st.none() | numbers), max_size=3
        ))),
        decisions, tolerance=asked, signal_e=draw(numbers) if asked == "1%" else None,
        noise_e=draw(numbers) if asked == "0.1noise" else None,
    )  # fmt: skip


@given(plans())
def test_json_comes_back_as_it_went(plan: Plan) -> None:
    text = json.dumps(plan.as_json(), allow_nan=False)
    assert Plan.from_json(json.loads(text)) == plan


def places(value: Any, at: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """Where something may be damaged: every key and index of a JSON value."""
    found = [at] if at else []
    if isinstance(value, dict):
        for name in value:
            found += places(value[name], (*at, name))
    elif isinstance(value, list):
        for index in range(min(len(value), 2)):
            found += places(value[index], (*at, index))
    return found


WHOLE = plan_of("shot,prnu").as_json() | {
    "approximations": [{"name": "a", "error_e": 0.5}], "slot_loop_reasons": ["why"],
}  # fmt: skip


def _damaged(at: tuple[Any, ...], change: Any) -> dict[str, Any]:
    """`WHOLE` with the value at a place changed; deleted where `change` is None."""
    values = copy.deepcopy(WHOLE)
    holder: Any = values
    for step in at[:-1]:
        holder = holder[step]
    if change is None:
        del holder[at[-1]]
    else:
        holder[at[-1]] = change
    return values


LATER = [
    (name,) for name in (
        "noise_e", "predicted_p999_e", "predicted_max_e", "tolerance_max", "tolerance_max_e",
        "noise_ratio", "saturating_lack", "cost", "reused",
    )
]  # fmt: skip
"""What older files of plans do not have."""


@pytest.mark.parametrize("at", LATER, ids=str)
def test_older_plans_open(at: tuple[Any, ...]) -> None:
    assert Plan.from_json(_damaged(at, None)) == Plan.from_json(WHOLE)


TAKEN = (KeyError, TypeError, ValueError)


SHORTER = {
    ("slot_loop",), ("leak_nodes",), ("closed_slots_counted",), ("approximations", 0),
    ("slot_loop_reasons", 0), ("effects", 0), ("effects", 1),
}  # fmt: skip
"""Places that follow from others, and lists that may well be shorter."""


@pytest.mark.parametrize(
    "at", [at for at in places(WHOLE) if at not in {*SHORTER, *LATER}], ids=str
)
def test_a_part_that_is_missing_is_noticed(at: tuple[Any, ...]) -> None:
    with pytest.raises(TAKEN):
        Plan.from_json(_damaged(at, None))


@pytest.mark.parametrize(
    "junk", [{}, [], "x", "\x00", [[1]], True, -1, math.nan, math.inf, 10**400]
)
@pytest.mark.parametrize("at", places(WHOLE), ids=str)
def test_a_value_of_another_kind_is_noticed(at: tuple[Any, ...], junk: Any) -> None:
    """Nothing but a plan comes out: either it is refused or the same JSON follows from it."""
    values = _damaged(at, junk)
    try:
        found = Plan.from_json(values)
    except TAKEN:
        return
    text = json.dumps(found.as_json(), allow_nan=False)
    again = json.loads(text)
    for plan in (found, Plan.from_json(again)):
        assert {each.name for each in plan.decisions} == {effect.name for effect in registered()}
        assert 0 < plan.tolerance_e < math.inf
    if isinstance(junk, (list, dict)) or (isinstance(junk, float) and not math.isfinite(junk)):
        assert at in SHORTER or (at[0], junk) in (
            ("approximations", []), ("slot_loop_reasons", []), ("saturating_lack", []),
            ("effects", []),
        ), f"{at} was taken as {junk!r}"  # fmt: skip


def test_what_a_plan_simulates() -> None:
    plan = plan_of("shot,full_well")
    assert plan.kept.on == {"shot", "full_well", "adc"}
    assert plan.requested_effects.on == {"shot", "full_well", "adc"}
    assert plan.execution.near_effects.on == {"shot", "full_well", "adc"}
    free = replace(plan, decisions=tuple(replace(each, forced=False) for each in plan.decisions))
    assert free.kept.on == {"shot", "full_well", "adc"}
    assert free.requested_effects.on == {*optional(), "adc"}
    assert free.execution.near_effects.on == {*optional(), "adc"} - {"register"}


@pytest.mark.parametrize(("effects", "nodes"), [("leakage", 2), ("shot", 1)])
def test_a_plan_tells_the_nodes_of_a_kept_leak(effects: str, nodes: int) -> None:
    assert plan_of(effects).as_json()["leak_nodes"] == nodes


@pytest.mark.parametrize(("rest_ms", "is_less"), [(-0.5, True), (0.0, False), (0.5, False)])
def test_only_a_negative_remainder_is_explained(rest_ms: float, is_less: bool) -> None:
    cost = Cost(total_ms=8.0 + rest_ms, saturating_ms=2.0, planning_ms=1.0, all_ms=20.0)
    rows = cost.rows(5.0, ())
    assert sum(row[-1] for row in rows) + 5.0 == cost.total_ms
    assert ("less what each" in rows[-1][1]) == is_less


def test_the_text_of_a_plan_gives_the_estimates_that_it_has() -> None:
    plan = replace(
        plan_of("shot"), predicted_e=3.0, predicted_p999_e=4.5, predicted_max_e=6.25,
        noise_ratio=1.125, other_states=0.0025,
    )  # fmt: skip
    text = str(plan)
    assert "99.9 % of the pixels within 4.5 e, the worst 6.25 e off; noise x 1.1250" in text
    assert "in other states: 0.25% of the pixels" in text
    assert "estimates" not in str(replace(plan, predicted_p999_e=None))
    assert "no error was measured; tolerance 5 e" in str(replace(plan, predicted_e=None))
