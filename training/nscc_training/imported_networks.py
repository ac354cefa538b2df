"""Import trained cells as programs, from state dicts of torch and from ONNX."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from nscc.chips.load import load_target
from nscc.files import read_whole
from nscc_training.cell_programs import cell_files, compiled_cell, level_on_chip
from nscc_training.cell_states import MOST_BYTES, cell_of_state, loaded_state, refused
from nscc_training.cells import PixelCell


@dataclass(frozen=True)
class ImportedNetwork:
    """The program of an imported cell.

    `kernels`: the bytes of the kernel file. `words`: number of words per frame after the exposure.
    `level`: the level in full wells with which the chip compares exposures."""

    text: str
    kernels: bytes
    cell: PixelCell
    words: int
    level: float


def import_network(
    path: Path, kernels_name: str, *, frame_us: float = 33_000.0, target: str = "scamp5"
) -> ImportedNetwork:
    """Return the program of a trained cell, from a state dict (.pt) or a forward pass (.onnx).

    `kernels_name` is the name of the kernel file in the program's text, `frame_us` the exposure
    time of a frame in microseconds. Raises Rejected: NS0851 for a file without such a cell, and the
    compiler's errors for a cell that does not fit the chip."""
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
    """Read a cell from a state dict (.pt, .pth) or an .onnx file; raise Rejected (NS0851) for
    another file."""
    suffix = path.suffix.lower()
    if suffix not in (".pt", ".pth", ".onnx"):
        raise refused(path, "its name does not end in .pt, .pth or .onnx")
    try:
        data = read_whole(path, MOST_BYTES)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise refused(path, reason[:1].lower() + reason[1:]) from error
    if suffix == ".onnx":
        from nscc_training.onnx_cells import cell_of_onnx

        return cell_of_onnx(path, data)
    return cell_of_state(path, loaded_state(path, data))
