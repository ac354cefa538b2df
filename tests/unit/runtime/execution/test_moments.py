"""Sums of light by lane, and leakage between two rates, against numpy."""

from __future__ import annotations

import numpy as np
import pytest
from plan_cases import case
from reference_programs import sensor_of

from nscc_runtime.effects import everything
from nscc_runtime.effects.leakage import leak_per_s
from nscc_runtime.execution import sum_loop as sums
from nscc_runtime.execution.moment_loop import Completing, complete_moments
from nscc_runtime.execution.moments import _rate_weights, leak_rates, on_chip
from nscc_runtime.execution.program import analysed
from nscc_runtime.light import Light


@pytest.mark.parametrize("shape", [(1, 1), (1, 9), (9, 1), (3, 4), (2, 515), (3, 1030)])
@pytest.mark.parametrize("clip", [True, False])
def test_sums_of_a_scene_are_weighted_sums_of_what_crosstalk_leaves(
    shape: tuple[int, int], clip: bool
) -> None:
    rng = np.random.default_rng(shape[1])
    slots, pixels, fraction = 5, shape[0] * shape[1], 0.07
    frames = rng.random((slots, *shape), dtype=np.float32)
    light = Light.of_clip(frames) if clip else Light.of_still(frames[0], rng.random(slots))
    lanes = rng.integers(0, 3, pixels).astype(np.int32)
    scale = rng.uniform(0.5, 1.5, pixels)
    scales, weights = scale.astype(np.float32), rng.uniform(-1, 1, (4, slots, 3))
    # Weights that are none, and the same for all lanes.
    weights[0, 1], weights[1, 2], weights[3, 0] = 0.0, 0.25, 0.5
    found = sums.light_sums(light, lanes, scales, sums.SlotWeights(weights), 2, fraction)
    dense = light.dense().astype(np.float64) * scale.reshape(shape)
    flow = np.zeros_like(dense)
    for axis in (1, 2):
        step = np.diff(dense, axis=axis)
        side = np.take(np.zeros_like(dense), [0], axis=axis)
        flow += np.concatenate([step, side], axis) - np.concatenate([side, step], axis)
    slots_of = (dense, dense, *[dense + fraction * flow] * 2)
    for each, weight, slot in zip(found, weights, slots_of, strict=True):
        wanted = (weight[:, lanes] * slot.reshape(slots, -1)).sum(axis=0)
        np.testing.assert_allclose(each, wanted, rtol=1e-5, atol=1e-5)
    for threads in (2, 5):
        again = sums.light_sums(
            light, lanes, scales, sums.SlotWeights(weights), 2, fraction, threads
        )
        assert again.tobytes() == found.tobytes()


def test_sums_of_light_in_several_passes_equal_those_in_one_pass(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The limit of entries is lowered to two pixels, so several passes are made. The sums keep
    their bytes."""
    rng = np.random.default_rng(4)
    light = Light.of_clip(rng.random((6, 4, 5), dtype=np.float32))
    lanes, scale = rng.integers(0, 3, 20).astype(np.int32), rng.random(20)
    scales, weights = scale.astype(np.float32), rng.random((5, 6, 3))
    whole = sums.light_sums(light, lanes, scales, sums.SlotWeights(weights), 3, 0.02)
    monkeypatch.setattr(sums, "_MOST_ENTRIES", 6 * 3 * 2)
    parts = sums.light_sums(light, lanes, scales, sums.SlotWeights(weights), 3, 0.02)
    assert parts.tobytes() == whole.tobytes()


def test_weights_follow_a_changed_matrix_of_the_light() -> None:
    """The matrix of weights is equal to that of earlier light, and is changed in place
    afterwards."""
    rng = np.random.default_rng(5)
    weights, matrix = sums.SlotWeights([rng.random((4, 3)), rng.random((4, 3))]), rng.random(4)
    frame = rng.random((2, 3), dtype=np.float32)
    for _ in range(3):
        light = Light.of_still(frame, matrix)
        for each in (light, Light.of_still(frame, matrix)):
            found = weights.of_frames(each)
            sums_of = np.array([matrix @ slots for slots in weights.slots])
            np.testing.assert_allclose(found.weights[:, 0], sums_of)
            np.testing.assert_allclose(found.most_part, sums_of.max(axis=0) / matrix.sum())
        clip = Light.of_clip(rng.random((4, 2, 3), dtype=np.float32))
        np.testing.assert_array_equal(weights.of_frames(clip).weights, weights.slots)
        matrix += 1.0


def test_shared_frames_and_slots_are_weighed_once_each() -> None:
    """Weights of slots, through the light's own matrix; runs of frames with the same weights are
    added up before they are weighed."""
    rng = np.random.default_rng(3)
    light = Light(
        rng.random((3, 2, 5)).astype(np.float32),
        np.array([0, 2, 2, 3, 5]),
        np.array([0, 1, 2, 1, 2], np.int32),
        rng.random(5),
        "clip",
    )
    lanes, scale = rng.integers(0, 2, 10).astype(np.int32), np.ones(10)
    scales, weights = scale.astype(np.float32), [rng.random((4, 2)) for _ in range(3)]
    found = sums.light_sums(light, lanes, scales, sums.SlotWeights(weights), 3, 0.0)
    slots = light.dense().reshape(4, 10)
    expected = [(weight[:, lanes] * slots).sum(axis=0) for weight in weights]
    np.testing.assert_allclose(found, expected, rtol=1e-6)
    many = Light.of_clip(rng.random((12, 2, 5)).astype(np.float32))
    alike = [np.repeat(weight[:3], 4, axis=0) for weight in weights]
    found = sums.light_sums(many, lanes, scales, sums.SlotWeights(alike), 1, 0.01)
    assert sums.SlotWeights(alike).of_frames(many).alike.tolist() == [4, 3, 2, 1] * 3
    parts = []
    for k in range(12):
        single = sums.SlotWeights([each * (np.arange(12) == k)[:, None] for each in alike])
        parts.append(sums.light_sums(many, lanes, scales, single, 1, 0.01))
    np.testing.assert_allclose(found, np.sum(parts, axis=0), rtol=1e-12)


def test_a_lane_that_there_is_not_is_refused() -> None:
    """The loop itself would read beyond the table's end."""
    light = Light.of_clip(np.ones((2, 1, 3), np.float32))
    scales, weights = np.ones(3, np.float32), sums.SlotWeights([np.ones((2, 2))])
    for lane in (2, -1):
        with pytest.raises(ValueError, match="lane"):
            sums.light_sums(light, np.full(3, lane, np.int32), scales, weights, 1, 0.0)


@pytest.mark.parametrize(
    ("tau_s", "spread", "count"),
    [(1.0, 0.0, 1), (1.0, 1e-320, 1), (5.0, 0.1, 2), (0.3, 0.3, 3), (0.05, 0.5, 3), (0.01, 2.0, 3)],
)
def test_interpolated_leakage_is_that_of_every_pixel_that_does_not_run_its_words(
    tau_s: float, spread: float, count: int
) -> None:
    """Chips with a single rate need no second one; a third is used if pixels differ much."""
    container = case("two buckets", rows=40, cols=50)
    sensor = sensor_of(container, leakage_tau_s=tau_s, leakage_spread_fraction=spread)
    every, program = everything(), analysed(container, sensor)
    rates = np.array(leak_rates(program, every))
    assert len(rates) == count
    device = program.device(3)
    evenly = np.delete(np.arange(2000), on_chip(program, every, 3).uneven)
    assert len(evenly) > (0 if count == 3 else 1999)
    of_pixels = leak_per_s(sensor, 3, device.places)[evenly]
    rate_weights = _rate_weights(every, device, tuple(rates.tolist()))[:, evenly]
    for age_s in np.array([0.1, 0.5, 1.0]) * program.oldest_s:
        near, exact = np.exp(-rates * age_s) @ rate_weights, np.exp(-of_pixels * age_s)
        assert np.abs(near / exact - 1.0).max() <= 4e-6
        # Sums take the noise at the mean rate.
        assert np.abs(np.exp(-age_s / tau_s) / exact - 1.0).max() <= 0.031


@pytest.mark.parametrize("buckets", [1, 2, 3, 4])
def test_independent_counts_have_the_covariances_of_the_sums(buckets: int) -> None:
    """One bucket is a multiple of another, and neighbours add counts."""
    rng, (rows, cols) = np.random.default_rng(buckets), (4, 7)
    pixels, pairs = rows * cols, buckets * (buckets + 1) // 2
    factors = rng.normal(size=(pixels, buckets, buckets))
    factors[::3, -1] = 2.0 * factors[::3, 0]
    wanted = np.einsum("pak,pbk->abp", factors, factors)
    below = [(a, b) for b in range(buckets) for a in range(b + 1)]
    dark_e2 = np.array([0.25 * wanted[a, b] for a, b in below], np.float32)
    light_e2 = np.array([0.75 * wanted[a, b] for a, b in below])
    charge_e = 10.0 * rng.random(pixels)
    dark_e = (0.3 * charge_e).astype(np.float32)
    unknown = 0.01 * rng.random((4, buckets, pixels), np.float32)
    unknown[:, :, ::3] = 0.0
    padded = np.pad(charge_e.reshape(rows, cols), 1)
    sides = padded[:-2, 1:-1], padded[2:, 1:-1], padded[1:-1, :-2], padded[1:-1, 2:]
    received = sum(part * side.reshape(-1) for part, side in zip(unknown, sides, strict=True))
    for b in range(buckets):
        wanted[b, b] += np.asarray(received)[b]
    weights = rng.uniform(0.5, 2.0, (buckets, pixels)).astype(np.float32)
    rate_weights, by_rate = rng.random((3, pixels), np.float32), rng.random((buckets, 3, pixels))
    fixed_e = rng.random((buckets, pixels), np.float32)
    mean_e, count_means = np.empty((buckets, pixels)), np.empty((buckets, pixels))
    own_weights = np.empty((buckets, buckets, pixels), np.float32)
    complete_moments(
        sizes=Completing(
            begin=0,
            end=rows,
            rows=rows,
            cols=cols,
            pixels=pixels,
            buckets=buckets,
            rates=3,
            light_pairs=pairs,
            dark_pairs=pairs,
            exchanges=1,
            overlaps=1,
        ),
        sums=np.concatenate([light_e2, by_rate.reshape(-1, pixels)]),
        rate_weights=rate_weights,
        fixed_e=fixed_e,
        dark_e2=dark_e2,
        sum_e=((charge_e - dark_e) / 2.0).astype(np.float32).reshape(rows, cols),
        factor=np.full(pixels, 2.0, np.float32),
        dark_e=dark_e,
        unknown=unknown,
        electron_weights=weights,
        covariance_e2=np.empty(pairs * cols),
        frame_e=np.empty(3 * cols),
        mean_e=mean_e,
        count_means=count_means,
        own_weights=own_weights,
    )
    np.testing.assert_allclose(mean_e, fixed_e + (by_rate * rate_weights).sum(axis=1))
    found = np.einsum("kap,kbp,kp->abp", own_weights, own_weights, count_means)
    np.testing.assert_allclose(found, wanted, rtol=1e-5, atol=1e-5)
    assert (count_means >= 0).all()
