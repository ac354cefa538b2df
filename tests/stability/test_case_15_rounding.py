"""Hard case 15: the ADC rounds half to even; its bias is below 0.001 codes."""

from __future__ import annotations

import numpy as np
from emulator_programs import target_of

from nscc_runtime.exposed_frame import Exposure
from nscc_runtime.frame_file import read_out
from nscc_runtime.sensor import default_sensor

# A full well is a step of IN: exposures are spread over the codes without a rest.
TARGET = target_of(
    (1, 1), full_well_e=255.0, register_max_e=127 * 255.0, register_min_e=-127 * 255.0
)
"""An electron a code."""


def codes(values: np.ndarray, offset: float = 0.0) -> np.ndarray:

    shaped = np.asarray(values, np.float64).reshape(1, 1, -1)
    sensor = default_sensor(TARGET).changed(adc_offset_lsb=offset)
    exposure = Exposure(shaped, np.ones(shaped.shape, bool))
    return read_out(exposure, TARGET, sensor).frame[0, 0].astype(int)


def test_case_15_halves_go_to_the_even_code() -> None:
    assert TARGET.electrons_per_lsb == 1.0
    assert codes(
        np.array([0.49999997, np.nextafter(0.5, 0), 0.5, np.nextafter(0.5, 1)])
    ).tolist() == [0, 0, 0, 1]
    halves = np.arange(254) + 0.5
    nearest_even = 2 * np.floor((np.arange(254) + 1) / 2)
    assert codes(halves).tolist() == nearest_even.astype(int).tolist()
    # The offset is added after rounding: it does not turn evens into odds.
    assert codes(halves[:200], 3.0).tolist() == (nearest_even[:200] + 3).astype(int).tolist()


def test_case_15_rounding_has_no_bias() -> None:
    even = np.linspace(10.0, 200.0, 190 * 1000, endpoint=False)
    on_halves = np.arange(10, 200, 0.5)
    random = np.random.default_rng(5).uniform(10, 200, 1_000_000)
    for values, slack in ((even, 0.0), (on_halves, 0.0), (random, 4 * 12**-0.5 / 1000)):
        assert abs((codes(values) - values).mean()) < 0.001 + slack


def test_case_15_noise_before_rounding_leaves_no_bias() -> None:
    rng = np.random.default_rng(6)
    for level in (20.0, 20.25, 20.5, 20.9):
        noise = rng.normal(0, 0.65, 1_000_000).reshape(1, 1, -1)
        exposure = Exposure(np.full(noise.shape, level), np.ones(noise.shape, bool))
        found = read_out(exposure, TARGET, noise_lsb=noise).frame
        # sqrt(0.65^2 + 1/12) / 1000 is the standard error; 0.65 codes of noise leave 1e-4 of bias.
        assert abs(found.mean() - level) < 4 * 0.71e-3
