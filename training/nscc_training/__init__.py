"""Learned shutters and decoders: encoders, decoders, baselines, losses, metrics, protocols.

    import nscc_training

    run = nscc_training.load_run("hdr")     # or a folder that `nscc train` wrote
    frame = run.capture("builtin:hdr")
    run.reconstruct(frame)                  # float32 (rows, cols); clips (T, rows, cols)

Functions on tensors need torch (`pip install 'nscc[train]'`), which is imported on first use.
`docs/python.md` describes the whole interface."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from nscc import __version__
from nscc.lazy import attribute

if TYPE_CHECKING:
    from nscc_training.codes_files import load_codes, save_codes
    from nscc_training.encoders import Encoder, ShutterSpec, make_encoder
    from nscc_training.finished_run import Run, load_run
    from nscc_training.metrics import mu_psnr, psnr, pu21_psnr, ssim, temporal_error
    from nscc_training.programs import Chip, program_of
    from nscc_training.sensor_model import SensorModel, differentiable_capture, lifted

_NAMES = {
    "codes_files": ("load_codes", "save_codes"),
    "encoders": ("Encoder", "ShutterSpec", "make_encoder"),
    "metrics": ("mu_psnr", "psnr", "pu21_psnr", "ssim", "temporal_error"),
    "programs": ("Chip", "program_of"),
    "finished_run": ("Run", "load_run"),
    "sensor_model": ("SensorModel", "differentiable_capture", "lifted"),
}
"""The public names, by module."""

__all__ = [
    "Chip",
    "Encoder",
    "Run",
    "SensorModel",
    "ShutterSpec",
    "__version__",
    "differentiable_capture",
    "lifted",
    "load_codes",
    "load_run",
    "make_encoder",
    "mu_psnr",
    "program_of",
    "psnr",
    "pu21_psnr",
    "save_codes",
    "ssim",
    "temporal_error",
]


def __getattr__(name: str) -> Any:
    return attribute("nscc_training", _NAMES, name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
