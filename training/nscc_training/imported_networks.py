"""Import trained cells as programs, from state dicts of torch and from ONNX."""

from __future__ import annotations

import io
import re
import zipfile
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import torch
from torch import Tensor

from nscc.chips.load import load_target
from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.files import read_whole
from nscc.mappings import NamedValues
from nscc_training.cell_programs import cell_files, compiled_cell, level_on_chip
from nscc_training.cells import MOST_KERNEL, MOST_OUTPUTS, MOST_STATES, PixelCell
from nscc_training.problems import listed, one_line


class ImportedNetwork(NamedTuple):
    """An imported cell (a small recurrent network in each pixel) as a program.

    `text` is the program, `kernels` the bytes of its kernel file, `cell` the cell itself, `words`
    its instruction words per frame, and `level` the level of its comparisons in full wells, as the
    chip can set it."""

    text: str
    kernels: bytes
    cell: PixelCell
    words: int
    level: float


def import_network(
    path: Path, kernels_name: str, *, frame_us: float = 33_000.0, target: str = "scamp5"
) -> ImportedNetwork:
    """Return the program of the trained cell in file `path`, a state dict (.pt, .pth) or a forward
    pass (.onnx).

    `kernels_name` is the name of the kernel file in the program's text, `frame_us` the exposure
    time of a frame in microseconds, and `target` a chip's name or file. Raises Rejected: NS0851 for
    a file without such a cell, and the compiler's errors for a cell that does not fit the chip."""
    cell = read_cell(path)
    table = load_target(target, Path())
    named = None if target.endswith(".toml") else target
    remark = f"Imported from {path.name}."
    files = cell_files(cell, kernels_name, frame_us=frame_us, target=named, remark=remark)
    program = compiled_cell(files, kernels_name, table)
    words = program.report["images_words_total"]
    return ImportedNetwork(
        files.text, files.kernels, cell, words, level_on_chip(float(cell.level), table)
    )


def read_cell(path: Path) -> PixelCell:
    """Return the cell in file `path`: a state dict (.pt, .pth) or an .onnx file. Raises Rejected
    (NS0851) for others."""
    suffix = path.suffix.lower()
    if suffix not in (".pt", ".pth", ".onnx"):
        raise refused(path, "its name does not end in .pt, .pth or .onnx")
    try:
        data = read_whole(path, MOST_BYTES)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise refused(path, reason[:1].lower() + reason[1:]) from error
    if suffix == ".onnx":
        return cell_of_onnx(path, data)
    return cell_of_state(path, loaded_state(path, data))


_LAYERS = frozenset(
    (
        "Cast",
        "Concat",
        "Constant",
        "Conv",
        "Greater",
        "Identity",
        "MaxPool",
        "Mul",
        "Pad",
        "Slice",
        "Sub",
    )
)
"""Operations of the forward pass of a `PixelCell` in the export of torch."""
_CHECKED_FRAMES = 8
"""Number of random frames for which the graph and the cell are compared."""
_MOST_PIXELS = 1 << 16
"""Most pixels of the frames that are compared, so that the check takes little time."""


def cell_of_onnx(path: Path, data: bytes) -> PixelCell:
    """Return the cell whose forward pass an ONNX file contains.

    The graph computes one frame: its inputs are the bits (1, 1, rows, cols) and the states (1,
    states, rows, cols) as +1 and -1, and its results are the outputs and the new states. The graph
    must give the same bits as the cell for random frames, because the names of its layers alone do
    not show how they are connected.

    Parameters
    ----------
    path : Path
        The file that messages name.
    data : bytes
        Content of the file.

    Returns
    -------
    PixelCell

    Raises
    ------
    Rejected
        NS0851 for another graph, with the name of the layer that is not part of a cell.
    """
    import onnx

    try:
        model = onnx.load_from_string(data)
        onnx.checker.check_model(model)
    except Exception as error:  # protobuf and onnx raise several types for damaged files
        raise refused(path, f"it is not a valid ONNX model: {one_line(error)}") from error
    graph = model.graph
    others = [
        f"`{node.name or node.output[0]}` ({node.op_type})"
        for node in graph.node
        if node.op_type not in _LAYERS or node.domain
    ]
    if others:
        raise refused(path, f"layers that are not part of a cell: {listed(others)}")
    cell = cell_of_state(path, _state(path, graph))
    _check_frames(path, model, cell)
    return cell


def _state(path: Path, graph: Any) -> dict[str, Tensor]:
    """Return the state dict of a cell (the names of `PixelCell`) from the layers of an ONNX graph.

    Raises Rejected (NS0851) for the file `path` if its graph is not that of a cell."""
    from onnx import numpy_helper

    def the(kind: str) -> Any:
        """Return the only layer of the ONNX operation `kind`. Raise Rejected (NS0851) if there are
        none or several."""
        nodes = [node for node in graph.node if node.op_type == kind]
        if len(nodes) != 1:
            raise refused(
                path, f"it has {len(nodes)} layers of the operation {kind}, but a cell has one"
            )
        return nodes[0]

    arrays = {tensor.name: tensor for tensor in graph.initializer}

    def constant(node: Any, number: int) -> Tensor:
        """Return input `number` (0 is the first) of a layer as a tensor. Raise Rejected (NS0851) if
        the layer lacks it, or the graph computes it."""
        name = node.input[number] if number < len(node.input) else ""
        if name not in arrays:
            raise refused(path, f"input {number} of layer `{node.name}` is not a constant")
        return torch.from_numpy(np.array(numpy_helper.to_array(arrays[name])))

    conv, pools = the("Conv"), [node for node in graph.node if node.op_type == "MaxPool"]
    # The subtraction after the convolution holds the thresholds; others make -1 and +1 of bits.
    after = [n for n in graph.node if n.op_type == "Sub" and n.input[0] == conv.output[0]]
    if len(after) != 1 or len(graph.input) != 2:
        raise refused(path, "it does not have two inputs, and one threshold after its layer Conv")
    sides = [a.ints[0] for n in pools for a in n.attribute if a.name == "kernel_shape"]
    state_name = graph.input[1].name
    flips = any(n.op_type == "Mul" and state_name in n.input for n in graph.node)
    return {
        "weight": constant(conv, 1),
        "threshold": constant(after[0], 1).reshape(-1),
        "outside": (constant(the("Pad"), 2) > 0).long(),
        "pool_size": torch.tensor(sides[0] if sides else 1),
        "flips": torch.tensor(int(flips)),
    }


def _check_frames(path: Path, model: Any, cell: PixelCell) -> None:
    """Raise Rejected (NS0851) if the ONNX `model` of the file `path` and the cell give different
    bits for random frames, or if the model cannot be evaluated."""
    from onnx.reference import ReferenceEvaluator

    shapes = [
        tuple(axis.dim_value or 1 for axis in value.type.tensor_type.shape.dim)
        for value in model.graph.input
    ]
    size = shapes[0][-2:]
    # The bits of the light and those of the states, for one frame.
    expected = [(1, 1, *size), (1, cell.states, *size)]
    if shapes != expected or not 0 < np.prod(size) <= _MOST_PIXELS:
        raise refused(
            path,
            f"its inputs have the shapes {shapes}, but a cell has "
            "(1, 1, rows, cols) and (1, states, rows, cols)",
        )
    generator = np.random.default_rng(0)
    names = [value.name for value in model.graph.input]
    for _ in range(_CHECKED_FRAMES):
        planes = [
            np.where(generator.random(shape) < 0.5, -1, 1).astype(np.float32) for shape in shapes
        ]
        try:
            found = ReferenceEvaluator(model).run(None, dict(zip(names, planes, strict=True)))
        except Exception as error:
            raise refused(path, f"its graph cannot be evaluated: {one_line(error)}") from error
        with torch.no_grad():
            # The graph and the cell must give equal bits for random frames.
            outputs = [tensor.numpy() for tensor in cell(*map(torch.from_numpy, planes))]
        if len(found) != 2 or not all(map(np.array_equal, found, outputs)):
            raise refused(
                path,
                "its graph does not compute the bits of a PixelCell with the same weights",
            )


MOST_BYTES = 1 << 24
"""Largest size in bytes of a file, packed and unpacked."""
_SHAPES = "(gates, 1 + states, kernel, kernel) and (gates,)"
_SETTINGS = {"level": 0.5, "outside": 0, "pool_size": 1, "flips": 1}
"""Optional settings in a state dict, and their defaults."""


def cell_of_state(path: Path, state: dict[str, Tensor]) -> PixelCell:
    """Return the cell that a state dict describes: `weight` and `threshold`, and the settings of
    `_SETTINGS` if they differ from their defaults.

    `weight` is (gates, 1 + states, kernel, kernel) and `threshold` (gates,), where the gates are
    those of the states and then of the outputs. Raises Rejected (NS0851) for the file `path` if
    names, shapes or values are not those of a cell, or all weights of a gate are 0."""
    known = {"weight", "threshold", *_SETTINGS}
    if state and all(name.startswith("module.") for name in state):
        raise refused(
            path,
            "all its names begin with `module.`, as torch.nn.DataParallel saves them",
            "save the model itself: torch.save(model.module.state_dict(), FILE.pt)",
        )
    unknown = sorted(name for name in state if name not in known)
    if unknown:
        layers = listed([f"`{name}`" for name in unknown])
        raise refused(path, f"layers that are not part of a cell: {layers}")
    missing = [name for name in ("weight", "threshold") if name not in state]
    if missing:
        raise refused(path, f"{listed([f'`{name}`' for name in missing])} is missing")
    weight, threshold = state["weight"], state["threshold"]
    # The weights have an axis for the gates and one for the planes that they read.
    gates, planes, rows, cols = weight.shape if weight.ndim == 4 else (0, 0, 0, 0)
    states = planes - 1
    fits = (
        1 <= states <= MOST_STATES
        and 1 <= gates - states <= MOST_OUTPUTS
        and rows == cols <= MOST_KERNEL
        and threshold.shape == (gates,)
    )
    if not fits:
        shapes = f"`weight` has the shape {_shape(weight)}, `threshold` {_shape(threshold)}"
        limits = (
            f"1 to {MOST_STATES} states, 1 to {MOST_OUTPUTS} outputs and at most "
            f"{MOST_KERNEL} x {MOST_KERNEL} weights"
        )
        raise refused(path, f"{shapes}; a cell has {_SHAPES}, with {limits}")
    settings: NamedValues = {}
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
            kernel=rows,
            states=states,
            outputs=gates - states,
            pool=settings["pool_size"],
            level=float(settings["level"]),
            outside=settings["outside"],
            update="flip" if settings["flips"] else "replace",
        )
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
    """Return the tensors of a state dict that `torch.save` wrote, by name; `data` is the content of
    the file at `path`.

    No code in the file is run. Raises Rejected (NS0851) for other contents, and for more than
    `MOST_BYTES`."""
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            unpacked = sum(entry.file_size for entry in archive.infolist())
        if unpacked > MOST_BYTES:
            raise ValueError(f"it unpacks to more than {MOST_BYTES >> 20} MiB")
        state: Any = torch.load(io.BytesIO(data), map_location="cpu", weights_only=True)
    except Exception as error:  # torch, zipfile and pickle raise a dozen types for damaged files
        raise refused(path, *_why_no_state(data, error)) from error
    if not isinstance(state, dict):
        raise refused(path, f"it holds {type(state).__name__}, not a state dict")
    for name, value in state.items():
        if not isinstance(name, str) or not isinstance(value, Tensor):
            raise refused(path, f"`{str(name)[:40]}` is {type(value).__name__}, not a tensor")
        if value.layout != torch.strided or value.numel() > MOST_BYTES or value.is_quantized:
            raise refused(path, f"`{name[:40]}` is not a small dense tensor")
    return state


_CLASS = re.compile(r"(?:GLOBAL|global) ([\w.]+)")
"""The class that torch's reader refuses, in its message."""


def _why_no_state(data: bytes, error: Exception) -> tuple[str, str]:
    """Return why a file with the content `data` is not a state dict, and a note on what to do.
    `error` is what its reader raised."""
    named = _CLASS.search(str(error))
    if data.startswith(b"version https://git-lfs"):
        return "it is a pointer of Git LFS, not the file itself", "`git lfs pull` fetches the file"
    if named is not None:
        return (
            f"it is a pickled object of the class {named[1]}, and reading it would run its code"
        ), "save its tensors: torch.save(model.state_dict(), FILE.pt)"
    if data.startswith(b"PK"):
        return "it is cut off or damaged: it begins like a file of torch.save", "copy it again"
    first_sentence = one_line(error).partition(". ")[0]
    reason = "it is not a file of torch.save that holds tensors only"
    return reason, f"the reader says: {first_sentence}"


def refused(path: Path, reason: str, note: str = "") -> Rejected:
    """Return the error (NS0851) that the file `path` is not a cell, because of `reason`. `note`, if
    not empty, is a suggestion printed below it."""
    return rejected(
        "NS0851",
        f"'{path}' cannot be imported: {reason}",
        notes=(note,) if note else (),
        helps=(
            "save a cell alone: torch.save(cell.state_dict(), FILE.pt), cell a "
            "nscc_training.cells.PixelCell; decoders stay off the chip",
        ),
    )


def _shape(tensor: Tensor) -> str:
    """Return the shape of a tensor as text."""
    return str(tuple(tensor.shape))
