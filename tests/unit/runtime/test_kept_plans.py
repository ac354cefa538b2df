"""Plans that serve the next scenes of a film or a batch, and their promise on these scenes."""

from __future__ import annotations

import warnings
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np
import pytest
from plan_cases import case, plan_of
from promise import difference_in_distribution, error_of, full_frames, still
from reference_programs import program, sensor_of
from successions import KINDS, succession

from nscc.diagnostics.diagnostic import Rejected
from nscc_runtime import capture, captures, plan
from nscc_runtime.captured import Capture
from nscc_runtime.kept_plans import KeptPlans, Turn
from nscc_runtime.light import Light
from nscc_runtime.planning.plan import Plan
from nscc_runtime.scenes.timing import with_motion
from nscc_runtime.sensor import default_sensor

PROGRAM = case("b edges", 8, rows=64, cols=64)
WIDE = still(8, 64, 72, 3000.0).astype(np.float32)
STOPS = program(
    """nsl 1
frame 16 slots of 1ms
code stop : 1..16
open when n < stop
pixels stop = tile [[4, 16], [8, 12]]
""",
    rows=64,
    cols=64,
)
QUIET = sensor_of(STOPS, analog_noise_lsb=0.0, dark_current_e_per_s=0.0)
"""Little noise, so that 32 frames tell the error of a plan from their own noise."""
REPEAT = 32


def frames(count: int) -> list[np.ndarray]:
    """A film that pans over a picture, with a little flicker; each frame is a clip of slots."""
    return [WIDE[:, :, k : k + 64] * (1.0 - 0.01 * k) for k in range(count)]


def lamps(slots: int) -> Light:
    """64 lamps, even over the array, that are lit in the first slots: each gives 24,000 electrons,
    every eighth 60,000, twice the full well. The pixels of lamps are open in four slots."""
    electrons = np.where(np.arange(64) % 8, 24_000.0, 60_000.0).reshape(8, 8)
    clip = np.full((16, 64, 64), 2.0, np.float32)
    clip[:slots, ::8, ::8] += electrons / slots
    return Light.of_clip(clip)


def stripes(moved: int) -> Light:
    """Samples of stripes of 10 and 1,710 electrons a slot, 8 pixels wide, that move by `moved`
    pixels in each slot, beside a bright bar that stands still and saturates."""
    columns = np.arange(64)
    rows = [np.where((columns + moved * n) // 8 % 2, 1710.0, 10.0) for n in range(16)]
    clip = np.repeat(np.array(rows, np.float32)[:, None], 64, axis=1)
    clip[:, :, :4] = 3000.0
    return with_motion(Light.of_clip(clip))


def difference_from_reference(taken: Capture, light: Light) -> float:
    """How far frames of `light` are from the reference in distribution, in electrons, after a check
    that they have the same maximum and that the same pixels reach their full well."""
    options = {"sensor": QUIET, "effects": "all", "fidelity": "reference"}
    true = capture(STOPS, light, **options, seed=5, repeat=REPEAT)
    assert taken.exposure_e.max() == pytest.approx(true.exposure_e.max(), rel=0.02)
    full, own_full = (frames.saturated_by.max(axis=0) & 1 for frames in (true, taken))
    assert full.any()
    np.testing.assert_array_equal(own_full, full)
    return difference_in_distribution(taken.exposure_e, true.exposure_e)


@pytest.mark.parametrize("tolerance", ["13e", "0.04noise"])
def test_lamps_that_flash_are_planned_anew(tolerance: str) -> None:
    """The plan of steady lamps is used again, without shot noise, until the lamps give their light
    in a quarter of the time: four times as much of it reaches their pixels, and some saturate."""
    plans = KeptPlans()
    options = {"sensor": QUIET, "tolerance": tolerance, "repeat": REPEAT}
    _, before, last = (
        capture(STOPS, light, **options, turn=Turn(plans, number))
        for number, light in enumerate([lamps(16), lamps(16), lamps(4)])
    )
    assert before.plan.reused
    assert "shot" in before.plan.names("dropped")
    # Without shot noise it would be 17 electrons. A promise has a tenth of slack.
    assert difference_from_reference(last, lamps(4)) <= 1.1 * before.plan.tolerance_e
    assert not last.plan.reused


def test_a_plan_of_steady_lamps_warns_of_lamps_that_flash() -> None:
    """A plan that the caller gives stays in use. A warning comes, and the frames differ from the
    reference by the predicted error. Pixels saturate as they should."""
    made = plan(STOPS, lamps(16), sensor=QUIET, tolerance="13e")
    assert "shot" in made.names("dropped")
    with pytest.warns(UserWarning, match="NS0749"):
        taken = capture(STOPS, lamps(4), sensor=QUIET, plan=made, repeat=REPEAT)
    assert taken.plan.predicted_e > 1.1 * 13
    error_e = difference_from_reference(taken, lamps(4))
    assert taken.plan.predicted_e == pytest.approx(error_e, rel=0.15)


@pytest.mark.parametrize(("tolerance", "part"), [("0.5lsb", 0.1), ("5e", 1.0)])
def test_a_plan_in_codes_has_the_electrons_of_the_sensor_that_it_is_used_on(
    tolerance: str, part: float
) -> None:
    """On a sensor with a tenth of the electrons in a code, half a code is a tenth of the electrons.
    A plan made for the other sensor breaks it, and a warning says so. Electrons stay."""
    made = plan(STOPS, lamps(16), sensor=QUIET, tolerance=tolerance)
    fine = QUIET.changed(electrons_per_lsb=QUIET.electrons_per_lsb / 10)
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        taken = capture(STOPS, lamps(16), sensor=fine, plan=made)
    assert taken.plan.tolerance_e == pytest.approx(part * made.tolerance_e)
    assert any("NS0749" in str(each.message) for each in said) is (part < 1)


def test_stripes_that_begin_to_move_are_planned_anew() -> None:
    """A plan with all figures leaves out motion while sampled stripes stand still, and is used
    again; not for the scene in which they move."""
    lights, options = [stripes(0), stripes(0), stripes(4)], {"sensor": QUIET, "tolerance": "20e"}
    _, before, last = captures(STOPS, lights, **options, audit=True, repeat=REPEAT)
    assert before.plan.reused
    assert "motion" in before.plan.names("dropped")
    assert difference_from_reference(last, stripes(4)) <= 1.1 * 20
    assert "motion" in last.plan.kept.on


def test_errors_stay_within_the_tolerance_for_any_succession_of_scenes() -> None:
    """Whatever happens to scenes after one that is exposed without some effects, errors stay within
    the tolerance, and frames agree with the loop over words. Light is given as sums over slots and
    as samples."""
    found = [succession(seed) for seed in (4, 6, 16, 29, 32, 35)]
    assert [text for broken, _ in found for text in broken] == []
    changes = set().union(*(each for _, each in found))
    assert changes == {*KINDS} | {f"{kind}, sampled" for kind in KINDS}


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


def test_a_shared_plan_that_drops_nothing_is_marked_as_reused() -> None:
    """At a tolerance that no effect fits into, nothing is dropped or measured."""
    plans = KeptPlans()
    found = [
        capture(PROGRAM, light, tolerance="1e-6e", turn=Turn(plans, number)).plan
        for number, light in enumerate(frames(2))
    ]
    assert [(each.names("dropped"), each.reused) for each in found] == [([], False), ([], True)]
    assert str(found[1]).endswith("made for an earlier scene")


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
