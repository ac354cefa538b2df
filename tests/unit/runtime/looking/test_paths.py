"""Programs that look by their ways: the words of the reference, and light by an interpreter."""

from __future__ import annotations

from dataclasses import replace
from math import sqrt
from pathlib import Path

import numpy as np
import pytest
from checkout import ROOT
from looks_programs import looking_frames
from numpy.typing import NDArray

from nscc.chips.load import builtin_target
from nscc.compiler import compile_source
from nscc.pipeline import Options
from nscc.source import Source
from nscc.words.container import Container
from nscc_runtime.effects import CannotHave, registry, selected
from nscc_runtime.effects.read import READ
from nscc_runtime.execution.block_program import lacks
from nscc_runtime.light import Light
from nscc_runtime.looked_frames import frames
from nscc_runtime.looking.paths import Pathless, Paths
from nscc_runtime.reference.capture import Reference, reference_scene
from nscc_runtime.sensor import default_sensor

EXAMPLES = ROOT / "examples"
ROWS, COLS = 24, 40
NAMES = ("float_pixel", "auto_exposure", "spike", "first_light")


def compiled(text: str, name: str = "scamp5", rows: int = ROWS, cols: int = COLS) -> Container:
    target = replace(builtin_target(name), rows=rows, cols=cols)
    options = Options(target=target, level=0, cache=False)
    made = compile_source(Source("t.nsl", text), Path(), options).container
    assert made is not None
    return made


@pytest.fixture(scope="module", params=NAMES)
def program(request: pytest.FixtureRequest) -> Container:
    text = (EXAMPLES / f"{request.param}.nsl").read_text().replace("target scamp5-algorithm1", "")
    chip = "scamp5-algorithm1" if request.param == "spike" else "scamp5"
    return compiled(text, chip)


def clip(container: Container) -> Light:
    """From dark to four full wells a frame, new in every slot."""
    choose = np.random.default_rng(5)
    share = choose.random((container.slots, ROWS, COLS)) * choose.random((ROWS, COLS)) ** 3
    return Light.of_clip((share * 8 * 30000.0 / container.slots).astype(np.float32))


@pytest.mark.parametrize("effects", ["none", "read,comparator_noise", "all,-shot,-dark"])
def test_frames_by_paths_equal_frames_by_words(program: Container, effects: str) -> None:
    light, sensor, chosen = clip(program), default_sensor(program.target), selected(effects)
    assert not lacks(program, sensor, chosen)
    options = {"seed": 3, "device_seed": 4, "count": 2}
    words = looking_frames(program, light, sensor, chosen, **options)
    ways = frames(program, light, sensor, chosen, **options, threads=2)
    for word, way in zip(words, ways, strict=True):
        # Rounding of normal numbers alone differs.
        room = 0.0 if effects == "none" else 1e-3
        np.testing.assert_allclose(way.exposure_e, word.exposure_e, rtol=0, atol=room)
        assert np.array_equal(way.frame, word.frame)
        assert np.array_equal(way.saturated_by, word.saturated_by)
        assert way.told.keys() == word.told.keys()
        for key, values in word.told.items():
            np.testing.assert_allclose(way.told[key], values, rtol=1e-6, err_msg=key)
        states = [values for key, values in word.told.items() if key.startswith("states_")]
        assert any(len(np.unique(values)) > 1 for values in states)


def test_threads_and_rows_change_no_bit(program: Container) -> None:
    sensor, chosen, light = default_sensor(program.target), selected("all"), clip(program)
    one, many = (
        [
            frame.exposure_e
            for frame in frames(program, light, sensor, chosen, seed=1, count=2, threads=threads)
        ]
        for threads in (1, 3)
    )
    assert np.array_equal(one, many)
    reference, scene = Reference.of(program, sensor, chosen), reference_scene(program, light)
    whole, part = (
        reference.execute(scene, program.planes(), (1, 2), 0, rows).exposure.exposure_e
        for rows in (None, range(5, 11))
    )
    assert np.array_equal(part, whole[:, 5:11])


def test_a_pixel_that_has_closed_runs_no_more_words() -> None:
    container = compiled((EXAMPLES / "float_pixel.nsl").read_text())
    paths = Paths.of(container)
    closing = [k for k, (no, yes) in enumerate(paths.following.tolist()) if no == yes < 0]
    lengths = np.diff(paths.start)[closing]
    # One copy where it closes, PIX and a copy where the frame ends.
    assert sorted(set(lengths[lengths > 0].tolist())) == [1, 2]
    assert len(next(iter(paths.endings.values()))) == 9


def interpreted(light_e: float, sensor_noise_e: float, level_e: float) -> NDArray[np.float64]:
    """The part of pixels that close at each of two looks, after 1 and 4 of 8 slots, or never."""
    choose, count = np.random.default_rng(0), 400_000
    first = choose.poisson(light_e, count)
    second = first + choose.poisson(3 * light_e, count)
    early = first + sensor_noise_e * choose.standard_normal(count) > level_e
    late = second + sensor_noise_e * choose.standard_normal(count) > level_e
    return np.array([early.mean(), (~early & late).mean(), (~early & ~late).mean()])


@pytest.mark.parametrize("share", [0.2, 0.5, 0.95])
def test_answers_are_as_likely_as_light_and_comparators_make_them(share: float) -> None:
    text = (
        "nsl 2\nframe 8 slots of 1ms\nsense bright when light > 10% at n in [1, 4]\n"
        "state closed : 0..2 = 0\nnext closed = looks when bright and closed == 0\n"
        "open when closed == 0\nread closed\n"
    )
    side = 160
    container = compiled(text, rows=side, cols=side)
    step_e = container.target.electrons_per_step
    level_e = round(0.1 * 30000.0 / step_e) * step_e
    light = Light.of_clip(np.full((8, side, side), share * level_e, np.float32))
    sensor = default_sensor(container.target).changed(comparator_noise_fraction=0.02)
    frame = next(iter(frames(container, light, sensor, selected("shot,comparator_noise"), seed=9)))
    found = [np.mean(frame.told["states_closed"] == k) for k in (1, 2, 0)]
    expected = interpreted(share * level_e, 0.02 * 30000.0, level_e)
    for part, wanted in zip(found, expected, strict=True):
        assert abs(part - wanted) < 5 * sqrt(wanted * (1 - wanted) / side**2) + 1e-3
    # What a pixel holds is the light of its open slots, counted.
    slots = frame.told["open_slots"][0]
    for open_slots in (1, 4, 8):
        held = frame.exposure_e[0][slots == open_slots]
        assert (held == np.rint(held)).all()
    never = frame.exposure_e[0][slots == 8]
    if share == 0.2:
        mean = 8 * share * level_e
        assert abs(never.mean() - mean) < 0.05 * mean


def test_effects_that_the_loop_lacks_are_simulated_by_the_reference(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    container = compiled((EXAMPLES / "first_light.nsl").read_text())
    slow = replace(READ, words=CannotHave("it is tried"))
    monkeypatch.setitem(registry._registered, "read", slow)
    chosen, sensor = selected("shot,read"), default_sensor(container.target)
    (why,) = lacks(container, sensor, chosen)
    assert why == "read: only the reference has it (it is tried)"
    light = clip(container)
    way = next(iter(frames(container, light, sensor, chosen, seed=1)))
    word = next(iter(looking_frames(container, light, sensor, chosen, seed=1)))
    assert np.array_equal(way.exposure_e, word.exposure_e)


def test_exposures_that_depend_on_the_frame_before_have_no_paths() -> None:
    container = compiled((EXAMPLES / "float_pixel.nsl").read_text())
    without_the_first = replace(container, launches=container.launches[1:])
    with pytest.raises(Pathless, match="frame before"):
        Paths.of(without_the_first)
