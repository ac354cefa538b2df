"""A sensor's values: checked one by one, completed from the target, digested."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from math import isfinite
from typing import Any

from nscc.diagnostics.suggest import closest
from nscc.target.target import Target
from nscc.toml_text import shown
from nscc_runtime.sensor.schema import BY_NAME, PARAMETERS, Parameter
from nscc_runtime.sensor.sensor import Sensor

UNKNOWN, WRONG = "NS0753", "NS0754"


@dataclass(frozen=True, slots=True)
class Problem:
    """What is wrong with a sensor's values, at which name."""

    code: str
    name: str
    message: str
    help: str | None = None


def default_sensor(target: Target) -> Sensor:
    """The sensor of a target, every parameter at its default."""
    return completed({}, target)


def completed(given: Mapping[str, float], target: Target) -> Sensor:
    """The sensor of checked values; what is not given has its default.

    Without `electrons_per_lsb` the full well is the top code, whoever gave the full well.
    """
    values = {
        "full_well_e": target.full_well_e,
        "register_min_e": target.register_min_e,
        "register_max_e": target.register_max_e,
        "digital_retention_us": target.digital_retention_us,
        "adc_offset_lsb": target.adc_offset_lsb,
        **{row.name: row.default for row in PARAMETERS if row.default is not None},
        **given,
    }
    values.setdefault("electrons_per_lsb", values["full_well_e"] / ((1 << target.adc_bits) - 1))
    return Sensor(**values)


def checked(values: Mapping[str, Any]) -> tuple[dict[str, float], list[Problem]]:
    """The values that are right, and what is wrong with the others."""
    found: dict[str, float] = {}
    problems: list[Problem] = []
    for name, value in values.items():
        row = BY_NAME.get(name)
        if row is None:
            problems.append(unknown(name))
            continue
        number = _number(row, value)
        if number is None:
            problems.append(
                Problem(
                    WRONG, name, f"{name} must be a number {row.allowed} ({row.unit}), not "
                    f"{shown(value)}", f"{name}: {row.meaning}",
                )
            )  # fmt: skip
        else:
            found[name] = number
    return found, problems


def unknown(name: str) -> Problem:
    """The problem of a name that no parameter has."""
    near = closest(name, BY_NAME)
    help_text = f"did you mean `{near}`?" if near else "`nscc effects --toml` prints every key"
    return Problem(UNKNOWN, name, f"a sensor has no parameter {shown(name)}", help_text)


def sensor_sha256(sensor: Sensor) -> str:
    """Hexadecimal digest of all values: the same sensor wherever its numbers came from."""
    return hashlib.sha256(json.dumps(asdict(sensor), sort_keys=True).encode()).hexdigest()


def _number(row: Parameter, value: Any) -> float | None:
    """The value as a float, -0.0 as 0.0; None where it is none within the range."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return None
    above = row.low < value if row.low_excluded else row.low <= value
    below = value < row.high if row.high_excluded else value <= row.high
    return float(value) + 0.0 if above and below and isfinite(value) else None
