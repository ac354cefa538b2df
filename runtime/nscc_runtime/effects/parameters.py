"""Parameters of the sensor: name, default, unit, range and source of the default.

Each effect declares its parameters. Reading and writing sensor files, overriding values, the
attributes of a `Sensor` and `nscc effects` follow from the declarations."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from nscc.chips.target import Target
from nscc.toml.kinds import Number
from nscc.toml.schema import Key
from nscc_runtime.effects.sensor import Sensor

OURS = "this project's default: not public"
TARGET = "the target table"
CHIP = "chip frames: fit to 404 public frames of a SCAMP-5, docs/silicon.md"
PUBLISHED = "publication: "
"""How the source of a value starts that was published."""

Default = float | Callable[[Target, Mapping[str, float]], float] | None
"""A number; a function of the target and of the preceding parameters; or None for the target's
value of the same name."""


@dataclass(frozen=True, slots=True)
class Parameter(Key):
    """A row of the sensor's schema: a number with unit, range and default. Under a heading,
    parameters are sorted by `place`. Calling a parameter with a sensor returns its value."""

    kind: Number
    place: int = 0

    def __call__(self, sensor: Sensor) -> float:
        """Return the value of the parameter on a sensor."""
        return sensor.values[self.name]

    @property
    def basis(self) -> str:
        """What the default rests on: "chip frames", a "publication", or an "assumption", which also
        stands for values of the target. It is the part of `source` before the colon."""
        basis, colon, _ = self.source.partition(":")
        return basis if colon and self.source.startswith((CHIP, PUBLISHED)) else "assumption"

    def default_for(self, target: Target, values: Mapping[str, float]) -> float:
        """Return the default on a target, given the values by name of the parameters before it in a
        sensor file. Raises AttributeError if the target has no value that the default names."""
        if self.default is None:
            return float(getattr(target, self.name))
        return float(self.default(target, values) if callable(self.default) else self.default)


def parameter(
    name: str,
    heading: str,
    default: Default,
    unit: str,
    low: float,
    high: float,
    meaning: str,
    source: str = OURS,
    *,
    low_excluded: bool = False,
    high_excluded: bool = False,
    place: int = 0,
) -> Parameter:
    """Declare a parameter of the sensor file for an effect.

    `name` ends in its unit, `heading` is a key of `HEADINGS`, under which it is listed. `default`
    is a number, a function of target and preceding values, or None for the target's value of this
    name. Values lie between `low` and `high` in `unit`; with `low_excluded` or `high_excluded` that
    end itself is not allowed. `meaning` is a text for the list of effects, `source` says where the
    default comes from, and `place` orders the parameters under a heading."""
    kind = Number(low, high, unit, low_excluded, high_excluded)
    # "": sensor files have no sections.
    return Parameter("", name, kind, meaning, default, source, heading=heading, place=place)


MOST_E = 1e15

HEADINGS = {
    "range": "what PIX and the registers hold",
    "light": "what becomes of the light",
    "dark": "charge without light",
    "noise": "of the photodiode",
    "comparator": "how well pixels compare",
    "analog": "errors of analog words: additions read two sources or more, moves fewer",
    "memory": "what registers lose",
    "readout": "the ADC",
}
"""The headings of a sensor file in order, each with an explanation."""
