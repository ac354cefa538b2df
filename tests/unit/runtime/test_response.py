"""Back from codes to light: what words add and lose is taken away, saturated exposures are not
used."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from one_scene import load_scene
from plan_cases import CASES, case
from reference_programs import program, sensor_of

from nscc_runtime import Capture, capture
from nscc_runtime.effects import selected
from nscc_runtime.light import Light
from nscc_runtime.merge import light_estimate, readouts
from nscc_runtime.response import response_of
from nscc_runtime.scenes import ExposureLevel

STOPS = """nsl 1
frame 256 slots of 125us
code stop : 1..256
open when n < stop
pixels stop = tile [[256, 64], [16, 4]]
"""
SIDE = 256
UNKNOWN = ",-readout_pattern,-readout_level"
"""Errors of a readout that no response of the words tells."""


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("effects", ["none", "all", "all,-leakage", "analog", "dark,leakage"])
def test_exposures_are_a_linear_function_of_the_light(name: str, effects: str) -> None:
    """The test compares means over many pixels and frames, dark and lit evenly."""
    container = case(name, rows=24, cols=32)
    sensor = sensor_of(
        container, leakage_tau_s=0.05, dark_current_e_per_s=2e4, analog_gain=0.98, lag_fraction=0.0
    )
    response = response_of(container, sensor, selected(effects))
    shutter = container.table.shutter_of_code[container.pixel_codes]
    for electrons in (0.0, 300.0):  # in every slot of 500 us
        light = Light.of_clip(np.full((8, 24, 32), electrons, np.float32))
        taken = capture(container, light, sensor=sensor, effects=effects, repeat=12)
        expected = response.zero_e + response.gain * response.open_s * (electrons / 500e-6)
        for lane in np.unique(shutter):
            here = (..., shutter == lane)
            each = taken.exposure_e[here]
            spread = each.std() / np.sqrt(each.size) + 0.02 * abs(expected[here]).mean()
            assert each.mean() == pytest.approx(expected[here].mean(), abs=4 * spread + 1e-9)


def test_codes_become_the_electrons_that_fell() -> None:
    container = program(STOPS, "edges", SIDE, SIDE)
    sensor = sensor_of(container, adc_offset_lsb=12.0, electrons_per_lsb=140.0)
    light = Light.of_still(np.full((SIDE, SIDE), 3e5, np.float32), np.full(256, 125e-6))
    taken = capture(container, light, sensor=sensor, effects=f"all,-lag{UNKNOWN}")
    response = taken.response
    # The stops of the four pixels of a tile; a slot lasts 125 us.
    for row, col, stop in ((0, 0, 256), (0, 1, 64), (1, 0, 16), (1, 1, 4)):
        found = response.electrons(taken.frame)[0, row::2, col::2].mean()
        assert found == pytest.approx(3e5 * stop * 125e-6, abs=25.0)


@pytest.fixture(scope="module", params=["auto", "all"])
def taken(request: pytest.FixtureRequest) -> tuple[Capture, Light]:
    """The README's program before its scene, at its exposure."""
    container = program(STOPS, "edges", SIDE, SIDE)
    scene = load_scene(
        "builtin:hdr", slot_us=container.slot_us, rows=SIDE, cols=SIDE, exposure=ExposureLevel(1e6)
    )
    quiet = sensor_of(container, analog_noise_lsb=0.4, spread_noise_lsb=0.65)
    effects = request.param + UNKNOWN
    return capture(container, scene, sensor=quiet, effects=effects, seed=1), scene


DECADES = [1e3, 1e4, 1e5, 1e6, 1.9e6]


def test_the_longest_unsaturated_exposure_of_a_tile_tells_its_light(
    taken: tuple[Capture, Light],
) -> None:
    frames, scene = taken
    response = frames.response
    open_s = response.open_s[0]
    rate = response.electrons(frames.frame)[0] / open_s
    truth = scene.total_e() / (256 * 125e-6)

    def blocks(values: np.ndarray) -> np.ndarray:
        return values.reshape(SIDE // 2, 2, SIDE // 2, 2).swapaxes(1, 2).reshape(-1, 4)

    usable = blocks(np.where(frames.saturated[0], 0.0, open_s))
    chosen = np.arange(len(usable)), usable.argmax(axis=1)
    lit = usable.max(axis=1) > 0
    whole_e = blocks(scene.total_e())[chosen]
    ratio = blocks(rate)[chosen] / blocks(truth)[chosen]
    for low, high in pairwise(DECADES):
        here = lit & (whole_e >= low) & (whole_e < high)
        assert here.sum() > 20
        assert np.median(ratio[here]) == pytest.approx(1.0, abs=0.02)
    assert np.median(np.abs(ratio[lit & (whole_e > 3e3)] - 1)) < 0.05


def test_the_merge_estimates_light_over_all_decades(taken: tuple[Capture, Light]) -> None:
    """In each decade of light the median estimate is right within 5 %. Pixels too bright for every
    exposure get more than the shortest can hold."""
    frames, scene = taken
    (readout,) = readouts(frames.container, frames, frames.response)
    light, known = light_estimate(readout)
    assert known.all()
    total_e = scene.total_e()
    ratio = light * (256 * 125e-6) / total_e
    for low, high in pairwise(DECADES):
        here = (total_e >= low) & (total_e < high)
        assert np.median(ratio[here]) == pytest.approx(1.0, abs=0.05)
    # What no exposure of a tile tells is taken as the most that its shortest could.
    blind = total_e > 4e6
    assert blind.any()
    assert np.median(light[blind]) > 30000.0 / (4 * 125e-6)


@pytest.mark.parametrize(
    ("codes", "shape", "window"),
    [
        ("(x % 2 + 2 * (y % 3)) % 5", (24, 20), (3, 2)),
        ("(x * x * x + y * y) % 23 % 5", (24, 20), (3, 3)),
        ("(x * x * x + x) % 5 + 0 * y", (2, 40), (1, 5)),
    ],
)
def test_pixels_are_merged_over_a_tile_and_without_a_small_one_with_their_neighbours(
    codes: str, shape: tuple[int, int], window: tuple[int, int]
) -> None:
    rule = "code stop : 1..8\nopen when n < stop\n"
    text = f"nsl 1\nframe 8 slots of 1ms\n{rule}pixels stop = 1 + {codes}\n"
    container = program(text, "auto", *shape)
    frames = capture(container, np.full((8, *shape), 500.0, np.float32), effects="none")
    (readout,) = readouts(container, frames, frames.response)
    assert readout.window == window
