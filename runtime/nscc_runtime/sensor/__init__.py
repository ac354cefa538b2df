"""The sensor file: the parameters of a sensor, their defaults and the sources of the defaults."""

from __future__ import annotations

from nscc_runtime.effects.effect import Parameter, parameter
from nscc_runtime.effects.registry import parameters
from nscc_runtime.effects.sensor import Sensor, sensor_sha256
from nscc_runtime.sensor.file import (
    completed,
    default_sensor,
    load_sensor,
    parse_sensor,
    read_sensor,
    schema,
    sensor_toml,
)

__all__ = [
    "Parameter",
    "Sensor",
    "completed",
    "default_sensor",
    "load_sensor",
    "parameter",
    "parameters",
    "parse_sensor",
    "read_sensor",
    "schema",
    "sensor_sha256",
    "sensor_toml",
]
