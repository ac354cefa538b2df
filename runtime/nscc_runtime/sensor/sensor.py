"""A sensor: every number that its effects depend on, as one frozen value."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Sensor:
    """The parameters of `nscc_runtime.sensor.schema`, all finite and within their ranges.

    Units are in the names: electrons, seconds, codes of the ADC (lsb); a fraction has none.
    """

    full_well_e: float
    register_min_e: float
    register_max_e: float
    register_knee_fraction: float
    prnu_fraction: float
    crosstalk_fraction: float
    lag_fraction: float
    dark_current_e_per_s: float
    dark_spread_fraction: float
    read_noise_e: float
    reset_noise_e: float
    analog_gain: float
    analog_noise_lsb: float
    analog_pattern_lsb: float
    analog_bias_lsb: float
    leakage_tau_s: float
    leakage_spread_fraction: float
    digital_retention_us: float
    electrons_per_lsb: float
    adc_offset_lsb: float
    adc_noise_lsb: float

    @property
    def analog_noise_e(self) -> float:
        """Random error of one analog word."""
        return self.analog_noise_lsb * self.electrons_per_lsb

    @property
    def analog_pattern_e(self) -> float:
        """Standard deviation over the pixels of a word's fixed error."""
        return self.analog_pattern_lsb * self.electrons_per_lsb

    @property
    def analog_bias_e(self) -> float:
        """Mean error of one analog word."""
        return self.analog_bias_lsb * self.electrons_per_lsb
