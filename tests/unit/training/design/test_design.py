"""`nscc design`: what is expected is what happens, and nothing better is expected of others."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import combinations_with_replacement, product
from pathlib import Path

import numpy as np
import pytest
from nscc_command import invoke
from numpy.typing import NDArray

from nscc.chips.load import builtin_target
from nscc.diagnostics.diagnostic import Rejected
from nscc.program.looking import level_steps
from nscc_runtime import capture
from nscc_runtime.effects import everything, selected
from nscc_runtime.light import Light
from nscc_runtime.looked_light import DEVIATION, LIGHT, merged_image
from nscc_runtime.request import Request
from nscc_runtime.response import response_of
from nscc_runtime.scenes import Scene, laid_lights
from nscc_runtime.sensor import default_sensor
from nscc_runtime.simulate import simulate
from nscc_training.baselines.merge_loop import merged
from nscc_training.design import Frame, design_looks, design_pattern, design_tile
from nscc_training.design.chip import Curve, DesignChip
from nscc_training.design.looking import LookModel, LookSchedule
from nscc_training.design.make import best_tile
from nscc_training.design.scene import best_stop, histogram, stops_tried
from nscc_training.design.stop_patterns import changed, patterns, tuned
from nscc_training.design.text import level_text
from nscc_training.metrics import mu_psnr, psnr

Values = NDArray[np.float64]
TARGET = builtin_target("scamp5")
SENSOR = default_sensor(TARGET)
FULL_E = 30000.0
STEP_E = FULL_E / 127


def scene(size: int = 64, stops: float = 14.0, seed: int = 0) -> Values:
    """Light over that many stops, up to 30 wells, electrons over the frame (size, size)."""
    generator = np.random.default_rng(seed)
    return np.asarray(30 * FULL_E * 2.0 ** -generator.uniform(0, stops, (size, size)))


def mu_law(part: Values) -> Values:
    return np.asarray(np.log1p(5000 * np.clip(part, 0, 1)) / np.log1p(5000))


def exposed(light: Values, at: list[int], levels_e: list[float], slots: int, seed: int) -> Values:
    """What a chip without errors but counts, comparators and converter tells: pixel by pixel."""
    draw = np.random.default_rng(seed)
    offset = draw.normal(0, 0.01 * FULL_E, light.shape)
    told, open_ = np.zeros(light.shape), np.ones(light.shape, bool)
    gathered = np.zeros(light.shape)
    for n in range(1, slots + 1):
        gathered += draw.poisson(light / slots)
        held = np.minimum(gathered, FULL_E)
        looks = n in at
        noise = draw.normal(0, 0.02 * FULL_E, light.shape)
        closes = open_ & (n == slots or (looks and held + offset + noise > levels_e[at.index(n)]))
        code = np.clip(np.round(held / (FULL_E / 255) + draw.normal(0, 0.65, light.shape)), 0, 255)
        told = np.where(closes, code * (FULL_E / 255) * slots / n, told)
        open_ &= ~closes
    return told


@pytest.mark.parametrize("curve", ["mu", "linear"])
def test_the_expected_error_of_looks_is_that_of_frames(curve: Curve) -> None:
    """On a chip that only counts, compares and converts, whatever the levels."""
    light = scene(128, 11)
    chip = DesignChip(TARGET, SENSOR, selected("full_well,shot,adc_noise"))
    model = LookModel(chip, histogram([light]), [125.0] * 16)
    schedule = LookSchedule((1, 3, 7), (40, 70, 55))
    told = exposed(light, [1, 3, 7], [step * STEP_E for step in schedule.steps], 16, 5)
    peak = np.percentile(light, 99.9)
    on = mu_law if curve == "mu" else lambda part: np.clip(part, 0, 1)
    measured = np.mean((on(told / peak) - on(light / peak)) ** 2)
    assert model.expected(schedule).errors[curve] == pytest.approx(measured, rel=0.05)


def test_no_other_single_look_is_expected_to_be_better() -> None:
    """The error of the best look is the least over all slots and levels, tried one by one."""
    chip = DesignChip.of(TARGET, SENSOR)
    model = LookModel(chip, histogram([scene(stops=9)]), [125.0] * 12)
    found = model.expected(model.best(1, "mu")).errors["mu"]
    every = (
        model.expected(LookSchedule((at,), (int(steps),))).errors["mu"]
        for at, steps in product(range(1, 12), chip.levels)
    )
    assert found == pytest.approx(min(every), rel=1e-6)


def test_more_looks_are_no_worse() -> None:
    """The expected error of the logarithm falls from 1 to 2 to 4 looks, and with 4 it is less than
    half."""
    model = LookModel(DesignChip.of(TARGET, SENSOR), histogram([scene(stops=9)]), [125.0] * 64)
    errors = [model.expected(model.best(looks, "log")).errors["log"] for looks in (1, 2, 4)]
    assert errors == sorted(errors, reverse=True)
    assert errors[-1] < errors[0] / 2


def test_designed_words_reach_the_expected_error() -> None:
    """The designed words on the emulator with every effect: half a decibel."""
    target = replace(TARGET, rows=96, cols=96)
    light = np.geomspace(100, 30 * FULL_E, 96 * 96).reshape(96, 96)
    made = design_looks([light], 4, Frame(slots=64))
    container = replace(made.compiled.container, target=target)  # type: ignore[type-var]
    container = replace(container, pixel_codes=container.pixel_codes[:96, :96])
    slot_s = np.full(64, 125e-6)
    still = Light.of_still((light / slot_s.sum()).astype(np.float32), slot_s)
    peak, squares = np.percentile(light, 99.9), []
    for chip in range(5):  # the expected error is a mean over chips
        taken = capture(container, still, effects="all", seed=3, device_seed=chip)
        told = merged_image(taken.told[LIGHT], taken.told[DEVIATION]) * slot_s.sum()
        squares.append((mu_law(told / peak) - mu_law(light / peak)) ** 2)
    measured = -10 * np.log10(np.mean(squares))
    assert measured == pytest.approx(-10 * math.log10(made.expected.errors["mu"]), abs=0.5)


def test_the_designed_tile_has_the_least_error_of_all_tiles() -> None:
    """The expected tile comes from a loop over tiles, pixels and their neighbours, with a fine sum
    over the noise."""
    chip = DesignChip(TARGET, SENSOR, selected("full_well,shot,adc_noise"))
    light, slots = scene(8, 10, 2), 8
    peak = np.percentile(light, 99.9)
    grid = (np.arange(2000) + 0.5) / 2000 * 12 - 6
    weight = np.exp(-(grid**2) / 2) / np.exp(-(grid**2) / 2).sum()

    def error(x: float, stop: int) -> float:
        e = x * stop / slots
        sd = math.sqrt(e + (FULL_E / 255) ** 2 * (1 / 12 + 0.65**2))
        seen = np.clip(e + sd * grid, 0, FULL_E) * slots / stop
        gap = mu_law(seen / peak) - mu_law(np.array(x / peak))
        return float((weight * gap**2).sum())

    stops, risks = stops_tried(slots), {}
    known = {(x, s): error(x, s) for x in light.ravel().tolist() for s in stops}
    for tile in combinations_with_replacement(stops, 4):
        laid, risk = tile[::-1], []
        for r, c in product(range(0, 8, 2), range(0, 8, 2)):
            here = light[r : r + 2, c : c + 2].ravel().tolist()
            on = mu_law(np.array(here) / peak)
            for p in range(4):
                ways = [known[here[q], laid[q]] + (on[p] - on[q]) ** 2 for q in range(4)]
                risk.append(min(ways))
        risks[laid] = np.mean(risk)
    found, tried = best_tile(chip, [light], slots, "mu")
    assert tried == len(risks)
    assert found.risk == pytest.approx(min(risks.values()), rel=1e-2)
    assert risks[found.stops] == pytest.approx(found.risk, rel=1e-2)


@pytest.mark.parametrize("step_e", ["auto", 100.0, 33.3])
def test_levels_are_rounded_to_their_own_steps(step_e: float | str) -> None:
    """A level written as a percentage and read again is the same number of steps, for three step
    sizes."""
    step = STEP_E if step_e == "auto" else float(step_e)
    target = replace(TARGET, in_step_e=step)
    for steps in DesignChip.of(target, default_sensor(target)).levels.tolist():
        text = level_text(steps, target)
        assert level_steps(float(text.rstrip("%")), "%", target) == steps


def test_a_design_is_a_program_in_the_one_style(tmp_path: Path) -> None:
    for options in (["--looks", "9"], ["--criterion", "sve-risk"], ["--search"]):
        done = invoke(
            [
                "design",
                "--scene",
                "builtin:hdr",
                "--exposure",
                "1000000",
                "-O",
                "0",
                "-o",
                "p.nsl",
                *options,
            ],
            tmp_path,
        )
        assert done.status == 0, done.err
        assert "wrote p.nsl" in done.out
        assert "dB PSNR" in done.out
        assert invoke(["fmt", "--check", "p.nsl"], tmp_path).status == 0
        assert invoke(["check", "p.nsl", "--deny-warnings"], tmp_path).status == 0


def test_equal_scenes_give_equal_designs() -> None:
    texts = {design_looks([scene()], 3, Frame(slots=16, level=0)).text for _ in range(2)}
    tiles = {design_tile([scene(8)], Frame(slots=16, level=0)).text for _ in range(2)}
    assert len(texts) == len(tiles) == 1


def test_scenes_of_different_sizes_have_equal_weights_in_the_histogram() -> None:
    """A large scene does not outvote a small one."""
    small, large = scene(16), scene(64, seed=1)
    both = histogram([small, large])
    of_small = both.peak_e == np.percentile(small, 99.9)
    assert both.weight[of_small].sum() == pytest.approx(0.5)
    assert both.weight[~of_small].sum() == pytest.approx(0.5)
    mean = (both.light_e * both.weight)[of_small].sum() / 0.5
    assert mean == pytest.approx(small.mean())


def test_a_search_tries_patterns_of_one_to_eight_levels() -> None:
    found = patterns(256)
    tiles = {(pattern.name, pattern.stops.tobytes()) for pattern in found}
    assert len(tiles) == len(found) > 250
    counts = {len(np.unique(pattern.stops)) for pattern in found}
    assert counts == {1, 2, 3, 4, 8}
    assert {p.stops.shape for p in found} == {(1, 1), (2, 2), (1, 4), (3, 3), (4, 4), (8, 8)}
    for pattern in found:
        levels = np.unique(pattern.stops)
        assert levels[0] >= 1
        assert levels[-1] <= 256
        assert set(levels) <= set(stops_tried(256))
    assert [[64, 8], [8, 64]] in [pattern.stops.tolist() for pattern in found]


def test_a_searched_pattern_keeps_its_predicted_rank_on_the_emulator() -> None:
    """The program itself, exposed under every effect and merged, beside frames put together."""
    [laid] = laid_lights(Scene("builtin:hdr", exposure="30000@70"), [125.0] * 64, TARGET)
    light_e = laid.light.total_e()
    made = design_pattern([light_e], Frame(slots=64, level=0))
    best, found = made.pattern, made.ranked
    assert best.mean_db >= found[0].mean_db - 0.5
    assert dict(made.lines)["tuned"].startswith("24 changes of the best tried: +")
    assert best.mean_db > max(p.mean_db for p in found if p.name == "uniform")
    container = made.compiled.container
    assert container is not None
    frame = simulate(container, laid.light, SENSOR, Request.of(effects="all", seed=7)).frame
    response = response_of(container, SENSOR, everything())
    codes = np.maximum(response.electrons(frame.frame)[0], 0) / SENSOR.electrons_per_lsb
    share = response.open_s[0] / container.slot_s.sum()
    noise_e = float(DesignChip.of(TARGET, SENSOR).exposed_sd_e(np.zeros(1))[0])
    light = merged(codes, share, SENSOR.electrons_per_lsb, frame.saturated[0], noise_e)
    peak = float(np.percentile(light_e, 99.9))
    # A shutter of several stops adds twice where that of one stop adds once.
    assert best.mu_db - 0.5 < mu_psnr(light_e, light, peak) < best.mu_db + 0.3
    truth, shown = (np.clip(part / peak, 0, 1) for part in (light_e, light))
    assert psnr(truth, shown, 1.0) == pytest.approx(best.linear_db, abs=0.3)


def test_a_change_of_a_pattern_moves_one_exposure_time_by_at_most_two_half_stops() -> None:
    pattern, generator = patterns(256)[150], np.random.default_rng(2)
    stops = stops_tried(256)
    for _ in range(50):
        found = changed(pattern, 256, generator)
        moved = pattern.stops != found.stops
        assert len(np.unique(pattern.stops[moved])) == len(np.unique(found.stops[moved])) <= 1
        for old, new in zip(pattern.stops[moved], found.stops[moved], strict=True):
            assert 1 <= abs(stops.index(old) - stops.index(new)) <= 2


def test_changes_are_kept_while_the_worth_rises() -> None:
    """Numbers that change by one each climb to 5 and stay; without trials the best stays."""
    best, gain_db = tuned(
        [-1, 0], range(40), lambda x, draw: x + int(draw.choice((-1, 1))), lambda x: -abs(x - 5)
    )
    assert (best, gain_db) == (5, 5)
    assert tuned([0, 1], range(0), lambda x, _: x + 1, float) == (1, 0)


@pytest.mark.parametrize("slots", [2, 5])
def test_a_frame_of_few_slots_has_no_tile_of_four_stops(slots: int) -> None:
    made = design_pattern([scene()[:16, :16]], Frame(slots=slots, level=0))
    assert "2 x 2" not in {label for label, _ in made.lines}


def test_words_decide_between_patterns_that_are_nearly_as_good() -> None:
    one, two = (
        replace(p, linear_db=30.0, mu_db=db) for p, db in zip(patterns(4), (30, 30.1), strict=False)
    )
    for words_of_two, best in ((20, two), (200, one)):
        chosen, _ = tuned(
            [two, one],
            (),
            lambda pattern, _: pattern,
            lambda pattern, words=words_of_two: (
                pattern.mean_db - 0.005 * (words if pattern is two else 20)
            ),
        )
        assert chosen is best


def test_the_best_single_exposure_shortens_with_more_light() -> None:
    """The exposure is shorter for more light, and a whole frame for a dark scene."""
    sensor = SENSOR.changed(
        analog_noise_lsb=0.4, spread_noise_lsb=0.65, adc_pattern_lsb=0.0, adc_smooth_lsb=0.0
    )
    chip, light = DesignChip.of(TARGET, sensor), scene(stops=4.0) / 60
    stops = [best_stop(chip, light * factor, 256, "mu") for factor in (0.01, 1.0, 8.0, 64.0)]
    assert stops == sorted(stops, reverse=True)
    assert stops[0] == 256
    assert stops[-1] <= 16


def test_impossible_designs_are_refused(tmp_path: Path) -> None:
    with pytest.raises(Rejected) as found:
        design_looks([np.zeros((4, 4))], 3)
    assert found.value.diagnostics[0].code == "NS0824"
    for options in (
        [],
        ["--looks", "3", "--criterion", "sve-risk"],
        ["--search", "--looks", "3"],
        ["--search", "--criterion", "mu"],
        ["--looks", "9", "--slots", "8"],
        ["--looks", "1"],
        ["--looks", "3", "--trials", "2"],
    ):
        done = invoke(["design", "--scene", "builtin:hdr", *options], tmp_path)
        assert done.status == 2, options
        assert "NS078" in done.err
    assert not list(tmp_path.iterdir())


def test_exposures_beyond_the_linear_range_of_a_register_are_not_trusted() -> None:
    sensor = SENSOR.changed(register_min_e=-16000, register_max_e=15000, register_knee_fraction=0.8)
    chip = DesignChip(TARGET, sensor, selected("register,full_well"))
    assert chip.gain == 1.0
    # Registers are linear up to the knee.
    assert chip.full_e == pytest.approx(0.8 * 15000)
    assert DesignChip(TARGET, sensor, selected("full_well")).full_e > 15000
