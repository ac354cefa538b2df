"""Programs of cells: the text of an `.nsl` file, and the kernels beside it."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from nscc.arrays import Bools, Floats32, Ints
from nscc_training.cells import PixelCell
from nscc_training.codes_files import codes_bytes

if TYPE_CHECKING:
    from nscc.chips.target import Target
    from nscc.shutter_program import ShutterProgram


class CellFiles(NamedTuple):
    """The program of a cell: its `text`, `kernels`, the bytes of its kernel file (`.npz`), and
    `planes`, the names of the planes that are read, one for each output."""

    text: str
    kernels: bytes
    planes: tuple[str, ...]


def cell_files(
    cell: PixelCell,
    kernels_name: str | None,
    *,
    frame_us: float = 33_000.0,
    target: str | None = None,
    remark: str = "",
) -> CellFiles:
    """Return the program of a cell.

    A pooled output is 1 if the gate's count exceeds the threshold in any pixel of a square. The
    program therefore dilates the bits of outputs (`any`), in steps of 3 x 3 pixels. The host uses
    only the pixels in the middle of the squares (`cell_film`).

    Parameters
    ----------
    cell : PixelCell
    kernels_name : str or None
        Name of the kernel file in the program's folder; None writes kernels into the text.
    frame_us : float
        Exposure time of a frame in microseconds.
    target : str, optional
        Name of the chip, for the program's text; None leaves it out.
    remark : str
        Comment at the start of the program.

    Returns
    -------
    CellFiles
        The same cell gives the same bytes.
    """
    states, updates = (_numbered(name, cell.states) for name in ("h", "f"))
    outputs = _numbered("o", cell.outputs)
    gates, thresholds = [*updates, *outputs], cell.thresholds().tolist()
    # Each gate has a kernel for the input plane x and one for each state; zero kernels are left
    # out.
    names = [[_kernel_name(gate, plane, states) for plane in ("x", *states)] for gate in gates]
    arrays: dict[str, Ints] = {
        names[i][j]: kernel
        for i, row in enumerate(cell.kernels().numpy())
        for j, kernel in enumerate(row)
        if kernel.any()
    }
    lines = [*(f"# {line}" for line in remark.splitlines()), "nsl 3"]
    lines += [] if target is None else [f"target {target}"]
    lines += [f"frame 1 slots of {frame_us:g}us", "open when true"]
    lines += [f"outside {int(cell.outside)}", ""]
    lines += [
        f"kernel {name} = {kernel.tolist()}"
        if kernels_name is None
        else f'kernel {name} from "{kernels_name}"'
        for name, kernel in arrays.items()
    ]
    # Pooling over an odd size is that many steps of an OR with the nearest neighbours.
    steps = cell.pool // 2
    if steps:
        lines.append("kernel around = [[1, 1, 1], [1, 1, 1], [1, 1, 1]]")
    lines += [f"state {state} : bit = 1 kept" for state in states]
    lines += ["", f"plane x = exposure > {100 * float(cell.level):.6g}%"]
    for gate, kernels in zip(gates, names, strict=True):
        terms = [
            f"agree({plane}, {name})"
            for plane, name in zip(("x", *states), kernels, strict=True)
            if name in arrays
        ]
        lines.append(f"image {gate} = {' + '.join(terms)}")
    planes = _numbered("b", cell.outputs)
    above = dict(zip(gates, thresholds, strict=True))
    lines += [
        f"plane {plane} = {output} > {above[output]}"
        for plane, output in zip(planes, outputs, strict=True)
    ]
    for state, gate in zip(states, updates, strict=True):
        # "flip" changes the state where its gate is above the threshold; else the gate is the new
        # state.
        flips = f"not ({state} xor {gate} > {above[gate]})"
        rule = flips if cell.update == "flip" else f"{gate} > {above[gate]}"
        lines.append(f"next {state} = {rule}")
    for step in range(steps):
        wider = _numbered("p" * (step + 1), cell.outputs)
        lines += [
            f"plane {wide} = any({plane}, around)"
            for wide, plane in zip(wider, planes, strict=True)
        ]
        planes = wider
    lines.append(f"read {', '.join(planes)}")
    return CellFiles("\n".join(lines) + "\n", codes_bytes(arrays), tuple(planes))


def compiled_cell(
    files: CellFiles, kernels_name: str | None = None, target: Target | str | None = None
) -> ShutterProgram:
    """Compile and prove the program of a cell.

    `kernels_name` is the argument that `cell_files` received. `target` is the chip; None leaves it
    to the text. Raises Rejected with the compiler's errors."""
    from nscc.shutter_program import compile

    with tempfile.TemporaryDirectory() as folder:
        if kernels_name is not None:
            (Path(folder) / kernels_name).write_bytes(files.kernels)
        return compile(files.text, target=target, folder=folder)


def level_on_chip(level: float, target: Target) -> float:
    """Return `level`, in full wells, rounded to a whole step of IN, the value that the controller
    sends to all pixels. A cell with this level then gives the same bits in torch and on the chip. A
    level below half a step becomes 0."""
    step_e = target.electrons_per_step
    return round(level * target.full_well_e / step_e) * step_e / target.full_well_e


def cell_film(
    program: ShutterProgram,
    cell: PixelCell,
    exposure: Floats32,
    planes: tuple[str, ...],
    *,
    effects: str = "none",
    seed: int = 0,
    device_seed: int = 0,
) -> Bools:
    """Run the program of a cell in the emulator.

    Parameters
    ----------
    program : ShutterProgram
    cell : PixelCell
    exposure : array of float32
        (frames, rows, cols), in full wells.
    planes : tuple of str
        Names of the program's planes of outputs, one for each output: `planes` of `CellFiles`.
    effects : str
        Effects of the sensor, such as "all"; "none" gives exact bits.
    seed, device_seed : int
        Seeds of the noise and of the device.

    Returns
    -------
    array of bool
        (frames, outputs, rows // pool, cols // pool): the bits in the middles of the squares.
        Without effects they are those of `PixelCell.film`, if `level` is a `level_on_chip`.
    """
    from nscc_runtime.exposing import film

    full_e = np.float32(program.container.target.full_well_e)
    lights = [frame[None] * full_e for frame in exposure]
    captured = film(program, lights, effects=effects, seed=seed, device_seed=device_seed, threads=1)
    stack = np.stack([captured.planes[name] for name in planes], axis=1)
    rows, cols = (size // cell.pool for size in stack.shape[-2:])
    first = cell.pool // 2
    return stack[..., first :: cell.pool, first :: cell.pool][..., :rows, :cols]


def _numbered(name: str, count: int) -> list[str]:
    """Return `count` names: `name` followed by 1, 2, ..; a single one has no number."""
    return [name] if count == 1 else [f"{name}{number + 1}" for number in range(count)]


def _kernel_name(gate: str, plane: str, states: list[str]) -> str:
    """Return the name of the kernel with which a gate counts the bits of a plane: `wf` for gate f
    over the exposure x, and `uf` over the state h; with two states `uf_h1` and `uf_h2`."""
    if plane == "x":
        return f"w{gate}"
    return f"u{gate}" if len(states) == 1 else f"u{gate}_{plane}"
