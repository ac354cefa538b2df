"""The parameters of a sensor: names, defaults, units, ranges and where each default comes from.

One row a parameter: reading a file, writing one, overriding a value, the attributes of a `Sensor`
and `nscc effects` all follow from it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

from nscc.target.target import Target
from nscc.toml.kinds import Number
from nscc.toml.schema import Codes, Key, Schema

OURS = "this project's default: not public"
TARGET = "the target table"
_MEASURED = "fit to the errors of a 9-word kernel measured by Guillard 2019"

Default = float | Callable[[Target, Mapping[str, float]], float] | None
"""A number; what gives it for a target and the values of the parameters that stand before; None
for what the target says under the same name."""


@dataclass(frozen=True, slots=True)
class Parameter(Key):
    """A row of the sensor's schema: a number in `kind`'s unit and range with a `Default`."""

    kind: Number

    def default_for(self, target: Target, values: Mapping[str, float]) -> float:
        """The default on that target, where the parameters before have these values."""
        if self.default is None:
            return float(getattr(target, self.name))
        return float(self.default(target, values) if callable(self.default) else self.default)


def parameter(
    name: str, heading: str, default: Default, unit: str, low: float, high: float, meaning: str,
    source: str = OURS, *, low_excluded: bool = False, high_excluded: bool = False,
) -> Parameter:  # fmt: skip
    """A parameter, listed under `heading`; `source` is where its default comes from."""
    kind = Number(low, high, unit, low_excluded, high_excluded)
    return Parameter("", name, kind, meaning, default, source, heading=heading)


def schema_of(rows: Iterable[Parameter]) -> Schema[Parameter]:
    """The sensor file of these parameters; ValueError if two have one name."""
    return Schema(
        "sensor",
        tuple(rows),
        HEADINGS,
        Codes("NS0751", "NS0752", unknown="NS0753", wrong="NS0754", change="NS0755"),
        "`nscc effects --toml > sensor.toml` writes a complete file to start from",
        noun="parameter",
        option="--sensor-set",
        example="read_noise_e=5",
    )


_MOST_E = 1e15


def _top_code_is_full_well(target: Target, values: Mapping[str, float]) -> float:
    return values["full_well_e"] / ((1 << target.adc_bits) - 1)


PARAMETERS: tuple[Parameter, ...] = (
    parameter("full_well_e", "range", None, "e", 0, _MOST_E,
        "charge that PIX holds above its reset level", TARGET, low_excluded=True),
    parameter("register_min_e", "range", None, "e", -_MOST_E, 0,
        "least value of an analog register", TARGET, high_excluded=True),
    parameter("register_max_e", "range", None, "e", 0, _MOST_E,
        "largest value of an analog register", TARGET, low_excluded=True),
    parameter("register_knee_fraction", "range", 0.9, "1", 0, 1,
        "a register is linear up to this part of its range and soft beyond; 1: clips hard"),
    parameter("prnu_fraction", "light", 0.01, "1", 0, 0.2,
        "standard deviation of the pixels' response to light"),
    parameter("crosstalk_fraction", "light", 0.005, "1", 0, 0.2,
        "part of a pixel's charge that each of its four neighbours gets"),
    parameter("lag_fraction", "light", 0.002, "1", 0, 1,
        "part of the previous frame's light that comes again in the same slot"),
    parameter("dark_current_e_per_s", "dark", 1000.0, "e/s", 0, _MOST_E,
        "dark current, mean over the pixels"),
    parameter("dark_spread_fraction", "dark", 0.2, "1", 0, 10,
        "its standard deviation over the pixels, relative to the mean"),
    parameter("read_noise_e", "noise", 10.0, "e", 0, _MOST_E, "of one read of PIX"),
    parameter("reset_noise_e", "noise", 40.0, "e", 0, _MOST_E,
        "of one reset of PIX; sqrt(kTC) of 10 fF at 300 K"),
    parameter("analog_gain", "analog", 0.996, "1/word", 0.5, 1.5,
        "gain of one analog word", _MEASURED),
    parameter("analog_noise_lsb", "analog", 0.75, "lsb/sqrt(word)", 0, 1e6,
        "random error of one analog word", _MEASURED),
    parameter("analog_pattern_lsb", "analog", 0.030, "lsb/word", 0, 1e6,
        "standard deviation over the pixels of a word's fixed error", _MEASURED),
    parameter("analog_bias_lsb", "analog", 0.42, "lsb/word", -1e6, 1e6,
        "mean error of one analog word", "3.75 codes a 9-word kernel, Guillard 2019"),
    parameter("leakage_tau_s", "memory", 10.0, "s", 0, 1e9,
        "time constant with which an analog register loses its value", low_excluded=True),
    parameter("leakage_spread_fraction", "memory", 0.1, "1", 0, 10,
        "standard deviation over the pixels of 1/tau, relative to the mean"),
    parameter("digital_retention_us", "memory", None, "us", 0, 1e15,
        "a digital register reads 0 when it was not written for longer", TARGET,
        low_excluded=True),
    parameter("electrons_per_lsb", "readout",
        _top_code_is_full_well, "e/lsb", 0, _MOST_E,
        "electrons a code of the ADC", "full_well_e over the top code", low_excluded=True),
    parameter("adc_offset_lsb", "readout", None, "lsb", -65536, 65536,
        "code of a register that holds nothing", TARGET),
    parameter("adc_noise_lsb", "readout", 0.65, "lsb", 0, 1e6,
        "temporal noise of the readout", "the scamp5c project's noise model"),
)  # fmt: skip

HEADINGS = {
    "range": "what PIX and the registers hold",
    "light": "what becomes of the light",
    "dark": "charge without light",
    "noise": "of the photodiode",
    "analog": "errors of analog words; counts are codes of the ADC",
    "memory": "what registers lose",
    "readout": "the ADC",
}
"""The headings of a file in their order, each with a remark."""

SCHEMA = schema_of(PARAMETERS)
