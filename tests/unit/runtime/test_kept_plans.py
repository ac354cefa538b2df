"""Plans that serve the next scenes of a film or a batch, and their promise on these scenes."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np
import pytest
from plan_cases import case, plan_of
from promise import error_of, full_frames, still
from successions import broken_successions

import nscc
from nscc.diagnostics.diagnostic import Rejected
from nscc_runtime import capture, captures
from nscc_runtime.captured import Capture
from nscc_runtime.effects import selected
from nscc_runtime.kept_plans import KeptPlans, Turn
from nscc_runtime.light import Light
from nscc_runtime.planning.make import make_plan
from nscc_runtime.planning.plan import Plan
from nscc_runtime.planning.plan_request import PlanRequest
from nscc_runtime.planning.planned_scene import planning_of
from nscc_runtime.scenes.timing import with_motion
from nscc_runtime.sensor import default_sensor

PROGRAM = case("b edges", 8, rows=64, cols=64)
WIDE = still(8, 64, 72, 3000.0).astype(np.float32)
STOPS = nscc.compile(
    """nsl 1
frame 16 slots of 1ms
code stop : 1..16
open when n < stop
pixels stop = tile [[4, 16], [8, 12]]
"""
).container
SENSOR = default_sensor(STOPS.target)


def frames(count: int) -> list[np.ndarray]:
    """A film that pans over a picture, with a little flicker; each frame is a clip of slots."""
    return [WIDE[:, :, k : k + 64] * (1.0 - 0.01 * k) for k in range(count)]


def lamps(slots: int) -> Light:
    """1,024 lamps of 60,000 electrons, even over the array, that are lit in the first slots."""
    clip = np.full((16, 256, 256), 2.0, np.float32)
    clip[:slots, ::8, ::8] += 60_000.0 / slots
    return Light.of_clip(clip)


def stripes(moved: int) -> Light:
    """Stripes of 10 and 1,710 electrons a slot, 8 pixels wide, that move in each slot."""
    columns = np.arange(256)
    rows = [np.where((columns + moved * n) // 8 % 2, 1710.0, 10.0) for n in range(16)]
    clip = np.broadcast_to(np.array(rows, np.float32)[:, None], (16, 256, 256))
    return with_motion(Light.of_clip(np.ascontiguousarray(clip)))


def error_e(plan: Plan, light: Light) -> float:
    """The error of a plan on a scene, in electrons."""
    full = full_frames(STOPS, light, SENSOR, 1, device_seed=0)
    return error_of(plan, full, STOPS, light, SENSOR, device_seed=0)


@pytest.mark.parametrize("tolerance", ["5e", "0.1noise"])
def test_lamps_that_flash_are_planned_anew(tolerance: str) -> None:
    """After 30 steady scenes the lamps give their light in a quarter of the time. The new plan
    keeps its promise and models saturation."""
    steady, flash = lamps(16), lamps(4)
    *_, last = captures(STOPS, [steady] * 30 + [flash], effects="auto", tolerance=tolerance)
    # A promise has a tenth of slack.
    assert last.plan.tolerance_e is None or error_e(last.plan, flash) <= 1.1 * last.plan.tolerance_e
    assert {"full_well", "register"} <= last.plan.kept.on


def test_a_given_plan_warns_of_lamps_that_flash() -> None:
    """A plan without saturation is given by the caller, so it stays in use. The warning NS0749
    comes, and its predicted error is the true one within 15 %."""
    steady, flash = lamps(16), lamps(4)
    scene = planning_of(STOPS, SENSOR, steady)
    loose = make_plan(scene, PlanRequest(selected("auto,-full_well,-register"), "5e", figures=True))
    plan = replace(loose, tolerance_e=900.0)
    with pytest.warns(UserWarning, match="NS0749"):
        taken = capture(STOPS, flash, plan=plan)
    assert taken.plan.predicted_e == pytest.approx(error_e(plan, flash), rel=0.15)


def test_stripes_that_begin_to_move_are_planned_anew() -> None:
    """After six still scenes the plan for moving stripes has the effect `motion` and an error
    within the tolerance."""
    still_stripes, moving = stripes(0), stripes(4)
    *_, last = captures(STOPS, [still_stripes] * 6 + [moving], effects="auto", tolerance="5e")
    assert "motion" in last.plan.kept.on
    # The tolerance of 5 electrons, with a tenth of slack.
    assert error_e(last.plan, moving) <= 5.5


def test_errors_stay_within_the_tolerance_for_any_succession_of_scenes() -> None:
    assert broken_successions(range(6)) == []


@pytest.mark.parametrize("tolerance", ["0.3noise", "50e"])
def test_frames_that_share_a_plan_are_measured(tolerance: str) -> None:
    film = frames(4)
    plans = KeptPlans()
    found = [
        capture(PROGRAM, light, tolerance=tolerance, turn=Turn(plans, number))
        for number, light in enumerate(film)
    ]
    assert [each.plan.reused for each in found] == [False, True, True, True]
    sensor = default_sensor(PROGRAM.target)
    for light, each in zip(film, found, strict=True):
        full = full_frames(PROGRAM, Light.of_clip(light), sensor, 16, device_seed=0)
        error = error_of(each.plan, full, PROGRAM, Light.of_clip(light), sensor, device_seed=0)
        assert each.plan.predicted_e == pytest.approx(error, rel=0.15)
    assert found[2].meta["plan"]["reused"]
    assert "made for an earlier scene" in str(found[2].plan)


@pytest.mark.parametrize("threads", [1, 4])
def test_the_order_of_scenes_alone_decides_which_plan_a_scene_reuses(threads: int) -> None:
    film = frames(2)
    spot = film[0].copy()
    spot[:, 3, 3] = 20 * film[0].max()
    lights = [film[0], film[1], film[0] * 3.0, film[0] * 0.3, spot, film[0][0]]

    def taken(threads: int) -> list[Capture]:
        plans = KeptPlans()
        plans.expect(range(len(lights)))

        def run(number: int) -> Capture:
            turn = Turn(plans, number)
            return capture(PROGRAM, lights[number], tolerance="60e", threads=1, turn=turn)

        with ThreadPoolExecutor(threads) as pool:
            return [*pool.map(run, range(len(lights)))]

    found, alone = taken(threads), taken(1)
    assert [each.plan for each in found] == [each.plan for each in alone]
    assert found[1].plan.reused
    assert not found[2].plan.reused
    for each, other in zip(found, alone, strict=True):
        assert each.exposure_e.tobytes() == other.exposure_e.tobytes()


@pytest.mark.parametrize("weights", [[2.0] * 5, [0.5, 1.0, 0.0, 3.0, 2.0]])
def test_the_sum_of_the_light_is_computed_once(weights: list[float]) -> None:
    """The sum over slots is kept: the second access returns the same array. An infinite pixel sums
    to 1e36, the most allowed."""
    frames = np.random.default_rng(2).uniform(0, 9, (3, 4, 6)).astype(np.float32)
    starts, index = np.arange(6), np.array([0, 2, 1, 1, 0], np.int32)
    light = Light(frames, starts, index, np.array(weights), "clip")
    np.testing.assert_allclose(light.sum_e, light.dense().astype(np.float64).sum(axis=0), 1e-6)
    assert light.sum_e is light.sum_e
    frames[0, 1, 1] = np.inf
    # Sums are at most 1e36.
    assert replace(light).sum_e[1, 1] == 1e36


ALL, SOME = plan_of("all"), plan_of("shot,read")


def planned(
    plans: KeptPlans, number: int, plan: Plan = ALL, frames: int = 1000, fits: bool = True
) -> tuple[Plan, int | None]:
    """The plan of a scene, and for how many frames it was made anew. An earlier plan `fits`."""
    asked: list[int] = []

    def make(expected: int) -> Plan:
        asked.append(expected)
        return plan

    def measure(earlier: Plan) -> Plan | None:
        return replace(earlier, reused=True) if fits else None

    found = plans.plan(Turn(plans, number, frames), "request", make, measure)
    return found, asked[0] if asked else None


def test_a_plan_that_does_not_fit_a_scene_is_made_anew() -> None:
    """The plan is expected to last 1000 frames, and after one that failed at once, 1. The next
    scene takes the new plan again."""
    plans = KeptPlans()
    assert planned(plans, 0, ALL) == (ALL, 1000)
    assert planned(plans, 1, SOME, fits=False) == (SOME, 1)
    assert planned(plans, 2, ALL) == (replace(SOME, reused=True), None)


def test_plans_are_expected_to_last_as_long_as_the_last_one() -> None:
    """A plan served five scenes, so the next is expected to serve 5, and the ones after it 1."""
    plans = KeptPlans()
    made = [planned(plans, number)[1] for number in range(5)]
    assert made == [1000, None, None, None, None]
    assert [planned(plans, 5 + k, fits=False)[1] for k in range(3)] == [5, 1, 1]
    assert planned(plans, 9, frames=2, fits=False)[1] == 1


def test_a_plan_is_made_again_after_8_scenes_and_then_after_16() -> None:
    plans = KeptPlans()
    made = [number for number in range(40) if planned(plans, number)[1] is not None]
    assert made == [0, 8, 24]


def test_a_failed_plan_is_not_kept() -> None:
    """The error reaches the caller and the next scene makes a plan. A later call takes it without
    making one."""
    plans = KeptPlans()

    def fails(_frames: int) -> Plan:
        raise ValueError("no plan")

    with pytest.raises(ValueError, match="no plan"):
        plans.plan(Turn(plans, 0), "request", fails, lambda plan: plan)
    assert planned(plans, 1) == (ALL, 1000)
    assert plans.plan(Turn(plans, 2), "request", fails, lambda plan: plan) is ALL


@pytest.mark.parametrize("lost", [0, 1, 2, 3])
def test_a_film_continues_after_a_skipped_or_refused_frame(lost: int) -> None:
    """A number that is skipped, and one whose capture was refused."""
    plans, film = KeptPlans(), frames(4)
    for number, light in enumerate(film):
        if number == lost:
            with pytest.raises(Rejected):
                capture(PROGRAM, light[:, :8], tolerance="5e", turn=Turn(plans, number))
        elif number != lost + 1:
            taken = capture(PROGRAM, light, tolerance="5e", turn=Turn(plans, number))
            assert taken.plan is not None


def test_captures_with_one_rejected_scene_raise_its_error_and_do_not_hang() -> None:
    lights = frames(5)
    lights[2] = lights[2][:, :8]
    with pytest.raises(Rejected):
        captures(PROGRAM, lights, tolerance="5e", threads=3)
