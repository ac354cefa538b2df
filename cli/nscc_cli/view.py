"""`nscc view`: draw a program's shutters, codes or gates, or the contents of a product file."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from nscc.diagnostics.diagnostic import rejected
from nscc.files import write_whole
from nscc.mappings import NamedValues
from nscc.words.legality import refuse_planes
from nscc_cli.options import PATH, build_options, flag, out_option, tone_option
from nscc_cli.programs import compile_program, loaded
from nscc_cli.support import common_command, say, say_done

_PROGRAMS = (".nsl", ".icw")


@common_command("view")
@click.argument("program", metavar="FILE|RUN", type=PATH)
@out_option("The picture (default: the program's name with .png, in this folder).")
@flag("--gates", "Draw the gates that decode the codes instead.")
@tone_option
@build_options
def command(program: Path, out: Path | None, gates: bool, tone: str | None, **options: Any) -> None:
    """Draw the shutters of a program as a time chart, and the map of its codes, as a PNG.

    For pixels that look at their light, the chart shows at which light they are open.

    Also draws files that nscc writes: a frame file, a reconstruction, a run folder, a result.json,
    a sensor.toml, a picture, a clip."""
    from nscc_runtime.formats import check_ending

    out = out or Path(program.stem + ".png")
    check_ending(out, (".png",), "a picture")
    if gates:
        data = _gates(program, options)
    elif program.suffix.lower() in _PROGRAMS:
        data = _shutters(program, options)
    else:
        from nscc_training.views import view_of

        data = view_of(program, tone)
    write_whole(out, data)
    say_done(f"wrote {out.as_posix()}")


def _shutters(program: Path, options: NamedValues) -> bytes:
    """Return the PNG of a program's shutters and their arrangement on the array, after compiling it
    with the `options` of the command. Print its messages. Raises Rejected if the program does not
    compile or cannot be read."""
    container = loaded(program, options)
    from nscc_runtime.pictures.sheet import png_of
    from nscc_runtime.run_kinds import KINDS

    return png_of(KINDS.of(container).sheet, container, program.name)


def _gates(program: Path, options: NamedValues) -> bytes:
    """Return the PNG of the gates that decode the codes of a program, which is compiled with the
    `options` of the command. Print its messages.

    Raises Rejected for a compiled program (NS0743), and for a chip without logic."""
    if program.suffix.lower() == ".icw":
        raise rejected(
            "NS0743",
            f"--gates cannot draw '{program}', which is compiled already",
            notes=("a compiled program contains words, but not their gates",),
            helps=("give the .nsl file instead",),
        )
    compiled = compile_program(program, options)
    say(compiled.diagnostics)
    refuse_planes(
        compiled.program.target,
        "--gates does not apply to this program",
        "without --gates it draws shutters",
    )
    assert compiled.lowered is not None  # programs that do not fit are rejected
    from nscc.pipeline import KINDS
    from nscc_runtime.pictures.gate_sheet import gate_sheet
    from nscc_runtime.pictures.sheet import png_of

    return png_of(gate_sheet, KINDS.of(compiled.program).network(compiled.lowered), program.name)
