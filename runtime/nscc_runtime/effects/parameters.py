"""What a parameter of the sensor is: name, default, unit, range and where the default comes from.

Each effect declares its own; reading a sensor file, writing one, overriding a value, the attributes
of a `Sensor` and `nscc effects` all follow from it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from nscc.chips.target import Target
from nscc.toml.kinds import Number
from nscc.toml.schema import Key
from nscc_runtime.effects.sensor import Sensor

OURS = "this project's default: not public"
TARGET = "the target table"

Default = float | Callable[[Target, Mapping[str, float]], float] | None
"""A number; what gives it for a target and the values of the parameters that stand before; None
for what the target says under the same name."""


@dataclass(frozen=True, slots=True)
class Parameter(Key):
    """A row of the sensor's schema: a number in `kind`'s unit and range with a `Default`. Under a
    heading those of a greater `place` stand below the others. Called, it gives a sensor's value.
    """

    kind: Number
    place: int = 0

    def __call__(self, sensor: Sensor) -> float:
        """Its value on a sensor."""
        return sensor.values[self.name]

    def default_for(self, target: Target, values: Mapping[str, float]) -> float:
        """The default on that target, where the parameters before have these values."""
        if self.default is None:
            return float(getattr(target, self.name))
        return float(self.default(target, values) if callable(self.default) else self.default)


def parameter(
    name: str, heading: str, default: Default, unit: str, low: float, high: float, meaning: str,
    source: str = OURS, *, low_excluded: bool = False, high_excluded: bool = False,
    place: int = 0,
) -> Parameter:  # fmt: skip
    """A parameter, listed under `heading`; `source` is where its default comes from."""
    kind = Number(low, high, unit, low_excluded, high_excluded)
    return Parameter("", name, kind, meaning, default, source, heading=heading, place=place)


MOST_E = 1e15

HEADINGS = {
    "range": "what PIX and the registers hold",
    "light": "what becomes of the light",
    "dark": "charge without light",
    "noise": "of the photodiode",
    "comparator": "how well pixels compare",
    "analog": "errors of analog words; counts are codes of the ADC",
    "memory": "what registers lose",
    "readout": "the ADC",
}
"""The headings of a file in their order, each with a remark."""
