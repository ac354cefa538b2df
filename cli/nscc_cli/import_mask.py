"""`nscc import-mask`: write a program for the shutters in a mask file."""

from __future__ import annotations

from pathlib import Path

import click

from nscc.files import write_together
from nscc_cli.new_program import NEW_PROGRAM, beside_program
from nscc_cli.options import PATH, chip_option
from nscc_cli.support import CommonCommand, NumberRange, say_done


@click.command("import-mask", cls=CommonCommand)
@click.argument("mask", metavar="MASK.npy|npz|mat", type=PATH)
@NEW_PROGRAM
@click.option("--slot-us", type=NumberRange(1e-3, 1e9), default=125.0, show_default=True,
              help="Length of a slot in microseconds.")  # fmt: skip
@chip_option
def command(mask: Path, out: Path, slot_us: float, target: str) -> None:
    """Write a program with the shutters of MASK, and a file with its codes.

    MASK contains `mask` (rows, cols, slots) or (slots, rows, cols) of 0 and 1: the whole array, or
    a tile that repeats over the array. Of the shutter classes that represent the mask, the class
    with the fewest words is chosen; the reasons against the other classes are printed."""
    from nscc_training.imported_masks import import_mask

    codes = beside_program(out, "codes")
    imported = import_mask(mask, codes.name, slot_us=slot_us, target=target)
    products = {out: imported.text.encode()}
    if imported.codes:
        products[codes] = imported.codes
    write_together(products)
    rows, cols = imported.tile
    say_done("\n".join([
        f"class {imported.kind}, a tile of {rows} x {cols}, "
        f"{imported.words_per_slot:g} words a slot",
        *(f"  not {reason}" for reason in imported.reasons),
        *(f"wrote {path.as_posix()}" for path in products),
    ]))  # fmt: skip
