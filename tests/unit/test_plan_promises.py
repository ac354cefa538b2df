"""What plans say beside their RMS, by the reference: worst pixels, noise, forced effects."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from plan_cases import case
from promise import full_frames, outcome, scene
from random_sensors import promises
from reference_programs import sensor_of
from scipy.optimize import brentq
from scipy.stats import norm, poisson

import nscc_runtime
from nscc.words.container import Container
from nscc_runtime.effects import selected
from nscc_runtime.light import Light
from nscc_runtime.plan_file import plan_text, read_plan
from nscc_runtime.planner.accounts import Errors
from nscc_runtime.planner.choose import Chooser
from nscc_runtime.planner.program import Program
from nscc_runtime.planner.sample import chances, sample_of
from nscc_runtime.planner.tolerance import DEFAULT
from nscc_runtime.planner.worst import Worst, largest, worst_measured, worst_of
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


def normal(mean: np.ndarray, variance: np.ndarray) -> Errors:
    return Errors(mean, variance, np.zeros(mean.shape))


def test_worst_pixels_of_a_mixture_are_those_of_its_draws() -> None:
    """A tenth of the pixels carries the whole error; drawn with numpy."""
    rng = np.random.default_rng(0)
    mean, variance = np.zeros((1, 1000)), np.ones((1, 1000))
    mean[0, :100], variance[0, :100] = 30.0, 100.0
    found = worst_of(normal(mean, variance), np.ones(1000), 1000)
    drawn = np.abs(mean + np.sqrt(variance) * rng.standard_normal((2000, 1000)))
    assert found.p999_e == pytest.approx(np.quantile(drawn, 0.999), rel=0.01)
    # A sample shows little of the largest: it is rather said too large.
    assert 1.0 <= found.max_e / np.quantile(drawn.max(axis=1), 0.99) <= 1.1


@pytest.mark.parametrize("seed", range(6))
def test_what_one_pixel_in_a_thousand_passes_is_the_root_of_its_chance(seed: int) -> None:
    rng = np.random.default_rng(seed)
    mean = rng.standard_t(3, (1, 700)) * (rng.random((1, 700)) < (1.0, 0.02)[seed % 2])
    variance = rng.exponential(4.0, (1, 700)) * (rng.random((1, 700)) < (0.0, 0.05, 1.0)[seed % 3])
    weight = rng.exponential(90.0, 700)
    if not variance.any():
        mean += 1e-3  # of nothing but zeros nothing is passed

    def beyond(limit: float) -> float:
        sigma = np.sqrt(np.maximum(variance[0], 1e-12))
        both = norm.sf((limit - mean[0]) / sigma) + norm.cdf((-limit - mean[0]) / sigma)
        return float(both @ weight / weight.sum()) - 1e-3

    found = worst_of(normal(mean, variance), weight, 65536)
    assert found.p999_e == pytest.approx(brentq(beyond, 0.0, 1e3, xtol=1e-9), rel=2e-3)


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize("centred", [False, True])
@pytest.mark.parametrize("count", [0.01, 0.1, 0.3, 1.0, 3.0, 10.0, 100.0, 1e4])
def test_worst_pixels_of_few_electrons_have_the_tail_of_counts(
    count: float, centred: bool, sign: float
) -> None:
    """Dropped counts, or their noise alone: by their distribution, to the electron."""
    law = poisson(count)
    errors = Errors(
        np.full((1, 50), 0.0 if centred else sign * count), np.full((1, 50), count),
        np.full((1, 50), sign * count),
    )  # fmt: skip
    found = worst_of(errors, np.full(50, 65536 / 50), 65536)
    center = count if centred else 0.0
    sizes = np.arange(0.0, 8.0 * math.sqrt(count) + count + 9.0, 0.5)
    passed = law.sf(center + sizes) + law.cdf(np.ceil(center - sizes) - 1.0)
    one, rare = (sizes[np.argmax(passed < share)] for share in (1e-3, 1 / 6553600))
    assert abs(found.p999_e - one) <= 1.0 + 0.01 * one
    assert rare - 1.0 <= found.max_e <= (2.0 if centred else 1.2) * rare + 2.0


def test_counts_that_hardly_ever_happen_make_no_tail() -> None:
    """One in a million pixels counts an electron: of a thousand errors of 1 e nobody sees that."""
    few = np.full((1, 50), 1e-6)
    found = worst_of(Errors(0 * few, few, few), np.ones(50), 65536)
    assert found.p999_e < 0.01
    assert found.max_e <= 5.0


@pytest.mark.parametrize(("total_e", "slots"), [(0.0, 8), (2.0, 4)])
def test_one_pixel_in_a_thousand_of_a_dark_scene_is_as_far_off_as_was_said(
    total_e: float, slots: int
) -> None:
    """Dropped dark charge of less than an electron, by the reference."""
    container = case("c accumulate", slots, "100us", SIDE, SIDE)
    sensor = sensor_of(container)
    light = Light.of_clip(np.full((slots, SIDE, SIDE), total_e / slots, np.float32))
    found = outcome(container, light, sensor, "5e", full_frames(container, light, sensor, 6, 3, 5))
    assert {each.name for each in found.plan.decisions if each.decision == "dropped"} >= {"dark"}
    assert found.p999_e <= 1.25 * found.plan.predicted_p999_e
    assert found.p999_e >= 0.6 * found.plan.predicted_p999_e


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


def test_pixels_beside_a_sun_are_drawn_whatever_suns_there_are() -> None:
    total_e = np.full((48, 48), 100.0)
    total_e[10, 10], total_e[30, 30] = 1e10, 2e5
    near = np.array(
        [10 * 48 + 10, *(48 * y + x for y, x in ((9, 10), (11, 10), (10, 9), (10, 11)))]
    )
    drawn = chances(total_e, np.sort(near))
    assert not drawn.reshape(-1)[near].any()
    assert drawn[29, 30] > 100 * np.median(drawn)


def test_worst_pixels_are_told_though_the_sample_lacks_them() -> None:
    """A fixed pattern on light that differs from pixel to pixel: the worst has much of both."""
    rng, said, frames = np.random.default_rng(5), [], []
    for _ in range(100):
        pattern = np.exp(0.8 * rng.standard_normal(2304)) * rng.standard_normal(2304)
        drawn = rng.choice(2304, 640, replace=False)
        errors = normal(pattern[None, drawn], np.ones((1, 640)))
        said.append(worst_of(errors, np.ones(640), 2304).max_e)
        frames.append(np.abs(pattern).max())
    assert np.mean(np.array(said) < 0.8 * np.array(frames)) < 0.1
    assert np.median(said) < 2 * np.median(frames)


def test_the_brightest_pixels_near_saturation_stand_for_themselves() -> None:
    rng = np.random.default_rng(6)
    total_e = np.full((64, 64), FULL_E)
    suns = rng.choice(64 * 64, 5, replace=False)
    total_e.reshape(-1)[suns] = 1e9
    near, spilt = np.arange(64 * 64), np.arange(100)
    found = sample_of(total_e, 1, near, spilt)
    assert len(np.unique(found.places)) == len(found.places)
    assert found.weight.sum() == pytest.approx(64 * 64)
    assert (found.weight[np.isin(found.places, suns)] == 1.0).sum() == 5
    seen_e = rng.random(64 * 64)
    most = np.argsort(seen_e)[-5:]
    found = sample_of(total_e, 1, near, spilt, seen_e)
    assert (found.weight[np.isin(found.places, most)] == 1.0).sum() == 5
    few = sample_of(total_e, 1, near[:7])
    assert set(near[:7]) <= set(few.places)
    assert few.weight.sum() == pytest.approx(64 * 64)


def test_where_the_worst_pixel_is_bounded_the_largest_exposures_are_in_the_sample() -> None:
    """Lamps that flash while their pixels are open are no brighter than others over a frame."""
    container, sensor = made("d edges", 64, 64)
    program, rng = Program.of(container, sensor), np.random.default_rng(2)
    frames = np.full((SLOTS, 64, 64), 60.0, np.float32)
    lit = rng.choice(64 * 64, 300, replace=False)
    frames[rng.integers(0, SLOTS, 300), lit // 64, lit % 64] = 300.0
    light = Light.of_clip(frames)
    exposed = full_frames(container, light, sensor, 1, 3, 5, "none")[0, 0].reshape(-1)
    few = np.argsort(exposed)[-10:]
    assert exposed[few].min() > 1.1 * np.median(exposed)
    bound = Chooser(program, light, 5, 1, "5e", "100e", selected("auto")).fields.sample
    assert np.isin(few, bound.places).mean() > 0.7
    assert bound.weight.sum() == pytest.approx(64 * 64)
    assert (bound.weight == 1.0).sum() >= 20


def test_a_limit_of_the_worst_pixel_keeps_what_would_break_it() -> None:
    container, sensor = made("codebook")
    light = scene("hdr", SLOTS, SIDE, SIDE)
    full = full_frames(container, light, sensor, 3, 3, 5)
    free = outcome(container, light, sensor, "50e", full)
    bound = outcome(container, light, sensor, "50e", full, tolerance_max="60e")
    assert free.max_e > 80.0
    assert bound.max_e <= 66.0
    assert bound.plan.predicted_max_e is not None
    assert bound.plan.predicted_max_e <= 0.9 * 60.0
    assert len(bound.plan.kept.on) > len(free.plan.kept.on)
    assert any("the worst pixel would be" in each.reason for each in bound.plan.decisions)
    for each in (free, bound):
        assert each.p999_e == pytest.approx(each.plan.predicted_p999_e, rel=0.3)
        assert not each.broken


def test_pixels_just_below_what_registers_hold_are_measured() -> None:
    """Most of an even scene is clipped in any case; a few exposures of three slots are not."""
    container = case("c edges", 16, "2000us", SIDE, SIDE)
    sensor = sensor_of(
        container, prnu_fraction=0.07, register_knee_fraction=1.0, register_min_e=-53e3,
        register_max_e=26e3, full_well_e=124e3,
    )  # fmt: skip
    light = Light.of_clip(np.full((16, SIDE, SIDE), 7800.0, np.float32))
    full = full_frames(container, light, sensor, 2, 3, 5)
    free = outcome(container, light, sensor, "50e", full)
    assert free.plan.saturating_lack
    assert free.max_e > 1.1 * 250.0
    assert not outcome(container, light, sensor, "50e", full, tolerance_max="250e").broken


def test_crosstalk_that_is_left_out_leaves_more_noise_and_says_so() -> None:
    container, sensor = made("a", crosstalk_fraction=0.02, analog_noise_lsb=0.0)
    full = full_frames(container, flat(12000.0), sensor, 4, 3, 5)
    found = outcome(container, flat(12000.0), sensor, "50e", full, effects="auto,-crosstalk")
    assert found.noise_ratio is not None
    assert found.noise_ratio > 1.03
    assert found.plan.noise_ratio == pytest.approx(found.noise_ratio, abs=0.01)
    held = outcome(container, flat(12000.0), sensor, "0.1noise", full)
    assert "crosstalk" in held.plan.kept.on
    assert held.noise_ratio == pytest.approx(1.0, abs=0.01)


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
    assert found.plan.predicted_e == pytest.approx(found.err, rel=0.25)


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


@pytest.mark.parametrize(
    ("effects", "tolerance"),
    [("auto,-leakage", "5e"), ("auto,-analog", "0.3e"), ("auto", "0.1e"), ("all", "50e")],
)
@pytest.mark.filterwarnings("ignore:warning.NS0749")
def test_errors_of_words_that_cancel_exactly_have_no_part(effects: str, tolerance: str) -> None:
    """Where pixels are shut when the frame begins, that without leakage is the first level's."""
    container, sensor = made("late")
    light = scene("hdr", SLOTS, SIDE, SIDE)
    full = full_frames(container, light, sensor, 4, 3, 5)
    found = outcome(container, light, sensor, tolerance, full, effects=effects)
    assert found.plan.predicted_e == pytest.approx(found.err, rel=0.15, abs=0.05)


def test_pixels_that_saturate_are_sampled_of_every_code_of_a_tile() -> None:
    side, total_e = 128, np.full((128, 128), FULL_E)
    sample = sample_of(total_e, 1, np.arange(side * side))
    for tile in (2, 4, 8):
        codes = sample.places // side % tile * tile + sample.places % side % tile
        assert len(np.unique(codes)) == tile**2


def test_a_plan_of_before_opens_and_its_new_effects_are_simulated(tmp_path: Path) -> None:
    container, sensor = made("a")
    plan = nscc_runtime.plan(container, flat(3000.0), sensor=sensor, tolerance="5e")
    values = json.loads(plan_text(plan, "p", sensor))
    later = ("noise_e", "predicted_p999_e", "predicted_max_e", "tolerance_max", "tolerance_max_e",
             "noise_ratio")  # fmt: skip
    for name in later:
        del values["plan"][name]
    del values["plan"]["cost"]["all_planning_ms"]
    rows = values["plan"]["effects"]
    values["plan"]["effects"] = [row for row in rows if row["name"] != "black_sun"]
    (tmp_path / "p.json").write_text(json.dumps(values))
    again = read_plan(tmp_path / "p.json", "p", sensor)
    assert again.kept.on == plan.kept.on | {"black_sun"}
    assert "; next frames: " in str(plan)
    assert str(again).count("% of all") == 1
    assert "; next frames: " not in str(again)
    assert [each.name for each in again.decisions] == [each.name for each in plan.decisions]


@pytest.mark.filterwarnings("ignore:warning.NS0793")
def test_pixels_that_a_sun_fills_are_forecast_with_what_it_spills() -> None:
    """Five suns, accumulated: what they spill fills registers of pixels that are dim themselves."""
    (suns,) = promises(10220, plans=1, frames=2)
    assert suns.found.broken == [], suns.said


@pytest.mark.filterwarnings("ignore:warning.NS0793")
@pytest.mark.parametrize("seed", [50038, 50161, 500008, 530432, 540165, 541011])
def test_suns_and_lamps_that_no_other_pixel_is_like_break_nothing(seed: int) -> None:
    """Five suns whose resets are eaten; lamps that carry half of the frame's noise; counts of suns,
    and of what is beside them, that are taken as even where a part of a slot is read."""
    for each in promises(seed, plans=3, frames=3):
        assert each.found.broken == [], each.said


@pytest.mark.filterwarnings("ignore:warning.NS0793")
def test_values_leak_while_they_wait_for_their_readout() -> None:
    """The second of two buckets waits 40 times as long as the frame takes."""
    (found,) = promises(110210, plans=1, frames=3)
    assert found.found.broken == [], found.said
    assert found.found.foreseen, found.said


def test_what_a_full_well_takes_in_other_frames_is_in_the_worst_pixel() -> None:
    """Few pixels pass the well, other ones in each frame, by far more than in the planner's."""
    assert [each.said for each in promises(320136) if each.found.broken] == []


@pytest.mark.parametrize("name", ["a", "c edges", "c accumulate", "two buckets"])
def test_what_noise_alone_takes_over_a_full_well_is_told(name: str) -> None:
    """A pattern of response brings some pixels to within a few sigma of the well: one in a hundred
    frames shows what the plan's own does not."""
    container, sensor = made(name, register_max_e=1e6, register_min_e=-1e6)
    program = Program.of(container, sensor)
    first, stop = program.tables.held_slots
    light = flat(0.97 * sensor.full_well_e * SLOTS / (stop - first).max())
    chooser = Chooser(program, light, 5, 1, DEFAULT, None, selected("auto"))
    fields, count = chooser.fields, 100
    full, free = (
        full_frames(container, light, sensor, count, 3, 5, effects=effects)
        for effects in ("all", "all,-full_well")
    )
    lost = np.abs(full - free)
    square = fields.fixed["full_well"] ** 2 + fields.variance["full_well"]
    told = np.sqrt(fields.sample.mean(square))
    worst = np.quantile(lost.reshape(count, -1).max(axis=1), 0.99)
    assert worst > 50.0
    # One pixel has most of it, and the plan's frame shows it at twice what it loses in others.
    assert 0.65 < told.max() / np.sqrt((lost**2).mean(axis=(0, 2, 3))).max() < 1.6
    assert 0.9 < chooser.worst(chooser.saturation, False).max_e / worst < 3.0


@pytest.mark.filterwarnings("ignore:warning.NS0793")
@pytest.mark.parametrize(
    "seed",
    [
        350136, 350052, 380117, 500032, 500033, 510747, 520816, 610306, 610531, 611575, 611775,
        621383,
    ],
)  # fmt: skip
def test_what_is_rare_is_said_though_no_frame_or_sample_of_the_plan_has_it(seed: int) -> None:
    """Of pixels that come near a well 3 % are full in six frames; of 2304 that may saturate 2 would
    not without what registers lose; of those that fill their registers 0.2 % are below that; of
    those that edges cross 1 % are not full at some read, and none of these was measured; of those
    that are left out, errors of resets cancel but where PIX is full, or registers bend; what
    saturation takes of the three pixels that have most of it is more in other frames; of a sun a
    level is subtracted four times that its counts nearly fill; and of a flat scene one pixel sees
    more than the others."""
    assert [each.said for each in promises(seed) if each.found.broken] == []


@pytest.mark.filterwarnings("ignore:warning.NS0793")
def test_what_a_few_pixels_beside_suns_lack_is_measured() -> None:
    """Not those that only their neighbours' light brings near saturation: these never lack it, and
    get so much of it that the others were hardly drawn."""
    assert [each.said for each in promises(390240) if each.found.broken] == []


@pytest.mark.filterwarnings("ignore:warning.NS0793")
def test_counts_of_neighbours_that_pixels_near_saturation_have_from_sums_are_foreseen() -> None:
    """Sums have no crosstalk there, pixels near saturation do: as even over the slots."""
    plans = [each.found for each in promises(390152) if "crosstalk" not in each.found.plan.kept]
    assert plans
    assert all(each.foreseen and not each.broken for each in plans)
    assert any("near saturation" in cut.name for each in plans for cut in each.plan.approximations)


@pytest.mark.parametrize("off", ["leakage", "leakage,-analog"])
@pytest.mark.parametrize("name", ["b latch", "two buckets"])
def test_errors_that_cancelled_by_leakage_alone_are_in_what_forcing_it_off_does(
    name: str, off: str
) -> None:
    """The noise of a reset is subtracted again, but for what leaks meanwhile."""
    container, sensor = made(name, reset_noise_e=400.0, leakage_tau_s=0.2)
    light = scene("dim", SLOTS, SIDE, SIDE)
    plan = Chooser(
        Program.of(container, sensor), light, 5, 1, "1e", None, selected(f"auto,-{off}")
    ).plan()
    full, less = (
        full_frames(container, light, sensor, 12, 3, 5, effects)
        for effects in ("all", f"all,-{off}")
    )
    measured_e = np.sqrt(((full - less) ** 2).mean(axis=(0, 2, 3)).max())
    assert measured_e > 2.0
    assert plan.predicted_e == pytest.approx(measured_e, rel=0.05)
    assert plan.noise_ratio is not None
    ratio = math.sqrt(less.var(axis=0).mean() / full.var(axis=0).mean())
    assert plan.noise_ratio == pytest.approx(ratio, abs=0.02)


@pytest.mark.parametrize("spread", [0.1, 1.0])
def test_errors_that_cancel_but_for_leakage_are_those_of_each_pixels_own(spread: float) -> None:
    """What is left of a reset grows with a pixel's leakage: of few pixels, most of the error."""
    values = {"leakage_spread_fraction": spread, "leakage_tau_s": 1.0, "reset_noise_e": 400.0}
    container, sensor = made("b edges", **values)
    light, count = scene("dim", SLOTS, SIDE, SIDE), 60
    full, less = (
        full_frames(container, light, sensor, count, 3, 5, effects)[:, 0].reshape(count, -1)
        for effects in ("all", "all,-reset")
    )
    program = Program.of(container, sensor)
    fields = Chooser(program, light, 5, 1, "1e", None, selected("auto")).fields
    places, told = fields.sample.places, fields.variance["reset"][0]
    measured = ((full - less)[:, places] ** 2).mean(axis=0)
    lane = program.lanes[places]
    assert len(np.unique(lane)) > 3
    for each in np.unique(lane):
        mine, its = told[lane == each], measured[lane == each]
        most = mine > np.quantile(mine, 0.9)
        for some in (most, ~most):
            assert mine[some].mean() == pytest.approx(its[some].mean(), rel=0.25)
    assert math.sqrt(told.mean()) == pytest.approx(math.sqrt(measured.mean()), rel=0.05)


@pytest.mark.parametrize("seed", [310023, 310048])
def test_what_dead_time_and_leakage_take_of_a_few_electrons_is_foreseen(seed: int) -> None:
    """Tolerances of hundredths of an electron: dark charge leaks as well, and counts are whole."""
    assert [each.said for each in promises(seed) if each.found.broken] == []


def test_noise_that_hangs_on_pixels_at_the_full_well_is_no_promise() -> None:
    side, slots = 16, 4
    container = case("b edges", slots, "500us", side, side)
    sensor = sensor_of(container)
    frames = np.full((slots, side, side), 0.999 * sensor.full_well_e / slots, np.float32)
    kept = nscc_runtime.capture(container, Light.of_clip(frames), effects="all")
    assert kept.plan.noise_ratio == pytest.approx(1.0, abs=0.01)
    with pytest.warns(UserWarning, match="NS0749"):
        less = nscc_runtime.capture(container, Light.of_clip(frames), effects="auto,-shot")
    assert less.plan.noise_ratio is None


def test_pixels_that_are_all_in_the_sample_leave_no_doubt() -> None:
    """What a lamp alone does wrong is then known, however much more that is than all the rest."""
    program = Program.of(*made("b edges", rows=16, cols=24))
    frames = np.full((SLOTS, 16, 24), 12.0, np.float32)
    frames[:, 3, 5] = 2500.0
    auto = selected("auto")
    chooser = Chooser(program, Light.of_clip(frames), 0, 1, DEFAULT, None, auto)
    assert (chooser.sampling_error(frozenset({"prnu"}), everywhere=False) == 0.0).all()


@pytest.mark.filterwarnings("ignore:warning.NS0793")
@pytest.mark.parametrize("seed", [530020, 531511, 541770, 620297, 641863, 650762])
def test_what_is_left_of_the_noise_is_said_or_nothing_is(seed: int) -> None:
    """Counts without the gain of words, which is below 1; crosstalk where the counts that it evens
    out are left out, or those of light alone; counts that pixels lack which the plan's frame has
    all of them full; errors of resets that cancel, but not there."""
    found = [each.found for each in promises(seed)]
    assert [each.broken for each in found if each.broken] == []
    assert all(each.plan.noise_ratio is None or each.plan.noise_ratio > 0.1 for each in found)


@pytest.mark.filterwarnings("ignore:warning.NS0793")
def test_what_else_could_be_left_out_is_reckoned_without_the_plans_own_short_cuts() -> None:
    """Without dark charge pixels near saturation have no counts of sums, whose errors lacking
    crosstalk takes away."""
    assert [each.said for each in promises(620636) if each.found.broken] == []
