"""A program's weights, its reach, its reads: against the reference probed slot by slot."""

from __future__ import annotations

import tracemalloc

import numpy as np
import pytest
from plan_cases import CASES, case
from reference_exposure import expose
from reference_programs import program, sensor_of

from nscc.words.container import Container
from nscc_runtime.effects import everything, named, selected
from nscc_runtime.effects.parts import Errors
from nscc_runtime.execution.program import AnalysedProgram
from nscc_runtime.execution.register_reach import reach_of
from nscc_runtime.light import Light
from nscc_runtime.reference.trace import AnalogWord
from nscc_runtime.reference.weights import ByName, WeightModel
from nscc_runtime.sensor import Sensor

ROWS, COLS = 6, 9
QUIET = {
    "analog_noise_lsb": 0.0,
    "analog_pattern_lsb": 0.0,
    "analog_bias_lsb": 0.0,
    "leakage_spread_fraction": 0.0,
    "leakage_tau_s": 0.02,
    "electrons_per_lsb": 10.0,
    "analog_gain": 0.96,
    "analog_move_loss": 0.25,
    "register_min_e": -1e9,
    "register_max_e": 1e9,
}
GAINS = {"gain": 0.96, "move_gain": 0.99}


def probed(container: Container, sensor: Sensor, effects: str) -> np.ndarray:
    """Weights (N, buckets, pixels): a thousand electrons in one slot of all pixels, and none."""
    slots = container.slots
    found = []
    dark = Light.of_clip(np.zeros((slots, ROWS, COLS), np.float32))
    nothing = expose(container, dark, sensor, selected(effects)).exposure_e
    for n in range(slots):
        frames = np.zeros((slots, ROWS, COLS), np.float32)
        frames[n] = 1000.0
        lit = expose(container, Light.of_clip(frames), sensor, selected(effects)).exposure_e
        found.append(((lit - nothing) / 1000.0).reshape(len(lit), -1))
    return np.stack(found)


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize(
    ("effects", "model"),
    [
        ("none", WeightModel()),
        ("analog", WeightModel(**GAINS)),
        ("leakage", WeightModel(leak_per_s=50.0)),
        ("dead_time", WeightModel(slow_words=True)),
        ("dead_time,black_sun", WeightModel(slow_words=True, lit_level=True)),
        ("decay", WeightModel(decay=True)),
        (
            "analog,leakage,dead_time,decay",
            WeightModel(leak_per_s=50.0, slow_words=True, decay=True, **GAINS),
        ),
        (
            "analog,leakage,dead_time,black_sun",
            WeightModel(leak_per_s=50.0, slow_words=True, lit_level=True, **GAINS),
        ),
    ],
)
def test_weights_are_those_of_the_words(name: str, effects: str, model: WeightModel) -> None:
    container = case(name, rows=ROWS, cols=COLS)
    sensor = sensor_of(container, digital_retention_us=1600.0, **QUIET)
    made = AnalysedProgram.of(container, sensor)
    weights = made.weights(model).slots[:, made.lanes].transpose(0, 2, 1)
    np.testing.assert_allclose(weights, probed(container, sensor, effects), atol=1e-9)


def test_weights_are_kept_and_decay_costs_nothing_where_nothing_decays() -> None:
    """Without decay both kinds of weights are the same object. With a retention of 600 us they
    differ."""
    container = case("b edges", rows=ROWS, cols=COLS)
    made = AnalysedProgram.of(container, sensor_of(container))
    assert made.decayed is made.fresh
    assert made.weights(WeightModel(decay=True)) is made.weights(WeightModel())
    short = AnalysedProgram.of(container, sensor_of(container, digital_retention_us=600.0))
    assert short.decayed is not short.fresh
    assert short.weights(WeightModel(decay=True)) is not short.weights(WeightModel())


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("effect", ["read", "reset", "analog"])
def test_the_covariance_of_word_errors_equals_that_of_reference_frames(
    name: str, effect: str
) -> None:
    """The test compares the computed covariance with that of many pixels."""
    rows, cols = 60, 128
    container = case(name, rows=rows, cols=cols)
    quiet = {**QUIET, "analog_noise_lsb": 0.75, "analog_gain": 1.0, "leakage_tau_s": 1e6}
    sensor = sensor_of(container, **quiet)
    (errors,) = named(effect).parts_of_kind(Errors)
    sigma = errors.sigma_e(sensor)
    made = AnalysedProgram.of(container, sensor)
    dark = Light.of_clip(np.zeros((container.slots, rows, cols), np.float32))
    found = expose(container, dark, sensor, selected(effect)).exposure_e.reshape(-1, rows * cols)
    weights = made.weights(WeightModel.of(selected(effect), sensor))
    covariance = sigma**2 * weights.covariance(errors.at)
    variance = sigma**2 * weights.variance(errors.at)
    for lane in np.unique(made.lanes):
        here = made.lanes == lane
        for bucket in range(len(found)):
            expected = variance[lane, bucket]
            tolerance = 6 * expected * (2 / here.sum()) ** 0.5
            assert (found[bucket, here] ** 2).mean() == pytest.approx(expected, abs=tolerance)
        if len(found) > 1:
            product = (found[0, here] * found[1, here]).mean()
            limit = 6 * (variance[lane].max()) / here.sum() ** 0.5
            assert product == pytest.approx(covariance[0, 1, lane], abs=limit)


# Retention shorter than most frames: the last words do not run, or run in other lanes.
KEPT = pytest.mark.parametrize(("name", "decay"), [(n, d) for n in CASES for d in (False, True)])


def fading(name: str, decay: bool) -> tuple[AnalysedProgram, tuple[AnalogWord, ...]]:
    """A program whose digital registers decay in the frame, and its words with or without decay."""
    container = case(name, rows=ROWS, cols=COLS)
    kept_us = 0.7 * sum(container.slot_us)
    made = AnalysedProgram.of(container, sensor_of(container, digital_retention_us=kept_us))
    return made, made.decayed if decay else made.fresh


def test_decay_stops_words_of_most_programs() -> None:
    made = [fading(name, True)[0] for name in CASES]
    assert sum(each.decayed is not each.fresh for each in made) > len(CASES) / 2


@KEPT
def test_seen_slots_are_the_slots_whose_light_reaches_a_register(name: str, decay: bool) -> None:
    """For each lane and slot, a slot is seen if light in it alone changes a register."""
    made, words = fading(name, decay)
    expected = [
        [brute_force(made, words, lane, slot) > 0 for lane in range(len(words[0].lanes))]
        for slot in range(made.container.slots)
    ]
    np.testing.assert_array_equal(made.seen_slots(decay), expected)


def brute_force(
    made: AnalysedProgram, words: tuple[AnalogWord, ...], lane: int, slot: int
) -> float:
    """The largest part of one electron in a slot that any register of a lane ever holds."""
    held = dict.fromkeys((*made.container.target.analog_registers, "PIX"), 0.0)
    most, at = 0.0, 0
    for word in words:
        held["PIX"] += at <= slot < word.boundary
        at = word.boundary
        if not word.lanes[lane]:
            continue
        if word.resets:
            held["PIX"] = 0.0
            continue
        total = sum(held[name] for name in word.op.sources)
        for name in word.op.destinations:
            held[name] = -total / word.op.operation.divisor
            most = max(most, abs(held[name]))
    return most


@KEPT
def test_reach_of_light_is_that_of_every_slot_and_lane(name: str, decay: bool) -> None:
    """The largest weight of a lane and slot is that found by exposing them one by one."""
    made, words = fading(name, decay)
    lanes, slots = range(len(words[0].lanes)), range(made.container.slots)
    most = [[brute_force(made, words, lane, slot) for lane in lanes] for slot in slots]
    weights = reach_of(made, selected("register,decay" if decay else "register")).charge_weights
    assert weights is not None
    np.testing.assert_array_equal(weights.max(axis=0), most)


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("bias", [0.42, -3.0])
def test_noise_and_offsets_alone_stay_within_their_reach(name: str, bias: float) -> None:
    rows, cols = 60, 128
    container = case(name, rows=rows, cols=cols)
    sensor = sensor_of(container, analog_bias_lsb=bias, dark_current_e_per_s=0.0)
    made = AnalysedProgram.of(container, sensor)
    dark = Light.of_clip(np.zeros((container.slots, rows, cols), np.float32))
    names = selected("read,reset,analog")
    found = expose(container, dark, sensor, names).exposure_e.reshape(-1, rows * cols)
    for lane in np.unique(made.lanes):
        here = found[:, made.lanes == lane]
        # A tenth less than 4 standard deviations, for the sampling error of a few hundred pixels.
        most = 0.9 * (np.abs(here.mean(axis=1)) + 4.0 * here.std(axis=1)).max()
        programs = (
            AnalysedProgram.of(container, limited(sensor, linear_e))
            for linear_e in (most, 8 * most + 200)
        )
        tight, wide = (reach_of(limits, everything()).least_e[:, lane].min() for limits in programs)
        assert tight == 0 < wide


def limited(sensor: Sensor, linear_e: float) -> Sensor:
    """A sensor whose registers are linear up to so many electrons."""
    return sensor.changed(
        register_min_e=-linear_e, register_max_e=linear_e, register_knee_fraction=1.0
    )


def test_many_lanes_share_the_reach_of_the_worst() -> None:
    """With more than 64 lanes no weights are held, and each lane has the least light of the
    worst."""
    text = "nsl 1\nframe 128 slots of 500us\ncode stop : 0..N\nopen when n < stop\n"
    container = program(text + "pixels stop = (x + 8 * y) % (N + 1)\n", "accumulate", 16, 16)
    made = AnalysedProgram.of(container, sensor_of(container))
    assert reach_of(made, everything()).charge_weights is None
    assert reach_of(made, everything()).least_e.shape[1] == len(container.encoding) > 64
    assert np.ptp(reach_of(made, everything()).least_e) == 0


def test_weights_of_words_in_few_lanes_are_held_by_lane() -> None:
    """In frames of many slots, most words act in one of thousands of lanes."""
    weights, found = np.eye(2000)[:, :, None] * -0.5, ByName[int]()
    weights[7] = 0.25
    weights[8] = 0.0
    tracemalloc.start()
    for number, weight in enumerate(weights):
        found.keep(number, weight)
    assert tracemalloc.get_traced_memory()[0] < weights.nbytes / 20
    tracemalloc.stop()
    assert list(found) == [n for n in range(2000) if n != 8]
    for number, weight in found.items():
        np.testing.assert_array_equal(weight, weights[number])
