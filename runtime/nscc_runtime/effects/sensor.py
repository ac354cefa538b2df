"""A sensor: the values of all parameters of its effects, frozen."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import islice

from nscc import html


@dataclass(frozen=True, repr=False)
class Sensor:
    """The parameters of a sensor. Each is an attribute too: `sensor.read_noise_e`.

    Parameters
    ----------
    values : mapping of str to float
        Value by parameter name. Names end with their unit: electrons (`_e`), seconds (`_s`),
        converter codes (`_lsb`); fractions have no unit.
    """

    values: Mapping[str, float]

    def __repr__(self) -> str:
        """Return the first values and their number as one line."""
        first = ", ".join(f"{name}={value:g}" for name, value in islice(self.values.items(), 4))
        return f"<nscc sensor: {first}, .. {len(self.values)} numbers>"

    def _repr_html_(self) -> str:
        """Return the table that a notebook shows."""
        rows = [(name, f"{value:g}") for name, value in self.values.items()]
        return html.card("sensor", f"{len(rows)} numbers", html.table(rows))

    def __getattr__(self, name: str) -> float:
        """Return the value of a parameter; raise AttributeError for an unknown one."""
        # Copies and pickles read attributes before the values are set.
        if name.startswith("__") or name == "values" or name not in self.values:
            raise AttributeError(f"unknown sensor parameter {name!a}")
        return self.values[name]

    def __hash__(self) -> int:
        """Return a hash of the values."""
        return self._hash

    @cached_property
    def _hash(self) -> int:
        """The hash of the values, without their names; cached."""
        # Hash the numbers alone: cached hashes travel to processes that hash names differently.
        return hash(frozenset(self.values.values()))

    def changed(self, **values: float) -> Sensor:
        """Return a sensor with other values of some parameters. Ranges are not checked.

        Parameters
        ----------
        **values : float
            New values by name of a parameter, in its unit.

        Returns
        -------
        Sensor

        Raises
        ------
        TypeError
            For an unknown parameter.
        """
        unknown = [name for name in values if name not in self.values]
        if unknown:
            raise TypeError(f"unknown sensor parameter {unknown[0]!a}")
        return Sensor({**self.values, **values})


def before_readout_effects(values: Mapping[str, float]) -> dict[str, float]:
    """Return the parameters that sensors of earlier versions lack, with the values that describe
    their frames. In these frames all words had the same errors, in converter codes, and the readout
    had white noise only. `values`: the parameters of such a sensor by name, with
    `electrons_per_lsb` among them."""
    return {
        "analog_lsb_e": values["electrons_per_lsb"],
        "analog_move_loss": 1.0,
        "analog_move_noise": 1.0,
        **dict.fromkeys(
            ("adc_pattern_lsb", "adc_smooth_lsb", "adc_level_lsb", "adc_column_strength"), 0.0
        ),
    }


def sensor_sha256(sensor: Sensor) -> str:
    """Return the hexadecimal SHA-256 digest of all parameter values, which identifies a sensor."""
    return hashlib.sha256(json.dumps(dict(sensor.values), sort_keys=True).encode()).hexdigest()
