"""`nscc asm`, `disasm`, `diff`, `prove`, `shutters`, `export-mask`: commands for compiled
programs."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import click

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.files import write_whole
from nscc.source import Source
from nscc.words.assembly import assemble, assemble_words
from nscc.words.diff import differences
from nscc.words.disassembly import disassemble
from nscc.words.encoding import word_text
from nscc.words.file import read_container, to_bytes
from nscc_cli.options import PATH, build_options, flag, out_option
from nscc_cli.programs import load_program, loaded
from nscc_cli.support import OutPath, common_command, refuse_ignored, say

_LARGEST_TEXT = 1 << 30


@common_command("asm")
@click.argument("file", metavar="FILE|-")
@click.option(
    "-o",
    "output",
    type=OutPath(str),
    metavar="OUT",
    help="Where to write (default: FILE with .icw).",
)
@flag("--words", "Print each word's five integers instead.")
def asm(file: str, output: str | None, words: bool) -> None:
    """Assemble FILE, or standard input for `-`, into a container (.icw)."""
    source = read_text(file)
    base = Path(file).parent if file != "-" else Path()
    if words:
        text = "".join(f"{word_text(word)}\n" for word in assemble_words(source, base))
        _write_or_print(text, output)
        return
    if output is None and file == "-":
        raise click.UsageError("text from standard input needs -o OUT.icw (or --words)")
    if output == "-":
        raise click.UsageError("a container is not printed: give -o a file, or use --words")
    container = assemble(source, base)
    write_whole(Path(output) if output else Path(file).with_suffix(".icw"), to_bytes(container))


def _write_or_print(text: str, output: str | None) -> None:
    """Write `text` to the file `output`, or to standard output for None and "-"."""
    if output is None or output == "-":
        click.echo(text.encode(), nl=False)
    else:
        write_whole(Path(output), text.encode())


def read_text(file: str) -> Source:
    """Read assembly text from a file, or from standard input if `file` is `-`.

    Raises Rejected (NS0717, status 2) if it cannot be read, has more than 1 GiB, or is not UTF-8.
    """
    name = "<standard input>" if file == "-" else file
    try:
        if file == "-":
            data = sys.stdin.buffer.read(_LARGEST_TEXT + 1)
        else:
            with open(file, "rb") as stream:
                data = stream.read(_LARGEST_TEXT + 1)
        if len(data) > _LARGEST_TEXT:
            raise ValueError(f"it has more than {_LARGEST_TEXT} bytes")
        return Source(name, data.decode("utf-8-sig"))
    except UnicodeDecodeError as error:
        reason = f"byte {error.start} is not UTF-8 text"
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
    helps = ("`nscc disasm` turns a container (.icw) into text",) if file.endswith(".icw") else ()
    message = f"cannot read assembly text from '{name}': {reason}"
    raise Rejected(Diagnostic("NS0717", message, helps=helps), status=2)


@common_command("disasm")
@click.argument("file", metavar="FILE.icw")
@click.option(
    "-o",
    "output",
    type=OutPath(str),
    metavar="OUT",
    help="Where to write (default: standard output).",
)
def disasm(file: str, output: str | None) -> None:
    """Write FILE.icw as assembly text, from which `nscc asm` makes the same file again."""
    _write_or_print(disassemble(read_container(Path(file))), output)


@common_command("diff")
@click.argument("first", metavar="A.icw")
@click.argument("second", metavar="B.icw")
def diff(first: str, second: str) -> None:
    """Print the differences between A.icw and B.icw: words, kernels, schedule, codes, costs."""
    lines = differences(read_container(Path(first)), read_container(Path(second)))
    click.echo("\n".join(lines) if lines else "identical")


@common_command("prove")
@click.argument("file", type=PATH)
@build_options
def prove(file: Path, **options: Any) -> None:
    """Prove FILE (.icw, or .nsl, which is compiled) by replaying its words.

    The words are replayed for all codes and two frames of random light.

    The proof checks that every code opens the shutter in the decode table, and that each bucket
    contains exactly the light of its open slots. For a chip that receives
    bit planes, it follows the light of every pixel through the planes."""
    from nscc.container_proof import prove_container
    from nscc.program.problems import counted

    if file.suffix.lower() == ".nsl":
        container, messages = load_program(file, options)
    else:
        refuse_ignored(f"'{file}' is compiled already", *options)
        container, messages = read_container(file), ()
    proof = prove_container(container, file.as_posix())
    say(messages)
    pixels = f"{counted(proof.pixels, 'pixel')} x " if proof.pixels else ""
    click.echo(
        f"{file.as_posix()}: proved: {pixels}{counted(proof.codes, 'code')} x "
        f"{counted(proof.slots, 'slot')} x {counted(len(container.buckets), 'bucket')}, "
        f"{counted(proof.frames, 'frame')}"
    )


@common_command("shutters")
@click.argument("file", type=PATH)
@out_option("The file to write.", "S.npz|S.mat|S.npy", required=True)
@build_options
def shutters(file: Path, out: Path, **options: Any) -> None:
    """Write the shutters of all pixels of FILE (.nsl or .icw), as its words open them.

    An .npz file contains `shutter`, which is (buckets, rows, cols, N) packed along N in
    little-endian bit order, its unpacked shape `shutter_shape`, and the pixels' codes
    `codes_FIELD`. A .npy file contains the unpacked array, a .mat file `mask` (rows, cols, N)."""
    from nscc_runtime.formats import check_ending, endings, file_of
    from nscc_runtime.formats.content import shutter_content

    check_ending(out, endings("arrays"), "shutters")
    from nscc.container_proof import shutters_of_pixels

    container = loaded(file, options)
    arrays = shutters_of_pixels(container, f"'{file.as_posix()}'")
    write_whole(out, file_of(out, shutter_content(arrays), "shutters"))
    click.echo(f"wrote {out.as_posix()}", err=True)


@common_command("export-mask")
@click.argument("program", metavar="PROGRAM", type=PATH)
@out_option("The mask.", "MASK.npy|npz|mat", required=True)
@click.option("--bucket", metavar="NAME", help="Write the shutters of this bucket only.")
@build_options
def export_mask(program: Path, out: Path, bucket: str | None, **options: Any) -> None:
    """Write the mask of PROGRAM (.nsl or .icw): what each of its pixels does in each slot.

    The array `mask` is uint8 (rows, cols, slots) of 0 and 1, or (buckets, rows, cols, slots) for
    several buckets without --bucket. `nscc import-mask` reads the mask of one bucket."""
    from nscc_runtime.formats import check_ending, file_of
    from nscc_runtime.formats.content import mask_content

    check_ending(out, (".npy", ".npz", ".mat"), "a mask")
    from nscc.container_proof import shutters_of_pixels

    container, messages = load_program(program, options)
    if bucket is not None and bucket not in container.buckets:
        names = ", ".join(container.buckets)
        raise click.BadParameter(f"'{bucket}' is not one of {names}", param_hint="--bucket")
    say(messages)
    arrays = shutters_of_pixels(container, f"'{program.as_posix()}'")
    index = None if bucket is None else container.buckets.index(bucket)
    write_whole(out, file_of(out, mask_content(arrays, index), "a mask"))
    click.echo(f"wrote {out.as_posix()}", err=True)
