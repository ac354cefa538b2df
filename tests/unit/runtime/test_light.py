"""Light on the array: the sparse form against a plain sum, and its identity."""

from __future__ import annotations

import math

import numpy as np
import pytest
from one_scene import load_scene

from nscc_runtime.light import Light


def some_light(seed: int = 0, slots: int = 7, frames: int = 4) -> tuple[Light, np.ndarray]:
    """A random light, and its slots by an independent sum in exact arithmetic."""
    rng = np.random.default_rng(seed)
    pictures = rng.random((frames, 3, 5), np.float32) * 1e4
    counts = rng.integers(0, 4, slots)
    row_start = np.concatenate(([0], np.cumsum(counts)))
    index = rng.integers(0, frames, row_start[-1]).astype(np.int32)
    weight = rng.random(row_start[-1])
    light = Light(pictures, row_start, index, weight, "clip")
    expected = np.zeros((slots, 3, 5), np.float32)
    for n, r, c in np.ndindex(expected.shape):
        parts = range(row_start[n], row_start[n + 1])
        expected[n, r, c] = math.fsum(float(pictures[index[k], r, c]) * weight[k] for k in parts)
    return light, expected


def test_slots_are_the_weighted_sums() -> None:
    """The dense clip of 7 slots of 3 x 5 pixels is the weighted sum of the stored pictures, in
    float32."""
    light, expected = some_light()
    np.testing.assert_allclose(light.dense(), expected, rtol=1e-7)
    assert light.dense().dtype == np.float32
    assert light.slots == 7
    assert light.shape == (3, 5)


def test_all_open_sum_is_the_sum_of_the_slots() -> None:
    light, _ = some_light(1, slots=500)
    dense = light.dense().astype(np.float64)
    exact = np.array([[math.fsum(dense[:, r, c]) for c in range(5)] for r in range(3)])
    np.testing.assert_allclose(light.total_e(), exact, rtol=1e-12)


def test_many_equal_slots_of_a_still_are_summed_accurately() -> None:
    light = Light.of_still(np.full((2, 2), 0.1, np.float32), np.full(4096, 1.0))
    # The sum is in float64: one in float32 would be less exact.
    assert light.total_e()[0, 0] == pytest.approx(4096 * float(np.float32(0.1)), rel=1e-15)


@pytest.mark.parametrize("entries", [[0, 1], [0, 1, 2]])
def test_frames_that_no_slot_uses_do_not_count(entries: list[int]) -> None:
    """The third frame is infinite and NaN; it falls into no slot, or has the weight 0."""
    frames = np.ones((3, 2, 2), np.float32)
    frames[2, 0] = np.inf, np.nan
    starts, weight = np.arange(len(entries) + 1), np.array([1.0, 2.0, 0.0])[: len(entries)]
    light = Light(frames, starts, np.array(entries, np.int32), weight, "clip")
    assert light.sum_e.tolist() == [[3.0, 3.0], [3.0, 3.0]]


def test_a_clip_of_weight_one_is_its_own_frames_to_the_bit() -> None:
    """Each slot is a view of the clip's own memory, and no copy."""
    frames = np.random.default_rng(2).random((4, 3, 3)).astype(np.float32)
    light = Light.of_clip(frames)
    for n in range(4):
        assert np.shares_memory(light.slot(n), frames)
        np.testing.assert_array_equal(light.slot(n), frames[n])


def test_a_slot_without_frames_is_dark() -> None:
    nothing = np.zeros(0)
    light = Light(
        np.ones((1, 2, 2), np.float32), np.array([0, 0]), nothing.astype(np.int32), nothing, "clip"
    )
    assert not light.slot(0).any()


def test_identity_depends_on_values_only() -> None:
    """The digest changes with values or weights. The order in memory does not change it."""
    first, second = some_light()[0], some_light()[0]
    assert first.sha256() == second.sha256()
    assert some_light(5)[0].sha256() != first.sha256()
    halved = Light(first.frames, first.row_start, first.frame_index, first.weight * 0.5, first.kind)
    assert halved.sha256() != first.sha256()
    view = np.asfortranarray(first.frames)
    same = Light(view, first.row_start, first.frame_index, first.weight, first.kind)
    assert same.sha256() == first.sha256()


def test_thousands_of_slots_of_a_still_cost_one_picture() -> None:
    """A still of 4096 slots keeps one picture of 64 x 64 float32 values."""
    light = load_scene("builtin:hdr", slot_us=(10.0,) * 4096, rows=64, cols=64)
    assert light.frames.nbytes == 64 * 64 * 4
    assert light.slots == 4096


def test_mismatched_parts_are_refused() -> None:
    with pytest.raises(ValueError, match="entries"):
        Light(
            np.ones((1, 2, 2), np.float32),
            np.array([0, 2]),
            np.zeros(1, np.int32),
            np.ones(1),
            "clip",
        )


@pytest.mark.parametrize("cols", [7, 8])
def test_light_notices_frames_that_change_in_place(cols: int) -> None:
    """One pixel changes, the last of an odd number included, or two change places."""
    for first, second in ((0, 1), (3 * cols - 1, 0), (2, 3 * cols - 2)):
        frame = np.random.default_rng(6).random((3, cols), dtype=np.float32)
        light, pixels = Light.of_still(frame, np.ones(4)), frame.reshape(-1)
        assert light.current() is light
        pixels[[first, second]] = pixels[[second, first]]
        assert light.current() is not light
        pixels[[first, second]] = pixels[[second, first]]
        assert light.current() is light
        pixels[first] = np.nextafter(pixels[first], np.float32(2.0))
        assert light.current() is not light


@pytest.mark.parametrize("value", [2.0, 16384.0, 32768.0])
def test_light_notices_a_bar_of_one_value_that_moves_in_place(value: float) -> None:
    frame = np.zeros((64, 64), np.float32)
    frame[:, 0] = value
    light = Light.of_still(frame, np.ones(4))
    assert light.current() is light
    for col in range(1, 64):
        frame[:] = 0.0
        frame[:, col] = value
        assert light.current() is not light


def test_dark_pixels_stay_dark_if_the_weight_of_all_slots_is_beyond_float32() -> None:
    frame = np.array([[0.0, 1e-36]], np.float32)
    light = Light.of_still(frame, np.full(8, 1e38))
    np.testing.assert_allclose(light.sum_e, [[0.0, 800.0]], rtol=1e-6)
