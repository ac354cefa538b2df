"""Frames by sums and by words, beside the reference with the same effects."""

from __future__ import annotations

import gc
from dataclasses import replace
from weakref import ref

import numpy as np
import pytest
from plan_cases import CASES, case, moving_light
from reference_programs import exposures, program, sensor_of

from nscc.diagnostics.diagnostic import Rejected
from nscc_runtime.effects import registry, selected
from nscc_runtime.effects.effect import CannotHave
from nscc_runtime.effects.read import READ
from nscc_runtime.execution import block_scene
from nscc_runtime.execution.block_scene import expose_pixels, prepare_pixels
from nscc_runtime.execution.frames import FrameSource, frame_source
from nscc_runtime.light import Light

ROWS, COLS = 12, 16
SEED, DEVICE = 3, 5


def source(name: str, effects: str, light: Light, threads: int = 1, **values: float) -> FrameSource:
    """A scene that is ready to be exposed."""
    container = case(name, rows=light.shape[0], cols=light.shape[1])
    sensor = sensor_of(container, **values)
    return frame_source(container, sensor, light, selected(effects), DEVICE, threads)


def both(
    name: str, effects: str, light: Light, **values: float
) -> tuple[np.ndarray, np.ndarray, FrameSource]:
    """Frame 1 by sums and by the reference (buckets, rows, cols)."""
    scene = source(name, effects, light, **values)
    container = case(name, rows=ROWS, cols=COLS)
    full = exposures(container, light, sensor_of(container, **values), effects, 2, SEED, DEVICE)[1]
    return scene.expose(SEED, 1).exposure_e, full, scene


LINEAR = (
    "none",
    "prnu",
    "lag",
    "prnu,lag",
    "crosstalk",
    "crosstalk,prnu",
    "dead_time",
    "dead_time,crosstalk,lag",
)


@pytest.mark.parametrize("effects", LINEAR)
@pytest.mark.parametrize("name", CASES)
def test_frames_with_linear_effects_only_equal_the_reference(name: str, effects: str) -> None:
    """No pixel is near saturation, so sums alone give the reference's electrons to 2e-6."""
    found, full, scene = both(name, effects, moving_light((8, ROWS, COLS), 300.0))
    assert not len(scene.near)
    np.testing.assert_allclose(found, full, rtol=2e-6, atol=1e-3)


@pytest.mark.parametrize("name", CASES)
def test_leakage_interpolated_between_two_rates_is_near_the_reference(name: str) -> None:
    """Frames last 4 ms and registers keep their charge for 500 ms. Pixels with more leakage are
    simulated by words."""
    light = moving_light((8, ROWS, COLS), 300.0)
    found, full, _ = both(name, "leakage", light, leakage_tau_s=0.5)
    np.testing.assert_allclose(found, full, rtol=1e-4, atol=1e-3)
    plain, _, _ = both(name, "none", light)
    # The only write of class a is the last word of all.
    assert (np.abs(plain - full).max() > 5) == (name != "a")


def test_frames_of_light_that_moves_inside_slots_equal_the_reference() -> None:
    from nscc_runtime.scenes.timing import with_motion

    light = with_motion(moving_light((8, ROWS, COLS), 300.0))
    for effects in ("motion", "none", "motion,prnu"):
        found, full, _ = both("c edges", effects, light)
        np.testing.assert_allclose(found, full, rtol=1e-5, atol=1e-3)


@pytest.mark.parametrize("name", CASES)
def test_pixels_near_saturation_equal_the_reference(name: str) -> None:
    """The test leaves out the effects shot and dark, whose counts are drawn in another way."""
    light = moving_light((8, ROWS, COLS), 300.0)
    light.frames[:, 4, 5] = 20000.0
    found, full, scene = both(
        name,
        "all,-shot,-dark",
        light,
        register_max_e=9000.0,
        register_min_e=-9000.0,
        analog_noise_lsb=0.4,
    )
    assert 4 * COLS + 5 in scene.near
    assert len(scene.near) < ROWS * COLS / 2
    rows, cols = np.divmod(scene.near, COLS)
    np.testing.assert_allclose(found[:, rows, cols], full[:, rows, cols], rtol=1e-9, atol=1e-3)


@pytest.mark.parametrize("effects", ["all,-shot", "full_well", "register,prnu"])
@pytest.mark.parametrize("name", CASES)
def test_no_saturating_pixel_is_missed_among_the_pixels_near_saturation(
    name: str, effects: str
) -> None:
    """The light is near the limits. Pixels that are not marked lose less than one electron."""
    light = moving_light((8, ROWS, COLS), 7000.0)
    container = case(name, rows=ROWS, cols=COLS)
    lossless = ",".join(n for n in (*effects.split(","), "-full_well", "-register"))
    full, free = (
        exposures(container, light, sensor_of(container), names, 1, SEED, DEVICE)[0]
        for names in (effects, lossless)
    )
    lost = np.abs(full - free).max(axis=0).reshape(-1)
    assert lost.max() > 1000
    lost[source(name, effects, light).near] = 0.0
    assert lost.max() < 1.0


@pytest.mark.parametrize("name", ["b edges", "d accumulate", "two buckets"])
def test_threads_change_no_bit(name: str) -> None:
    """With 1, 2 and 5 threads the electrons and codes have equal bytes."""
    light = moving_light((8, 40, 50), 5000.0)
    found = [next(source(name, "all", light, n).frames(SEED, 1)) for n in (1, 2, 5)]
    assert len({each.exposure_e.tobytes() for each in found}) == 1
    assert len({each.frame.tobytes() for each in found}) == 1


def test_frames_and_seeds_differ_and_come_again() -> None:
    """The same seed and frame number give the same bytes. Another of either gives other noise."""
    scene = source("b edges", "all", moving_light((8, ROWS, COLS), 300.0))
    one, other, seeded, again = (
        scene.expose(seed, frame).exposure_e for seed, frame in ((1, 0), (1, 1), (2, 0), (1, 0))
    )
    assert one.tobytes() == again.tobytes()
    assert not np.array_equal(one, other)
    assert not np.array_equal(one, seeded)


def test_light_that_does_not_fit_is_refused_and_no_number_is_marked() -> None:
    """Five columns of light for a wider array give NS0734. A NaN pixel alone is not valid."""
    container = case("b edges", rows=ROWS, cols=COLS)
    sensor = sensor_of(container)
    with pytest.raises(Rejected) as caught:
        frame_source(container, sensor, moving_light((8, ROWS, 5), 1.0), selected("all"))
    assert caught.value.diagnostics[0].code == "NS0734"
    light = moving_light((8, ROWS, COLS), 300.0)
    light.frames[0, 3, 4] = np.nan
    found = source("b edges", "shot,dark,read", light).expose(0, 0)
    assert not found.valid[0, 3, 4]
    assert found.valid.sum() == found.valid.size - 1


@pytest.mark.parametrize("name", CASES)
def test_pixels_beside_lamps_that_lose_charge_are_found_near_saturation_for_all_codes(
    name: str,
) -> None:
    """Charge of a lamp spills into slots in which its own shutter is closed."""
    container = case(name, 16, rows=ROWS, cols=COLS)
    sensor = sensor_of(container)
    light = moving_light((16, ROWS, COLS), 10.0)
    for row, col in ((2, 3), (5, 8), (9, 12)):
        light.frames[:, row, col] = 800_000.0
    scene = frame_source(container, sensor, light, selected("all"), DEVICE, 1)
    full, free = (
        exposures(container, light, sensor, names, 1, SEED, DEVICE)[0]
        for names in ("all,-shot", "all,-shot,-full_well,-register")
    )
    lost = np.abs(full - free).max(axis=0).reshape(-1)
    assert (lost > 1.0).sum() > 2
    assert set(np.flatnonzero(lost > 1.0).tolist()) <= set(scene.near.tolist())


def test_effects_that_only_the_reference_has_are_exposed_by_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Read noise is registered without its fast form. The frame has the reference's bytes."""
    slow = replace(READ, words=CannotHave("it is tried"))
    monkeypatch.setitem(registry._registered, "read", slow)
    light = moving_light((8, ROWS, COLS), 300.0)
    found, full, scene = both("b edges", "shot,read", light)
    assert not len(scene.near)
    assert found.tobytes() == full.tobytes()


@pytest.mark.parametrize(
    ("effects", "electrons"), [("shot,read,full_well", 300.0), ("all", 300.0), ("all", 8000.0)]
)
def test_the_light_of_a_frame_is_freed_with_it(effects: str, electrons: float) -> None:
    """Films would hold many scenes at a time if they waited for the collector of cycles."""
    light = moving_light((8, ROWS, COLS), electrons)
    scene = source("b edges", effects, light)
    gone = ref(light)
    gc.collect()
    gc.disable()
    try:
        assert list(scene.frames(SEED, 2))
        del light, scene
        assert gone() is None
    finally:
        gc.enable()


ALWAYS = "nsl 1\nframe 4 slots of 1ms\nopen when true"


def by_each(effects: str, light: Light, **values: float) -> list[np.ndarray]:
    """A frame by sums, by the loop over words, and by the reference: exposures (rows, cols)."""
    container = program(ALWAYS, "auto", *light.shape)
    chip = container, sensor_of(container, **values), light, selected(effects)
    places = np.arange(light.shape[0] * light.shape[1])
    by_words = expose_pixels(prepare_pixels(*chip, places, DEVICE), SEED, 0).exposure_e
    whole = [frame_source(*chip, DEVICE, by_words=each).expose(SEED, 0) for each in (False, True)]
    return [whole[0].exposure_e[0], by_words.reshape(light.shape), whole[1].exposure_e[0]]


def test_neighbours_lack_the_light_of_one_slot_that_is_nan() -> None:
    """A pixel with NaN in one of four slots gives its neighbours that of the other three."""
    clip = np.full((4, 1, 3), 1000.0, np.float32)
    clip[1, 0, 1] = np.nan
    for found in by_each("crosstalk", Light.of_clip(clip), crosstalk_fraction=0.05):
        np.testing.assert_allclose(found, [[3950.0, np.nan, 3950.0]], rtol=1e-6)


def test_crosstalk_of_the_brightest_light_is_finite() -> None:
    clip = np.zeros((4, 3, 3), np.float32)
    clip[2, 1, 1] = 3e38
    for found in by_each("crosstalk", Light.of_clip(clip), crosstalk_fraction=0.05):
        assert found[1] == pytest.approx([1.5e37, 2.4e38, 1.5e37])
        assert found[0] == pytest.approx([0.0, 1.5e37, 0.0])


@pytest.mark.parametrize("electrons", [1e11, 1e30])
def test_bright_light_is_counted_to_its_mean(electrons: float) -> None:
    """Counts of more than 1e12 electrons have no noise, and are not clipped."""
    light = Light.of_clip(np.full((4, 2, 3), electrons, np.float32))
    for found in by_each("shot", light):
        np.testing.assert_allclose(found, 4.0 * electrons, rtol=1e-4)


def test_what_all_frames_share_is_computed_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """The mean charge of pixels that run through their words does not depend on the frame."""
    calls, compute = [], block_scene._charge_scene

    def counted(*arguments: object) -> object:
        calls.append(arguments)
        return compute(*arguments)

    monkeypatch.setattr(block_scene, "_charge_scene", counted)
    light = Light.of_clip(np.full((8, ROWS, COLS), 1e5, np.float32))
    scene = source("b edges", "all", light)
    assert len(scene.near) == ROWS * COLS
    for number in range(3):
        scene.expose(SEED, number)
    assert len(calls) == 1
