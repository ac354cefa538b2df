"""Plans: the promise, what they drop, and what they say of each effect."""

from __future__ import annotations

import numpy as np
import pytest
from plan_cases import CASES, case, measured_plan
from promise import Outcome, full_frames, outcome, scene
from random_sensors import promises, rare_pixels
from reference_programs import program, sensor_of

import nscc_runtime
from nscc_runtime.effects import everything, selected
from nscc_runtime.effects.parts import Saturates
from nscc_runtime.execution.block_scene import expose_pixels, prepare_pixels
from nscc_runtime.light import Light
from nscc_runtime.planning.make import make_plan
from nscc_runtime.planning.plan import PlanRequest
from nscc_runtime.planning.planned_scene import PlannedScene

SIDE, SLOTS = 64, 8


def found(program: str, name: str, tolerance: str, effects: str = "auto") -> Outcome:
    container = case(program, SLOTS, rows=SIDE, cols=SIDE)
    sensor, light = sensor_of(container), scene(name, SLOTS, SIDE, SIDE)
    full = full_frames(container, light, sensor, 4)
    return outcome(container, light, sensor, tolerance, full, effects=effects)


@pytest.mark.parametrize("program", CASES)
@pytest.mark.parametrize(
    ("name", "tolerance"), [("mid", "50e"), ("hdr, bright", "5e"), ("flicker", "0.15noise")]
)
def test_errors_of_plans_stay_within_the_tolerance_as_predicted(
    program: str, name: str, tolerance: str
) -> None:
    """For each program and scene the promise is kept, no effect stays on that was needless, and the
    prediction is near the error."""
    each = found(program, name, tolerance)
    assert each.kept
    assert not each.needless
    assert not each.counts or each.foreseen


@pytest.mark.parametrize("seed", range(3))
def test_errors_of_plans_of_random_programs_scenes_and_sensors_stay_within_the_tolerance(
    seed: int,
) -> None:
    """For three seeds of random programs, scenes and sensors, no promise is broken."""
    assert [draw.said for draw in promises(40 + seed, frames=2) if not draw.found.kept] == []


@pytest.mark.parametrize("seed", [8, 30008])
def test_few_pixels_with_most_of_the_error_are_measured(seed: int) -> None:
    """Nine of 30008 pixels saturate, and only in frames with much noise."""
    draw = rare_pixels(seed)
    assert draw.found.kept, draw.said


@pytest.mark.parametrize(
    ("light_e", "values"),
    [
        (50.0, {"dark_spread_fraction": 5.0, "dark_current_e_per_s": 300.0}),
        (50.0, {"dark_spread_fraction": 10.0, "dark_current_e_per_s": 300.0}),
        (500.0, {"leakage_spread_fraction": 10.0}),
    ],
)
def test_few_pixels_of_a_chip_with_most_of_the_error_are_measured(
    light_e: float, values: dict[str, float]
) -> None:
    """The promise is kept where few pixels have most of the dark charge or of the leakage."""
    stops = "code stop : 1..N open when n < stop pixels stop = tile [[4, 16], [8, 12]]"
    container = program(f"nsl 1 frame 16 slots of 1ms {stops}", "auto", 256, 256)
    sensor = sensor_of(container, **values)
    light = Light.of_clip(np.full((16, 256, 256), light_e, np.float32))
    planned = PlannedScene(container, sensor, light)
    plan = make_plan(planned, PlanRequest(selected("auto"), "20e", figures=True))
    every = np.arange(256 * 256)
    kept_e, all_e = (
        expose_pixels(prepare_pixels(container, sensor, light, effects, every, 0), 9, 0).exposure_e
        for effects in (plan.kept, everything())
    )
    assert plan.names("dropped")
    assert np.sqrt(((kept_e - all_e) ** 2).mean(axis=1)).max() <= 1.1 * 20.0


@pytest.mark.parametrize("tolerance", ["0.01e", "1e6e"])
def test_larger_tolerances_drop_more_effects(tolerance: str) -> None:
    """At 0.01 electrons no effect is dropped. At a million all costly ones but `adc` are, yet none
    that saturates."""
    plan = found("b edges", "mid", tolerance).plan
    dropped = {*plan.names("dropped")}
    saturating = everything().names(Saturates)
    if tolerance == "0.01e":
        assert not dropped
    else:
        costly = {each.name for each in plan.decisions if each.cost_ms_model > 0}
        assert dropped >= {"shot", "dark", "read", "reset", "analog"}
        assert dropped.isdisjoint(saturating)
        assert costly - dropped <= {"adc"}


def test_absent_effects_stay_on_for_the_next_scene() -> None:
    """In a dim scene saturation and motion cost nothing and stay on, without a loop over slots. A
    saturated scene needs the loop."""
    plan = found("b edges", "dim", "50e").plan
    assert {"full_well", "register", "motion"} <= {*plan.names("absent")}
    assert plan.kept.on >= {"full_well", "register", "motion"}
    assert not plan.slot_loop
    assert found("b edges", "saturated", "50e").plan.slot_loop


def test_effects_that_are_forced_off_do_not_loosen_the_tolerance_of_others() -> None:
    """Without shot noise the error exceeds 20 electrons, which is reported. The others are dropped
    as before."""
    free, forced = (
        found("b edges", "mid", "20e", effects).plan for effects in ("auto", "auto,-shot")
    )
    assert forced.predicted_e > 20.0
    assert forced.breach is not None
    assert {*free.names("dropped")} - {"shot", "dark"} <= {*forced.names("dropped")}
    [shot] = [each for each in forced.decisions if each.name == "shot"]
    assert (shot.decision, shot.forced, shot.reason) == ("dropped", True, "named in --effects")
    assert shot.predicted_rms_e == pytest.approx(forced.predicted_e, rel=0.1)


def test_figures_of_an_effect_are_those_of_leaving_it_out_alone() -> None:
    """The error in an effect's row is that of a plan with all other effects. For dark current it is
    mostly a bias."""
    container = case("c edges", SLOTS, rows=SIDE, cols=SIDE)
    sensor, light = sensor_of(container), scene("mid", SLOTS, SIDE, SIDE)
    plan = measured_plan(container, light, sensor, "1e")
    for name in ("shot", "dark", "crosstalk", "prnu", "leakage"):
        [row] = [each for each in plan.decisions if each.name == name]
        error = measured_plan(container, light, sensor, "1e", f"all,-{name}")
        assert error.predicted_e == pytest.approx(row.predicted_rms_e, rel=1e-6)
    [dark] = [each for each in plan.decisions if each.name == "dark"]
    assert dark.predicted_bias_e > 0.5 * dark.predicted_rms_e


def test_a_single_frame_is_not_measured_and_many_are() -> None:
    """For one frame measuring costs more than it saves, so nothing is dropped. For 1000 frames it
    pays."""
    container = case("b edges", SLOTS, rows=256, cols=256)
    light = scene("mid", SLOTS, 256, 256)
    planned = PlannedScene(container, sensor_of(container), light)
    plans = [
        make_plan(planned, PlanRequest(selected("auto"), "60e", frames)) for frames in (1, 1000)
    ]
    assert [plan.predicted_e is not None for plan in plans] == [False, True]
    assert not plans[0].names("dropped")
    assert plans[1].names("dropped")
    assert plans[1].total_ms < plans[1].all_ms


def test_effects_that_are_estimated_to_be_too_large_are_not_measured() -> None:
    """At 5 electrons counts, words and crosstalk of a scene with lamps are all too large, as a plan
    with figures measures. A plan for 20 frames does not measure them; at 500 electrons it does."""
    container = case("b edges", SLOTS, rows=256, cols=256)
    light = scene("hdr, bright", SLOTS, 256, 256)
    planned = PlannedScene(container, sensor_of(container), light)
    table = make_plan(planned, PlanRequest(selected("auto"), "5e", figures=True))
    large = {each.name for each in table.decisions if (each.predicted_rms_e or 0.0) > 5.0}
    assert large >= {"shot", "analog", "crosstalk"}
    plans = [make_plan(planned, PlanRequest(selected("auto"), x, 20)) for x in ("5e", "500e")]
    assert [plan.predicted_e is not None for plan in plans] == [False, True]
    assert {"shot", "dark"} <= {*plans[1].names("dropped")}


def test_a_relative_tolerance_is_that_of_the_frames_noise() -> None:
    """`0.3noise` is 0.3 of the standard deviation of 40 frames with all effects, which the plan
    knows within 5 %."""
    container = case("b edges", SLOTS, rows=SIDE, cols=SIDE)
    light = scene("mid", SLOTS, SIDE, SIDE)
    sensor = sensor_of(container, adc_offset_lsb=30.0)  # no code is clipped at 0
    plan = measured_plan(container, light, sensor, "0.3noise")
    taken = nscc_runtime.capture(
        container, light, sensor=sensor, effects="all", device_seed=5, repeat=40
    )
    codes = taken.frame.astype(np.float64) * sensor.electrons_per_lsb
    noise = np.sqrt(codes.var(axis=0, ddof=1).mean(axis=(1, 2))).max()
    assert plan.tolerance_e == pytest.approx(0.3 * noise, rel=0.05)


def test_plans_without_measurement_give_the_reasons_of_their_own_chip() -> None:
    """In a frame of 4 s, the leakage of other numbers of pixels is far from the mean on two chips;
    a plan that is made again for the first chip has the reasons of the first."""
    container = case("b edges", SLOTS, slot="500ms", rows=SIDE, cols=SIDE)
    light = Light.of_clip(np.full((SLOTS, SIDE, SIDE), 100.0, np.float32))
    reasons = [
        nscc_runtime.capture(container, light, effects="all", device_seed=seed).plan
        for seed in (0, 1, 0)
    ]
    first, second, again = (plan.slot_loop_reasons for plan in reasons if plan is not None)
    assert "the leakage of" in first[0]
    assert first == again != second


def test_light_without_end_and_no_light_have_plans() -> None:
    """One pixel that is infinite, dark or NaN does not spoil the plan: the predicted error stays
    within 5 electrons."""
    container = case("b edges", SLOTS, rows=SIDE, cols=SIDE)
    for value in (np.inf, 0.0, np.nan):
        clip = np.full((SLOTS, SIDE, SIDE), 100.0, np.float32)
        clip[:, 5, 7] = value
        plan = measured_plan(container, Light.of_clip(clip), sensor_of(container), "5e")
        assert plan.predicted_e <= 5.0
