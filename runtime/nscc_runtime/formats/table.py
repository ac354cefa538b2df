"""The one table of formats, and what refuses all others before any work is done."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from nscc.diagnostics.rejection import rejected
from nscc.files import Product
from nscc_runtime.formats import arrays, clips, pictures
from nscc_runtime.formats.content import Content


@dataclass(frozen=True)
class Format:
    """How names of a format end, what it `holds` (picture, clip, arrays), and what writes it.

    What is `shown` is not light but what a screen makes of it, by a tone curve.
    """

    ending: str
    holds: str
    write: Callable[[Content], Product]
    shown: bool = False


FORMATS = {
    format_.ending: format_
    for format_ in (
        Format(".npz", "arrays", arrays.npz),
        Format(".npy", "arrays", arrays.npy),
        Format(".mat", "arrays", arrays.mat),
        Format(".hdr", "picture", pictures.hdr),
        Format(".exr", "picture", pictures.exr),
        Format(".pfm", "picture", pictures.pfm),
        Format(".tiff", "picture, clip", pictures.tiff),
        Format(".png", "picture", pictures.png, shown=True),
        Format(".gif", "clip", clips.gif, shown=True),
        Format(".mp4", "clip", clips.mp4, shown=True),
    )
}
"""By ending. A name without an ending, such as /dev/stdout, gets a command's own format."""


def endings(*kinds: str) -> tuple[str, ...]:
    """The endings of the formats that hold one of these kinds; without kinds, all."""
    return tuple(
        ending
        for ending, found in FORMATS.items()
        if not kinds or any(kind in found.holds for kind in kinds)
    )


def check_ending(path: Path, allowed: tuple[str, ...], what: str) -> str:
    """The ending of a product's name, in lower case, the first of `allowed` where it has none.

    Raises Rejected (NS0786) for another one: nothing is written in a format that its name denies.
    """
    ending = path.suffix.lower()
    if ending in allowed:
        return ending
    if not ending:
        return allowed[0]
    known = ", ".join(allowed)
    raise rejected(
        "NS0786",
        f"{what} cannot be written as '{path.name}': no format ends in '{path.suffix[:20]}' here",
        notes=(f"it can end in {known}" if len(allowed) > 1 else f"it ends in {known}",),
        helps=(f"name it {path.stem or 'name'}{allowed[0]}",),
        data={"endings": list(allowed)},
    )


def file_of(path: Path, content: Content, what: str) -> Product:
    """What `path` is to hold; Rejected (NS0786) where its format cannot hold that."""
    ending = check_ending(path, endings(), what)
    found = FORMATS[ending]
    lacks = content.lacks(found.holds)
    if lacks is not None:
        kind = "clip" if content.moving else "picture"
        others = endings("arrays", kind) if content.light is not None else endings("arrays")
        raise rejected(
            "NS0786",
            f"{what} cannot be written as '{path.name}': {lacks}",
            notes=(f"{ending} holds a {found.holds.replace(', ', ' or a ')}",),
            helps=(f"use {', '.join(others)}",),
            data={"endings": list(others)},
        )
    if ending == ".npz" and content.whole is not None:
        return content.whole
    return found.write(content)
