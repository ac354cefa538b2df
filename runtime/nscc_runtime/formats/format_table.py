"""The table of formats, and the check of file names before any work is done."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from types import SimpleNamespace
from typing import IO

import numpy as np

from nscc.diagnostics.diagnostic import rejected
from nscc.files import Product
from nscc_runtime.formats import pictures
from nscc_runtime.formats.content import Arrays, Content


def npz(content: Content) -> Product:
    """Return the function that writes an .npz file of `content`, such as `FrameFile.write` for a
    frame; without such a function, the bytes of a file of all arrays by name. Equal arrays give
    equal bytes, because no time is stored."""
    if content.write_npz is not None:
        return content.write_npz
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_STORED) as archive:
        for name, values in content.arrays.items():
            entry = io.BytesIO()
            np.lib.format.write_array(entry, np.asarray(values))
            archive.writestr(zipfile.ZipInfo(f"{name}.npy"), entry.getvalue())
    return stream.getvalue()


def npy(content: Content) -> Product:
    """Return a function that writes an .npy file of the main array of `content` (its `main()`, or
    its first array) to a stream, which may be a pipe."""
    first = content.main or (lambda: next(iter(content.arrays.values())))

    def write(file: IO[bytes]) -> None:
        """Write the main array to `file`."""
        # Hide the file's type from numpy, which would seek in it: pipes cannot seek.
        np.lib.format.write_array(SimpleNamespace(write=file.write), np.asarray(first()))

    return write


def mat(content: Content) -> bytes:
    """Return the bytes of a compressed MATLAB file (version 5) of the benchmark arrays of
    `content`, or of all its arrays without those. Raises what `content.benchmark` raises."""
    from scipy.io import savemat

    arrays: Arrays = content.arrays if content.benchmark is None else content.benchmark()
    stream = io.BytesIO()
    savemat(stream, dict(arrays), do_compression=True)
    # The header's text, 116 bytes, contains the time; replace it.
    head = b"MATLAB 5.0 MAT-file, written by nscc".ljust(116)
    return head + stream.getvalue()[116:]


@dataclass(frozen=True)
class Format:
    """A file format.

    `ending`: with the dot. `holds`: the kinds of content, "picture", "clip", "arrays" or "picture,
    clip". `write`: returns the bytes of a file, or a function that writes it. `shown`: it contains
    display pictures after a tone curve instead of light."""

    ending: str
    holds: str
    write: Callable[[Content], Product]
    shown: bool = False


FORMATS = {
    format_.ending: format_
    for format_ in (
        Format(".npz", "arrays", npz),
        Format(".npy", "arrays", npy),
        Format(".mat", "arrays", mat),
        Format(".hdr", "picture", pictures.hdr),
        Format(".exr", "picture", pictures.exr),
        Format(".pfm", "picture", pictures.pfm),
        Format(".tiff", "picture, clip", pictures.tiff),
        Format(".png", "picture", pictures.png, shown=True),
        Format(".gif", "clip", pictures.gif, shown=True),
        Format(".mp4", "clip", pictures.mp4, shown=True),
    )
}
"""Formats by ending. For names without ending (/dev/stdout), each command has a default."""


def endings(*kinds: str) -> tuple[str, ...]:
    """Return the endings of formats that hold one of `kinds` ("picture", "clip", "arrays"), in the
    order of the table; without kinds, all endings."""
    return tuple(
        ending
        for ending, format_ in FORMATS.items()
        if not kinds or any(kind in format_.holds for kind in kinds)
    )


def check_ending(path: Path, allowed: tuple[str, ...], product: str) -> str:
    """Return the lower-case ending of the file name `path`, or the first of `allowed` if it has no
    ending. `product` is what is written, for the message. Raises Rejected (NS0786) for an ending
    not in `allowed`."""
    ending = path.suffix.lower()
    if ending in allowed:
        return ending
    if not ending:
        return allowed[0]
    known = ", ".join(allowed)
    # The name of a file that exists may be that of the input.
    named = [path.with_name((path.stem or "name") + ending) for ending in allowed]
    free = next((name for name in named if not name.exists()), named[0])
    raise rejected(
        "NS0786",
        f"{product} cannot be written as '{path.name}': the ending '{path.suffix[:20]}' is "
        "not supported here",
        notes=(f"it can end in {known}" if len(allowed) > 1 else f"it ends in {known}",),
        helps=(f"name it {free.name}",),
        data={"endings": list(allowed)},
    )


def file_of(path: Path, content: Content, product: str) -> Product:
    """Return the bytes of an output file, or a function that writes it, in the format of the ending
    of `path`; without an ending, .npz. `product` is what is written, for messages. Raises Rejected
    (NS0786) for an unknown ending, or if its format cannot hold the content."""
    ending = check_ending(path, endings(), product)
    format_ = FORMATS[ending]
    lacks = content.lacks(format_.holds)
    if lacks is not None:
        kind = "clip" if content.moving else "picture"
        possible_endings = endings("arrays", *([kind] if content.light is not None else []))
        raise rejected(
            "NS0786",
            f"{product} cannot be written as '{path.name}': {lacks}",
            notes=(f"{ending} holds a {format_.holds.replace(', ', ' or a ')}",),
            helps=(f"use {', '.join(possible_endings)}",),
            data={"endings": list(possible_endings)},
        )
    return format_.write(content)
