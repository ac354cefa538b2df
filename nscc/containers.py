"""Loading of containers from `.icw` files or by compiling programs."""

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
from nscc.program.pixel_codes import Ranges, codes_from_arrays, codes_from_file
from nscc.source import Source
from nscc.stream.planes import with_planes
from nscc.words.container import Container
from nscc.words.file import read_container

SUFFIX = ".icw"


def is_compiled(path: Path) -> bool:
    """Return whether a file name is the name of a container, not of a program text."""
    return path.suffix.lower() == SUFFIX


def load_container(
    path: Path, options: Options | None = None
) -> tuple[Container, tuple[Diagnostic, ...]]:
    """Read an `.icw` file, or compile a program with `options`; return container and messages.

    Raises Rejected if a program does not compile or a file cannot be read."""
    if is_compiled(path):
        return read_container(path), ()
    compiled = compile_file(path, options)
    if compiled.container is None:  # undecided programs pass here
        raise ValueError(f"{path}: there are no words")
    return compiled.container, compiled.diagnostics


def with_pixels(
    container: Container,
    name: str | Path,
    pixels: Path | Mapping[str, NDArray[Any]] | None = None,
) -> Container:
    """Return the container with the pixel codes of `pixels` (a file, or arrays by field), or its
    own.

    Messages call the container `name`. Raises Rejected: NS0741 (status 2) if there are no codes,
    and the errors of `codes_from_file` and `codes_from_arrays`."""
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
    """Add the bit planes of the pixel codes, for a chip without logic."""
    return with_planes(container) if container.target.streamed else container


def _ranges(container: Container, program: Path) -> Ranges:
    """Return the ranges of the fields in the source text that a container includes."""
    source = Source(program.name, "\n".join(container.source_lines))
    return ranges_of(source, container.target, program.parent)
