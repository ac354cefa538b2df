"""`nscc asm`: assembly text to a container, or to bare words."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.files import write_whole
from nscc.source import Source
from nscc.words.assembly import assemble, assemble_words
from nscc.words.encoding import word_text
from nscc.words.file import to_bytes
from nscc_cli.support import CommonCommand, OutPath

_LARGEST_TEXT = 1 << 30


@click.command(name="asm", cls=CommonCommand)
@click.argument("file", metavar="FILE|-")
@click.option(
    "-o",
    "output",
    type=OutPath(str),
    metavar="OUT",
    help="Where to write (default: FILE with .icw).",
)
@click.option("--words", is_flag=True, help="Print each word's five integers instead.")
def command(file: str, output: str | None, words: bool) -> None:
    """Assemble FILE, or standard input for `-`, into a container (.icw)."""
    source = read_text(file)
    base = Path(file).parent if file != "-" else Path()
    if words:
        text = "".join(f"{word_text(word)}\n" for word in assemble_words(source, base))
        if output is None or output == "-":
            click.echo(text, nl=False)
        else:
            write_whole(Path(output), text.encode("ascii"))
        return
    if output is None and file == "-":
        raise click.UsageError("text from standard input needs -o OUT.icw (or --words)")
    if output == "-":
        raise click.UsageError("a container is not printed: give -o a file, or use --words")
    container = assemble(source, base)
    write_whole(Path(output) if output else Path(file).with_suffix(".icw"), to_bytes(container))


def read_text(file: str) -> Source:
    """The text of a file, or of standard input; raises Rejected (NS0717, status 2)."""
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
