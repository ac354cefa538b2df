"""The sensor file: the numbers of a sensor, their defaults and where these come from."""

from __future__ import annotations

from nscc_runtime.sensor.load import load_sensor, parse_sensor, read_sensor, sensor_toml
from nscc_runtime.sensor.schema import PARAMETERS, Parameter
from nscc_runtime.sensor.sensor import Sensor
from nscc_runtime.sensor.values import default_sensor, sensor_sha256

__all__ = [
    "PARAMETERS",
    "Parameter",
    "Sensor",
    "default_sensor",
    "load_sensor",
    "parse_sensor",
    "read_sensor",
    "sensor_sha256",
    "sensor_toml",
]
