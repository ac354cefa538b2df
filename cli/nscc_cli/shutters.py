"""`nscc shutters`: every pixel's shutter, found by replaying the words."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from nscc.files import write_whole
from nscc_cli.options import OUT, PATH, build_options
from nscc_cli.programs import load_program
from nscc_cli.support import CommonCommand, say


@click.command("shutters", cls=CommonCommand)
@click.argument("file", type=PATH)
@click.option("-o", "out", required=True, metavar="S.npz|S.mat|S.npy", type=OUT)
@build_options
def command(file: Path, out: Path, **options: Any) -> None:
    """Write the shutters of all pixels of FILE (.nsl or .icw) as the words open them.

    In an .npz `shutter` holds (buckets, rows, cols, N) packed along N in little bit order,
    `shutter_shape` that shape, `codes_FIELD` the pixels' codes; a .npy holds them unpacked, a .mat
    `mask` (rows, cols, N).
    """
    from nscc_runtime.formats import check_ending, endings, file_of
    from nscc_runtime.formats.frames import shutter_content

    check_ending(out, endings("arrays"), "shutters")
    from nscc.prove.shutters import shutters_of_pixels

    container, messages = load_program(file, options)
    say(messages)
    arrays = shutters_of_pixels(container, f"'{file.as_posix()}'")
    write_whole(out, file_of(out, shutter_content(arrays), "shutters"))
    click.echo(f"wrote {out.as_posix()}", err=True)
