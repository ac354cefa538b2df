"""The sensor file: the numbers of a sensor, their defaults and where these come from."""

from __future__ import annotations

from nscc_runtime.sensor.file import (
    completed,
    default_sensor,
    load_sensor,
    parse_sensor,
    read_sensor,
    sensor_toml,
)
from nscc_runtime.sensor.parameters import PARAMETERS, SCHEMA, Parameter, parameter, schema_of
from nscc_runtime.sensor.sensor import Sensor, sensor_sha256

__all__ = [
    "PARAMETERS",
    "SCHEMA",
    "Parameter",
    "Sensor",
    "completed",
    "default_sensor",
    "load_sensor",
    "parameter",
    "parse_sensor",
    "read_sensor",
    "schema_of",
    "sensor_sha256",
    "sensor_toml",
]
