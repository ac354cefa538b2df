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
from nscc_runtime.sensor.parameters import PARAMETERS, SCHEMA
from nscc_runtime.sensor.sensor import Sensor, sensor_sha256

__all__ = [
    "PARAMETERS",
    "SCHEMA",
    "Sensor",
    "completed",
    "default_sensor",
    "load_sensor",
    "parse_sensor",
    "read_sensor",
    "sensor_sha256",
    "sensor_toml",
]
