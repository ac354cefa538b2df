"""Single pixels through their words: what the reference makes of them, to rounding."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from plan_cases import CASES, case, moving_light
from reference_programs import sensor_of

from nscc.words.container import Container
from nscc_runtime.effects import optional, selected
from nscc_runtime.execution.pixels import Running
from nscc_runtime.execution.program import AnalysedProgram
from nscc_runtime.light import Light
from nscc_runtime.reference import expose
from nscc_runtime.sensor import Sensor

SEEDS = {"seed": 3, "device_seed": 5, "frame": 2}
SETS = (
    "none", "all", *optional(), "shot,dark", "shot,crosstalk", "dark,crosstalk,leakage",
    "read,reset,analog", "all,-full_well,-register", "full_well,register,dead_time",
)  # fmt: skip


def compared(
    container: Container, light: Light, sensor: Sensor, effects: str, places: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """What the loop and the reference give (buckets, places); what cut it off is the same."""
    chosen = selected(effects)
    program = AnalysedProgram.of(container, sensor)
    exposed = expose(container, light, sensor, chosen, **SEEDS)  # type: ignore[arg-type]
    wired = program.wired(chosen, SEEDS["device_seed"])
    found, marked = Running(wired, light, places, 1).expose(SEEDS["seed"], SEEDS["frame"])
    buckets = len(container.buckets)
    assert np.array_equal(marked, exposed.saturated_by.reshape(buckets, -1)[:, places])
    return found, exposed.exposure_e.reshape(buckets, -1)[:, places]


def sensor_near(container: Container, **values: float) -> Sensor:
    """A sensor whose wells and registers the light of these tests fills here and there."""
    wells = {
        "full_well_e": 2500.0, "register_min_e": -3000.0, "register_max_e": 3000.0,
        "electrons_per_lsb": 10.0, "leakage_tau_s": 0.05, "leakage_spread_fraction": 0.3,
        "crosstalk_fraction": 0.03, "dark_current_e_per_s": 20000.0, "prnu_fraction": 0.05,
    }  # fmt: skip
    return sensor_of(container, **{**wells, **values})


@pytest.mark.parametrize("effects", SETS)
@pytest.mark.parametrize("name", CASES)
def test_every_lowering_and_effect_as_the_reference(name: str, effects: str) -> None:
    container = case(name, rows=6, cols=9)
    light = moving_light((8, 6, 9), 500.0)
    found, full = compared(container, light, sensor_near(container), effects, np.arange(54))
    assert np.ptp(full) > 0
    np.testing.assert_allclose(found, full, rtol=1e-9, atol=1e-7)


@pytest.mark.parametrize("slots", [1, 3, 5, 13])
def test_numbers_of_slots_that_are_no_powers_of_two(slots: int) -> None:
    from reference_programs import program

    text = f"nsl 1\nframe {slots} slots of 1ms\ncode stop : 0..N\nopen when n < stop\n"
    container = program(text + "pixels stop = (x + y) % (N + 1)\n", "edges", 5, 7)
    light = moving_light((slots, 5, 7), 900.0)
    for effects in ("all", "shot", "shot,dark,leakage"):
        found, full = compared(container, light, sensor_near(container), effects, np.arange(35))
        np.testing.assert_allclose(found, full, rtol=1e-9, atol=1e-7)


def test_arrays_of_one_pixel_one_row_and_one_column() -> None:
    for rows, cols in ((1, 1), (1, 9), (9, 1)):
        container = case("d edges", rows=rows, cols=cols)
        light = moving_light((8, rows, cols), 500.0)
        every = np.arange(rows * cols)
        found, full = compared(container, light, sensor_near(container), "all", every)
        np.testing.assert_allclose(found, full, rtol=1e-9, atol=1e-7)


@pytest.mark.parametrize("name", ["b edges", "d edges", "codebook", "two buckets"])
@pytest.mark.parametrize("retention_us", [700.0, 1600.0])
def test_registers_that_lose_their_codes(name: str, retention_us: float) -> None:
    container = case(name, rows=6, cols=9)
    light = moving_light((8, 6, 9), 500.0)
    sensor = sensor_near(container, digital_retention_us=retention_us)
    kept, lost = (
        compared(container, light, sensor, effects, np.arange(54))
        for effects in ("all,-decay", "all")
    )
    assert not np.array_equal(kept[1], lost[1])
    for found, full in (kept, lost):
        np.testing.assert_allclose(found, full, rtol=1e-9, atol=1e-7)


@pytest.mark.parametrize("effects", ["none", "leakage,read", "all"])
def test_what_registers_held_before_the_frame_is_read(effects: str) -> None:
    container = case("b accumulate", rows=6, cols=9)
    container = replace(container, launches=container.launches[1:])
    program = AnalysedProgram.of(container, sensor_near(container))
    assert program.pixels.stale
    assert not AnalysedProgram.of(case("b accumulate", rows=6, cols=9), program.sensor).pixels.stale
    light = moving_light((8, 6, 9), 500.0)
    found, full = compared(container, light, sensor_near(container), effects, np.arange(54))
    np.testing.assert_allclose(found, full, rtol=1e-9, atol=1e-7)


@pytest.mark.parametrize("frames_s", [None, 0.003])
def test_light_that_is_sampled_or_spread(frames_s: float | None) -> None:
    """Light whose slots are sums of several frames, with and without motion inside them."""
    from nscc_runtime.scenes import ExposureLevel
    from nscc_runtime.scenes.exposure import scale
    from nscc_runtime.scenes.timing import check_fps, overlaps, spread, with_motion

    container = case("d edges", rows=6, cols=9)
    if frames_s is None:
        light = with_motion(moving_light((8, 6, 9), 500.0))
    else:
        fps = check_fps(1 / frames_s)
        parts = overlaps(container.slot_us, fps)
        frames = moving_light((3, 6, 9), 500.0).frames
        clip = spread(frames, parts, lambda total: scale(total, ExposureLevel(4000.0), "clip"))
        light = with_motion(clip, parts.seconds, float(fps))
    for effects in ("all", "motion", "all,-motion"):
        found, full = compared(container, light, sensor_near(container), effects, np.arange(54))
        np.testing.assert_allclose(found, full, rtol=1e-9, atol=1e-7)


def test_stills_whose_slots_are_alike_or_not() -> None:
    container = case("d edges", rows=6, cols=9)
    frame = moving_light((8, 6, 9), 500.0).frames[0]
    for weight in (np.full(8, 0.7), np.linspace(0.1, 2.0, 8)):
        light = Light.of_still(frame, weight)
        for effects in ("all", "shot", "full_well,lag,prnu"):
            found, full = compared(container, light, sensor_near(container), effects, np.arange(54))
            np.testing.assert_allclose(found, full, rtol=1e-9, atol=1e-7)


def test_slots_so_short_that_words_fill_them() -> None:
    from reference_programs import program

    text = "nsl 1\nframe 4 slots of 3us\ncode stop : 0..4\nopen when n < stop\n"
    container = program(text + "pixels stop = x % 5\n", "edges", 5, 7)
    container = replace(container, slot_us=(1.5,) * 4)
    light = moving_light((4, 5, 7), 900.0)
    for effects in ("dead_time", "dead_time,shot,crosstalk", "all"):
        found, full = compared(container, light, sensor_near(container), effects, np.arange(35))
        np.testing.assert_allclose(found, full, rtol=1e-9, atol=1e-7)


def test_zeros_and_extremes_of_the_sensor() -> None:
    container = case("c accumulate", rows=6, cols=9)
    light = moving_light((8, 6, 9), 500.0)
    for values in (
        {"dark_current_e_per_s": 0.0},
        {"dark_spread_fraction": 0.0, "leakage_spread_fraction": 0.0},
        {"register_knee_fraction": 0.0},
        {"register_knee_fraction": 1.0},
        {"analog_bias_lsb": -8.0, "analog_gain": 1.3},
        {"full_well_e": 1.0},
        {"lag_fraction": 1.0, "prnu_fraction": 0.2},
        {"leakage_tau_s": 1e-4},
    ):
        sensor = sensor_near(container, **values)
        found, full = compared(container, light, sensor, "all", np.arange(54))
        np.testing.assert_allclose(found, full, rtol=1e-9, atol=1e-7)


def test_light_without_limit_and_next_to_none() -> None:
    container = case("b edges", rows=6, cols=9)
    light = moving_light((8, 6, 9), 500.0)
    light.frames[2, 1, 1] = 3e38
    light.frames[3, 4, 4] = 1e-30
    found, full = compared(
        container, light, sensor_near(container), "all,-crosstalk", np.arange(54)
    )
    np.testing.assert_allclose(found, full, rtol=1e-9, atol=1e-7)


def test_order_and_threads_change_no_bit_and_nothing_is_asked_for_twice() -> None:
    container = case("d accumulate", rows=20, cols=30)
    light = moving_light((8, 20, 30), 500.0)
    sensor = sensor_near(container)
    program = AnalysedProgram.of(container, sensor)
    places = np.arange(600)
    wired = program.wired(selected("all"), 5)
    once, _ = Running(wired, light, places, 1).expose(0, 0)
    order = np.random.default_rng(2).permutation(600)
    for threads in (2, 7):
        again, _ = Running(wired, light, order, threads).expose(0, 0)
        assert again.tobytes() == once[:, order].tobytes()
    none, marked = Running(wired, light, places[:0], 1).expose(0, 0)
    assert none.shape == marked.shape == (1, 0)
