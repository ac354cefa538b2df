"""Read cells from ONNX files, and check them by evaluating the graph."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import torch
from torch import Tensor

from nscc_training.cell_states import cell_of_state, refused
from nscc_training.cells import PixelCell
from nscc_training.problems import listed, one_line

_LAYERS = frozenset((
    "Cast", "Concat", "Constant", "Conv", "Greater", "Identity", "MaxPool", "Mul", "Pad", "Slice",
    "Sub",
))  # fmt: skip
"""Operations of the forward pass of a `PixelCell` in the export of torch."""
_CHECKED_FRAMES = 8
_MOST_PIXELS = 1 << 16


def cell_of_onnx(path: Path, data: bytes) -> PixelCell:
    """Return the cell whose forward pass an ONNX file contains.

    The graph computes one frame: its inputs are the bits (1, 1, rows, cols) and the states (1,
    states, rows, cols) as +1 and -1, and its results are the outputs and the new states. The graph
    must give the same bits as the cell for random frames.

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
    others = [f"`{node.name or node.output[0]}` ({node.op_type})" for node in graph.node
              if node.op_type not in _LAYERS or node.domain]  # fmt: skip
    if others:
        raise refused(path, f"layers that are not part of a cell: {listed(others)}")
    cell = cell_of_state(path, _state(path, graph))
    _check_frames(path, model, cell)
    return cell


def _state(path: Path, graph: Any) -> dict[str, Tensor]:
    """Return the state dict that the layers of a graph describe."""
    from onnx import numpy_helper

    def the(kind: str) -> Any:
        nodes = [node for node in graph.node if node.op_type == kind]
        if len(nodes) != 1:
            raise refused(path, f"it has {len(nodes)} layers {kind}, but a cell has one")
        return nodes[0]

    arrays = {tensor.name: tensor for tensor in graph.initializer}

    def constant(node: Any, number: int) -> Tensor:
        name = node.input[number] if number < len(node.input) else ""
        if name not in arrays:
            raise refused(path, f"input {number} of layer `{node.name}` is not a constant")
        return torch.from_numpy(np.array(numpy_helper.to_array(arrays[name])))

    conv, pools = the("Conv"), [node for node in graph.node if node.op_type == "MaxPool"]
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
    """Raise Rejected (NS0851) if the graph and the cell differ for random frames."""
    from onnx.reference import ReferenceEvaluator

    shapes = [
        tuple(axis.dim_value or 1 for axis in value.type.tensor_type.shape.dim)
        for value in model.graph.input
    ]
    size = shapes[0][-2:]
    expected = [(1, 1, *size), (1, cell.states, *size)]
    if shapes != expected or not 0 < np.prod(size) <= _MOST_PIXELS:
        raise refused(path, f"its inputs have the shapes {shapes}, but a cell has "
                            "(1, 1, rows, cols) and (1, states, rows, cols)")  # fmt: skip
    generator = np.random.default_rng(0)
    names = [value.name for value in model.graph.input]
    for _ in range(_CHECKED_FRAMES):
        planes = [np.where(generator.random(shape) < 0.5, -1, 1).astype(np.float32)
                  for shape in shapes]  # fmt: skip
        try:
            found = ReferenceEvaluator(model).run(None, dict(zip(names, planes, strict=True)))
        except Exception as error:
            raise refused(path, f"its graph cannot be evaluated: {one_line(error)}") from error
        with torch.no_grad():
            outputs = [tensor.numpy() for tensor in cell(*map(torch.from_numpy, planes))]
        if len(found) != 2 or not all(map(np.array_equal, found, outputs)):
            raise refused(path, "its graph does not compute the bits of a cell")
