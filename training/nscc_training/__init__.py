"""Learned shutters and decoders: encoders, decoders, baselines, losses, metrics, protocols.

Everything that touches tensors needs torch (`pip install 'nscc[train]'`), which is imported when it
is first used. This package imports nscc and nscc_runtime, neither of which knows it.

    from nscc_training import SensorModel, ShutterSpec, capture, make_encoder

    encoder = make_encoder(ShutterSpec("b", 64, (4, 4)), "quad")
    frame = capture(light, encoder, SensorModel(30000.0, 30000.0 / 255)).frame
    frame.sum().backward()
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from nscc import __version__

if TYPE_CHECKING:
    from nscc_training.codes_files import load_codes, save_codes
    from nscc_training.encoders import Encoder, ShutterSpec, make_encoder
    from nscc_training.programs import Chip, program_of
    from nscc_training.sensor_model import SensorModel, capture, lifted

_NAMES = {
    "codes_files": ("load_codes", "save_codes"),
    "encoders": ("Encoder", "ShutterSpec", "make_encoder"),
    "programs": ("Chip", "program_of"),
    "sensor_model": ("SensorModel", "capture", "lifted"),
}
"""What is public, by its module."""

__all__ = [
    "Chip",
    "Encoder",
    "SensorModel",
    "ShutterSpec",
    "__version__",
    "capture",
    "lifted",
    "load_codes",
    "make_encoder",
    "program_of",
    "save_codes",
]


def __getattr__(name: str) -> Any:
    """Import a public name's module when it is first asked for."""
    for module, names in _NAMES.items():
        if name in names:
            return getattr(import_module(f"nscc_training.{module}"), name)
    raise AttributeError(f"module 'nscc_training' has no attribute '{name}'")
