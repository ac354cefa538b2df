"""`nscc import-mask`, `import-network`, `import-frame`: programs for a mask or a network that was
trained with torch, and frame files of what a chip's own host saved."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from nscc.files import reads, refuse_same, write_together
from nscc_cli.frames import sensor_of
from nscc_cli.options import (
    PATH,
    build_options,
    chip_option,
    declared,
    flag,
    out_option,
    pixels_option,
    sensor_options,
)
from nscc_cli.programs import loaded
from nscc_cli.support import common_command, say_done
from nscc_training.command_settings import Axis, ImportSettings

_PROGRAM = out_option("The program.", "P.nsl", required=True)


def _beside_program(out: Path, arrays: str) -> Path:
    """Return the path of the file from which the program at `out` reads its arrays: STEM.ARRAYS.npz
    beside it, where `arrays` is a word such as "codes". Raise BadParameter if the program's name
    does not end in .nsl."""
    if out.suffix.lower() != ".nsl":
        raise click.BadParameter(f"'{out}' does not end in .nsl", param_hint="-o")
    path = out.with_suffix(f".{arrays}.npz")
    refuse_same([out, path], f"-o and its {arrays}")
    return path


@common_command("import-mask")
@click.argument("mask", metavar="MASK.npy|npz|mat", type=PATH)
@_PROGRAM
@declared(ImportSettings, "slot_us", "slots_axis", show=True)
@chip_option
def import_mask(
    mask: Path, out: Path, slot_us: float, slots_axis: Axis | None, target: str
) -> None:
    """Write a program with the shutters of MASK, and a file with its codes.

    MASK contains `mask` (rows, cols, slots) or (slots, rows, cols) of 0 and 1: the whole array, or
    a tile that repeats over the array. A tile is (rows, cols, slots) if rows and cols are equal and
    slots differ; any other needs --slots-axis. Of the shutter classes that represent the mask, the
    class with the fewest words is chosen; the reasons against the other classes are printed."""
    from nscc_training import imported_masks

    codes = _beside_program(out, "codes")
    imported = imported_masks.import_mask(
        mask, codes.name, slot_us=slot_us, target=target, slots_axis=slots_axis
    )
    products = {out: imported.text.encode()}
    if imported.codes:
        products[codes] = imported.codes
    write_together(products)
    rows, cols = imported.tile
    say_done(
        "\n".join(
            [
                f"class {imported.kind}, a tile of {rows} x {cols}, {imported.axes}, "
                f"{imported.words_per_slot:g} words a slot",
                *(f"  not {reason}" for reason in imported.reasons),
                *(f"wrote {path.as_posix()}" for path in products),
            ]
        )
    )


@common_command("import-network")
@click.argument("model", metavar="MODEL.pt|onnx", type=PATH)
@_PROGRAM
@declared(ImportSettings, "frame_us", show=True)
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
    say_done(
        "\n".join(
            [
                f"{counted(cell.states, 'state')}, {counted(cell.outputs, 'output')}, "
                f"kernels {cell.kernel} x {cell.kernel}, {imported.words} words a frame",
                f"exposures are compared with {100 * imported.level:.4g} % of a full well",
                *(f"wrote {path.as_posix()}" for path in (out, kernels)),
            ]
        )
    )


def _place(
    _context: click.Context, _option: click.Parameter, value: str | None
) -> tuple[int, int] | None:
    """Return (row, column) of an option's value, a text R,C of two numbers from 0; None without
    one. Raise BadParameter for another text."""
    if value is None:
        return None
    row, _, col = value.partition(",")
    if not (row.strip().isdecimal() and col.strip().isdecimal()):
        raise click.BadParameter(f"'{value}' is not a row and a column, such as 128,0")
    return int(row), int(col)


@common_command("import-frame")
@click.argument("program", metavar="FILE.nsl|FILE.icw", type=PATH)
@click.argument("files", metavar="FILE..|NAME=FILE..", nargs=-1, required=True)
@out_option("The frame file.", "FRAME.npz", required=True)
@click.option(
    "--crop",
    callback=_place,
    metavar="R,C",
    help="Row and column of the picture's pixel that is the array's first pixel.",
)
@click.option(
    "--flip",
    type=click.Choice(("rows", "cols", "both")),
    default=None,
    help="Reverse the order of rows, columns or both, after --crop.",
)
@flag("--transpose", "Exchange rows and columns, after --flip.")
@sensor_options
@pixels_option
@build_options
def import_frame(
    program: Path,
    files: tuple[str, ...],
    out: Path,
    crop: tuple[int, int] | None,
    flip: str | None,
    transpose: bool,
    **options: Any,
) -> None:
    """Write the frame file of pictures that a chip's own host saved.

    FILE is an 8-bit grey picture of codes, or a picture of bits: .bmp, .png, .tiff, .npy or .csv.
    There is one for each bucket, then for each image and plane that the program reads, in this
    order or as NAME=FILE. A program that reads states needs a picture of each register of its
    states.

    No picture tells how the host turned the array: compare the result with a known scene."""
    from nscc.words.readout import converter_of
    from nscc_runtime.device.imported_frame import Orientation, readout_names
    from nscc_runtime.device.imported_frame import import_frame as imported
    from nscc_runtime.formats import check_ending
    from nscc_runtime.run_messages import frame_lines

    check_ending(out, (".npz",), "an imported frame")
    container = loaded(program, options)
    known = [name for names in readout_names(container) for name in names]
    pairs = [
        (name, Path(path))
        for file in files
        for name, mark, path in [file.partition("=")]
        # The name of an existing file may contain `=`.
        if mark and (name in known or not Path(file).exists())
    ]
    if pairs and len(pairs) < len(files):
        raise click.UsageError("only some files have a NAME: give all files as NAME=FILE, or none")
    if len(dict(pairs)) < len(pairs):
        raise click.UsageError("a NAME is given twice: name each readout once, as NAME=FILE")
    orientation = Orientation(crop, flip or "none", transpose)  # type: ignore[arg-type]  # Choice
    named = dict(pairs) if pairs else [Path(file) for file in files]
    reads(*(named.values() if isinstance(named, dict) else named))
    sensor = sensor_of(converter_of(container), options)
    file = imported(container, named, orientation, sensor)
    write_together({out: file.write})
    say_done(
        "\n".join(
            [
                *frame_lines(container, file.frame),
                f"assumed: {orientation}; no picture tells how the host turned the array",
                f"wrote {out.as_posix()}",
            ]
        )
    )
