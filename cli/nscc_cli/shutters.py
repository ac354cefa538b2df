"""`nscc shutters`: every pixel's shutter, found by replaying the words."""

from __future__ import annotations

from pathlib import Path
from typing import BinaryIO

import click

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.files import write_whole
from nscc_cli.programs import BuildChoice, build_options, load_program
from nscc_cli.support import CommonCommand, say


@click.command("shutters", cls=CommonCommand)
@click.argument("file", type=click.Path(path_type=Path))
@click.option("-o", "out", required=True, metavar="S.npz", type=click.Path(path_type=Path))
@build_options
def command(
    file: Path,
    out: Path,
    level: int | None,
    codes: str | None,
    lowering: str | None,
    target: str | None,
    cache: bool,
    max_words_per_slot: int | None,
) -> None:
    """Write the shutters of all pixels of FILE (.nsl or .icw) as the words open them.

    `shutter` holds (buckets, rows, cols, N) packed along N in little bit order, `shutter_shape`
    that shape, `codes_FIELD` the pixels' codes.
    """
    import numpy as np

    from nscc.prove.replay import shutters
    from nscc.words.legality import decoded

    container, messages = load_program(
        file, BuildChoice(level, codes, lowering, target, cache, max_words_per_slot)
    )
    say(messages)
    pixels = container.pixel_codes
    if pixels is None and len(container.table.codes) == 1:
        pixels = np.zeros((container.target.rows, container.target.cols), dtype=np.int32)
    if pixels is None:
        raise Rejected(
            Diagnostic(
                "NS0441",
                f"'{file.as_posix()}' has no pixel data, so its pixels have no shutters yet",
                helps=("give the program a `pixels` statement",),
            )
        )
    found = shutters(container, decoded(container))
    if found is None:
        raise Rejected(
            Diagnostic(
                "NS0442",
                f"the words of '{file.as_posix()}' are no shutter: some slot's light counts "
                "neither once nor not at all",
                helps=("`nscc prove` says what the words do wrong",),
            )
        )
    lanes = container.table.shutter_of_code[pixels]
    packed = np.packbits(found, axis=2, bitorder="little").transpose(1, 0, 2)[:, lanes, :]
    arrays = {
        "shutter": packed,
        "shutter_shape": np.array([len(container.buckets), *lanes.shape, container.slots]),
    }
    for index, field in enumerate(container.table.fields):
        arrays[f"codes_{field}"] = container.table.codes[:, index][pixels]

    def save(stream: BinaryIO) -> None:
        np.savez(stream, **arrays)  # type: ignore[arg-type]  # numpy types keywords as one kind

    write_whole(out, save)
    click.echo(f"wrote {out.as_posix()}", err=True)
