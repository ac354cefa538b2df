"""Plans that serve the next frames of a film: when they do, and that the promise holds there."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from plan_cases import case
from promise import still

from nscc.diagnostics.diagnostic import Rejected
from nscc_runtime import capture, captures
from nscc_runtime.effects import Selection, registered
from nscc_runtime.execution.program import analysed
from nscc_runtime.kept_plans import KeptPlans, Statistics, Turn
from nscc_runtime.light import Light
from nscc_runtime.planning.plan import Plan
from nscc_runtime.planning.plan_parts import Decision
from nscc_runtime.sensor import default_sensor

PROGRAM = case("b edges", 8, rows=64, cols=64)
WIDE = still(8, 64, 72, 3000.0).astype(np.float32)
LIGHT = Light.of_clip(np.ascontiguousarray(WIDE[:, :, :64]))
OPEN = analysed(PROGRAM, default_sensor(PROGRAM.target)).open_part
NOTHING = Plan(
    None, None, None, "none", (), 0.0, (),
    tuple(
        Decision(effect.name, effect.kind, "dropped", True, "", None, None, None, 0.0)
        for effect in registered()
    ),
)  # fmt: skip
"""The plan that simulates no effect."""
MEASURED = replace(NOTHING, tolerance_e=5.0, predicted_e=1.0)


def statistics(light: Light, part: np.ndarray = OPEN) -> Statistics:
    return Statistics.of(light, part)


def frames(count: int) -> list[np.ndarray]:
    """A film that pans over a picture, with a little flicker; each frame is a clip of slots."""
    return [WIDE[:, :, k : k + 64] * (1.0 - 0.01 * k) for k in range(count)]


@pytest.mark.parametrize("tolerance", ["0.1noise", "5e", "50e"])
def test_the_promise_holds_on_frames_that_share_a_plan(tolerance: str) -> None:
    found = captures(PROGRAM, frames(4), tolerance=tolerance, audit=True)
    assert [each.plan.reused for each in found if each.plan] == [False, True, True, True]
    assert all(each.audit is not None and each.audit.holds for each in found)
    assert found[2].meta["plan"]["reused"]
    assert "made for an earlier scene" in str(found[2].plan)


@pytest.mark.parametrize("threads", [1, 4])
def test_whose_plan_a_scene_takes_follows_from_the_order_alone(threads: int) -> None:
    film = frames(2)
    bright, dark, spot = film[0] * 1.2, film[0] * 0.3, film[0].copy()
    spot[:, 3, 3] = 2 * film[0].max()
    lights = [film[0], film[1], bright, bright, dark, spot, film[0][0]]
    found = captures(PROGRAM, lights, tolerance="5e", threads=threads, audit=True)
    reused = [each.plan is not None and each.plan.reused for each in found]
    assert reused == [False, True, False, True, False, False, False]
    for light, each in zip(lights, found, strict=True):
        if each.plan is not None and not each.plan.reused:
            alone = capture(PROGRAM, light, tolerance="5e", audit=True)
            assert alone.exposure_e.tobytes() == each.exposure_e.tobytes()


@pytest.mark.parametrize(
    "changed",
    [
        lambda x: x * 1.05,  # brighter
        lambda x: np.where(np.arange(64) % 2, x * 1.9, x * 0.1),  # as bright, with steeper steps
        lambda x: x[::-1] * (np.arange(8) < 4)[:, None, None] * 2.0,  # as bright, earlier
        lambda x: x * np.where(OPEN.mean() < OPEN, 1.3, 0.7),  # as bright, where pixels are open
        lambda x: np.where(x == x.max(), np.inf, x),  # without end
    ],
)
def test_light_that_grows_in_any_way_is_planned_anew(changed: object) -> None:
    base = np.full((8, 64, 64), 300.0, np.float32)
    base += np.random.default_rng(3).normal(0.0, 3.0, (64, 64)).astype(np.float32)
    assert callable(changed)
    light, other = Light.of_clip(base), Light.of_clip(np.asarray(changed(base), np.float32))
    assert statistics(light).resembles(statistics(light))
    assert not statistics(light).resembles(statistics(other))


def test_what_saturates_may_not_grow_where_a_plan_leaves_saturation_out() -> None:
    light = LIGHT.dense()
    one, more = statistics(LIGHT), statistics(Light.of_clip(light * np.float32(1.01)))
    assert one.resembles(more)
    assert not one.resembles(more, saturating=False)
    assert not one.covers(more, NOTHING)


def test_dark_scenes_and_narrow_ones_have_statistics() -> None:
    for shape in ((2, 1, 40), (2, 40, 1), (2, 1, 1), (2, 3, 5)):
        part = np.ones(shape[1:], np.float32)
        dark = statistics(Light.of_clip(np.zeros(shape, np.float32)), part)
        assert dark.resembles(dark)
        lit = statistics(Light.of_clip(np.ones(shape, np.float32)), part)
        assert lit.resembles(lit)
        assert not dark.resembles(lit)


@pytest.mark.parametrize("weights", [[2.0] * 5, [0.5, 1.0, 0.0, 3.0, 2.0]])
def test_light_is_added_up_once_for_all_who_ask(weights: list[float]) -> None:
    frames = np.random.default_rng(2).uniform(0, 9, (3, 4, 6)).astype(np.float32)
    starts, index = np.arange(6), np.array([0, 2, 1, 1, 0], np.int32)
    light = Light(frames, starts, index, np.array(weights), "clip")
    np.testing.assert_allclose(light.sum_e, light.dense().astype(np.float64).sum(axis=0), 1e-6)
    assert light.sum_e is light.sum_e
    frames[0, 1, 1] = np.inf
    assert replace(light).sum_e[1, 1] == 1e36


def test_the_sizes_of_light_are_means_of_its_powers() -> None:
    light = Light.of_clip(np.random.default_rng(1).uniform(1, 9, (2, 5, 7)).astype(np.float32))
    part = np.random.default_rng(2).uniform(0, 1, (5, 7)).astype(np.float32)
    total = light.dense().astype(np.float64).sum(axis=0)
    steps = np.concatenate([np.diff(total, axis=axis).reshape(-1) for axis in (0, 1)])

    def sizes(values: np.ndarray) -> list[float]:
        powers = [(values**power).mean() ** (1 / power) for power in (1, 2, 8)]
        return [*powers, values.max()]

    expected = [*sizes(total), *sizes(total * part), np.sqrt((steps**2).mean())]
    np.testing.assert_allclose(statistics(light, part).sizes, expected, 1e-6)


ASKED = Selection(frozenset(), frozenset())


def planned(
    plans: KeptPlans, number: int, plan: Plan, light: Light = LIGHT, frames: int = 1000,
    serves: bool = True,
) -> tuple[Plan, int | None]:  # fmt: skip
    """The plan of a scene, and for how many frames it was made anew."""
    asked: list[int] = []

    def make(expected: int) -> Plan:
        asked.append(expected)
        return plan

    turn = Turn(plans, number, frames)
    found = plans.plan(turn, ASKED, statistics(light), make, lambda _: serves)
    return found, asked[0] if asked else None


def test_a_plan_that_does_not_serve_a_scene_is_made_anew() -> None:
    plans, other = KeptPlans(), replace(MEASURED, tolerance_e=3.0)
    assert planned(plans, 0, MEASURED) == (MEASURED, 1000)
    assert planned(plans, 1, other, serves=False)[0] is other
    assert planned(plans, 2, MEASURED) == (replace(other, reused=True), None)


def test_a_plan_that_could_not_be_made_serves_nobody() -> None:
    plans = KeptPlans()

    def fails(_frames: int) -> Plan:
        raise ValueError("no plan")

    with pytest.raises(ValueError, match="no plan"):
        plans.plan(Turn(plans, 0), ASKED, statistics(LIGHT), fails, lambda _: True)
    assert planned(plans, 1, MEASURED)[0] is MEASURED
    found = plans.plan(Turn(plans, 2), ASKED, statistics(LIGHT), fails, lambda _: True)
    assert found.reused


def test_where_no_two_scenes_are_alike_no_plan_is_made_for_many() -> None:
    plans, unmeasured = KeptPlans(), NOTHING
    lights = [Light.of_clip(LIGHT.dense() * np.float32(2.0**k)) for k in range(4)]
    expected = [planned(plans, k, unmeasured, light)[1] for k, light in enumerate(lights)]
    assert expected == [1000, 1, 1, 1]
    # Of a scene that stays, as many more are expected as there were: measuring may pay by then.
    again = [planned(plans, 4 + k, unmeasured, lights[-1])[1] for k in range(3)]
    assert again == [2, 3, 4]
    assert planned(plans, 8, MEASURED, lights[-1], frames=2) == (MEASURED, 2)
    # A kind that lasted long is followed by one of which as many are expected.
    assert [planned(plans, 9 + k, MEASURED, lights[-1])[1] for k in range(3)] == [None] * 3
    assert planned(plans, 12, MEASURED, lights[0])[1] == 8


@pytest.mark.parametrize("lost", [0, 1, 2, 3])
def test_a_film_does_not_wait_for_a_frame_that_is_lost(lost: int) -> None:
    """A number that is skipped, and one whose capture was refused."""
    plans, film = KeptPlans(), frames(4)
    for number, light in enumerate(film):
        if number == lost:
            with pytest.raises(Rejected):
                capture(PROGRAM, light[:, :8], tolerance="5e", turn=Turn(plans, number))
        elif number != lost + 1:
            taken = capture(PROGRAM, light, tolerance="5e", turn=Turn(plans, number))
            assert taken.plan is not None


def test_one_rejected_scene_of_many_hangs_no_other() -> None:
    lights = frames(5)
    lights[2] = lights[2][:, :8]
    with pytest.raises(Rejected):
        captures(PROGRAM, lights, tolerance="5e", threads=3)
