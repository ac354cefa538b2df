"""The sample of pixels: means over it are those of the array, and lamps are never missed."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from nscc.chips.load import load_target
from nscc_runtime.effects.dark import current_e_per_s
from nscc_runtime.execution.near_saturation import NO_PIXELS, NearSaturation
from nscc_runtime.light import Light
from nscc_runtime.planning.sample import Sample, draw_sample, drawing_chances, sampled_errors
from nscc_runtime.scenes.timing import with_motion
from nscc_runtime.sensor.file import completed

WELL_E, COUNT, FRAME_S = 30_000.0, 4000, 0.016
SENSOR = completed({"full_well_e": WELL_E}, load_target("scamp5", Path()))


def near_at(places: np.ndarray) -> NearSaturation:
    """Pixels near saturation, with charges around a full well."""
    most_e = np.random.default_rng(8).uniform(0.5, 4.0, len(places)) * WELL_E
    return NearSaturation(places, most_e)


def light(kind: str, rows: int = 128, cols: int = 160) -> Light:
    rng = np.random.default_rng(4)
    if kind == "noise":
        total = rng.exponential(500.0, (rows, cols))
    elif kind == "edges":
        total = np.where((np.arange(cols) // 20 % 2)[None], 8000.0, 20.0) * np.ones((rows, 1))
    elif kind == "dark":
        total = np.zeros((rows, cols))
    else:
        total = np.full((rows, cols), 30.0)
        total[77, 31] = 1e7
    return Light.of_clip(total[None].astype(np.float32))


def sample(scene: Light, near: NearSaturation = NO_PIXELS, count: int = COUNT) -> Sample:
    return draw_sample(near, WELL_E, count, drawing_chances(scene, near, SENSOR, 0, FRAME_S))


@pytest.mark.parametrize("kind", ["noise", "edges", "dark", "lamp"])
@pytest.mark.parametrize("near_count", [0, 100, 6000])
def test_means_over_the_sample_are_those_of_the_array(kind: str, near_count: int) -> None:
    scene = light(kind)
    total = scene.sum_e.reshape(-1)
    places = np.sort(np.random.default_rng(1).choice(total.size, near_count, replace=False))
    found = sample(scene, near_at(places))
    assert found.weight.sum() == pytest.approx(total.size)
    assert len(found.places) <= COUNT + 24
    assert (np.diff(found.places) > 0).all()
    assert found.weight.min() > 0
    assert (found.near == np.isin(found.places, places)).all()
    assert found.weight[found.near].sum() == pytest.approx(near_count)
    assert (found.unseen_share > 0) == (near_count > found.near.sum())
    mean = (total[found.places] * found.weight).sum() / total.size
    assert mean == pytest.approx(total.mean(), rel=0.02)


@pytest.mark.parametrize("device_seed", range(6))
def test_the_sample_has_the_mean_square_of_dark_charge_that_few_pixels_have(
    device_seed: int,
) -> None:
    """The mean square of a widely spread dark current over the sample is that of the array; without
    dark current the sample is as with the default one."""
    scene, target = light("noise"), load_target("scamp5", Path())
    hot = completed({"dark_current_e_per_s": 300.0, "dark_spread_fraction": 10.0}, target)
    chance = drawing_chances(scene, NO_PIXELS, hot, device_seed, FRAME_S)
    found = draw_sample(NO_PIXELS, WELL_E, 1000, chance)
    square = current_e_per_s(hot, device_seed, np.arange(128 * 160)) ** 2
    assert square[found.places] @ found.weight == pytest.approx(square.sum(), rel=0.1)
    cold = completed({"dark_current_e_per_s": 0.0}, target)
    default = drawing_chances(scene, NO_PIXELS, completed({}, target), device_seed, FRAME_S)
    assert (default == drawing_chances(scene, NO_PIXELS, cold, device_seed, FRAME_S)).all()


@given(st.integers(0, 127), st.integers(0, 159))
def test_a_lamp_and_its_neighbours_are_always_drawn(row: int, col: int) -> None:
    """Wherever one bright pixel stands, the sample has it with a weight of 1: it stands for itself
    alone."""
    total = np.full((1, 128, 160), 30.0, np.float32)
    total[0, row, col] = 20_000.0
    found = sample(Light.of_clip(total))
    assert found.weight[found.places == row * 160 + col].tolist() == [1.0]


def test_pixels_beside_a_lamp_are_drawn_beside_brighter_lamps_that_saturate() -> None:
    """1600 pixels near saturation are ten times as bright as a lamp. Its neighbours, which get most
    charge of all other pixels from it, stand for themselves alone."""
    total = np.full((1, 128, 160), 30.0, np.float32)
    total[0, 20:60, 20:60] = 1e7
    total[0, 100, 100] = 1e6
    scene = Light.of_clip(total)
    found = sample(scene, near_at(np.flatnonzero(total > WELL_E)))
    for row, col in ((99, 100), (101, 100), (100, 99), (100, 101)):
        assert found.weight[found.places == row * 160 + col].tolist() == [1.0]


@pytest.mark.parametrize("is_sampled", [False, True])
def test_a_flashing_pixel_and_its_neighbours_are_always_drawn(is_sampled: bool) -> None:
    """A pixel whose light comes in one slot, as much as that of the others, has a weight of 1. So
    have its neighbours, which get charge from it if they are open then."""
    clip = np.full((8, 128, 160), 50.0, np.float32)
    clip[:, 5, 5] = [400] + [0] * 7
    scene = Light.of_clip(clip)
    found = sample(with_motion(scene) if is_sampled else scene)
    for row, col in ((5, 5), (4, 5), (6, 5), (5, 4), (5, 6)):
        assert found.weight[found.places == row * 160 + col].tolist() == [1.0]


def test_all_pixels_of_small_scenes_are_measured() -> None:
    """Of 3000 pixels each is measured, with a weight of 1."""
    found = sample(light("noise", 50, 60))
    assert found.places.tolist() == [*range(3000)]
    assert set(found.weight.tolist()) == {1.0}


def test_the_brightest_and_darkest_pixels_near_saturation_are_drawn() -> None:
    near = near_at(np.arange(10_000))
    found = sample(light("noise"), near)
    for extreme in (near.most_e.argmax(), near.most_e.argmin()):
        assert found.weight[found.places == near.places[extreme]].tolist() == [1.0]


@pytest.mark.parametrize("seed", range(5))
def test_the_standard_error_is_that_of_other_samples(seed: int) -> None:
    """The standard error equals the spread of the means of 400 samples of an uneven population."""
    rng = np.random.default_rng(seed)
    errors_e = rng.standard_gamma(2.0, 20_000) * 10
    chance = rng.uniform(0.2, 5.0, 20_000)
    said, means = [], []
    for _ in range(400):
        drawn = rng.choice(20_000, 500, p=chance / chance.sum())
        size_e, weight = errors_e[drawn][None, None, None], 1.0 / chance[drawn]
        same = np.ones(size_e.shape, np.bool_)
        found = sampled_errors(size_e, np.zeros(size_e.shape), same, weight)
        means.append(found.square_e2())
        said.append(found.square_e2(1.0) - found.square_e2())
    assert np.mean(said) == pytest.approx(np.std(means), rel=0.15)
    assert np.mean(means) == pytest.approx((errors_e**2).mean(), rel=0.05)


def test_exposures_that_are_not_finite_are_large_errors_and_other_states_are_left_out() -> None:
    exposed, true = np.array([[[[1.0, np.nan, 3.0]]]]), np.array([[[[0.0, 0.0, np.nan]]]])
    same = np.ones(true.shape, np.bool_)
    found = sampled_errors(exposed, true, same, np.ones(3))
    assert found.worst_e == 1e30
    assert found.size_e.tolist() == [[[[1.0, 1e30, 0.0]]]]
    assert found.other_states == pytest.approx(1 / 3)
    same[0, 0, 0, 1] = False
    found = sampled_errors(exposed, true, same, np.ones(3))
    assert found.square_e2() == pytest.approx(1.0)
    assert found.other_states == pytest.approx(2 / 3)
