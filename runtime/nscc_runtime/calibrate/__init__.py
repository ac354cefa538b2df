"""Estimate the parameters of a sensor from flat and dark frames by photon transfer (`nscc
calibrate`)."""

from __future__ import annotations

from nscc_runtime.calibrate.calibration_report import as_json, as_table, as_toml, messages
from nscc_runtime.calibrate.estimate import Calibration, calibrate_files, calibrated
from nscc_runtime.calibrate.frame_stacks import Stack, grouped, load_stack
from nscc_runtime.calibrate.sensor_parameters import Chain, ParameterChoice, parameters

__all__ = [
    "Calibration",
    "Chain",
    "ParameterChoice",
    "Stack",
    "as_json",
    "as_table",
    "as_toml",
    "calibrate_files",
    "calibrated",
    "grouped",
    "load_stack",
    "messages",
    "parameters",
]
