"""The sample of pixels: means over it are those of the array, and a lamp is never missed."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from nscc_runtime.planner import sample as module
from nscc_runtime.planner.sample import sample_of

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
