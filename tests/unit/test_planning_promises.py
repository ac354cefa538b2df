"""What plans promise and what they estimate, by the reference: errors, worst pixels, noise."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from plan_cases import case
from promise import full_frames, outcome, scene
from random_sensors import promises
from reference_programs import sensor_of

import nscc_runtime
from nscc.words.container import Container
from nscc_runtime.light import Light
from nscc_runtime.planning.differences import Worst, largest, worst_measured
from nscc_runtime.planning.plan_file import plan_text, read_plan
from nscc_runtime.sensor import Sensor

SLOTS, SIDE = 8, 48
FULL_E = 30000.0


def made(
    name: str, rows: int = SIDE, cols: int = SIDE, **values: float
) -> tuple[Container, Sensor]:
    container = case(name, SLOTS, rows=rows, cols=cols)
    return container, sensor_of(container, **values)


def flat(total_e: float) -> Light:
    return Light.of_clip(np.full((SLOTS, SIDE, SIDE), total_e / SLOTS, np.float32))


def test_worst_pixels_that_were_measured_weigh_what_they_stand_for() -> None:
    sizes, weight = np.arange(1.0, 101.0), np.ones(100)
    assert largest(sizes, weight).max_e == 100.0
    weight[-1] = 1e-4
    assert (largest(sizes, weight).p999_e, largest(sizes, weight).max_e) == (100.0, 100.0)
    weight[:] = 1.0
    weight[0] = 1e6
    assert largest(sizes, weight).p999_e == 2.0


@pytest.mark.parametrize(
    "law", [np.random.Generator.exponential, np.random.Generator.standard_normal]
)
def test_worst_pixels_of_which_some_were_measured_are_told_from_the_largest(
    law: Callable[..., np.ndarray],
) -> None:
    """By 288 of 2304 errors, all alike or the larger ones more likely; seldom less than the
    largest of nine frames in ten."""
    rng = np.random.default_rng(3)
    frames = [np.abs(law(rng, size=2304)).max() for _ in range(200)]
    for power in (0.0, 1.0):
        said = []
        for _ in range(200):
            errors = law(rng, size=2304)
            chance = np.abs(errors) ** power
            chance *= 288 / chance.sum()
            seen = np.flatnonzero(rng.random(2304) < chance)
            part = 1.0 / np.minimum(chance[seen], 1.0) / 2304
            said.append(worst_measured(errors[None, seen], part, 2304).max_e)
        assert np.mean(said < np.quantile(frames, 0.9)) < 0.05
        assert np.median(said) < 2 * np.max(frames)
    assert worst_measured(np.array([[-3.0]]), np.array([1 / 2304]), 2304).max_e == 3.0
    assert worst_measured(np.zeros((2, 0)), np.zeros(0), 2304) == Worst(0.0, 0.0)


def test_one_measured_pixel_in_a_thousand_is_told_by_what_pixels_stand_for() -> None:
    """Of 40,000 pixels 48 are measured: 19 stand for 2 each and are off by 10 e, the others by 1 e.
    One in a thousand are 40."""
    errors = np.append(np.full(19, 10.0), np.full(29, 1.0))
    part = np.append(np.full(19, 2.0), np.full(29, 39_962 / 29)) / 40_000
    assert worst_measured(errors[None], part, 40_000).p999_e == 1.0
    part[:19] *= 1.5
    assert worst_measured(errors[None], part, 40_000).p999_e == 10.0


def test_crosstalk_that_is_left_out_leaves_more_noise_and_says_so() -> None:
    container, sensor = made("a", crosstalk_fraction=0.02, analog_noise_lsb=0.0)
    full = full_frames(container, flat(12000.0), sensor, 4, 3, 5)
    found = outcome(container, flat(12000.0), sensor, "50e", full, effects="auto,-crosstalk")
    assert found.noise_ratio is not None
    assert found.noise_ratio > 1.03
    assert found.plan.noise_ratio == pytest.approx(found.noise_ratio, abs=0.01)


@pytest.mark.parametrize("name", ["a", "codebook"])
def test_without_a_tolerance_it_is_a_part_of_the_noise_of_frames(name: str) -> None:
    container, sensor = made(name)
    light = scene("mid", SLOTS, SIDE, SIDE)
    taken = nscc_runtime.capture(
        container, light, sensor=sensor, effects="all", fidelity="reference", repeat=6
    )
    frame_e = sensor.electrons_per_lsb * taken.frame.astype(np.float64)
    noise_e = np.sqrt(frame_e.var(axis=0, ddof=1).mean())
    plan = nscc_runtime.plan(container, light, sensor=sensor)
    assert plan.tolerance == "0.15noise"
    assert plan.noise_e == pytest.approx(noise_e, rel=0.03)
    assert plan.tolerance_e == pytest.approx(0.15 * noise_e, rel=0.03)
    assert f"0.15 of the frame's own noise = {plan.tolerance_e:.4g} e" in str(plan)
    assert nscc_runtime.capture(container, light, plan=plan, audit=True).audit is not None


@pytest.mark.filterwarnings("ignore:warning.NS0749")
@pytest.mark.parametrize("off", ["register", "full_well", "prnu", "read", "register,-analog"])
@pytest.mark.parametrize("part", [0.99, 1.0])
def test_what_is_forced_off_at_a_full_well_stays_within_its_bound(part: float, off: str) -> None:
    """Tiles of 2 x 2 codes, whose pixels come near the well at once."""
    container, sensor = made("codebook")
    full = full_frames(container, flat(part * FULL_E), sensor, 4, 3, 5)
    found = outcome(container, flat(part * FULL_E), sensor, "5e", full, effects=f"auto,-{off}")
    assert found.err <= 1.02 * found.plan.bound_e
    # All pixels are near saturation, of which some tens are measured.
    assert found.plan.predicted_e == pytest.approx(found.err, rel=0.3)


@pytest.mark.filterwarnings("ignore:warning.NS0749")
@pytest.mark.parametrize("off", ["register,-analog", "register,-full_well,-analog", "shot,-dark"])
def test_what_is_forced_off_together_with_what_saturates_is_foreseen_together(off: str) -> None:
    """What words do to charge is little of what registers then lose, and the other way round."""
    container, sensor = made("a")
    light = flat(100e3)
    full = full_frames(container, light, sensor, 3, 3, 5)
    found = outcome(container, light, sensor, "5e", full, effects=f"auto,-{off}")
    assert found.err <= 1.02 * found.plan.bound_e
    assert found.plan.predicted_e == pytest.approx(found.err, rel=0.1, abs=0.1)


def test_a_plan_of_before_opens_and_its_new_effects_are_simulated(tmp_path: Path) -> None:
    container, sensor = made("a")
    plan = nscc_runtime.plan(container, flat(3000.0), sensor=sensor, tolerance="5e")
    values = json.loads(plan_text(plan, "p", sensor))
    later = "noise_e", "predicted_p999_e", "predicted_max_e", "noise_ratio"
    for name in later:
        del values["plan"][name]
    del values["plan"]["cost"]["all_planning_ms"]
    rows = values["plan"]["effects"]
    values["plan"]["effects"] = [row for row in rows if row["name"] != "black_sun"]
    (tmp_path / "p.json").write_text(json.dumps(values))
    again = read_plan(tmp_path / "p.json", "p", sensor)
    assert again.kept.on == plan.kept.on | {"black_sun"}
    assert "; next frames: " in str(plan)
    assert "; next frames: " not in str(again)
    assert [each.name for each in again.decisions] == [each.name for each in plan.decisions]


@pytest.mark.filterwarnings("ignore:warning.NS0793")
@pytest.mark.parametrize(
    "seed", [10220, 50038, 50161, 110210, 310023, 320136, 350136, 390240, 500008, 500032, 530432]
)
def test_rare_pixels_break_no_promise(seed: int) -> None:
    """Suns whose resets are eaten, lamps that carry half of the frame's noise, registers that wait
    long for their readout, wells that few pixels pass, other ones in each frame."""
    for each in promises(seed, plans=3, frames=3):
        assert each.found.kept, each.said


def test_noise_that_hangs_on_pixels_at_the_full_well_is_estimated() -> None:
    side, slots = 16, 4
    container = case("b edges", slots, "500us", side, side)
    sensor = sensor_of(container)
    frames = np.full((slots, side, side), 0.999 * sensor.full_well_e / slots, np.float32)
    kept = nscc_runtime.plan(container, Light.of_clip(frames), effects="all")
    assert kept.noise_ratio == pytest.approx(1.0, abs=0.01)
    with pytest.warns(UserWarning, match="NS0749"):
        less = nscc_runtime.capture(
            container, Light.of_clip(frames), effects="auto,-shot", audit=True
        )
    assert less.plan.noise_ratio < 0.9
