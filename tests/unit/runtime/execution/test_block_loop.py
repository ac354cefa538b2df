"""Pixels that run through their words: the reference's exposures, to the rounding of noise."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from plan_cases import CASES, case, moving_light
from reference_exposure import expose
from reference_programs import sensor_of

from nscc.words.container import Container
from nscc_runtime.caches import Recent
from nscc_runtime.effects import optional, selected
from nscc_runtime.execution import block_scene
from nscc_runtime.execution.block_program import _in_use
from nscc_runtime.execution.block_scene import expose_pixels, prepare_pixels
from nscc_runtime.light import Light
from nscc_runtime.sensor import Sensor

SEEDS = {"seed": 3, "device_seed": 5, "frame": 2}
COUNTED = ",-shot,-dark"
"""Counts are drawn for other intervals than in the reference: `test_simulators_agree`."""
SETS = (
    "none",
    "all",
    *(name for name in optional() if name not in ("shot", "dark")),
    "crosstalk,leakage",
    "read,reset,analog",
    "all,-full_well,-register",
    "full_well,register,dead_time",
)


def compared(
    container: Container, light: Light, sensor: Sensor, effects: str, places: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """What the loop and the reference give (buckets, places), without counts; what cut it off is
    the same."""
    chosen = selected(effects + COUNTED)
    exposed = expose(container, light, sensor, chosen, **SEEDS)  # type: ignore[arg-type]
    scene = prepare_pixels(container, sensor, light, chosen, places, SEEDS["device_seed"])
    found = expose_pixels(scene, SEEDS["seed"], SEEDS["frame"])
    buckets = len(container.buckets)
    marked = exposed.saturated_by.reshape(buckets, -1)[:, places]
    assert np.array_equal(found.saturated_by, marked)
    return found.exposure_e, exposed.exposure_e.reshape(buckets, -1)[:, places]


def sensor_near(container: Container, **values: float) -> Sensor:
    """A sensor whose wells and registers the light of these tests fills here and there."""
    wells = {
        "full_well_e": 2500.0,
        "register_min_e": -3000.0,
        "register_max_e": 3000.0,
        "electrons_per_lsb": 10.0,
        "leakage_tau_s": 0.05,
        "leakage_spread_fraction": 0.3,
        "crosstalk_fraction": 0.03,
        "dark_current_e_per_s": 20000.0,
        "prnu_fraction": 0.05,
    }
    return sensor_of(container, **{**wells, **values})


@pytest.mark.parametrize("effects", SETS)
@pytest.mark.parametrize("name", CASES)
def test_every_lowering_and_effect_equals_the_reference(name: str, effects: str) -> None:
    """For each program and set of effects, the loop over blocks gives the electrons of the
    word-by-word reference."""
    container = case(name, rows=6, cols=9)
    light = moving_light((8, 6, 9), 500.0)
    found, full = compared(container, light, sensor_near(container), effects, np.arange(54))
    assert np.ptp(full) > 0
    np.testing.assert_allclose(found, full, rtol=1e-9, atol=1e-3)


@pytest.mark.parametrize("slots", [1, 3, 5, 13])
def test_any_number_of_slots_equals_the_reference(slots: int) -> None:
    """Frames of 1, 3, 5 and 13 slots have the reference's electrons: blocks of slots need not be
    full."""
    from reference_programs import program

    text = f"nsl 1\nframe {slots} slots of 1ms\ncode stop : 0..N\nopen when n < stop\n"
    container = program(text + "pixels stop = (x + y) % (N + 1)\n", "edges", 5, 7)
    light = moving_light((slots, 5, 7), 900.0)
    for effects in ("all", "shot", "shot,dark,leakage"):
        found, full = compared(container, light, sensor_near(container), effects, np.arange(35))
        np.testing.assert_allclose(found, full, rtol=1e-9, atol=1e-3)


def test_arrays_of_one_pixel_row_or_column_equal_the_reference() -> None:
    for rows, cols in ((1, 1), (1, 9), (9, 1)):
        container = case("d edges", rows=rows, cols=cols)
        light = moving_light((8, rows, cols), 500.0)
        every = np.arange(rows * cols)
        found, full = compared(container, light, sensor_near(container), "all", every)
        np.testing.assert_allclose(found, full, rtol=1e-9, atol=1e-3)


@pytest.mark.parametrize("name", ["b edges", "d edges", "codebook", "two buckets"])
@pytest.mark.parametrize("retention_us", [700.0, 1600.0])
def test_exposures_with_registers_that_lose_their_bits_equal_the_reference(
    name: str, retention_us: float
) -> None:
    container = case(name, rows=6, cols=9)
    light = moving_light((8, 6, 9), 500.0)
    sensor = sensor_near(container, digital_retention_us=retention_us)
    kept, lost = (
        compared(container, light, sensor, effects, np.arange(54))
        for effects in ("all,-decay", "all")
    )
    assert not np.array_equal(kept[1], lost[1])
    for found, full in (kept, lost):
        np.testing.assert_allclose(found, full, rtol=1e-9, atol=1e-3)


@pytest.mark.parametrize("frames_s", [None, 0.003])
def test_light_from_several_frames_in_a_slot_equals_the_reference(frames_s: float | None) -> None:
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
        np.testing.assert_allclose(found, full, rtol=1e-9, atol=1e-3)


def test_stills_with_equal_or_different_slots_equal_the_reference() -> None:
    container = case("d edges", rows=6, cols=9)
    frame = moving_light((8, 6, 9), 500.0).frames[0]
    for weight in (np.full(8, 0.7), np.linspace(0.1, 2.0, 8)):
        light = Light.of_still(frame, weight)
        for effects in ("all", "shot", "full_well,lag,prnu"):
            found, full = compared(container, light, sensor_near(container), effects, np.arange(54))
            np.testing.assert_allclose(found, full, rtol=1e-9, atol=1e-3)


def test_slots_filled_by_their_words_equal_the_reference() -> None:
    from reference_programs import program

    text = "nsl 1\nframe 4 slots of 3us\ncode stop : 0..4\nopen when n < stop\n"
    container = program(text + "pixels stop = x % 5\n", "edges", 5, 7)
    container = replace(container, slot_us=(1.5,) * 4)
    light = moving_light((4, 5, 7), 900.0)
    for effects in ("dead_time", "dead_time,shot,crosstalk", "all"):
        found, full = compared(container, light, sensor_near(container), effects, np.arange(35))
        np.testing.assert_allclose(found, full, rtol=1e-9, atol=1e-3)


def test_extreme_sensors_equal_the_reference() -> None:
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
        np.testing.assert_allclose(found, full, rtol=1e-9, atol=1e-3)


def test_extreme_light_equals_the_reference() -> None:
    container = case("b edges", rows=6, cols=9)
    light = moving_light((8, 6, 9), 500.0)
    light.frames[2, 1, 1] = 3e38
    light.frames[3, 4, 4] = 1e-30
    found, full = compared(
        container, light, sensor_near(container), "all,-crosstalk", np.arange(54)
    )
    np.testing.assert_allclose(found, full, rtol=1e-9, atol=1e-3)


def test_order_threads_and_memory_change_no_bit(monkeypatch: pytest.MonkeyPatch) -> None:
    container = case("d accumulate", rows=20, cols=30)
    light = moving_light((8, 20, 30), 500.0)
    sensor, every, places = sensor_near(container), selected("all"), np.arange(600)

    def exposed(places: np.ndarray, threads: int = 1) -> np.ndarray:
        scene = prepare_pixels(container, sensor, light, every, places, 5, threads)
        return expose_pixels(scene, 0, 1, threads).exposure_e

    once = exposed(places)
    order = np.random.default_rng(2).permutation(600)
    for threads in (2, 7):
        assert exposed(order, threads).tobytes() == once[:, order].tobytes()
    # Each pixel is the same beside other pixels, and if light is not kept in memory.
    assert exposed(places[100:110]).tobytes() == once[:, 100:110].tobytes()
    monkeypatch.setattr(block_scene, "_MOST_BYTES", 20_000)
    assert len(prepare_pixels(container, sensor, light, every, places, 5).parts) > 3
    assert exposed(order, 3).tobytes() == once[:, order].tobytes()
    assert exposed(places[:0]).shape == (1, 0)


@pytest.mark.parametrize("left", ["crosstalk", "dark", "read", "prnu", "leakage", "dead_time"])
def test_effects_that_are_left_out_change_no_other_draw(left: str) -> None:
    """The difference is that of the effect, not that of other photons."""
    container = case("c edges", rows=12, cols=16)
    light, places = moving_light((8, 12, 16), 900.0), np.arange(192)
    sensor = sensor_of(container)
    every, some, other = (
        expose_pixels(prepare_pixels(container, sensor, light, selected(names), places, 5), seed, 0)
        for names, seed in (("all", 3), (f"all,-{left}", 3), ("all", 4))
    )
    away, uncoupled = (
        np.sqrt(((found.exposure_e - every.exposure_e) ** 2).mean()) for found in (some, other)
    )
    assert 0.0 < away < 0.5 * uncoupled


def test_scenes_that_share_sums_of_light_are_as_if_each_had_its_own() -> None:
    """Every trial of a plan has other effects on the light of the same pixels."""
    container = case("c edges", rows=12, cols=16)
    light, places, sensor = (
        moving_light((8, 12, 16), 900.0),
        np.arange(40, 150),
        sensor_of(container),
    )
    shared = Recent(64)
    for left in ("adc", *optional(), "dark,-shot", "crosstalk,-prnu", "adc"):
        chosen = selected("all").without(*left.split(",-"))
        scenes = [
            prepare_pixels(container, sensor, light, chosen, places, 5, 1, known)
            for known in (None, shared)
        ]
        alone, together = (expose_pixels(scene, 3, 0).exposure_e for scene in scenes)
        assert alone.tobytes() == together.tobytes(), left
    assert 2 < len(shared._found) < len(optional())


def test_resets_that_no_read_follows_are_left_out() -> None:
    #                 reset  read  reset  reset  other  read | reset  read  reset | reset
    lane = np.array([0, 0, 0, 0, 0, 0, 1, 1, 1, 2])
    word = np.array([0, 1, 2, 3, 4, 5, 0, 1, 2, 3])
    resets = np.array([True, False, True, True, False, False])
    reads = np.array([False, True, False, False, False, True])
    left_lane, left_word = _in_use(lane, word, resets, reads)
    assert left_word.tolist() == [0, 1, 3, 4, 5, 0, 1]
    assert left_lane.tolist() == [0, 0, 0, 0, 0, 1, 1]


def test_light_that_is_not_a_number_is_marked() -> None:
    """With any effects only the pixel at row 3, column 4 is NaN."""
    container = case("d edges", rows=12, cols=16)
    light = moving_light((8, 12, 16), 300.0)
    light.frames[0, 3, 4] = np.nan
    for effects in ("shot,dark,read", "all,-crosstalk", "none"):
        scene = prepare_pixels(
            container, sensor_of(container), light, selected(effects), np.arange(192), 5
        )
        found = expose_pixels(scene, 3, 0).exposure_e
        assert np.flatnonzero(np.isnan(found[0])).tolist() == [3 * 16 + 4]
