"""Relations between exposures that hold whatever the light, with no oracle to compute them.

Light is drawn by its bits, evenly over the float32 that can be light: every exponent, denormal
numbers, -0.0. What the reference does about its effects is in test_reference_relations.py.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from reference_exposure import expose as by_reference
from reference_programs import LOWERINGS, program, sensor_of

from nscc.words.container import Container
from nscc_runtime.effects import optional, selected
from nscc_runtime.emulator import expose
from nscc_runtime.light import Light

ROWS, COLS = 4, 16
SLOTS = 6
CODES = 1 << SLOTS
ALL = f"nsl 1\nframe {SLOTS} slots of 1ms\ncode bits : bit[N]\nopen when bits[n]\npixels bits = "
EVERY = ALL + "16 * (y % 4) + x"
"""Every one of the 64 shutters of six slots, a pixel each."""
STOPS = "nsl 1\nframe {0} slots of {1}us\ncode stop : 0..{0}\nopen when n < stop\n"
STOPS += "pixels stop = {2} * (x % 9)\n"
BUCKETS = f"""nsl 1
frame {SLOTS} slots of 1ms
code bits : bit[N]
bucket one open when bits[n]
bucket other open when not bits[n]
pixels bits = 16 * (y % 4) + x
"""

_TOP = np.float32(1e38).view(np.uint32)


def patterns(slots: int = SLOTS, rows: int = ROWS, cols: int = COLS) -> st.SearchStrategy:
    """float32 (slots, rows, cols), not negative, evenly over the bit patterns up to 1e38."""

    def made(seed: int) -> np.ndarray:
        rng = np.random.default_rng(seed)
        bits = rng.integers(0, int(_TOP), (slots, rows, cols), dtype=np.uint32)
        bits[rng.random(bits.shape) < 0.05] = 0x8000_0000  # -0.0
        bits[rng.random(bits.shape) < 0.05] &= 0x007F_FFFF  # denormal
        return bits.view(np.float32)

    return st.integers(0, 2**32).map(made)


def frames(container: Container, light: np.ndarray) -> np.ndarray:
    """(buckets, rows, cols)."""
    found = expose(container, Light.of_clip(np.ascontiguousarray(light)))
    assert found.valid.all()
    return found.exposure_e


def close(one: np.ndarray, other: np.ndarray, light: np.ndarray) -> None:
    """Equal to 1e-6, but for the rounding of light that is subtracted again."""
    size = np.abs(light.astype(float)).sum(axis=0)
    assert (np.abs(one - other) <= 1e-6 * np.abs(other) + 1e-12 * size).all()


def shutters() -> np.ndarray:
    """bool (SLOTS, ROWS, COLS) of EVERY."""
    code = 16 * np.arange(ROWS)[:, None] + np.arange(COLS)
    return (code >> np.arange(SLOTS)[:, None, None] & 1).astype(bool)


@pytest.mark.parametrize("lowering", ["accumulate", "edges"])
@settings(max_examples=80, deadline=None)
@given(patterns())
def test_a_shutter_that_is_always_open_gives_the_sum_of_all_slots(
    lowering: str, light: np.ndarray
) -> None:
    container = program(ALL + "63", lowering, ROWS, COLS)
    close(frames(container, light)[0], light.astype(float).sum(axis=0), light)


@pytest.mark.parametrize("lowering", ["accumulate", "edges"])
@settings(max_examples=80, deadline=None)
@given(patterns())
def test_a_shutter_and_its_complement_add_up_to_everything(
    lowering: str, light: np.ndarray
) -> None:
    both = program(BUCKETS, lowering, ROWS, COLS)
    opened = program(ALL + "63", lowering, ROWS, COLS)
    close(frames(both, light).sum(axis=0), frames(opened, light)[0], light)


@pytest.mark.parametrize("lowering", ["accumulate", "edges"])
@settings(max_examples=80, deadline=None)
@given(patterns(rows=1, cols=1))
def test_all_shutters_of_one_light_are_its_subsets(lowering: str, light: np.ndarray) -> None:
    """Sums over disjoint shutters add, in any order, for each of the 64 shutters."""
    everywhere = np.broadcast_to(light, (SLOTS, ROWS, COLS))
    found = frames(program(EVERY, lowering, ROWS, COLS), everywhere).reshape(-1)
    single = found[1 << np.arange(SLOTS)]
    sums = np.array([single[[c >> n & 1 == 1 for n in range(SLOTS)]].sum() for c in range(CODES)])
    total = float(light.astype(float).sum())
    assert (np.abs(found - sums) <= 1e-6 * sums + 1e-12 * total).all()
    assert found[0] == 0
    assert not np.signbit(found[0])


@pytest.mark.parametrize("lowering", LOWERINGS)
@settings(max_examples=80, deadline=None)
@given(patterns(8, 1, 9))
def test_half_the_light_in_twice_the_slots_gives_equal_exposures(
    lowering: str, light: np.ndarray
) -> None:
    light = np.where(light < 1e-37, 0, light).astype(np.float32)  # halves of others are exact
    once = program(STOPS.format(8, 200, 1), lowering, 1, 9)
    twice = program(STOPS.format(16, 100, 2), lowering, 1, 9)
    close(frames(twice, np.repeat(light / 2, 2, axis=0))[0], frames(once, light)[0], light)


@pytest.mark.parametrize("lowering", ["accumulate", "edges"])
@settings(max_examples=80, deadline=None)
@given(patterns(), st.permutations(range(SLOTS)))
def test_permuted_slots_and_shutters_give_equal_exposures(
    lowering: str, light: np.ndarray, order: list[int]
) -> None:
    container = program(EVERY, lowering, ROWS, COLS)
    opened = shutters()[np.array(order)]
    number = (opened << np.arange(SLOTS)[:, None, None]).sum(axis=0)
    codes = container.table.codes[:, 0]
    place = np.searchsorted(codes, number).astype(np.int32)
    assert np.array_equal(codes[place], number)
    moved = replace(container, pixel_codes=place)
    close(frames(moved, light[np.array(order)])[0], frames(container, light)[0], light)


@pytest.mark.parametrize("lowering", ["accumulate", "edges"])
@settings(max_examples=80, deadline=None)
@given(patterns(), st.integers(-20, 20))
def test_scaled_light_scales_the_exposure(lowering: str, light: np.ndarray, power: int) -> None:
    light = np.where((light < 1e-30) | (light > 1e30), 0, light).astype(np.float32)
    factor = np.float32(2.0**power)
    container = program(EVERY, lowering, ROWS, COLS)
    close(
        frames(container, light * factor)[0], frames(container, light)[0] * factor, light * factor
    )


@settings(max_examples=80, deadline=None)
@given(patterns(), patterns())
def test_the_exposure_of_a_sum_is_the_sum_of_exposures(one: np.ndarray, other: np.ndarray) -> None:
    """The exposure of two scenes is the sum of their exposures, where their sum is a float32."""
    scale = np.float32(1e4)
    one, other = (
        np.floor(np.minimum(np.where(v < 1, 0, v), scale)).astype(np.float32) for v in (one, other)
    )
    container = program(EVERY, "accumulate", ROWS, COLS)
    close(
        frames(container, one + other),
        frames(container, one) + frames(container, other),
        one + other,
    )


@settings(max_examples=80, deadline=None)
@given(patterns())
def test_the_initial_register_contents_do_not_change_a_frame(light: np.ndarray) -> None:
    container = program(EVERY, "accumulate", ROWS, COLS)
    seen = Light.of_clip(light)
    one, other = (expose(container, seen, device_seed=seed).exposure_e for seed in (1, 2))
    close(one[0], other[0], light)


@settings(max_examples=40, deadline=None)
@given(patterns(), st.sampled_from([*optional(), "all", "all,-crosstalk", "shot,dark,read"]))
def test_every_effect_gives_finite_exposures_for_any_light(light: np.ndarray, effects: str) -> None:
    container = program(EVERY, "edges", ROWS, COLS)
    found = by_reference(
        container,
        Light.of_clip(light),
        sensor_of(container),
        selected(f"none,{effects}" if effects in optional() else effects),
    )
    assert found.valid.all()
    assert np.isfinite(found.exposure_e).all()


@settings(max_examples=80, deadline=None)
@given(patterns())
def test_a_pixel_that_never_opens_is_exactly_zero(light: np.ndarray) -> None:
    """Without dark current and without noise of words a pixel that never opens is +0 exactly."""
    container = program(EVERY, "edges", ROWS, COLS)
    sensor = sensor_of(container, dark_current_e_per_s=0.0)
    found = by_reference(
        container, Light.of_clip(light), sensor, selected("shot,prnu,dark,full_well,crosstalk")
    )
    closed = np.zeros((ROWS, COLS), bool)
    closed[0, 0] = True
    assert found.exposure_e[0][closed].tolist() == [0.0]
    assert not np.signbit(found.exposure_e[0][closed]).any()
