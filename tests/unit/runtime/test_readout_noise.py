"""Fixed pattern, level and correlated noise of a readout: sizes, seeds and switches."""

from __future__ import annotations

import numpy as np
import pytest

from nscc.chips.load import builtin_target
from nscc_runtime.effects import selected
from nscc_runtime.exposed_frame import Exposure
from nscc_runtime.frame_file import converted
from nscc_runtime.readout_noise import ReadoutNoise
from nscc_runtime.sensor import Sensor, default_sensor

TARGET = builtin_target("scamp5")
SENSOR = default_sensor(TARGET)
SHAPE = 240, 250


def codes(effects: str, frames: int = 1, sensor: Sensor = SENSOR, **keys: int) -> np.ndarray:
    """Errors (frames, rows, cols) of the first bucket."""
    noise = ReadoutNoise.of(sensor, selected(effects), keys.get("device_seed", 0), SHAPE)
    return np.array([noise.codes(5, number, 1)[0] for number in range(frames)])


def test_the_readout_pattern_is_equal_in_all_frames_of_a_chip_and_differs_between_chips() -> None:
    first, again = codes("readout_pattern", 2)
    np.testing.assert_array_equal(first, again)
    other = codes("readout_pattern", device_seed=1)[0]
    # The smooth parts of two chips may look alike by chance.
    assert abs(np.corrcoef(first.ravel(), other.ravel())[0, 1]) < 0.7
    # The difference of neighbours has no smooth part, and twice the variance of the white part.
    white = first[:, 1:] - first[:, :-1]
    assert white.std() == pytest.approx(2**0.5 * SENSOR.adc_pattern_lsb, rel=0.02)


def test_patterns_of_many_chips_have_the_size_that_the_sensor_says() -> None:
    chips = np.array([codes("readout_pattern", device_seed=seed)[0] for seed in range(80)])
    # Independent parts add up by their squares.
    both = np.hypot(SENSOR.adc_pattern_lsb, SENSOR.adc_smooth_lsb)
    assert chips.std() == pytest.approx(both, rel=0.06)
    assert chips.mean() == pytest.approx(0, abs=0.3)
    expected = selected("readout_pattern").converter_lsb(SENSOR)
    assert expected == pytest.approx(both)


def test_the_readout_level_is_equal_in_all_pixels_of_a_readout() -> None:
    levels = codes("readout_level", 400)
    assert np.ptp(levels, axis=(1, 2)).max() == 0
    assert levels[:, 0, 0].std() == pytest.approx(SENSOR.adc_level_lsb, rel=0.15)
    noise = ReadoutNoise.of(SENSOR, selected("readout_level"), 0, SHAPE)
    first, second = noise.codes(5, 0, 2)
    assert first[0, 0] != second[0, 0]


@pytest.mark.parametrize(
    ("effects", "lags"),
    [
        ("adc_noise", (0, 0, 0, 0, 0)),
        ("adc_noise,column_noise", (-0.371, 0.121, 0.19, -0.34, 0.331)),
    ],
)
def test_noise_is_correlated_down_columns_only(effects: str, lags: tuple[float, ...]) -> None:
    noise = codes(effects, 4)
    variance = noise.var()
    assert variance == pytest.approx(SENSOR.adc_noise_lsb**2, rel=0.02)
    for lag, expected in enumerate(lags, 1):
        found = (noise[:, lag:] * noise[:, :-lag]).mean() / variance
        assert found == pytest.approx(expected, abs=0.012)
        assert (noise[:, :, lag:] * noise[:, :, :-lag]).mean() / variance == pytest.approx(
            0, abs=0.012
        )
    half = codes(effects, sensor=SENSOR.changed(adc_column_strength=0.0))[0]
    assert (half[1:] * half[:-1]).mean() / half.var() == pytest.approx(0, abs=0.02)


def test_columns_that_share_random_bits_are_independent() -> None:
    """Columns half a row apart draw from the two halves of the bits of one place."""
    noise = codes("adc_noise", 4) / SENSOR.adc_noise_lsb
    left, right = noise[:, :, : SHAPE[1] // 2], noise[:, :, SHAPE[1] // 2 :]
    # Within five standard errors: products have the variances 1 and 4.
    assert abs((left * right).mean()) < 5 / left.size**0.5
    assert abs(((left**2 - 1) * (right**2 - 1)).mean()) < 10 / left.size**0.5
    assert len(np.unique(noise)) > 0.9 * noise.size


def test_frames_have_the_errors_of_their_effects() -> None:
    rows, cols = 20, 33
    exposure_e = np.random.default_rng(1).uniform(-3000, 33_000, (2, rows, cols))
    exposure = Exposure(exposure_e, np.isfinite(exposure_e))
    chosen = selected("all")
    frame = converted(exposure, TARGET, SENSOR, chosen, (7, 3), 4).frame
    errors = ReadoutNoise.of(SENSOR, chosen, 3, (rows, cols)).codes(7, 4, 2)
    codes = np.rint(exposure_e / SENSOR.electrons_per_lsb + errors) + SENSOR.adc_offset_lsb
    np.testing.assert_array_equal(frame, np.rint(np.clip(codes, 0, 255)))


def test_chips_that_were_not_measured_have_no_converter_pattern() -> None:
    sensor = default_sensor(builtin_target("dual-tap"))
    assert sensor.adc_pattern_lsb == sensor.adc_smooth_lsb == sensor.adc_level_lsb == 0
