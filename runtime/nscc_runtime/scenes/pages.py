"""The pictures of a file, the properties that it states, and the limits of their size."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from fractions import Fraction
from math import prod
from pathlib import Path
from typing import Any

from nscc.arrays import Array, Floats
from nscc.diagnostics.diagnostic import rejected
from nscc_runtime.scenes.colour import Colours

MOST_PIXELS = 1 << 26
"""Largest number of pixels of a picture or of a frame of a clip: 8192 x 8192, 67 million."""

MOST_LARGE_PIXELS = 3 * MOST_PIXELS
"""Largest number of pixels of a scene that is one picture of 8 bits per sample: 201 million."""

_HEAD_BYTES = 1 << 16
"""Number of bytes at the start of a file in which a format is recognised."""

Note = tuple[str, str]
"""A sentence about a file, without its name, and a remedy."""

Edges = tuple[Fraction, ...] | None
"""Starts of a clip's frames, and its end, in steps of equal length; None if every frame lasts one
step. Frame k lasts from entry k to entry k + 1."""


@dataclass(frozen=True)
class Stated:
    """The colours that a file states, None if it states none that can be used, and notes about
    them."""

    colours: Colours | None = None
    notes: tuple[Note, ...] = ()


@dataclass(frozen=True)
class Pages:
    """The `count` pictures of a file, decoded only while `read` is iterated.

    `sizes`: rows and columns of the pictures by the head of the file, the first picture first.
    `read` yields each picture as stored, (R, C) grey or (R, C, 3) red, green, blue. `stated`: the
    colours that the file states. `notes`: unexpected choices of the reader. `durations_s` returns
    the durations of the pictures in seconds; None if the file has no clock. `edges`: the starts of
    frames that last unequally (see `timing`). `is_clip`: whether the file is a clip even if it
    has one picture. `is_light`: whether samples are linear light unless the file states otherwise.
    `has_8_bits`: whether samples have at most 8 bits."""

    sizes: tuple[tuple[int, int], ...]
    count: int
    read: Callable[[], Iterator[Array]]
    stated: Stated = Stated()
    notes: tuple[Note, ...] = ()
    durations_s: Callable[[], Floats] | None = None
    edges: Edges = None
    is_clip: bool = False
    is_light: bool = False
    has_8_bits: bool = False

    @property
    def colours(self) -> Colours:
        """The colours of the file, or else those of its format: linear light, or sRGB."""
        return self.stated.colours or Colours.of("linear" if self.is_light else "srgb")


def head_of(path: Path) -> bytes:
    """Return the first 65536 bytes of the file `path`, or all if there are fewer. Raises OSError if
    it cannot be read."""
    with open(path, "rb") as file:
        return file.read(_HEAD_BYTES)


class UnsupportedPicture(Exception):
    """An intact file of a kind that nscc does not decode. Its arguments are two texts: the reason,
    which says what it has, and what to do."""


def check_sizes(path: Path, pages: Pages, large: bool) -> None:
    """Raise Rejected (NS0734) if a picture of the file `path` has more than MOST_PIXELS, by the
    sizes that `pages` states.

    With `large`, a file of a single picture of 8 bits per sample may have MOST_LARGE_PIXELS."""
    rows, cols = max(pages.sizes, key=prod)
    admits_more = large and pages.has_8_bits and pages.count == 1
    most = MOST_LARGE_PIXELS if admits_more else MOST_PIXELS
    if rows * cols > most:
        help_text = "reduce or crop the picture"
        if large and not admits_more:
            allowed = f"{MOST_LARGE_PIXELS:,} pixels"
            help_text += f"; a single picture with 8 bits per sample may have {allowed}"
        raise rejected(
            "NS0734",
            f"'{path}' has {rows:,} x {cols:,} pixels, but at most {most:,} are allowed",
            helps=(help_text,),
        )


@contextmanager
def opened_by_pillow(path: Path) -> Iterator[Any]:
    """Open the file `path` by Pillow for a with block. Its limit on pixels, of the whole process,
    is off meanwhile: `check_sizes` applies the limits."""
    from PIL import Image

    pillow_limit, Image.MAX_IMAGE_PIXELS = Image.MAX_IMAGE_PIXELS, None
    try:
        with Image.open(path) as image:
            yield image
    finally:
        Image.MAX_IMAGE_PIXELS = pillow_limit
