"""Frames under an execution, beside the reference with the same effects."""

from __future__ import annotations

import gc
from dataclasses import replace
from weakref import ref

import numpy as np
import pytest
from plan_cases import CASES, case, exposed_under, moving_light, plan_of
from reference_programs import exposures, sensor_of

from nscc.diagnostics.diagnostic import Rejected
from nscc.words.container import Container
from nscc_runtime.effects import optional
from nscc_runtime.execution.frames import ExecutedScene, near_pixels
from nscc_runtime.light import Light
from nscc_runtime.planning.plan import Plan
from nscc_runtime.sensor import Sensor

ROWS, COLS = 12, 16
SEED, DEVICE = 3, 5


def planned(container: Container, light: Light, sensor: Sensor, plan: Plan) -> ExecutedScene:
    return exposed_under(plan, container, light, sensor, DEVICE)


def near(scene: ExecutedScene) -> np.ndarray:
    """The places that run through their words."""
    return near_pixels(scene.program, scene.light, scene.device_seed, scene.execution)


def both(
    name: str, effects: str, light: Light, **values: float
) -> tuple[np.ndarray, np.ndarray, ExecutedScene]:
    """Frame 1 by sums and by the reference (buckets, rows, cols)."""
    container = case(name, rows=ROWS, cols=COLS)
    sensor = sensor_of(container, **values)
    scene = planned(container, light, sensor, plan_of(effects))
    full = exposures(container, light, sensor, effects, 2, SEED, DEVICE)[1]
    return scene.expose(SEED, 1).exposure_e, full, scene


LINEAR = ("none", "prnu", "lag", "prnu,lag", "crosstalk", "crosstalk,prnu", "dead_time",
          "dead_time,crosstalk,lag")  # fmt: skip


@pytest.mark.parametrize("effects", LINEAR)
@pytest.mark.parametrize("name", CASES)
def test_fixed_effects_are_exact_sums(name: str, effects: str) -> None:
    found, full, scene = both(name, effects, moving_light((8, ROWS, COLS), 300.0))
    assert not len(near(scene))
    np.testing.assert_allclose(found, full, rtol=2e-6, atol=1e-3)


@pytest.mark.parametrize("name", CASES)
def test_leakage_between_rates_is_near(name: str) -> None:
    """Frames of 4 ms, where registers keep charge for 500 ms: what is more goes by words."""
    light = moving_light((8, ROWS, COLS), 300.0)
    found, full, _ = both(name, "leakage", light, leakage_tau_s=0.5)
    np.testing.assert_allclose(found, full, rtol=1e-4, atol=1e-3)
    plain, _, _ = both(name, "none", light)
    # The only write of class a is the last word of all.
    assert (np.abs(plain - full).max() > 5) == (name != "a")


@pytest.mark.parametrize("effects", ["shot", "shot,prnu,lag", "shot,crosstalk"])
@pytest.mark.parametrize("name", CASES)
def test_counts_are_the_references_but_for_rare_ones(name: str, effects: str) -> None:
    """One draw a group, by formula from a rate of 10 on: another count in few pixels."""
    found, full, _ = both(name, effects, moving_light((8, ROWS, COLS), 300.0))
    plain, _, _ = both(name, "none", moving_light((8, ROWS, COLS), 300.0))
    away = np.abs(found - full)
    limit = 1e-3 if "crosstalk" not in effects else 4.0
    assert (away > limit).mean() < 0.01
    assert away.max() <= 1.0 + limit
    assert np.std(plain - full) > 10


def test_dark_counts_of_open_and_closed_slots() -> None:
    light = moving_light((8, ROWS, COLS), 0.0)
    for name in ("b edges", "d accumulate", "two buckets"):
        found, full, _ = both(name, "dark", light, dark_current_e_per_s=50000.0)
        assert full.max() > 50
        assert (np.abs(found - full) > 1e-6).mean() < 0.01


@pytest.mark.parametrize("effects", ["read", "reset", "analog", "read,reset,analog"])
@pytest.mark.parametrize("name", CASES)
def test_the_noise_of_words_is_one_draw_a_bucket(name: str, effects: str) -> None:
    """With the other effects of the sensor as they were when the draws were laid out."""
    container = case(name, rows=ROWS, cols=COLS)
    sensor = sensor_of(container, leakage_spread_fraction=0.0, analog_gain=1.0,
                       leakage_tau_s=1e6)  # fmt: skip
    light = moving_light((8, ROWS, COLS), 300.0)
    scene = planned(container, light, sensor, plan_of(effects))
    full = exposures(container, light, sensor, effects, 1, SEED, DEVICE)[0]
    np.testing.assert_allclose(scene.expose(SEED, 0).exposure_e, full, rtol=1e-5, atol=0.01)
    plain = exposures(container, light, sensor, "none", 1, SEED, DEVICE)[0]
    # A bump read at both of its edges has the level of one reset twice, and loses it.
    assert np.std(full - plain) > 5 or effects == "reset"


def test_motion_is_the_moving_light() -> None:
    from nscc_runtime.scenes.timing import with_motion

    light = with_motion(moving_light((8, ROWS, COLS), 300.0))
    for effects in ("motion", "none", "motion,prnu"):
        found, full, _ = both("c edges", effects, light)
        np.testing.assert_allclose(found, full, rtol=1e-5, atol=1e-3)


@pytest.mark.parametrize(
    ("effects", "most_e"),
    [("all,-crosstalk,-dead_time", 1e-5), ("all", 4.0), ("all,-shot,-dark", 1e-5)],
)
@pytest.mark.parametrize("name", CASES)
def test_saturating_pixels_run_through_their_words(name: str, effects: str, most_e: float) -> None:
    """Some pixels at their limits: equal to the reference there, but for when counts of neighbours
    come, and those of slots that words see a part of, which is taken from their light."""
    container = case(name, rows=ROWS, cols=COLS)
    sensor = sensor_of(container, register_max_e=9000.0, register_min_e=-9000.0)
    light = moving_light((8, ROWS, COLS), 300.0)
    light.frames[:, 4, 5] = 20000.0
    scene = planned(container, light, sensor, plan_of(effects))
    assert 4 * COLS + 5 in near(scene)
    assert len(near(scene)) < ROWS * COLS / 2
    full = exposures(container, light, sensor, effects, 2, SEED, DEVICE)[1]
    found = scene.expose(SEED, 1).exposure_e
    rows, cols = np.divmod(near(scene), COLS)
    away = np.abs(found - full)[:, rows, cols]
    assert away.max() < most_e
    assert np.sqrt(np.mean(away**2)) < most_e / 4


def test_light_that_is_not_kept_is_laid_out_again(monkeypatch: pytest.MonkeyPatch) -> None:
    """Pixels in several parts, whose light takes more memory than is kept: the same frames."""
    from nscc_runtime.execution import pixels

    container = case("d edges", rows=ROWS, cols=COLS)
    sensor = sensor_of(container, register_max_e=9000.0, register_min_e=-9000.0)
    plan = plan_of("all")
    clip = moving_light((8, ROWS, COLS), 2000.0)
    for light in (clip, Light.of_still(clip.frames[0], np.full(8, 1.0))):
        kept, parts = (planned(container, light, sensor, plan) for _ in range(2))
        frames = [kept.expose(SEED, number).exposure_e for number in range(2)]
        with monkeypatch.context() as limited:
            limited.setattr(pixels, "_MOST_LIGHT", 4000)
            again = [parts.expose(SEED, number).exposure_e for number in range(2)]
        assert len(near(kept)) > 20
        np.testing.assert_array_equal(again, frames)
        assert np.any(frames[0] != frames[1])


@pytest.mark.parametrize("effects", ["all", "all,-shot", "full_well", "register,prnu"])
@pytest.mark.parametrize("name", CASES)
def test_no_pixel_that_saturates_is_missed(name: str, effects: str) -> None:
    """Light around the limits: what the bound lets through loses nothing worth mentioning."""
    container = case(name, rows=ROWS, cols=COLS)
    sensor = sensor_of(container)
    light = moving_light((8, ROWS, COLS), 7000.0)
    scene = planned(container, light, sensor, plan_of(effects))
    lossless = ",".join(n for n in (*effects.split(","), "-full_well", "-register"))
    full, free = (
        exposures(container, light, sensor, names, 1, SEED, DEVICE)[0]
        for names in (effects, lossless)
    )
    lost = np.abs(full - free).max(axis=0).reshape(-1)
    assert lost.max() > 1000
    lost[near(scene)] = 0.0
    assert lost.max() < 1.0


@pytest.mark.parametrize("effects", ["all", "none", "shot,crosstalk,read", *optional()])
def test_all_pixels_through_their_words_are_the_reference(effects: str) -> None:
    container = case("d edges", rows=ROWS, cols=COLS)
    light, sensor = moving_light((8, ROWS, COLS), 3000.0), sensor_of(container)
    scene = planned(container, light, sensor, plan_of(effects, loop="all"))
    full = exposures(container, light, sensor, effects, 1, SEED, DEVICE)[0]
    np.testing.assert_allclose(scene.expose(SEED, 0).exposure_e, full, rtol=1e-9, atol=1e-6)


@pytest.mark.parametrize("name", ["b edges", "d accumulate", "two buckets"])
def test_threads_change_no_bit(name: str) -> None:
    container = case(name, rows=40, cols=50)
    light = moving_light((8, 40, 50), 5000.0)
    plan, sensor = plan_of("all"), sensor_of(container)
    found = {
        threads: exposed_under(plan, container, light, sensor, threads=threads).expose(SEED, 0)
        for threads in (1, 2, 5)
    }
    assert len({each.exposure_e.tobytes() for each in found.values()}) == 1


def test_frames_and_seeds_differ_and_come_again() -> None:
    container = case("b edges", rows=ROWS, cols=COLS)
    light, sensor = moving_light((8, ROWS, COLS), 300.0), sensor_of(container)
    scene = planned(container, light, sensor, plan_of("all"))
    one, other, seeded, again = (
        scene.expose(seed, frame).exposure_e for seed, frame in ((1, 0), (1, 1), (2, 0), (1, 0))
    )
    assert one.tobytes() == again.tobytes()
    assert not np.array_equal(one, other)
    assert not np.array_equal(one, seeded)


def test_light_that_does_not_fit_is_refused_and_no_number_is_marked() -> None:
    container = case("b edges", rows=ROWS, cols=COLS)
    sensor = sensor_of(container)
    with pytest.raises(Rejected) as caught:
        planned(container, moving_light((8, ROWS, 5), 1.0), sensor, plan_of("all"))
    assert caught.value.diagnostics[0].code == "NS0734"
    light = moving_light((8, ROWS, COLS), 300.0)
    light.frames[0, 3, 4] = np.nan
    found = planned(container, light, sensor, plan_of("shot,dark,read")).expose(0, 0)
    assert not found.valid[0, 3, 4]
    assert found.valid.sum() == found.valid.size - 1


@pytest.mark.parametrize("name", CASES)
def test_lamps_take_their_neighbours_along_whatever_the_codes_are(name: str) -> None:
    """Charge of a lamp spills into slots in which its own shutter is closed."""
    container = case(name, 16, rows=ROWS, cols=COLS)
    sensor = sensor_of(container)
    light = moving_light((16, ROWS, COLS), 10.0)
    for row, col in ((2, 3), (5, 8), (9, 12)):
        light.frames[:, row, col] = 800_000.0
    scene = planned(container, light, sensor, plan_of("all"))
    full, free = (
        exposures(container, light, sensor, names, 1, SEED, DEVICE)[0]
        for names in ("all", "all,-full_well,-register")
    )
    lost = np.abs(full - free).max(axis=0).reshape(-1)
    assert (lost > 1.0).sum() > 2
    assert set(np.flatnonzero(lost > 1.0).tolist()) <= set(near(scene).tolist())


def test_a_code_read_once_beside_codes_read_often_loses_what_the_well_does() -> None:
    """Registers are far from full, so nothing but the well says that a pixel needs its words."""
    container = case("b accumulate", rows=ROWS, cols=COLS)
    sensor = sensor_of(container, full_well_e=500.0, register_knee_fraction=1.0)
    light = moving_light((8, ROWS, COLS), 900.0)
    scene = planned(container, light, sensor, plan_of("all"))
    full = exposures(container, light, sensor, "all", 1, SEED, DEVICE)[0]
    error = scene.expose(SEED, 0).exposure_e - full
    assert np.abs(error).max() < 5.0


@pytest.mark.parametrize("left", ["prnu", "dark", "lag", "crosstalk", "prnu,dark,lag,crosstalk"])
def test_what_a_plan_leaves_out_does_not_change_which_pixels_run(left: str) -> None:
    """The prediction has all pixels near their limits exact, with all effects."""
    container = case("d edges", 8, rows=ROWS, cols=COLS)
    sensor = sensor_of(container, prnu_fraction=0.1, dark_current_e_per_s=1e6)
    light = moving_light((8, ROWS, COLS), 4000.0)
    names = ["all", *(f"-{name}" for name in left.split(","))]

    def places(effects: str) -> list[int]:
        plan = plan_of(effects)
        free = tuple(replace(each, forced=False) for each in plan.decisions)
        scene = planned(container, light, sensor, replace(plan, decisions=free))
        found: list[int] = near(scene).tolist()
        return found

    assert places("all") == places(",".join(names))
    assert 0 < len(places("all")) < ROWS * COLS


@pytest.mark.parametrize(
    ("effects", "electrons", "loop"),
    [
        ("shot,read,full_well", 300.0, "some"), ("all", 300.0, "some"), ("all", 8000.0, "some"),
        ("all", 300.0, "all"), ("all", 300.0, "reference"),
    ],
)  # fmt: skip
def test_a_frames_light_is_let_go_of_with_it(effects: str, electrons: float, loop: str) -> None:
    """Films would hold many scenes at a time if they waited for the collector of cycles."""
    container = case("b edges", rows=ROWS, cols=COLS)
    light = moving_light((8, ROWS, COLS), electrons)
    scene = planned(container, light, sensor_of(container), plan_of(effects, loop=loop))
    gone = ref(light)
    gc.collect()
    gc.disable()
    try:
        assert list(scene.frames(SEED, 2))
        del light, scene
        assert gone() is None
    finally:
        gc.enable()
