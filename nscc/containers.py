"""Containers, wherever they come from: an `.icw` file, or a program that is compiled now."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.compiler import compile_file
from nscc.diagnostics.diagnostic import Diagnostic
from nscc.diagnostics.rejection import rejected
from nscc.pipeline import Options
from nscc.program.analyse import ranges_of
from nscc.program.pixels import Ranges, codes_from_arrays, codes_from_file
from nscc.source import Source
from nscc.stream.planes import with_planes
from nscc.words.container import Container
from nscc.words.file import read_container

SUFFIX = ".icw"


def is_compiled(path: Path) -> bool:
    """Whether a file's name says that it holds words, and not the text of a program."""
    return path.suffix.lower() == SUFFIX


def load_container(
    path: Path, options: Options | None = None
) -> tuple[Container, tuple[Diagnostic, ...]]:
    """The container in an .icw file, or of a program that is compiled now; and its messages.

    `options` are the compiler's, for programs. Raises Rejected where a program does not compile or
    a file cannot be read.
    """
    if is_compiled(path):
        return read_container(path), ()
    compiled = compile_file(path, options)
    if compiled.container is None:  # only a search can tell, and the options let that pass
        raise ValueError(f"{path}: there are no words")
    return compiled.container, compiled.diagnostics


def with_pixels(
    container: Container,
    name: str | Path,
    pixels: Path | Mapping[str, NDArray[Any]] | None = None,
) -> Container:
    """The container with the codes of `pixels`, a file or arrays by field, or else with its own.

    `name` is what messages call it. Raises Rejected: NS0741 (status 2) if there are no codes at
    all, and what `codes_from_file` and `codes_from_arrays` find wrong.
    """
    target, fields = container.target, container.table.fields
    if pixels is not None:
        size = (container.table, target.rows, target.cols)
        mode, ranges = container.notes.get("codes", ""), partial(_ranges, container, Path(name))
        codes = (
            codes_from_file(pixels, *size, mode=mode, ranges=ranges)
            if isinstance(pixels, Path)
            else codes_from_arrays(pixels, *size, mode=mode, ranges=ranges)
        )
        return _laid(replace(container, pixel_codes=codes))
    if container.pixel_codes is not None:
        return container
    if not fields:
        everywhere = np.zeros((target.rows, target.cols), np.int32)
        return _laid(replace(container, pixel_codes=everywhere))
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


def _laid(container: Container) -> Container:
    """With the planes of its codes, for a chip that is sent some."""
    return with_planes(container) if container.target.streamed else container


def _ranges(container: Container, program: Path) -> Ranges:
    """The ranges of the fields, of the source that a container carries."""
    source = Source(program.name, "\n".join(container.source_lines))
    return ranges_of(source, container.target, program.parent)
