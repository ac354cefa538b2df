"""`nscc import-mask` and `nscc import-network`: programs for the shutters in a mask file, and for
a network that was trained with torch."""

from __future__ import annotations

from pathlib import Path

import click

from nscc.files import refuse_same, write_together
from nscc_cli.options import OUT, PATH, chip_option
from nscc_cli.support import CommonCommand, NumberRange, say_done

_PROGRAM = click.option("-o", "out", required=True, metavar="P.nsl", type=OUT, help="The program.")


def _beside_program(out: Path, arrays: str) -> Path:
    """Return the path STEM.ARRAYS.npz beside a program, whose name must end in .nsl."""
    if out.suffix.lower() != ".nsl":
        raise click.BadParameter(f"'{out}' does not end in .nsl", param_hint="-o")
    path = out.with_suffix(f".{arrays}.npz")
    refuse_same([out, path], f"-o and its {arrays}")
    return path


@click.command("import-mask", cls=CommonCommand)
@click.argument("mask", metavar="MASK.npy|npz|mat", type=PATH)
@_PROGRAM
@click.option("--slot-us", type=NumberRange(1e-3, 1e9), default=125.0, show_default=True,
              help="Length of a slot in microseconds.")  # fmt: skip
@chip_option
def import_mask(mask: Path, out: Path, slot_us: float, target: str) -> None:
    """Write a program with the shutters of MASK, and a file with its codes.

    MASK contains `mask` (rows, cols, slots) or (slots, rows, cols) of 0 and 1: the whole array, or
    a tile that repeats over the array. Of the shutter classes that represent the mask, the class
    with the fewest words is chosen; the reasons against the other classes are printed."""
    from nscc_training import imported_masks

    codes = _beside_program(out, "codes")
    imported = imported_masks.import_mask(mask, codes.name, slot_us=slot_us, target=target)
    products = {out: imported.text.encode()}
    if imported.codes:
        products[codes] = imported.codes
    write_together(products)
    rows, cols = imported.tile
    say_done("\n".join([
        f"class {imported.kind}, a tile of {rows} x {cols}, {imported.axes}, "
        f"{imported.words_per_slot:g} words a slot",
        *(f"  not {reason}" for reason in imported.reasons),
        *(f"wrote {path.as_posix()}" for path in products),
    ]))  # fmt: skip


@click.command("import-network", cls=CommonCommand)
@click.argument("model", metavar="MODEL.pt|onnx", type=PATH)
@_PROGRAM
@click.option("--frame-us", type=NumberRange(1e-3, 1e9), default=33_000.0, show_default=True,
              help="Exposure time of a frame in microseconds.")  # fmt: skip
@chip_option
def import_network(model: Path, out: Path, frame_us: float, target: str) -> None:
    """Write the program of a recurrent cell of bits, and its kernels beside it.

    MODEL is the state dict of a `nscc_training.cells.PixelCell`, or the ONNX export of its forward
    pass. Other networks are refused, with the names of their layers. The program is compiled and
    proved before it is written."""
    from nscc.program.problems import counted
    from nscc_training import imported_networks

    kernels = _beside_program(out, "kernels")
    imported = imported_networks.import_network(
        model, kernels.name, frame_us=frame_us, target=target
    )
    write_together({out: imported.text.encode(), kernels: imported.kernels})
    cell = imported.cell
    say_done("\n".join([
        f"{counted(cell.states, 'state')}, {counted(cell.outputs, 'output')}, "
        f"kernels {cell.kernel} x {cell.kernel}, {imported.words} words a frame",
        f"exposures are compared with {100 * imported.level:.4g} % of a full well",
        *(f"wrote {path.as_posix()}" for path in (out, kernels)),
    ]))  # fmt: skip
