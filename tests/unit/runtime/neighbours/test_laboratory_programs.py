"""Ten pixel programs of laboratories (`tests/laboratory`) beside numpy models, on films.

Exposures are multiples of a quarter of a step of IN, so that no comparison is a tie."""

from __future__ import annotations

import csv
from typing import Any

import numpy as np
import pytest
from checkout import ROOT
from numpy.typing import NDArray
from scipy.ndimage import binary_dilation, binary_erosion, label, median_filter

import nscc
import nscc_runtime
from nscc_runtime import Capture

FOLDER = ROOT / "tests" / "laboratory"
SIDE, FRAMES = 256, 20
STEP_E = 30000 / 127
Array = NDArray[Any]
with (FOLDER / "public_words.csv").open() as file:
    PUBLIC_WORDS = {row["program"]: int(row["public words"]) for row in csv.DictReader(file)}


def program(name: str) -> nscc.ShutterProgram:
    example = FOLDER.parents[1] / "examples" / f"{name}.nsl"
    return nscc.compile(example if example.exists() else FOLDER / f"{name}.nsl")


def film_light(slots: int, seed: int, frames: int = FRAMES, most_steps: int = 100) -> Array:
    """Light of smooth blobs that move, and noise: (frames, slots, rows, cols), electrons."""
    rng = np.random.default_rng(seed)
    y, x = np.mgrid[:SIDE, :SIDE]
    lights = np.empty((frames, slots, SIDE, SIDE), np.float32)
    for frame in range(frames):
        wave = np.sin((x + 3 * frame) / 17.0) + np.sin((y - 2 * frame) / 23.0) + 2
        steps = (wave / 4 * most_steps).round() + rng.integers(0, 8, (SIDE, SIDE)) + 0.25
        lights[frame] = (steps * STEP_E / slots).astype(np.float32)
    return lights


def moved(values: Array, dx: int, dy: int) -> Array:
    """The values of the pixels at an offset; 0 beyond the array."""
    result = np.zeros_like(values)
    rows, cols = values.shape
    result[max(0, -dy) : min(rows, rows - dy), max(0, -dx) : min(cols, cols - dx)] = values[
        max(0, dy) : min(rows, rows + dy), max(0, dx) : min(cols, cols + dx)
    ]
    return result


def sobel(exposure: Array) -> Array:
    across = sum(
        w * (moved(exposure, -1, d) - moved(exposure, 1, d)) for d, w in ((-1, 1), (0, 2), (1, 1))
    )
    along = sum(
        w * (moved(exposure, d, -1) - moved(exposure, d, 1)) for d, w in ((-1, 1), (0, 2), (1, 1))
    )
    return np.asarray(np.abs(across) / 8 + np.abs(along) / 8)


def exposures(light: Array) -> Array:
    """Exposures in electrons (frames, rows, cols), added as the emulator does."""
    return light.astype(np.float64).sum(axis=1)


def same(capture: Capture, name: str, frame: int, expected: Array, border: int = 0) -> None:
    inner = np.s_[border : SIDE - border, border : SIDE - border]
    np.testing.assert_array_equal(capture.planes[name][frame][inner], expected[inner])


RING = [(-2, -2), (-1, -2), (0, -2), (1, -2), (2, -2), (2, -1), (2, 0), (2, 1)]
RING += [(-x, -y) for x, y in RING]


def test_fast_corners_are_those_of_the_numpy_model() -> None:
    """Nine neighbours on a ring of 16, for at most 60 % of the 1400 words of the public version."""
    compiled = program("fast_corners")
    assert compiled.container.pictures.words <= 0.6 * 1400
    light = film_light(4, 13)
    rng = np.random.default_rng(13)
    light[:, :, 100:140, 60:120] *= rng.integers(0, 2, (FRAMES, 1, 40, 60))
    levels = [4 + frame % 6 for frame in range(FRAMES)]
    capture = nscc_runtime.film(compiled, light, params=[{"t": level * STEP_E} for level in levels])
    inner = np.zeros((SIDE, SIDE), np.bool_)
    inner[2:-2, 2:-2] = True
    for frame, e in enumerate(exposures(light)):
        differences = np.stack([moved(e, *place) - e for place in RING])
        corner = np.zeros_like(inner)
        for answers in (
            differences > levels[frame] * STEP_E,
            differences < -levels[frame] * STEP_E,
        ):
            runs = [np.roll(answers, -first, axis=0)[:9].all(axis=0) for first in range(16)]
            corner |= np.any(runs, axis=0)
        same(capture, "corner", frame, corner, border=2)
        assert capture.reports["count corner"][frame] == (corner & inner).sum() > 0


def test_a_background_follows_the_exposure_where_nothing_moves() -> None:
    light = film_light(4, 14, most_steps=60)
    light = np.repeat(light, 2, axis=1) / 2
    capture = nscc_runtime.film(program("background"), light, params={"t": "4%"})
    background = np.zeros((SIDE, SIDE))
    square = np.ones((3, 3))
    for frame, e in enumerate(exposures(light)):
        differs = np.abs(e - background) > 5 * STEP_E
        opened = binary_dilation(binary_erosion(differs, square), square)
        background = np.where(opened, background, background + (e - background) / 8)
        same(capture, "foreground", frame, opened)
        assert capture.reports["count foreground"][frame] == opened.sum()


def test_images_and_planes_shift_by_up_to_64_pixels() -> None:
    light, rng = film_light(4, 15), np.random.default_rng(15)
    offsets = [{"dx": int(dx), "dy": int(dy)} for dx, dy in rng.integers(-64, 65, (FRAMES, 2))]
    capture = nscc_runtime.film(program("far_shift"), light, params=offsets)
    for frame, e in enumerate(exposures(light)):
        dx, dy = offsets[frame].values()
        same(capture, "plane_moved", frame, moved(e > 51 * STEP_E, dx, dy))
        inner = moved(np.ones((SIDE, SIDE), np.bool_), dx, dy)
        image = capture.images["image_moved"][frame]
        np.testing.assert_allclose(image[inner], moved(e, dx, dy)[inner], atol=1e-6)


@pytest.mark.parametrize("name", PUBLIC_WORDS)
def test_a_program_has_no_more_words_than_the_public_one(name: str) -> None:
    """Without the words that load and refresh inputs: two for each input plane."""
    pictures = program(name).container.pictures
    words = pictures.words - 2 * len(pictures.inputs)
    if name == "flood_border":  # the public version counts the flood alone
        flood = {"outer bounds", "outer flooded"}
        words = sum(cost.words for cost in pictures.costs if cost.name in flood)
    assert words <= PUBLIC_WORDS[name]


def test_a_step_of_the_automaton_has_no_more_words_than_the_public_one() -> None:
    """The survey counts 21 words for rule 90, which its program runs once for each row."""
    pictures = program("rule_90").container.pictures
    (loop,) = pictures.loops
    step = pictures.launches[loop.first : loop.first + loop.launches]
    assert sum(len(pictures.kernels[launch.kernel]) for launch in step) <= 21


@pytest.mark.parametrize(("name", "public_words"), [("median_of_5", 165), ("median_of_9", 1026)])
def test_medians_have_at_most_60_percent_of_the_public_words(name: str, public_words: int) -> None:
    compiled = program(name)
    assert compiled.container.pictures.words <= 0.6 * public_words
    light = film_light(4, 11)
    found = nscc_runtime.film(compiled, light).images["median"]
    near = np.ones((3, 3)) if name == "median_of_9" else [[0, 1, 0], [1, 1, 1], [0, 1, 0]]
    for frame, e in enumerate(exposures(light)):
        expected = median_filter(e, footprint=near)
        np.testing.assert_allclose(found[frame][1:-1, 1:-1], expected[1:-1, 1:-1], atol=1e-6)


def test_an_image_is_converted_to_bits_and_back() -> None:
    light = film_light(4, 12, most_steps=110)
    capture = nscc_runtime.film(program("adc"), light)
    for frame, e in enumerate(exposures(light)):
        number = np.minimum(e / (8 * STEP_E), 15).astype(int)
        for bit in range(4):
            same(capture, f"b{bit}", frame, (number >> bit & 1).astype(np.bool_))
        np.testing.assert_allclose(capture.images["back"][frame], number * 8 * STEP_E, atol=1e-6)


def test_sobel_and_laplace_equal_numpy() -> None:
    light = film_light(4, 1)
    capture = nscc_runtime.film(program("sobel_laplace"), light)
    inner = np.s_[1:-1, 1:-1]
    for frame, e in enumerate(exposures(light)):
        four = sum(moved(e, *d) for d in ((1, 0), (-1, 0), (0, 1), (0, -1)))
        for name, expected in (("sobel", sobel(e)), ("laplace", np.abs(e - four / 4))):
            np.testing.assert_allclose(
                capture.images[name][frame][inner], expected[inner], atol=1e-6
            )


def test_hdr_edges_are_those_of_the_numpy_model() -> None:
    light = film_light(21, 2, most_steps=90)
    thresholds = [{"t": f"{2 + frame % 5}%"} for frame in range(FRAMES)]
    capture = nscc_runtime.film(program("hdr_edges"), light, params=thresholds)
    for frame in range(FRAMES):
        parts = np.split(light[frame].astype(np.float64), [1, 5])
        level = round((2 + frame % 5) * 300 / STEP_E) * STEP_E
        edge = np.any([sobel(part.sum(axis=0)) > level for part in parts], axis=0)
        expected = edge | np.any([moved(edge, *d) for d in ((1, 0), (-1, 0), (0, 1), (0, -1))], 0)
        same(capture, "wide", frame, expected, border=3)


def test_the_report_tells_whether_any_pixel_of_the_input_plane_is_above_the_level() -> None:
    light, rng = film_light(4, 3), np.random.default_rng(3)
    boxes = rng.random((FRAMES, SIDE, SIDE)) < 1e-4
    levels = [75.0 + frame * 2 for frame in range(FRAMES)]
    capture = nscc_runtime.film(
        program("any_in_box"),
        light,
        inputs=[{"box": box} for box in boxes],
        params=[{"t": level * STEP_E} for level in levels],
    )
    found = [
        bool((e[box] > level * STEP_E).any())
        for e, box, level in zip(exposures(light), boxes, levels, strict=True)
    ]
    assert capture.reports["any bright"] == found
    assert len(set(found)) == 2


def test_masked_memory_keeps_the_states_of_the_numpy_model() -> None:
    light, rng = film_light(4, 4), np.random.default_rng(4)
    boxes = rng.random((FRAMES, SIDE, SIDE)) < 0.3
    capture = nscc_runtime.film(
        program("masked_memory"), light, inputs=[{"box": box} for box in boxes], params={"t": "30%"}
    )
    memory = np.zeros((SIDE, SIDE), np.bool_)
    for frame, e in enumerate(exposures(light)):
        memory = np.where(boxes[frame], e > 38 * STEP_E, memory)
        same(capture, "memory", frame, memory)


def test_history_keeps_the_bits_of_eight_frames() -> None:
    light = film_light(4, 5)
    capture = nscc_runtime.film(program("history"), light)
    bright = exposures(light) > 51 * STEP_E
    for frame in range(FRAMES):
        for age in range(9):
            past = bright[frame - age] if frame >= age else np.zeros_like(bright[0])
            same(capture, f"h{age}", frame, past)


def spiral() -> NDArray[np.bool_]:
    """A dark path, one pixel wide, from the border to the middle."""
    dark = np.zeros((SIDE, SIDE), np.bool_)
    x = y = 0
    dx, dy, dark[0, 0] = 1, 0, True
    while True:
        ahead, beyond = (y + dy, x + dx), (y + 2 * dy, x + 2 * dx)
        free = all(0 <= each < SIDE for each in ahead) and not (
            all(0 <= each < SIDE for each in beyond) and dark[beyond]
        )
        if not free:
            dx, dy = -dy, dx
            if dark[y + dy, x + dx] or dark[y + 2 * dy, x + 2 * dx]:
                return dark
            continue
        y, x = ahead
        dark[y, x] = True


def test_a_flood_removes_what_touches_the_border() -> None:
    """A spiral is longer than the number of steps, so the frame reports an incomplete flood."""
    light = film_light(4, 6, most_steps=80)
    light[-1] = np.where(spiral(), 1.25, 100.25) * STEP_E / 4
    capture = nscc_runtime.film(program("flood_border"), light, params={"t": "35%"})
    complete = capture.reports["flood outer"]
    edge = np.ones((SIDE, SIDE), np.bool_)
    edge[1:-1, 1:-1] = False
    for frame, e in enumerate(exposures(light)):
        dark = e < 44 * STEP_E
        parts, _ = label(dark)
        outer = np.isin(parts, np.unique(parts[edge & dark]))
        inner = capture.planes["inner"][frame]
        if complete[frame]:
            np.testing.assert_array_equal(inner, dark & ~outer)
        else:
            assert not (dark & ~outer & ~inner).any()
            assert (inner & outer).any()
    assert complete == [True] * (FRAMES - 1) + [False]


@pytest.mark.parametrize("name", ["event_camera", "contrast_share"])
def test_temporal_contrast_gives_the_events_of_the_numpy_model(name: str) -> None:
    """An event camera: events are those of a numpy model, bit for bit."""
    light = film_light(4, 7, most_steps=50)
    capture = nscc_runtime.film(program(name), light)
    reference = np.zeros((SIDE, SIDE))
    events = 0
    for frame, e in enumerate(exposures(light)):
        if name == "event_camera":
            on, off = e - reference > 13 * STEP_E, reference - e > 13 * STEP_E
        else:
            on, off = e - reference * 9 / 8 > 0, reference * 7 / 8 - e > 0
        reference = np.where(on | off, e, reference)
        same(capture, "on", frame, on)
        same(capture, "off", frame, off)
        events += on.sum() + off.sum()
    assert events > 0


def test_an_event_camera_sends_noise_only_with_effects() -> None:
    """A still scene at 40 % of a full well. The rate falls with the level."""
    light = np.full((5, 4, SIDE, SIDE), 3000.0, np.float32)
    rates = {}
    for effects, level in (("none", "4%"), ("all", "4%"), ("all", "10%")):
        film = nscc_runtime.film(
            program("event_camera"), light, params={"t": level}, effects=effects, seed=1
        )
        events = film.planes["on"][2:] | film.planes["off"][2:]
        rates[effects, level] = events.mean()
    assert rates["none", "4%"] == 0
    assert 1e-4 < rates["all", "10%"] < 1e-2 < rates["all", "4%"] < 0.5


def test_stabilisation_moves_the_image_as_the_numpy_model_does() -> None:
    light, rng = film_light(4, 9), np.random.default_rng(9)
    offsets = [{"dx": int(dx), "dy": int(dy)} for dx, dy in rng.integers(-32, 33, (FRAMES, 2))]
    offsets[1:3] = [{"dx": 32, "dy": -32}, {"dx": -32, "dy": 32}]
    capture = nscc_runtime.film(program("stabilise"), light, params=offsets)
    around = {"here": (0, 0), "east": (1, 0), "west": (-1, 0), "south": (0, 1), "north": (0, -1)}
    last = np.zeros((SIDE, SIDE), np.bool_)
    for frame, e in enumerate(exposures(light)):
        edge = np.zeros((SIDE, SIDE), np.bool_)  # at the border, edges depend on light beyond it
        edge[1:-1, 1:-1] = (sobel(e) > 5 * STEP_E)[1:-1, 1:-1]
        shifted = moved(edge, *offsets[frame].values())
        for name, step in around.items():
            expected = (moved(shifted, *step) & last).sum()
            assert capture.reports[f"count {name}"][frame] == expected
            assert expected or frame % 4 == 0
        last = edge


def test_half_size_averages_four_pixels() -> None:
    light = film_light(4, 10)
    capture = nscc_runtime.film(program("half"), light)
    for frame, e in enumerate(exposures(light)):
        np.testing.assert_allclose(capture.images["both"][frame][64:192], e[::2], atol=1e-6)


def test_states_with_a_range_count_in_each_pixel() -> None:
    """Two states step together on planes, on a comparison and on each other; a plane compares them.
    The oracle computes with integers."""
    compiled = nscc.compile(
        "nsl 4\nframe 4 slots of 1ms\nopen when true\noutside 0\n"
        "state seen : 0..5 = 2 kept\nstate sign : -1..0 = -1 kept\n"
        "plane bright = exposure > 40%\nplane often = seen >= 3 and exposure < 70% or seen == 0\n"
        "next seen = min(seen + 1, 5) if bright else max(seen + 2 * sign, 0)\n"
        "next sign = -1 - sign when sign * seen < -2 or not bright and seen == 0\n"
        "read seen, often, sign\n"
    )
    lights = film_light(4, seed=5, most_steps=110)
    seen, sign = np.full((SIDE, SIDE), 2), np.full((SIDE, SIDE), -1)
    capture = nscc_runtime.film(compiled, lights)
    for n, exposure in enumerate(lights.sum(axis=1)):
        bright = exposure > 0.4 * 30000
        often = (seen >= 3) & (exposure < 0.7 * 30000) | (seen == 0)
        turns = (sign * seen < -2) | ~bright & (seen == 0)
        seen = np.where(bright, np.minimum(seen + 1, 5), np.maximum(seen + 2 * sign, 0))
        sign = np.where(turns, -1 - sign, sign)
        assert np.array_equal(capture.told["states_seen"][n], seen)
        assert np.array_equal(capture.told["states_sign"][n], sign)
        assert np.array_equal(capture.planes["often"][n], often)
    assert len(np.unique(seen)) == 6
    assert len(np.unique(sign)) == 2
