"""`nscc import-network`: convert a network that was trained with torch to a program."""

from __future__ import annotations

from pathlib import Path

import click

from nscc.files import write_together
from nscc_cli.new_program import NEW_PROGRAM, beside_program
from nscc_cli.options import PATH, chip_option
from nscc_cli.support import CommonCommand, NumberRange, say_done


@click.command("import-network", cls=CommonCommand)
@click.argument("model", metavar="MODEL.pt|onnx", type=PATH)
@NEW_PROGRAM
@click.option("--frame-us", type=NumberRange(1e-3, 1e9), default=33_000.0, show_default=True,
              help="Exposure time of a frame in microseconds.")  # fmt: skip
@chip_option
def command(model: Path, out: Path, frame_us: float, target: str) -> None:
    """Write the program of a recurrent cell of bits, and its kernels beside it.

    MODEL is the state dict of a `nscc_training.cells.PixelCell`, or the ONNX export of its forward
    pass. Other networks are refused, with the names of their layers. The program is compiled and
    proved before it is written."""
    from nscc.program.problems import counted
    from nscc_training.imported_networks import import_network

    kernels = beside_program(out, "kernels")
    imported = import_network(model, kernels.name, frame_us=frame_us, target=target)
    write_together({out: imported.text.encode(), kernels: imported.kernels})
    cell = imported.cell
    say_done("\n".join([
        f"{counted(cell.states, 'state')}, {counted(cell.outputs, 'output')}, "
        f"kernels {cell.kernel} x {cell.kernel}, {imported.words} words a frame",
        f"exposures are compared with {100 * imported.level:.4g} % of a full well",
        *(f"wrote {path.as_posix()}" for path in (out, kernels)),
    ]))  # fmt: skip
