"""Plans of programs that look: what they foresee, against frames with all effects."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from plan_cases import plan_of

from nscc.chips.load import builtin_target
from nscc.codec import from_plain
from nscc.compiler import compile_file, compile_source
from nscc.diagnostics.diagnostic import Severity
from nscc.pipeline import Options
from nscc.source import Source
from nscc.words.container import Container
from nscc_runtime import captures
from nscc_runtime.effects import everything
from nscc_runtime.light import Light
from nscc_runtime.planning.make import measured_again, served_plan
from nscc_runtime.planning.plan import MOST_OTHER_STATES, Plan
from nscc_runtime.planning.planned_scene import PlannedScene
from nscc_runtime.reference.capture import Reference, reference_scene
from nscc_runtime.request import Request
from nscc_runtime.sensor import default_sensor
from nscc_runtime.simulate import Listener, Simulated, simulate

SIDE, SLOTS = 96, 32
TEXT = f"""nsl 2
frame {SLOTS} slots of 1ms
sense bright when light > 45% at n in [1, 4, 16]
state closed : 0..3 = 0
next closed = looks when bright and closed == 0
open when closed == 0
read closed
"""


@pytest.fixture(scope="module")
def program() -> Container:
    target = replace(builtin_target("scamp5"), rows=SIDE, cols=SIDE)
    made = compile_source(Source("t.nsl", TEXT), Path(), Options(level=0, target=target)).container
    assert made is not None
    return made


def light(full_wells: float) -> Light:
    """A still of smooth light with a bright lamp, in full wells a frame."""
    y, x = np.mgrid[:SIDE, :SIDE] / SIDE
    still = np.exp(2.0 * np.sin(3.0 * x) * np.cos(5.0 * y)) + 30.0 * ((x - 0.3) ** 2 < 1e-4)
    still *= full_wells * 30000.0 / (SLOTS * 1e-3)
    return Light.of_still(still.astype(np.float32), np.full(SLOTS, 1e-3))


def run(
    program: Container, scene: Light, effects: str, listener: Listener | None = None, **given: Any
) -> tuple[Plan, Simulated]:
    request = Request.of(effects=effects, **{"audit": True, **given})
    sensor = default_sensor(program.target)
    done = simulate(program, scene, sensor, request, listener or Listener())
    assert done.plan is not None
    return done.plan, done


@pytest.mark.parametrize("full_wells", [0.05, 2.0])
@pytest.mark.parametrize("tolerance", [2.0, 40.0])
def test_errors_of_plans_of_looking_programs_stay_within_the_tolerance_as_predicted(
    program: Container, full_wells: float, tolerance: float
) -> None:
    plan, done = run(program, light(full_wells), "auto", tolerance=tolerance, audit=True)
    report = done.audit
    assert report is not None
    assert report.holds
    assert plan.predicted_e <= 0.9 * tolerance
    if report.measured_rms_e > 0.1 * tolerance:
        assert plan.predicted_e == pytest.approx(report.measured_rms_e, rel=0.25)
    assert report.path_e is None  # the loop exposes the frames
    dropped = {each.name for each in plan.decisions if each.decision == "dropped"}
    if full_wells < 1.0 or tolerance > 10.0:
        assert dropped
    else:
        assert dropped <= {"reset"}  # a quarter of an electron
    assert plan.slot_loop


def test_plans_keep_comparator_noise_where_it_changes_the_final_states_of_pixels(
    program: Container,
) -> None:
    bright, dim = (run(program, light(wells), "auto", tolerance=5.0)[0] for wells in (2.0, 0.01))
    for plan, choice in ((bright, "kept"), (dim, "absent")):
        found = {each.name: each for each in plan.decisions}
        assert found["comparator_noise"].decision == choice
    noise = next(each for each in bright.decisions if each.name == "comparator_noise")
    sensor, scene = default_sensor(program.target), reference_scene(program, light(2.0))
    planes = [
        Reference.of(program, sensor, effects).execute(scene, program.planes(), (0, 0), 0).planes
        for effects in (everything(), everything().without("comparator_noise"))
    ]
    turned = np.logical_or.reduce([planes[0][name] != planes[1][name] for name in planes[0]]).mean()
    assert turned > MOST_OTHER_STATES
    assert noise.other_states == pytest.approx(turned, rel=0.5)


def test_effects_that_are_forced_off_break_the_tolerance_with_a_warning(program: Container) -> None:
    warned: list[Severity] = []
    listener = Listener(warn=lambda diagnostic: warned.append(diagnostic.severity))
    effects = "auto,-comparator_noise,-comparator_offset"
    plan, done = run(program, light(2.0), effects, listener, audit=True)
    assert warned == [Severity.WARNING]
    assert plan.breach is not None
    assert "other states" in plan.breach
    assert "other states" in str(plan)
    report = done.audit
    assert report is not None
    assert not report.holds
    assert report.other_states == pytest.approx(plan.other_states, rel=0.5)
    assert done.broken is not None
    assert "in other states" in done.broken.diagnostics[0].message


def test_a_plan_survives_json_and_is_measured_on_other_scenes(program: Container) -> None:
    """The plan read from JSON is equal. In brighter light it predicts a larger error with the same
    effects."""
    plan, _ = run(program, light(0.05), "auto", tolerance=40.0)
    again: Plan = from_plain(Plan, json.loads(json.dumps(plan.as_json())))
    assert again == plan
    scene = PlannedScene(program, default_sensor(program.target), light(2.0))
    brighter = measured_again(scene, again)
    assert brighter.kept.on == plan.kept.on
    assert brighter.predicted_e > plan.predicted_e


@pytest.mark.parametrize(
    ("name", "rows", "cols", "e_per_s", "tolerance"),
    [("first_light", 2, 19, 1.4e6, "1%"), ("float_pixel", 4, 14, 2.9e5, "50e")],
)
def test_errors_of_few_pixels_in_small_arrays_are_predicted(
    name: str, rows: int, cols: int, e_per_s: float, tolerance: str, root: Path
) -> None:
    """One frame of them shows none that ends in another state, nor one in a thousand."""
    target = replace(builtin_target("scamp5"), rows=rows, cols=cols)
    small = compile_file(root / "examples" / f"{name}.nsl", Options(target=target)).container
    assert small is not None
    still = np.tile(e_per_s * np.linspace(0.05, 4.0, cols), (rows, 1))
    ramp = Light.of_still(still.astype(np.float32), np.array(small.slot_us) * 1e-6)
    (found,) = captures(small, [ramp], tolerance=tolerance, audit=True)
    assert found.plan is not None
    assert found.audit is not None
    assert found.audit.breach(found.plan) is None


def test_films_of_programs_that_look_share_a_plan(program: Container) -> None:
    """The second scene is a mirror image at 99 % of the light: it uses the first scene's plan, and
    both audits hold."""
    first = light(0.2)
    mirrored = np.ascontiguousarray(first.frames[0][:, ::-1] * np.float32(0.99))
    film = [first, Light.of_still(mirrored, first.weight)]
    found = captures(program, film, tolerance="50e", audit=True)
    assert [each.plan.reused for each in found if each.plan] == [False, True]
    assert all(each.audit is not None and each.audit.holds for each in found)


def test_a_plan_serves_a_scene_only_where_few_pixels_end_in_other_states(
    program: Container,
) -> None:
    """The light is even. Where it is near a level, the dropped effects change the final states of
    pixels."""
    plan = replace(plan_of("all,-shot,-prnu", tolerance_e=1e4))
    weight = light(1.0).weight

    def served(full_wells: float) -> tuple[bool, float]:
        still = np.full((SIDE, SIDE), full_wells * 30000.0 / weight.sum(), np.float32)
        scene = PlannedScene(program, default_sensor(program.target), Light.of_still(still, weight))
        measured = measured_again(scene, plan)
        return served_plan(scene, plan, plan.tolerance) is not None, measured.other_states

    for full_wells in (0.05, *np.geomspace(0.5, 4.0, 12)):
        serves, other_states = served(float(full_wells))
        assert serves is (other_states <= 0.7 * MOST_OTHER_STATES)
