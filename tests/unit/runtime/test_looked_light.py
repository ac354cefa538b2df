"""Light from frames whose pixels looked, and comparators that are off: against plain statistics."""

from __future__ import annotations

from dataclasses import replace
from math import erf, sqrt
from pathlib import Path

import numpy as np
import pytest
from looks_programs import looking_frames

from nscc.chips.load import builtin_target
from nscc.pipeline import Options, run_passes
from nscc.source import Source
from nscc.words.container import Container
from nscc_runtime.effects import selected
from nscc_runtime.frame_file import Frame
from nscc_runtime.light import Light
from nscc_runtime.looked_light import DEVIATION, LIGHT, merged_image
from nscc_runtime.sensor import default_sensor

SIDE, WELL_E, LOOK, SLOTS = 96, 30000.0, 4, 16
TEXT = f"""nsl 2
frame {SLOTS} slots of 1ms
sense bright when light > 50% at n == {LOOK}
state closed : bit = 0
next closed = true when bright
open when not closed
read closed
"""
LEVEL_E = round(0.5 * WELL_E / (WELL_E / 127)) * WELL_E / 127


@pytest.fixture(scope="module")
def program() -> Container:
    target = replace(builtin_target("scamp5"), rows=SIDE, cols=SIDE)
    made = run_passes(Source("t.nsl", TEXT), Path(), Options(level=0, target=target, cache=False))
    assert made.container is not None
    return made.container


def taken(program: Container, at_look_e: float, effects: str, **sensor: float) -> Frame:
    """A frame of a flat scene that has gathered so much when the pixels look."""
    light = np.full((SIDE, SIDE), at_look_e / LOOK * 1000.0, np.float32)
    still = Light.of_still(light, np.full(SLOTS, 1e-3))
    figures = default_sensor(program.target).changed(**sensor)
    return next(iter(looking_frames(program, still, figures, selected(effects), seed=3)))


@pytest.mark.parametrize("effect", ["comparator_offset", "comparator_noise"])
@pytest.mark.parametrize("share", [-1.0, 0.0, 0.7])
def test_comparators_are_off_by_their_figures(
    program: Container, effect: str, share: float
) -> None:
    """The light lies `share` standard deviations from the level. The share of closed shutters is
    that of a normal distribution."""
    size = 0.02
    figures = {f"{effect}_fraction": size}
    frame = taken(program, LEVEL_E + share * size * WELL_E, effect, **figures)
    closed = frame.told["states_closed"].mean()
    # The share of a normal distribution below `share` standard deviations.
    expected = 0.5 * (1 + erf(share / sqrt(2)))
    assert abs(closed - expected) < 5 * sqrt(0.25 / SIDE**2)


def test_offsets_of_comparators_are_equal_in_every_frame_and_their_noise_is_not(
    program: Container,
) -> None:
    frames = {}
    for effect in ("comparator_offset", "comparator_noise"):
        light = np.full((SIDE, SIDE), LEVEL_E / LOOK * 1000.0, np.float32)
        still = Light.of_still(light, np.full(SLOTS, 1e-3))
        sensor = default_sensor(program.target)
        made = looking_frames(program, still, sensor, selected(effect), seed=3, count=2)
        frames[effect] = [frame.told["states_closed"] for frame in made]
    assert np.array_equal(*frames["comparator_offset"])
    # At the level half of the answers are yes, so two of noise alone differ in half of the pixels.
    assert 0.4 < (frames["comparator_noise"][0] != frames["comparator_noise"][1]).mean() < 0.6


@pytest.mark.parametrize("at_look_e", [900.0, 3000.0, 20000.0])
def test_the_stated_deviation_of_the_light_equals_the_spread_of_its_errors(
    program: Container, at_look_e: float
) -> None:
    # Without neighbours, lag and words that take time, which a steady flat scene does not have, and
    # without errors that many pixels have in common.
    off = "-crosstalk,-lag,-dead_time,-leakage,-readout_pattern,-readout_level"
    frame = taken(program, at_look_e, f"all,{off}")
    truth = at_look_e / LOOK * 1000.0
    light, deviation = frame.told[LIGHT][0], frame.told[DEVIATION][0]
    pull = (light - truth) / deviation
    assert np.isfinite(pull).all()
    assert abs(np.std(pull) - 1) < 0.12
    assert abs(np.mean(pull)) < 0.35
    assert np.unique(frame.told["open_slots"]).tolist() == [LOOK if at_look_e > LEVEL_E else SLOTS]


def test_a_saturated_pixel_has_a_lower_bound_and_infinite_deviation(program: Container) -> None:
    """With four wells of light the pixel tells at least 0.99 of a well, with an infinite
    deviation."""
    frame = taken(program, 4 * WELL_E, "full_well,shot")
    assert frame.saturated.all()
    assert np.isinf(frame.told[DEVIATION]).all()
    assert (frame.told[LIGHT] * LOOK * 1e-3 > 0.99 * WELL_E).all()


def test_buckets_merge_by_their_precision() -> None:
    """Where all buckets are full (infinite deviation), the largest value counts; where all are
    unknown (NaN), the light is 0."""
    light = np.array([[[10.0, 10.0, 5.0, np.nan]], [[20.0, 30.0, 7.0, np.nan]]])
    deviation = np.array([[[1.0, 1.0, np.inf, np.nan]], [[1.0, np.inf, np.inf, np.nan]]])
    assert merged_image(light, deviation).tolist() == [[15.0, 10.0, 7.0, 0.0]]
