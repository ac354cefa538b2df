"""What a plan decides, what it says about it, and whether it comes true."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from plan_cases import case, measured_plan, moving_light
from promise import full_frames, outcome, pool, scene
from reference_programs import exposures, sensor_of

from nscc.words.container import Container
from nscc_runtime.effects import optional, registered, selected
from nscc_runtime.light import Light
from nscc_runtime.planning.decisions import Demands, why_kept
from nscc_runtime.planning.differences import Worst
from nscc_runtime.planning.make import measured_again
from nscc_runtime.planning.plan import Plan
from nscc_runtime.planning.plan_parts import Decision
from nscc_runtime.planning.scenes import planning_of
from nscc_runtime.planning.tolerance import Tolerance
from nscc_runtime.sensor import Sensor

# What is forced off here breaks its tolerance on purpose, and a capture says so.
pytestmark = pytest.mark.filterwarnings("ignore:warning.NS07(49|93)")
ROWS, COLS = 32, 48


def made(
    container: Container, light: Light, sensor: Sensor, tolerance: float, effects: str = "auto"
) -> Plan:
    return measured_plan(container, light, sensor, tolerance, effects)


def again_on(container: Container, light: Light, sensor: Sensor, plan: Plan) -> Plan:
    """The decisions of a plan, measured on another scene."""
    return measured_again(planning_of(container, sensor, light, 5, threads=1), plan)


def row(plan: Plan, name: str) -> Decision:
    [found] = (each for each in plan.decisions if each.name == name)
    return found


@pytest.fixture(scope="module")
def mid() -> tuple[Container, Light, Sensor]:
    container = case("b edges", 8, rows=ROWS, cols=COLS)
    return container, moving_light((8, ROWS, COLS), 400.0), sensor_of(container)


def test_a_plan_has_every_effect_once_and_says_why(mid: tuple[Container, Light, Sensor]) -> None:
    plan = made(*mid, 5.0)
    assert [each.name for each in plan.decisions] == [effect.name for effect in registered()]
    assert all(each.reason for each in plan.decisions)
    assert not any(each.forced for each in plan.decisions)
    assert row(plan, "adc").decision == row(plan, "adc_noise").decision == "kept"
    assert row(plan, "motion").decision == row(plan, "decay").decision == "absent"
    assert 0 < plan.predicted_e <= plan.bound_e
    assert plan.predicted_e <= 0.9 * plan.tolerance_e
    assert 0 < plan.sampled_fraction <= 1


def test_larger_tolerances_keep_less_and_huge_ones_nothing(
    mid: tuple[Container, Light, Sensor],
) -> None:
    costs = []
    for tolerance in (2.0, 10.0, 100.0, 1e6):
        plan = made(*mid, tolerance)
        kept = [each for each in plan.decisions if each.decision == "kept"]
        costs.append(sum(each.cost_ms_model for each in kept))
        assert plan.predicted_e <= 0.9 * tolerance
    assert costs == sorted(costs, reverse=True)
    assert costs[-1] == 0 < costs[0]


@pytest.mark.parametrize("name", optional())
@pytest.mark.parametrize("sign", "+-")
def test_forced_effects_are_as_told(
    sign: str, name: str, mid: tuple[Container, Light, Sensor]
) -> None:
    plan = made(*mid, 1e4 if sign == "+" else 1.0, f"auto,{sign}{name}")
    found = row(plan, name)
    absent = name in ("motion", "decay", "full_well", "register") or name.startswith("comparator")
    if not absent:
        assert found.decision == ("kept" if sign == "+" else "dropped")
        assert found.reason == "named in --effects"
    assert found.forced
    assert not any(each.forced for each in plan.decisions if each.name != name)


def test_black_suns_go_with_dead_time_and_keep_it_where_they_are_named(
    mid: tuple[Container, Light, Sensor],
) -> None:
    """Where words take no time nothing falls on the level of a reset."""
    names = ("dead_time", "black_sun")
    free, named = made(*mid, 100.0), made(*mid, 100.0, "auto,+black_sun")
    assert [row(free, name).decision for name in names] == ["dropped", "dropped"]
    assert [row(named, name).decision for name in names] == ["kept", "kept"]


def test_lists_of_effects_decide_on_everything(mid: tuple[Container, Light, Sensor]) -> None:
    plan = made(*mid, 5.0, "shot,read")
    assert {each.name for each in plan.decisions if each.decision == "kept"} >= {"shot", "read"}
    assert row(plan, "prnu").decision == "dropped"
    assert row(plan, "prnu").forced
    assert plan.predicted_e > 5.0


def test_what_is_forced_off_counts_as_an_error() -> None:
    """Predicted as measured: the reference has what the user left out."""
    container = case("b edges", 8, rows=64, cols=64)
    light, sensor = scene("mid", 8, 64, 64), sensor_of(container)
    full = full_frames(container, light, sensor, 4, 3, 5)
    for effects in ("auto,-shot", "auto,-prnu,-dark", "auto,-analog", "none,+shot", "none"):
        found = outcome(container, light, sensor, 5.0, full, effects=effects)
        assert not found.kept
        assert found.foreseen, (effects, found.err, found.plan.predicted_e)


@pytest.mark.parametrize("name", ["a", "b edges", "d accumulate", "codebook", "two buckets"])
def test_contributions_are_those_of_the_reference(name: str) -> None:
    """Each effect's RMS and bias against the reference with and without it."""
    container = case(name, 8, rows=ROWS, cols=COLS)
    light = moving_light((8, ROWS, COLS), 400.0, zeros=False)
    sensor = sensor_of(container, leakage_tau_s=0.5, analog_gain=1.0)
    plan = made(container, light, sensor, 5.0)
    for effect in ("shot", "prnu", "lag", "crosstalk", "dead_time", "leakage", "dark", "read",
                   "reset"):  # fmt: skip
        # The noise of words is weighed as with every effect, whatever is left out.
        every = "all" if effect in ("read", "reset") else "all,-read,-reset,-analog"
        full, without = (
            exposures(container, light, sensor, names, 4) for names in (every, f"{every},-{effect}")
        )
        change = full - without
        rms = np.sqrt((change**2).mean(axis=(0, 2, 3))).max()
        found = row(plan, effect)
        if rms < 0.05:
            continue
        assert found.predicted_rms_e == pytest.approx(rms, rel=0.12, abs=0.05), effect
        means = change.mean(axis=(0, 2, 3))
        nearest = means[np.abs(means - found.predicted_bias_e).argmin()]
        # Means that are no larger than their standard errors are none.
        assert found.predicted_bias_e == pytest.approx(nearest, rel=0.15, abs=0.2 * rms), effect


def test_dropping_one_more_is_predicted(mid: tuple[Container, Light, Sensor]) -> None:
    """`predicted_if_dropped_e` is the prediction of the plan that does leave it out."""
    container, light, sensor = mid
    plan = made(container, light, sensor, 5.0)
    off = {each.name for each in plan.decisions if each.decision == "dropped"}
    for name in ("shot", "prnu", "read", "analog", "crosstalk"):
        if name in off:
            continue
        rest = [n for n in optional() if n not in {*off, name}]
        other = made(container, light, sensor, 5.0, ",".join(rest))
        found = row(plan, name).predicted_if_dropped_e
        assert other.predicted_e == pytest.approx(found, rel=0.02, abs=0.05)


def test_absent_effects_cost_nothing_and_change_nothing() -> None:
    container = case("b edges", 8, rows=ROWS, cols=COLS)
    none = {
        "prnu_fraction": 0.0, "dark_current_e_per_s": 0.0, "lag_fraction": 0.0,
        "crosstalk_fraction": 0.0, "read_noise_e": 0.0, "reset_noise_e": 0.0, "analog_gain": 1.0,
        "analog_noise_lsb": 0.0, "analog_pattern_lsb": 0.0, "analog_bias_lsb": 0.0,
    }  # fmt: skip
    plan = made(container, moving_light((8, ROWS, COLS), 400.0), sensor_of(container, **none), 0.5)
    gone = ("prnu", "dark", "lag", "crosstalk", "read", "reset", "analog", "motion", "decay",
            "register")  # fmt: skip
    for name in gone:
        assert row(plan, name).decision == "absent", name
        assert row(plan, name).cost_ms_model == 0
    dark = made(container, moving_light((8, ROWS, COLS), 0.0), sensor_of(container, **none), 0.5)
    after = {"adc", "adc_noise", "spreading"}
    assert {each.name for each in dark.decisions if each.decision == "kept"} == after
    assert dark.predicted_e < 0.02


def test_the_same_plan_every_time(mid: tuple[Container, Light, Sensor]) -> None:
    """Nothing in a plan is drawn or measured anew: no times, no order of threads."""
    container, light, sensor = mid
    first = measured_plan(container, light, sensor, 2.0)
    assert measured_plan(container, light, sensor, 2.0) == first
    assert measured_plan(container, light, sensor, 2.0, device_seed=6) != first


@pytest.mark.parametrize(
    ("name", "effects", "tolerance"),
    [
        ("mid", "auto", 5.0),
        ("mid", "auto,-leakage,+lag", 40.0),
        ("saturated", "auto", 50.0),
        ("saturated", "auto,-analog,-prnu", 50.0),
        ("saturated", "auto", 3.0),
    ],
)
def test_a_plan_for_the_same_scene_is_worth_what_it_was(
    name: str, effects: str, tolerance: float
) -> None:
    """What was left out by choice is not taken for forced off."""
    container = case("b edges", 8, rows=64, cols=64)
    sensor, light = sensor_of(container), scene(name, 8, 64, 64)
    plan = made(container, light, sensor, tolerance, effects)
    again = again_on(container, light, sensor, plan)
    assert any(e.decision == "dropped" and not e.forced for e in plan.decisions)
    kept = {e.name: (e.decision, e.forced) for e in plan.decisions}
    assert {e.name: (e.decision, e.forced) for e in again.decisions} == kept
    # What planning takes is less where nothing is searched for.
    bare = [
        replace(p, cost=None, decisions=tuple(replace(e, reason="") for e in p.decisions))
        for p in (plan, again)
    ]
    assert bare[0] == bare[1]
    assert again.cost is not None
    assert plan.cost is not None
    assert again.cost.planning_ms <= plan.cost.planning_ms


def test_a_plan_for_another_scene_says_what_it_is_worth_there() -> None:
    container = case("b edges", 8, rows=64, cols=64)
    sensor = sensor_of(container)
    dim = made(container, scene("dim", 8, 64, 64), sensor, 5.0)
    light = scene("mid", 8, 64, 64)
    again = again_on(container, light, sensor, dim)
    assert [each.decision for each in again.decisions if each.name in ("prnu", "dark", "lag")] == [
        each.decision for each in dim.decisions if each.name in ("prnu", "dark", "lag")
    ]
    assert not any(each.forced for each in again.decisions)
    from nscc_runtime import capture

    full = full_frames(container, light, sensor, pool(light), 3, 5)
    taken = capture(
        container, light, sensor=sensor, plan=again, seed=3, device_seed=5, repeat=len(full)
    )
    err = math.sqrt(float(((taken.exposure_e - full) ** 2).mean()))
    assert again.predicted_e == pytest.approx(err, rel=0.15)


def test_frames_that_are_samples_have_motion() -> None:
    from nscc_runtime.scenes.timing import with_motion

    container = case("c edges", 8, rows=ROWS, cols=COLS)
    light = with_motion(moving_light((8, ROWS, COLS), 400.0))
    sensor = sensor_of(container)
    plan = made(container, light, sensor, 1.0)
    full, left = (
        exposures(container, light, sensor, names, 1) for names in ("motion,prnu", "prnu")
    )
    found = row(plan, "motion")
    assert found.decision == "kept"
    assert found.predicted_rms_e == pytest.approx(((full - left) ** 2).mean() ** 0.5, rel=0.05)


def test_decay_is_found_where_registers_are_kept_too_long() -> None:
    container = case("d edges", 8, rows=ROWS, cols=COLS)
    light = moving_light((8, ROWS, COLS), 400.0)
    plan = made(container, light, sensor_of(container, digital_retention_us=1600.0), 1.0)
    found = row(plan, "decay")
    assert found.decision == "kept"
    names = "decay,lag,prnu"
    sensor = sensor_of(container, digital_retention_us=1600.0)
    full, left = (exposures(container, light, sensor, n, 1) for n in (names, "lag,prnu"))
    assert found.predicted_rms_e == pytest.approx(((full - left) ** 2).mean() ** 0.5, rel=0.1)
    assert row(made(container, light, sensor_of(container), 1.0), "decay").decision == "absent"


def test_decay_counts_in_the_dark_too() -> None:
    """Words that act otherwise leave other errors and, where nothing is read, an old register."""
    container = case("b edges", 8, rows=ROWS, cols=COLS)
    dark = Light.of_clip(np.zeros((8, ROWS, COLS), np.float32))
    sensor = sensor_of(container, digital_retention_us=1600.0)
    found = row(made(container, dark, sensor, 15.0), "decay")
    assert found.decision == "kept"
    full, left = (exposures(container, dark, sensor, names, 1) for names in ("all", "all,-decay"))
    assert found.predicted_rms_e == pytest.approx(((full - left) ** 2).mean() ** 0.5, rel=0.1)


@pytest.mark.parametrize(("name", "slots", "by"), [("b accumulate", 8, "all"),
                                                   ("b edges", 128, "all")])  # fmt: skip
def test_small_tolerances_take_no_short_cut_where_weights_of_slots_differ(
    name: str, slots: int, by: str
) -> None:
    """Strong leakage weighs slots differently: one count for all of them cannot be exact."""
    container = case(name, slots, rows=ROWS, cols=COLS)
    light = moving_light((slots, ROWS, COLS), 3200.0 / slots)
    sensor = sensor_of(container, leakage_tau_s=0.00025 * slots)
    tight, loose = (made(container, light, sensor, tolerance) for tolerance in (0.5, 500.0))
    assert tight.slot_loop == by
    assert tight.slot_loop_reasons
    assert not tight.approximations
    assert loose.slot_loop == "none"
    assert loose.approximations


def test_huge_light_is_planned_without_a_warning() -> None:
    container = case("b edges", 8, rows=12, cols=16)
    sensor = sensor_of(container)
    for electrons in (1e15, 3.4e38):
        light = moving_light((8, 12, 16), 300.0)
        light.frames[:, 4, 5] = electrons
        full = full_frames(container, light, sensor, 2, 3, 5)
        found = outcome(container, light, sensor, 5.0, full)
        assert found.kept


def test_one_pixel_one_row_one_slot() -> None:
    from reference_programs import program

    for rows, cols in ((1, 1), (1, 7), (7, 1)):
        container = program("nsl 1\nframe 1 slots of 1ms\nopen when true\n", "auto", rows, cols)
        light = moving_light((1, rows, cols), 3000.0, zeros=False)
        sensor = sensor_of(container)
        full = full_frames(container, light, sensor, 3, 3, 5)
        assert outcome(container, light, sensor, 0.5, full).kept


def test_forced_plans_are_plans_too(mid: tuple[Container, Light, Sensor]) -> None:
    plan = made(*mid, 5.0, "all")
    assert all(each.forced == (each.kind != "after") or each.forced for each in plan.decisions[:-2])
    again = replace(plan, decisions=plan.decisions)
    assert again.requested_effects == plan.requested_effects


def test_pixels_beside_lamps_are_predicted_with_what_they_get() -> None:
    """A percent of the lamps' crosstalk is what leaving non-uniformity out costs there."""
    container = case("a", 8, rows=64, cols=64)
    light, sensor = scene("hdr, bright", 8, 64, 64), sensor_of(container)
    full = full_frames(container, light, sensor, 4, 3, 5)
    for effects in ("auto", "auto,-prnu", "auto,-lag"):
        found = outcome(container, light, sensor, 2.0, full, effects=effects)
        assert found.foreseen, (effects, found.err, found.plan.predicted_e)


def test_dark_current_that_differs_much_is_predicted() -> None:
    """Few pixels have most of it, and spill some of it."""
    container = case("b edges", 8, "2ms", rows=128, cols=128)
    light = Light.of_clip(np.full((8, 128, 128), 3.0, np.float32))
    sensor = sensor_of(container, dark_spread_fraction=1.8, crosstalk_fraction=0.04)
    full = full_frames(container, light, sensor, 2, 3, 5)
    for effects in ("auto,-dark", "auto,-crosstalk"):
        found = outcome(container, light, sensor, 1.0, full, effects=effects)
        assert found.foreseen, (effects, found.err, found.plan.predicted_e)


def test_short_cuts_count_where_saturation_is_left_out() -> None:
    """All pixels near their limits, none of them run word by word: noise is that of sums."""
    container = case("two buckets", 4, rows=64, cols=64)
    light = Light.of_clip(np.full((4, 64, 64), 2000.0, np.float32))
    sensor = sensor_of(container, register_max_e=9000.0, register_knee_fraction=1.0)
    full = full_frames(container, light, sensor, 8, 3, 5)
    found = outcome(container, light, sensor, 5.0, full, effects="auto,-full_well,-register")
    assert abs(found.plan.predicted_e - found.err) <= 0.2 * found.err + 0.05


@pytest.mark.parametrize("tolerance", [5.0, 50.0])
@pytest.mark.parametrize("name", ["a", "b edges", "b latch"])
def test_wells_that_are_smaller_than_registers(name: str, tolerance: float) -> None:
    """What comes after a full well is lost, though registers hold it."""
    container = case(name, 8, rows=64, cols=64)
    light = scene("saturated", 8, 64, 64)
    sensor = sensor_of(
        container, full_well_e=20_000.0, register_min_e=-2e5, register_max_e=2e5,
        register_knee_fraction=1.0, analog_gain=0.99, leakage_spread_fraction=0.6,
    )  # fmt: skip
    full = full_frames(container, light, sensor, 8, 3, 5)
    found = outcome(container, light, sensor, tolerance, full)
    assert found.kept
    assert 0.6 * found.err <= found.plan.predicted_e
    assert found.err <= found.plan.bound_e


def assert_the_table_adds_up(plan: Plan) -> None:
    table = str(plan).splitlines()
    end = next(i for i, line in enumerate(table) if line.startswith("predicted error"))
    took = [
        float(line.split()[-1]) for line in table[1:end]
        if line.startswith("(") or (" kept " in line and line[-1].isdigit() and "." in line[-5:])
    ]  # fmt: skip
    assert plan.cost is not None
    assert sum(took) == pytest.approx(plan.cost.total_ms, abs=0.01 * len(took))


def test_what_several_effects_would_save_is_said_where_all_pixels_run_through_their_words() -> None:
    """Crosstalk draws the counts that shot noise and dark current have: without any of the three
    there are none."""
    container = case("d edges", 8, rows=64, cols=64)
    plan = made(container, scene("hdr", 8, 64, 64), sensor_of(container), 0.1)
    assert plan.slot_loop == "all"
    assert_the_table_adds_up(plan)
    rest = next(line for line in str(plan).splitlines() if line.startswith("(the rest)"))
    assert ("less what each of several effects would save" in rest) == ("-" in rest.split()[-1])
    assert float(rest.split()[-1]) < 0


def test_what_a_plan_costs_adds_up_and_its_frames_take_at_most_those_of_all() -> None:
    """Saturating pixels lack what the plan drops; the table's last column is the plan's time.
    Planning may take longer than that of all effects, as frames make up for it."""
    container = case("b edges", 8, rows=64, cols=64)
    light, sensor = scene("saturated", 8, 64, 64), sensor_of(container)
    plan, everything = (made(container, light, sensor, 50.0, name) for name in ("auto", "all"))
    assert plan.cost is not None
    assert everything.cost is not None
    assert_the_table_adds_up(plan)
    table = str(plan).splitlines()
    assert plan.cost.total_ms - plan.cost.planning_ms <= plan.cost.all_ms
    assert plan.cost.all_ms == pytest.approx(everything.cost.total_ms - everything.cost.planning_ms)
    assert plan.cost.all_planning_ms == 0.0
    assert f"instead of {plan.cost.all_ms:.2f}; next frames: saves " in table[-1]
    assert set(plan.saturating_lack) <= {e.name for e in plan.decisions if e.decision == "dropped"}


def test_a_plan_of_a_bright_scene_serves_one_where_nothing_saturates() -> None:
    container = case("b edges", 8, rows=64, cols=64)
    sensor = sensor_of(container)
    bright = made(container, scene("saturated", 8, 64, 64), sensor, 50.0)
    dropped = next(e.name for e in bright.decisions if e.decision == "dropped")
    plan = replace(bright, saturating_lack=(dropped,))
    dim = scene("dim", 8, 64, 64)
    found = again_on(container, dim, sensor, plan)
    assert found.kept.on <= plan.kept.on  # without the well, which is far
    assert found.predicted_e < 50.0


@pytest.mark.parametrize(
    ("changed", "text"),
    [
        ({"saved_ns": 0.0}, "costs nothing"),
        ({"name": "lag"}, "left out, the error would be above 5 e"),
        ({"then_e": 4.6}, "left out, the error would be 4.6 e"),
        ({"other_states": 0.25}, "left out, 25.00% would end in other states"),
        ({"most": Tolerance("9e", 9.0)}, "left out, the worst pixel could be 13 e off"),
        # The larger of two buckets: twice 3 + 1.5 e2 above 4 e.
        ({}, "left out, the error could be 5 e: few pixels tell"),
    ],
)
def test_why_an_effect_is_simulated(changed: dict[str, Any], text: str) -> None:
    alone: Any = SimpleNamespace(
        other_states=changed.get("other_states", 0.0), worst=Worst(1.0, 12.0),
        unsure_e2=np.array([3.0, 1.0]),
    )  # fmt: skip
    together: Any = SimpleNamespace(
        worst=Worst(1.0, 5.0), difference=SimpleNamespace(unsure_e2=np.array([1.5, 3.0, 1.0, 2.0]))
    )
    demands = Demands(selected("all"), frozenset(), Tolerance("5e", 5.0), changed.get("most"))
    measured: Any = SimpleNamespace(alone={"read": alone})
    name, saved_ns = changed.get("name", "read"), changed.get("saved_ns", 1.0)
    then_e = changed.get("then_e", 4.0)
    assert why_kept(name, demands, measured, together, saved_ns, then_e) == text
