"""The sample of pixels: means over it are those of the array, and a lamp is never missed."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from plan_cases import case
from reference_programs import sensor_of

from nscc_runtime.effects.prnu import response
from nscc_runtime.light import Light
from nscc_runtime.planner import sample as module
from nscc_runtime.planner.program import Program
from nscc_runtime.planner.sample import Sample, chances, drawn_by, sample_of
from nscc_runtime.planner.sampled import SampledScene

NONE = np.empty(0, np.int64)


def scene(kind: str, rows: int = 128, cols: int = 160) -> np.ndarray:
    rng = np.random.default_rng(4)
    if kind == "noise":
        return rng.exponential(500.0, (rows, cols))
    if kind == "ramp":
        return np.linspace(0, 9000, rows * cols).reshape(rows, cols)
    if kind == "edges":
        return np.where((np.arange(cols) // 20 % 2)[None], 8000.0, 20.0) * np.ones((rows, 1))
    if kind == "dark":
        return np.zeros((rows, cols))
    found = np.full((rows, cols), 30.0)
    found[77, 31] = 1e7
    return found


@pytest.mark.parametrize("kind", ["noise", "ramp", "edges", "dark", "lamp"])
@pytest.mark.parametrize("near_count", [0, 100, 3000])
def test_means_over_the_sample_are_those_of_the_array(kind: str, near_count: int) -> None:
    total = scene(kind)
    near = np.sort(np.random.default_rng(1).choice(total.size, near_count, replace=False))
    sample = sample_of(total, 16, near)
    assert sample.weight.sum() == pytest.approx(total.size)
    assert np.all(sample.weight > 0)
    rest = np.ones(total.size, bool)
    rest[near] = False
    assert sample.near.any() == (near_count > 0)
    assert rest[sample.places[~sample.near]].all()
    assert np.isin(sample.places[sample.near], near).all()
    assert sample.weight[sample.near].sum() == pytest.approx(near_count)
    flat = total.reshape(-1)
    code = np.arange(total.size) % 160 % 8
    for values, most in (
        (flat, 0.1), (np.sqrt(flat), 0.1), (flat**2, 0.1), (flat * (code < 4), 0.15),
        (1.0 * (code == 3), 0.35),
    ):  # fmt: skip
        # With the lamp, means that no even sample of this size gets right.
        found = sample.mean(values[sample.places])
        assert found == pytest.approx(values.mean(), rel=most)


def test_the_mean_square_of_a_single_lamp_is_found() -> None:
    total = scene("lamp")
    sample = sample_of(total, 16, NONE)
    assert 77 * 160 + 31 in sample.places
    assert {76 * 160 + 31, 78 * 160 + 31, 77 * 160 + 30, 77 * 160 + 32} <= set(sample.places)
    found = sample.mean(total.reshape(-1)[sample.places] ** 2)
    assert found == pytest.approx((total**2).mean(), rel=0.02)


def test_all_pixels_of_a_small_array_count_once() -> None:
    sample = sample_of(scene("noise", 20, 30), 16, np.array([4, 5, 9]))
    assert sorted(sample.places) == list(range(600))
    np.testing.assert_allclose(sample.weight, 1.0)


def test_many_frames_mean_fewer_pixels_but_never_too_few() -> None:
    sizes = [len(sample_of(scene("noise"), frames, NONE).places) for frames in (1, 128, 4096)]
    assert sizes[0] >= sizes[1] >= sizes[2] > 500
    assert sizes[0] <= module._MOST_PIXELS


def test_pixels_that_may_saturate_are_at_most_some_hundreds() -> None:
    total = scene("noise")
    sample = sample_of(total, 16, np.arange(total.size))
    assert sample.near.all()
    assert 100 < len(sample.places) <= module._MOST_NEAR
    assert sample.weight.sum() == pytest.approx(total.size)


@given(
    st.integers(1, 9), st.integers(1, 9), st.integers(1, 10_000), st.data(),
)  # fmt: skip
def test_any_array_has_a_sample(rows: int, cols: int, frames: int, data: st.DataObject) -> None:
    values = data.draw(st.lists(st.floats(0, 1e30), min_size=rows * cols, max_size=rows * cols))
    near = data.draw(st.sets(st.integers(0, rows * cols - 1)))
    total = np.array(values).reshape(rows, cols)
    sample = sample_of(total, frames, np.array(sorted(near), np.int64))
    assert sample.weight.sum() == pytest.approx(rows * cols)
    assert len(set(sample.places.tolist())) == len(sample.places)
    assert (
        sample.places.tolist()
        == sample_of(total, frames, np.array(sorted(near), np.int64)).places.tolist()
    )


@pytest.mark.parametrize("wanted", [1, 7, 300])
def test_places_are_drawn_where_the_sum_of_chances_passes_points_in_equal_strata(
    wanted: int,
) -> None:
    chance = np.random.default_rng(wanted).exponential(1.0, 211)
    chance[[0, 50, 51, 210]] = 0.0
    points = np.arange(wanted) + (np.arange(wanted) * 0.6180339887498949) % 1.0
    upto = np.cumsum(chance)
    passed = np.searchsorted(upto, points * (upto[-1] / wanted), side="right")
    assert drawn_by(chance, wanted).tolist() == np.minimum(passed, 210).tolist()


@pytest.mark.parametrize("shape", [(1, 1), (1, 9), (9, 1), (6, 7)])
def test_chances_are_light_and_its_differences_to_each_neighbour(shape: tuple[int, int]) -> None:
    light = np.random.default_rng(2).exponential(50.0, shape)
    wide = np.pad(light, 1, mode="edge")
    score = light + sum(
        np.abs(light - beside)
        for beside in (wide[:-2, 1:-1], wide[2:, 1:-1], wide[1:-1, :-2], wide[1:-1, 2:])
    )
    never = np.arange(min(2, light.size - 1))
    drawn = np.ones(light.size, bool)
    drawn[never] = False
    score = np.where(drawn.reshape(shape), score + score.reshape(-1)[drawn].mean(), 0.0)
    assert chances(light, never) == pytest.approx(score)


def test_light_is_gathered_at_places_and_beside_them() -> None:
    rng = np.random.default_rng(3)
    frames = rng.exponential(9.0, (5, 4, 6)).astype(np.float32)
    frames[2, 1, 1] = 3e38
    places = np.array([0, 5, 7, 13, 18, 23])
    container = case("d edges", rows=4, cols=6)
    weight = Sample(places, np.ones(6), np.zeros(6, bool))
    clip = Light.of_clip(np.concatenate([frames, frames[:3]]))
    program = Program.of(container, sensor_of(container, prnu_fraction=0.1))
    scene = SampledScene(program, clip, weight, 5)
    part, most = program.device(5).fixed(response).reshape(4, 6), np.minimum(clip.frames, 1e30)
    there = np.pad(np.ones((4, 6)), 1)
    light, seen = (
        np.pad(most, ((0, 0), (1, 1), (1, 1))),
        np.pad(most * part, ((0, 0), (1, 1), (1, 1))),
    )
    sides = ((0, 1), (2, 1), (1, 0), (1, 2))
    row, col = np.divmod(places, 6)
    found = scene._frames
    assert found.own == pytest.approx(most[:, row, col])
    assert found.even == pytest.approx(sum(light[:, row + r, col + c] for r, c in sides), rel=1e-6)
    flow = found.lit[:, 1]
    assert flow == pytest.approx(sum(seen[:, row + r, col + c] for r, c in sides), rel=1e-6)
    count = sum(there[row + r, col + c] for r, c in sides)
    fraction = scene.exchanged
    own = (most * part)[:, row, col]
    falls = (1 - fraction * count) * own + fraction * flow
    weights = program.tables.weights(program.full).slots[:, program.lanes[places], 0]
    assert scene.light[0] == pytest.approx((falls * weights).sum(axis=0), rel=1e-6)
