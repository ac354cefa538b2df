"""Which values lost light: every lowering, without effects, with some and with all of them."""

from __future__ import annotations

import numpy as np
import pytest
from plan_cases import CASES, WHOLE, case
from reference_programs import program, sensor_of
from saturation_oracle import exposures, lost_e

from nscc.words.container import Container
from nscc_runtime import Capture, capture
from nscc_runtime.device.device_chip import frame_of
from nscc_runtime.effects import selected
from nscc_runtime.light import Light
from nscc_runtime.reference import frames

pytestmark = pytest.mark.filterwarnings("ignore:warning.NS0793")

SHAPE = (24, 32)
WELL, REGISTER, CONVERTER, RESET_LEVEL = 1, 2, 4, 8
FULL_E, KNEE = 30000.0, 0.9
LIMITS = {"well_e": FULL_E, "most_e": FULL_E, "knee": KNEE}
MUCH_E = 0.17 * (1 - KNEE) * FULL_E
"""What a register has lost where it keeps half of what is added."""
# Crosstalk takes light where the oracle, pixel by pixel, sees none.
QUIET = {
    "crosstalk_fraction": 0.0,
    "register_min_e": -FULL_E,
    "register_max_e": FULL_E,
    "analog_gain": 0.996,
    "analog_noise_lsb": 0.4,
    "spread_noise_lsb": 0.65,
    "adc_pattern_lsb": 0.1,
    "adc_smooth_lsb": 0.1,
    "adc_level_lsb": 0.1,
}
SPARE = 0.15
"""Of light, for noise, gain, and what else no oracle of limits knows."""


def light_for(container: Container, part: float = 0.2) -> np.ndarray:
    """Light (N, rows, cols) of high dynamic range, so bright that a part of the exposures is cut
    off."""
    rng = np.random.default_rng(3)
    picture = rng.lognormal(0.0, 2.0, SHAPE)
    light = (picture * rng.uniform(0.7, 1.3, (container.slots, *SHAPE))).astype(np.float32)
    low, high = 1.0, 1e6
    for _ in range(40):
        scale = np.sqrt(low * high)
        over = (lost_e(container, light * scale, **LIMITS) > MUCH_E).mean()
        low, high = (scale, high) if over < part else (low, scale)
    return light * np.float32(low)


@pytest.fixture(scope="module", params=CASES)
def lit(request: pytest.FixtureRequest) -> tuple[Container, np.ndarray]:
    """A program of every class and lowering, and its light."""
    container = case(request.param, rows=SHAPE[0], cols=SHAPE[1])
    return container, light_for(container)


def taken(container: Container, light: np.ndarray, effects: str) -> Capture:
    sensor = sensor_of(container, **QUIET)
    found = capture(container, light, sensor=sensor, effects=effects, seed=2, device_seed=4)
    assert found.saturated_by.dtype == np.uint8
    assert np.array_equal(found.saturated, found.saturated_by > 0)
    return found


def test_without_effects_only_values_of_the_last_code_are_saturated(
    lit: tuple[Container, np.ndarray],
) -> None:
    container, light = lit
    found = taken(container, light, "none")
    over = np.rint(exposures(container, light) / (FULL_E / 255)) >= 255
    assert np.array_equal(found.saturated_by, np.where(over, CONVERTER, 0))
    # The scene saturates some pixels, but not most.
    assert 0.05 < over.mean() < 0.3


@pytest.mark.parametrize("effects", ["auto", "all"])
def test_saturation_under_effects_follows_from_well_and_registers(
    lit: tuple[Container, np.ndarray], effects: str
) -> None:
    container, light = lit
    found = taken(container, light, effects)
    brighter, darker = light * (1 + SPARE), light * (1 - SPARE)
    surely = lost_e(container, darker, **LIMITS) > MUCH_E
    perhaps = lost_e(container, brighter, **LIMITS) > MUCH_E
    assert 0.1 < surely.mean() <= perhaps.mean() < 0.3
    assert found.saturated[surely].all()
    assert not found.saturated[~perhaps].any()
    assert found.saturated.mean() == pytest.approx(0.2, abs=0.03)
    in_pix = lost_e(container, darker, well_e=FULL_E) > 0
    assert ((found.saturated_by[in_pix] & (WELL | RESET_LEVEL)) > 0).all()
    not_in_pix = lost_e(container, brighter, well_e=FULL_E) == 0
    assert not (found.saturated_by[not_in_pix & ~perhaps] & (WELL | RESET_LEVEL)).any()


@pytest.mark.parametrize("effects", ["all,-shot,-dark", "full_well,register", "full_well"])
def test_fast_paths_and_reference_agree(lit: tuple[Container, np.ndarray], effects: str) -> None:
    container, light = lit
    found = taken(container, light, effects)
    sensor = sensor_of(container, **QUIET)
    (full,) = frames(
        container, Light.of_clip(light), sensor, selected(effects), seed=2, device_seed=4
    )
    assert np.array_equal(found.saturated_by, full.saturated_by)
    assert found.saturated.any()


@pytest.mark.parametrize("knee", [KNEE, 1.0])
def test_saturation_of_device_frames_follows_from_codes(
    lit: tuple[Container, np.ndarray], knee: float
) -> None:
    """What unsaturated pixels never read: light that fills PIX before a shutter opens leaves any
    code."""
    container, light = lit
    still = np.broadcast_to(light.mean(axis=0), light.shape)
    sensor = sensor_of(container, **QUIET, register_knee_fraction=knee)
    found = capture(container, still, sensor=sensor, effects="all", seed=2, device_seed=4)
    size = found.frame.shape
    sent = found.frame.transpose(0, 2, 1).tobytes()  # column by column
    told = frame_of(sent, 1, size, sensor, container.target, container)
    most = np.where(found.saturated, 0, found.frame).max()
    assert told.saturated[found.frame > most].all()
    assert (found.frame > most).mean() > 0.01
    assert (told.saturated & ~found.saturated).mean() < 0.03
    blind = frame_of(sent, 1, size, sensor, container.target)
    assert np.array_equal(blind.saturated, found.frame == 255)


def test_many_small_losses_in_registers_add_up_to_saturation() -> None:
    """Each write beyond the knee reduces the value again."""
    container = program(WHOLE.format(slots=256, slot="100us"), "accumulate", *SHAPE)
    ideal = {"analog_gain": 1.0, "leakage_tau_s": 1e9, "analog_bias_lsb": 0.0}
    sensor = sensor_of(container, **QUIET | ideal)
    for slot_e, full in ((95.0, False), (150.0, True)):
        light = np.full((256, *SHAPE), slot_e, np.float32)
        assert (lost_e(container, light, **LIMITS) > MUCH_E).all() == full
        found = capture(container, light, sensor=sensor, effects="full_well,register,shot")
        assert np.all(found.saturated_by == (REGISTER if full else 0))
        assert found.exposure_e.max() < 0.96 * FULL_E


@pytest.mark.parametrize("electrons", [1e8, 1e30])
@pytest.mark.parametrize("effects", ["none", "auto", "all", "full_well,dead_time,black_sun"])
def test_a_flooded_scene_is_saturated_everywhere(
    lit: tuple[Container, np.ndarray], electrons: float, effects: str
) -> None:
    container, light = lit
    flood = np.full_like(light, electrons)
    found = taken(container, flood, effects)
    assert found.saturated.all()
    if effects != "none":  # the level that is subtracted is as full as what it is taken from
        assert found.frame.max() < 20
        assert (found.saturated_by & RESET_LEVEL > 0).all()


def test_dark_and_closed_pixels_are_not_saturated() -> None:
    text = "nsl 1\nframe 4 slots of 1ms\ncode stop : 0..4\nopen when n < stop\n"
    container = program(text + "pixels stop = 4 * (x % 2)\n", "edges", *SHAPE)
    flood = np.full((4, *SHAPE), 1e6, np.float32)
    for effects in ("auto", "all"):
        assert not capture(container, flood * 0, effects=effects).saturated.any()
        found = capture(container, flood, effects=effects)
        assert found.saturated[..., 1::2].all()
        assert not found.saturated[..., ::2].any()


def test_each_repeat_has_its_own_saturation_marks() -> None:
    container = case("b edges", rows=SHAPE[0], cols=SHAPE[1])
    sensor = sensor_of(container, **QUIET)
    found = capture(container, light_for(container), sensor=sensor, effects="all", repeat=3)
    assert found.saturated.shape == found.saturated_by.shape == (3, 1, *SHAPE)
    assert 0 < (found.saturated[0] != found.saturated[1]).sum() < 0.05 * found.saturated[0].size
