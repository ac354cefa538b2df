"""Read cells from state dicts of torch in untrusted files."""

from __future__ import annotations

import io
import zipfile
from pathlib import Path
from typing import Any

import torch
from torch import Tensor

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected
from nscc_training.cells import MOST_KERNEL, MOST_OUTPUTS, MOST_STATES, PixelCell
from nscc_training.problems import listed, one_line

MOST_BYTES = 1 << 24
"""Largest size in bytes of a file, packed and unpacked."""
_SHAPES = "(gates, 1 + states, kernel, kernel) and (gates,)"
_SETTINGS = {"level": 0.5, "outside": 0, "pool_size": 1, "flips": 1}
"""Optional settings in a state dict, and their defaults."""


def cell_of_state(path: Path, state: dict[str, Tensor]) -> PixelCell:
    """Return the cell of a state dict; raise Rejected (NS0851) for another layout."""
    known = {"weight", "threshold", *_SETTINGS}
    unknown = sorted(name for name in state if name not in known)
    if unknown:
        layers = listed([f"`{name}`" for name in unknown])
        raise refused(path, f"layers that are not part of a cell: {layers}")
    missing = [name for name in ("weight", "threshold") if name not in state]
    if missing:
        raise refused(path, f"{listed([f'`{name}`' for name in missing])} is missing")
    weight, threshold = state["weight"], state["threshold"]
    gates, planes, rows, cols = weight.shape if weight.ndim == 4 else (0, 0, 0, 0)
    states = planes - 1
    fits = (
        1 <= states <= MOST_STATES and 1 <= gates - states <= MOST_OUTPUTS
        and rows == cols <= MOST_KERNEL and threshold.shape == (gates,)
    )  # fmt: skip
    if not fits:
        shapes = f"`weight` has the shape {_shape(weight)}, `threshold` {_shape(threshold)}"
        raise refused(path, f"{shapes}; a cell has {_SHAPES}, with 1 or 2 states")
    settings: dict[str, Any] = {}
    for name, default in _SETTINGS.items():
        value = state.get(name, torch.tensor(default))
        if value.numel() != 1:
            raise refused(path, f"`{name}` has the shape {_shape(value)}, not one number")
        settings[name] = value.item()
    for name, tensor in ("weight", weight), ("threshold", threshold):
        if tensor.is_complex() or not bool(torch.isfinite(tensor).all()):
            raise refused(path, f"`{name}` has values that are not finite real numbers")
    if settings["flips"] not in (0, 1):
        raise refused(path, f"`flips` is {settings['flips']:g}, but must be 0 or 1")
    try:
        cell = PixelCell(
            kernel=rows, states=states, outputs=gates - states, pool=settings["pool_size"],
            level=float(settings["level"]), outside=settings["outside"],
            update="flip" if settings["flips"] else "replace",
        )  # fmt: skip
    except ValueError as error:
        raise refused(path, str(error)) from error
    with torch.no_grad():
        cell.weight.copy_(weight)
        cell.threshold.copy_(threshold)
    for gate, kernels in enumerate(cell.kernels()):
        if not kernels.any():
            raise refused(path, f"all weights of gate {gate} are 0")
    return cell


def loaded_state(path: Path, data: bytes) -> dict[str, Tensor]:
    """Return the tensors of a file of `torch.save`; raise Rejected (NS0851) for another file."""
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            unpacked = sum(entry.file_size for entry in archive.infolist())
        if unpacked > MOST_BYTES:
            raise ValueError(f"it unpacks to more than {MOST_BYTES >> 20} MiB")
        state: Any = torch.load(io.BytesIO(data), map_location="cpu", weights_only=True)
    except Exception as error:  # torch, zipfile and pickle raise a dozen types for damaged files
        reason = "it is not a file of torch.save that holds tensors only"
        raise refused(path, reason, f"the reader says: {_first_sentence(error)}") from error
    if not isinstance(state, dict):
        raise refused(path, f"it holds {type(state).__name__}, not a state dict")
    for name, value in state.items():
        if not isinstance(name, str) or not isinstance(value, Tensor):
            raise refused(path, f"`{str(name)[:40]}` is {type(value).__name__}, not a tensor")
        if value.layout != torch.strided or value.numel() > MOST_BYTES or value.is_quantized:
            raise refused(path, f"`{name[:40]}` is not a small dense tensor")
    return state


def refused(path: Path, reason: str, note: str = "") -> Rejected:
    """Return the error (NS0851) for a file that is not a cell."""
    return rejected(
        "NS0851",
        f"'{path}' cannot be imported: {reason}",
        notes=(note,) if note else (),
        helps=(
            "save a cell alone: torch.save(cell.state_dict(), FILE.pt), cell a "
            "nscc_training.cells.PixelCell; decoders stay off the chip",
        ),
    )


def _first_sentence(error: Exception) -> str:
    return one_line(error).partition(". ")[0]


def _shape(tensor: Tensor) -> str:
    return str(tuple(tensor.shape))
