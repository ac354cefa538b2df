"""The parameters of a sensor: names, defaults, units, ranges and where each default comes from.

One row a parameter: reading a file, writing one, overriding a value and `nscc effects` all follow
from it. A parameter is an attribute of `nscc_runtime.sensor.sensor.Sensor` of the same name.
"""

from __future__ import annotations

from dataclasses import dataclass

OURS = "this project's default: not public"
TARGET = "the target table"
_MEASURED = "fit to the errors of a 9-word kernel measured by Guillard 2019"


@dataclass(frozen=True, slots=True)
class Parameter:
    """A parameter of the sensor, a finite number within `low`..`high`.

    `default` is a number, or None where it follows from the target (`nscc_runtime.sensor.values`
    says how). `low_excluded` and `high_excluded` leave the bounds themselves out. `source` is where
    the default comes from. `group` is the heading under which files list it.
    """

    name: str
    group: str
    default: float | None
    unit: str
    low: float
    high: float
    meaning: str
    source: str = OURS
    low_excluded: bool = False
    high_excluded: bool = False

    @property
    def allowed(self) -> str:
        """The range in words."""
        left = "above" if self.low_excluded else "from"
        right = "below" if self.high_excluded else "to"
        return f"{left} {self.low:g} {right} {self.high:g}"


_MOST_E = 1e15

PARAMETERS: tuple[Parameter, ...] = (
    Parameter("full_well_e", "range", None, "e", 0, _MOST_E,
        "charge that PIX holds above its reset level", TARGET, low_excluded=True),
    Parameter("register_min_e", "range", None, "e", -_MOST_E, 0,
        "least value of an analog register", TARGET, high_excluded=True),
    Parameter("register_max_e", "range", None, "e", 0, _MOST_E,
        "largest value of an analog register", TARGET, low_excluded=True),
    Parameter("register_knee_fraction", "range", 0.9, "1", 0, 1,
        "a register is linear up to this part of its range and soft beyond; 1: clips hard"),
    Parameter("prnu_fraction", "light", 0.01, "1", 0, 0.2,
        "standard deviation of the pixels' response to light"),
    Parameter("crosstalk_fraction", "light", 0.005, "1", 0, 0.2,
        "part of a pixel's charge that each of its four neighbours gets"),
    Parameter("lag_fraction", "light", 0.002, "1", 0, 1,
        "part of the previous frame's light that comes again in the same slot"),
    Parameter("dark_current_e_per_s", "dark", 1000.0, "e/s", 0, _MOST_E,
        "dark current, mean over the pixels"),
    Parameter("dark_spread_fraction", "dark", 0.2, "1", 0, 10,
        "its standard deviation over the pixels, relative to the mean"),
    Parameter("read_noise_e", "noise", 10.0, "e", 0, _MOST_E, "of one read of PIX"),
    Parameter("reset_noise_e", "noise", 40.0, "e", 0, _MOST_E,
        "of one reset of PIX; sqrt(kTC) of 10 fF at 300 K"),
    Parameter("analog_gain", "analog", 0.996, "1/word", 0.5, 1.5,
        "gain of one analog word", _MEASURED),
    Parameter("analog_noise_lsb", "analog", 0.75, "lsb/sqrt(word)", 0, 1e6,
        "random error of one analog word", _MEASURED),
    Parameter("analog_pattern_lsb", "analog", 0.030, "lsb/word", 0, 1e6,
        "standard deviation over the pixels of a word's fixed error", _MEASURED),
    Parameter("analog_bias_lsb", "analog", 0.42, "lsb/word", -1e6, 1e6,
        "mean error of one analog word", "3.75 codes a 9-word kernel, Guillard 2019"),
    Parameter("leakage_tau_s", "memory", 10.0, "s", 0, 1e9,
        "time constant with which an analog register loses its value", low_excluded=True),
    Parameter("leakage_spread_fraction", "memory", 0.1, "1", 0, 10,
        "standard deviation over the pixels of 1/tau, relative to the mean"),
    Parameter("digital_retention_us", "memory", None, "us", 0, 1e15,
        "a digital register reads 0 when it was not written for longer", TARGET,
        low_excluded=True),
    Parameter("electrons_per_lsb", "readout", None, "e/lsb", 0, _MOST_E,
        "electrons a code of the ADC", "full_well_e over the top code", low_excluded=True),
    Parameter("adc_offset_lsb", "readout", None, "lsb", -65536, 65536,
        "code of a register that holds nothing", TARGET),
    Parameter("adc_noise_lsb", "readout", 0.65, "lsb", 0, 1e6,
        "temporal noise of the readout", "the scamp5c project's noise model"),
)  # fmt: skip

GROUPS = {
    "range": "what PIX and the registers hold",
    "light": "what becomes of the light",
    "dark": "charge without light",
    "noise": "of the photodiode",
    "analog": "errors of analog words; counts are codes of the ADC",
    "memory": "what registers lose",
    "readout": "the ADC",
}
"""The headings of a file in their order, each with a remark."""

BY_NAME = {row.name: row for row in PARAMETERS}
