"""Sums of light by lane, and leakage between a few rates, against exact arithmetic."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from nscc.target.load import builtin_target
from nscc_runtime.effects import everything
from nscc_runtime.effects.leakage import leak_per_s
from nscc_runtime.effects.parts import Leak
from nscc_runtime.light import Light
from nscc_runtime.planner import leak_nodes, sums
from nscc_runtime.sensor import default_sensor

SENSOR = default_sensor(builtin_target("scamp5"))
LEAK = everything().part(Leak)


def exact(frames: np.ndarray, lanes: np.ndarray, tables: np.ndarray) -> np.ndarray:
    """The weighted sums (J, pixels), by fsum over float64 products."""
    return np.array(
        [
            [
                math.fsum(
                    float(table[k, lanes[p]]) * float(frames[k, p]) for k in range(len(frames))
                )
                for p in range(frames.shape[1])
            ]
            for table in tables
        ]
    )


@pytest.mark.parametrize("shape", [(1, 1, 1, 1), (7, 5, 3, 2), (40, 600, 4, 3), (3, 1025, 1, 1)])
def test_sums_are_exact_sums(shape: tuple[int, int, int, int]) -> None:
    count, pixels, lanes_count, number = shape
    rng = np.random.default_rng(count)
    frames = np.exp(rng.uniform(-20, 20, (count, pixels))).astype(np.float32)
    lanes = rng.integers(0, lanes_count, pixels)
    tables = rng.uniform(-1, 1, (number, count, lanes_count))
    found = sums.weighted_sums(frames, lanes, tables)
    size = exact(frames, lanes, np.abs(tables))
    assert np.all(np.abs(found - exact(frames, lanes, tables)) <= 1e-13 * size)


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
    scales, weights = (scale, scale.astype(np.float32)), rng.uniform(-1, 1, (4, slots, 3))
    # Weights that are none, and the same for all lanes.
    weights[0, 1], weights[1, 2], weights[3, 0] = 0.0, 0.25, 0.5
    found = sums.scene_sums(light, lanes, scales, sums.Weights(weights), 2, fraction)
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
        again = sums.scene_sums(light, lanes, scales, sums.Weights(weights), 2, fraction, threads)
        assert again.tobytes() == found.tobytes()


def test_large_tables_are_taken_in_turns(monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(4)
    light = Light.of_clip(rng.random((6, 4, 5), dtype=np.float32))
    lanes, scale = rng.integers(0, 3, 20).astype(np.int32), rng.random(20)
    scales, weights = (scale, scale.astype(np.float32)), rng.random((5, 6, 3))
    whole = sums.scene_sums(light, lanes, scales, sums.Weights(weights), 3, 0.02)
    monkeypatch.setattr(sums, "_MOST_ENTRIES", 6 * 3 * 2)
    parts = sums.scene_sums(light, lanes, scales, sums.Weights(weights), 3, 0.02)
    assert parts.tobytes() == whole.tobytes()


def test_weights_are_those_of_the_light_that_is_asked_for() -> None:
    """Also where its matrix is what another's was, and has been written to since."""
    rng = np.random.default_rng(5)
    weights, matrix = sums.Weights([rng.random((4, 3)), rng.random((4, 3))]), rng.random(4)
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


def test_threads_change_no_bit_and_views_are_read_as_they_are() -> None:
    rng = np.random.default_rng(1)
    frames = rng.random((9, 2000)).astype(np.float32)
    lanes, tables = rng.integers(0, 3, 1000), rng.random((2, 9, 3))
    once = sums.weighted_sums(frames[:, ::2], lanes, tables)
    np.testing.assert_allclose(once[:, :20], exact(frames[:, ::2][:, :20], lanes, tables))
    for threads in (2, 3, 16):
        again = sums.weighted_sums(frames[:, ::2], lanes, tables, threads)
        assert again.tobytes() == once.tobytes()


def test_nothing_to_add_up() -> None:
    none = np.empty((4, 0), np.float32), np.empty(0, np.int32), np.ones((2, 4, 1))
    assert sums.weighted_sums(*none).shape == (2, 0)
    light = Light.of_clip(np.ones((4, 1, 3), np.float32))
    empty = sums.sums_by_slot(light, light.frames.reshape(4, 3), np.zeros(3, np.int32), [])
    assert empty.shape == (0, 3)


@pytest.mark.parametrize(
    ("lanes", "tables"),
    [
        (np.zeros(5, np.int32), (1, 3, 2)),
        (np.zeros(4, np.int32), (1, 4, 2)),
        (np.full(5, 2, np.int32), (1, 4, 2)),
        (np.full(5, -1, np.int32), (1, 4, 2)),
    ],
)
def test_arrays_that_do_not_fit_are_refused(lanes: np.ndarray, tables: tuple[int, ...]) -> None:
    """The loop itself would read beyond their ends."""
    with pytest.raises(ValueError, match="lane"):
        sums.weighted_sums(np.ones((4, 5), np.float32), lanes, np.ones(tables))


def test_slots_that_share_frames(monkeypatch: pytest.MonkeyPatch) -> None:
    """Weights of slots, through the light's own matrix; table by table where memory is short."""
    rng = np.random.default_rng(3)
    light = Light(
        rng.random((3, 2, 5)).astype(np.float32),
        np.array([0, 2, 2, 3, 5]),
        np.array([0, 1, 2, 1, 2], np.int32),
        rng.random(5),
        "clip",
    )
    lanes = rng.integers(0, 2, 10)
    weights = [rng.random((4, 2)) for _ in range(3)]
    slots = np.zeros((4, 10))
    for n in range(4):
        for k in range(light.row_start[n], light.row_start[n + 1]):
            slots[n] += light.weight[k] * light.frames[light.frame_index[k]].reshape(-1)
    expected = [(weight[:, lanes] * slots).sum(axis=0) for weight in weights]
    flat = light.frames.reshape(3, 10)
    found = sums.sums_by_slot(light, flat, lanes, weights)
    np.testing.assert_allclose(found, expected, rtol=1e-12)
    monkeypatch.setattr(sums, "_MOST_ENTRIES", 1)
    assert sums.sums_by_slot(light, flat, lanes, weights).tobytes() == found.tobytes()


@given(st.integers(2, leak_nodes.MOST), st.floats(0.01, 0.6), st.integers(0, 5))
def test_between_rates_polynomials_are_exact(count: int, spread: float, power: int) -> None:
    """With K rates, powers of the rate below K come out as they are."""
    sensor = SENSOR.changed(leakage_spread_fraction=spread)
    nodes = leak_nodes.rates(LEAK, sensor, count)
    assert len(nodes) == len(set(nodes.tolist())) == count
    mean = 1.0 / sensor.leakage_tau_s
    leak = np.linspace(nodes.min(), nodes.max(), 11)
    weights = leak_nodes.between(nodes, leak)
    power = min(power, count - 1)
    np.testing.assert_allclose(
        ((nodes / mean) ** power) @ weights, (leak / mean) ** power, rtol=1e-6
    )


@pytest.mark.parametrize("spread", [0.0, 0.1, 0.5])
@pytest.mark.parametrize("age_s", [0.01, 1.0, 10.0])
def test_the_error_between_rates_is_that_of_real_pixels(spread: float, age_s: float) -> None:
    sensor = SENSOR.changed(leakage_tau_s=5.0, leakage_spread_fraction=spread)
    leak = leak_per_s(sensor, 3, np.arange(60_000))
    for count in range(1, leak_nodes.MOST + 1):
        if spread == 0.0 and count > 1:
            break  # one rate is all there is
        nodes = leak_nodes.rates(LEAK, sensor, count)
        near = np.exp(-nodes * age_s) @ leak_nodes.between(nodes, leak)
        measured = float(np.sqrt(((near - np.exp(-leak * age_s)) ** 2).mean()))
        predicted = leak_nodes.error(LEAK, sensor, count, age_s)
        # A spread is all in the tails: beyond four sigmas there are few pixels with large errors.
        assert measured == pytest.approx(predicted, rel=0.25, abs=1e-12)


def test_more_rates_are_better() -> None:
    sensor = SENSOR.changed(leakage_spread_fraction=0.3)
    errors = [leak_nodes.error(LEAK, sensor, count, 5.0) for count in range(1, leak_nodes.MOST + 1)]
    assert errors == sorted(errors, reverse=True)
    assert errors[-1] < 1e-4 * errors[0]
