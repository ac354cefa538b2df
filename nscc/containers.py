"""Loading of containers from `.icw` files or by compiling programs, and of programs' texts."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np

from nscc.arrays import Array
from nscc.compiler import compile_file
from nscc.diagnostics.arguments import path_of, shown, wrong_argument
from nscc.diagnostics.diagnostic import Diagnostic, rejected
from nscc.options import Options
from nscc.pipeline import KINDS
from nscc.program.analyse import ranges_of
from nscc.program.pixel_codes import codes_from
from nscc.source import Source
from nscc.syntax.parse import read_source
from nscc.words.container import Container
from nscc.words.file import read_container

SUFFIX = ".icw"
_PATHS = (".nsl", SUFFIX)


def is_compiled(path: Path) -> bool:
    """Return whether a path has the ending of compiled programs (.icw)."""
    return path.suffix.lower() == SUFFIX


def load_container(
    path: Path, options: Options | None = None
) -> tuple[Container, tuple[Diagnostic, ...]]:
    """Return the container (a compiled program) of an `.icw` file, or of a program that is compiled
    with `options` (None: the defaults); and the messages of its compilation, none for an .icw file.

    Raises Rejected if the program does not compile or a file cannot be read, and ValueError if the
    options leave it open whether the program fits."""
    if is_compiled(path):
        return read_container(path), ()
    compiled = compile_file(path, options)
    if compiled.container is None:  # undecided programs pass here
        raise ValueError(f"{path}: no words were found, so it is unknown whether the program fits")
    return compiled.container, compiled.diagnostics


def with_pixels(
    container: Container,
    name: str | Path,
    pixels: Path | Mapping[str, Array] | None = None,
) -> Container:
    """Return the container (a compiled program) with pixel codes: those of `pixels` (a file, or
    arrays by field), or its own.

    A program without fields needs none. `name` is the container in messages, and the path of its
    program, in whose folder files are looked up. Raises Rejected: NS0741 (status 2) if there are no
    codes, and for invalid `pixels` NS0311 to NS0314 and NS0319."""
    target, fields = container.target, container.table.fields
    if pixels is not None:
        program = Path(name)
        source = Source(program.name, "\n".join(container.source_lines))
        codes = codes_from(
            pixels,
            container.table,
            target.rows,
            target.cols,
            mode=container.notes.get("codes", ""),
            ranges=partial(ranges_of, source, target, program.parent),
        )
        return KINDS.of(container).with_planes(replace(container, pixel_codes=codes))
    if container.pixel_codes is not None:
        return container
    # Without fields there is one code, number 0, which all pixels have.
    if not fields:
        everywhere = np.zeros((target.rows, target.cols), np.int32)
        return KINDS.of(container).with_planes(replace(container, pixel_codes=everywhere))
    arrays = ", ".join(f"{name}=..." for name in fields)
    raise rejected(
        "NS0741",
        f"the pixels of '{name}' have no codes, so it cannot be exposed",
        notes=(f"its code has the fields: {', '.join(fields)}",),
        helps=(
            f"add a statement such as `pixels {fields[0]} = ...` to the program",
            f"or give codes with --pixels CODES.npz, written by np.savez('CODES.npz', "
            f"{arrays}), integers ({target.rows}, {target.cols})",
        ),
    )


def program_text(source: object, folder: str | os.PathLike[str] | None) -> tuple[Source, Path]:
    """Return the text of a program, given as text or as the path of its file, and the folder of its
    data files.

    A str of one line that ends in .nsl is a path. `folder` is the folder of data files for a text,
    by default the current one. Raises WrongArgument for anything else, a compiled program, and a
    `folder` beside a file; Rejected if the file cannot be read or is no text."""
    if not isinstance(source, str | os.PathLike):
        raise wrong_argument(
            f"nscc.compile takes a program's path or its text, not {shown(source)}",
            helps=("a str that ends in .nsl is a path, any other the text of a program",),
        )
    # A single word without white space is more likely a mistyped path than a program.
    if isinstance(source, str) and ("\n" in source or not source.lower().endswith(_PATHS)):
        if source.strip() and not any(map(str.isspace, source.strip())):
            raise wrong_argument(
                f"nscc.compile: {shown(source)} is neither a program nor the path of one",
                notes=("a str is a path if it ends in .nsl, else the text of a program",),
            )
        base = Path() if folder is None else path_of("nscc.compile", folder)
        return Source("<text>", source), base
    path = path_of("nscc.compile", source)
    if is_compiled(path):
        raise wrong_argument(
            f"nscc.compile takes the text of a program, but '{path}' is compiled already",
            helps=(f"use nscc.load('{path}')",),
        )
    if folder is not None:
        raise wrong_argument(
            "nscc.compile: folder applies only to a program without a file",
            helps=("leave it out: paths in a program file are relative to the file",),
        )
    return read_source(path), path.parent
