"""Place pictures of any size on arrays: cropped, scaled, or in pieces.

With `scale` and `tiles` the frame has the size of the picture, which lies in the top left corner of
as many arrays as needed, side by side. The remaining pixels see its mirror image, and are cut off
afterwards."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import prod

import numpy as np

from nscc.arrays import Array, Floats, Floats32
from nscc.diagnostics.diagnostic import Diagnostic, Severity, rejected
from nscc.mappings import JsonObject
from nscc.words.container import Container
from nscc_runtime.light import Light
from nscc_runtime.scene_settings import Fit, Scene
from nscc_runtime.scenes.colour import Colours, white_of
from nscc_runtime.scenes.errors import Path_or_name, size

MOST_PIXELS = 1 << 26
"""Largest number of pixels of a picture in pieces: a frame needs about 30 bytes per pixel."""


@dataclass(frozen=True)
class Window:
    """The size (rows, cols) of the array, and the position (row, column) of its top left corner in
    pictures.

    If `corner` is None, the array is centred."""

    array: tuple[int, int]
    corner: tuple[int, int] | None = None

    def place(self, have: tuple[int, int], name: Path_or_name) -> tuple[slice, slice]:
        """Return the rows and the columns that the array takes from the picture `name` of size
        `have` (rows, cols).

        If the margins of a centred window cannot be equal, the smaller ones are above and to the
        left. Raises Rejected (NS0734) if the window does not fit."""
        rows, cols = self.array
        down, across = have[0] - rows, have[1] - cols
        sizes = {"scene": list(have), "array": list(self.array)}
        if min(down, across) < 0:
            raise rejected(
                "NS0734",
                f"the scene '{name}' is {size(have)}, smaller than the array of {size(self.array)}",
                notes=(
                    "sizes are rows x columns; without --fit pictures are cropped but not scaled",
                ),
                helps=("use a larger picture, `--fit scale`, or a target with a smaller array",),
                data=sizes,
            )
        row, col = self.corner or (down // 2, across // 2)
        if not (0 <= row <= down and 0 <= col <= across):
            raise rejected(
                "NS0734",
                f"--crop {row},{col} puts the array of {size(self.array)} outside the scene "
                f"'{name}' of {size(have)}",
                notes=("--crop R,C is the row and column of the top left corner",),
                helps=(f"R may be 0 to {down} here, C 0 to {across}",),
                data={**sizes, "crop": [row, col]},
            )
        return slice(row, row + rows), slice(col, col + cols)


def parse_crop(text: str | tuple[int, int] | None) -> tuple[int, int] | None:
    """Parse `R,C` as two whole numbers from 0, each of at most nine digits, possibly with spaces.
    Raises Rejected (NS0739) for other texts.

    A parsed corner (row, column), or None, is returned unchanged."""
    if not isinstance(text, str):
        return text
    numbers = text.split(",")
    if len(numbers) == 2 and all(p.strip().isdecimal() and len(p.strip()) < 10 for p in numbers):
        return int(numbers[0]), int(numbers[1])
    raise rejected(
        "NS0739",
        f"invalid corner '{text[:60]}' for --crop",
        notes=("--crop R,C: the row and column of the top left corner, from 0",),
        helps=("for instance --crop 120,300",),
    )


@dataclass(frozen=True)
class Placement:
    """The placement of a picture on arrays.

    `fit`: "crop", "scale" or "tiles". `picture` (R, C): size as stored. `size` (rows, cols): size
    as exposed. `array` (rows, cols): size of each array.

    `overlap`: ((top, bottom), (left, right)), the numbers of rows and columns at the sides of an
    array that the picture takes from the neighbouring array instead. Overlapping arrays end where
    the picture ends; other arrays may extend beyond it."""

    fit: Fit
    picture: tuple[int, int]
    size: tuple[int, int]
    array: tuple[int, int]
    overlap: tuple[tuple[int, int], tuple[int, int]] = ((0, 0), (0, 0))

    @property
    def arrays(self) -> tuple[int, int]:
        """Numbers of arrays, down and across."""
        return len(self._starts(0)), len(self._starts(1))

    def _starts(self, axis: int) -> list[int]:
        """Return the first row (`axis` 0) or column (`axis` 1) of each array in the picture; one
        entry or more."""
        size, array, shared = self.size[axis], self.array[axis], sum(self.overlap[axis])
        starts = range(0, max(1, size - shared), array - shared)
        if not shared:
            return list(starts)
        # The last array is moved back to end with the picture; a picture smaller than it begins at
        # 0.
        return [min(start, max(0, size - array)) for start in starts]

    def _used(self, axis: int) -> list[slice]:
        """Return the rows (`axis` 0) or columns (`axis` 1) that the picture takes from each array,
        counted in the array."""
        starts = self._starts(axis)
        firsts = [0, *(start + self.overlap[axis][0] for start in starts[1:])]
        ends = [*firsts[1:], self.size[axis]]
        return [
            slice(first - start, end - start)
            for start, first, end in zip(starts, firsts, ends, strict=True)
        ]

    @property
    def fits_one_array(self) -> bool:
        """Whether the exposed picture has the size of one array."""
        return self.size == self.array

    def cut(self, values: Array) -> Array:
        """Return the part of `values` (.., rows, cols) that belongs to the picture: its top left
        corner of size `size`. Their rows and columns are those of all arrays side by side."""
        return values[..., : self.size[0], : self.size[1]]

    def pieces(self, light: Light) -> list[Light]:
        """Return the light of the picture cut into arrays, row by row and from left to right in a
        row. `light` is that of all arrays side by side."""
        if self.fits_one_array:
            return [light]
        rows, cols = self.array
        return [
            light.part(slice(top, top + rows), slice(left, left + cols))
            for top in self._starts(0)
            for left in self._starts(1)
        ]

    def joined(self, pieces: list[Array]) -> Array:
        """Return the picture of values (.., rows, cols). `pieces` are those of each array, row by
        row and from left to right in a row; overlaps and margins are cut off."""
        if len(pieces) == 1:
            return self.cut(pieces[0])
        parts = iter(pieces)
        bands = (
            np.concatenate([next(parts)[..., rows, cols] for cols in self._used(1)], axis=-1)
            for rows in self._used(0)
        )
        return np.concatenate([*bands], axis=-2)

    def repeated(self, values: Array) -> Array:
        """Return the `values` of an array (.., rows, cols), repeated on every array, at the pixels
        of the picture."""
        return np.ascontiguousarray(self.joined([values] * prod(self.arrays)))

    def widened(self, container: Container) -> Container:
        """Return a copy of `container` with the codes of every pixel of the picture; the container
        itself if it has no codes of pixels, or if one array is enough. A container is a compiled
        program."""
        if container.pixel_codes is None or self.fits_one_array:
            return container
        return replace(container, pixel_codes=self.repeated(container.pixel_codes))

    def as_json(self) -> JsonObject:
        """Return the entry in a frame file's meta: `fit`, and as lists of rows and columns
        `picture` (size as stored) and `arrays` (numbers of arrays)."""
        return {"fit": self.fit, "picture": list(self.picture), "arrays": list(self.arrays)}


def placement_of(
    fit: Fit, picture: tuple[int, int], window: Window, name: Path_or_name
) -> Placement:
    """Return where the picture `name` of size `picture` (rows, cols) lies on arrays of the size of
    `window`.

    By `fit` it is cropped to one array ("crop"), spread over several ("tiles"), or scaled with its
    aspect kept to fit into one ("scale"), also enlarged. Raises Rejected (NS0734) if it has too
    many pixels for tiles. Whether a crop fits is checked by `Window.place`."""
    array = window.array
    if fit == "crop":
        return Placement(fit, picture, array, array)
    if fit == "tiles":
        if prod(picture) > MOST_PIXELS:
            raise rejected(
                "NS0734",
                f"the scene '{name}' is {size(picture)}, which is too large for --fit tiles",
                notes=(f"the limit is {MOST_PIXELS} pixels",),
                helps=("--fit scale exposes the whole picture, reduced to the array",),
            )
        return Placement(fit, picture, picture, array)
    factor = min(array[0] / picture[0], array[1] / picture[1])
    rows, cols = (
        min(most, max(1, round(side * factor))) for side, most in zip(picture, array, strict=True)
    )
    return Placement(fit, picture, (rows, cols), array)


def placed(light: Floats, placement: Placement) -> Floats32:
    """Return the light of a picture on all arrays side by side, (rows, cols). `light` (rows, cols)
    is scaled to `placement.size` if it has another size. The mirror image of the picture fills what
    remains to the right and below."""
    exposed = light.astype(np.float32)
    if exposed.shape != placement.size:
        import cv2

        smaller = placement.size[0] <= light.shape[0] and placement.size[1] <= light.shape[1]
        how = cv2.INTER_AREA if smaller else cv2.INTER_LINEAR
        resized = cv2.resize(exposed, placement.size[::-1], interpolation=how)
        exposed = np.asarray(resized, np.float32)
    (rows, cols), (down, across) = placement.array, placement.arrays
    margin = [(0, down * rows - exposed.shape[0]), (0, across * cols - exposed.shape[1])]
    return np.pad(exposed, margin, mode="symmetric")


def in_colour(stored: Array) -> bool:
    """Return whether the picture `stored`, (R, C) or (R, C, 3), has a pixel that is not grey."""
    # Row by row, because a mask of a whole picture takes much memory.
    return stored.ndim == 3 and any((row != row[:, :1]).any() for row in stored)


def changes(
    scene: Scene, stored: Array, colours: Colours, placement: Placement, colour: bool
) -> Iterator[Diagnostic]:
    """Yield notes (NS0773) on how the picture `stored` of `scene` was cut, scaled or turned grey to
    fit the array by `placement`, and on the curve and white level that were assumed for `colours`.

    `colour`: whether it is in colour. The note on colours has the entry `grey` in its `data`, by
    which `laid_lights` leaves it out."""
    name, picture, array = scene.name, size(placement.picture), size(placement.array)
    if placement.fit == "crop" and placement.picture != placement.size:
        share = prod(placement.size) / prod(placement.picture)
        yield picture_note(
            f"'{name}' is {picture}, the array {array}: {share:.2g} of the picture is exposed",
            "--fit scale exposes the whole picture, reduced; --fit tiles exposes all of it "
            "in parts; --crop R,C selects the part",
        )
    elif placement.fit == "scale" and placement.picture != placement.size:
        text = f"'{name}' is {picture}, and is exposed as {size(placement.size)}"
        yield picture_note(text, "--fit tiles exposes every pixel of it, in parts")
    elif placement.fit == "tiles" and placement.arrays != (1, 1):
        text = f"'{name}' is {picture}: it is exposed in parts of {array}"
        yield picture_note(text, "--fit scale exposes it at once, reduced")
    if colour:
        text = f"'{name}' is in colour: its luminance is exposed"
        note = picture_note(text, "--color exposes red, green and blue one after the other")
        yield replace(note, data={"grey": True})
    kind = stored.dtype
    if scene.transfer is None and colours.transfer == "srgb" and kind.kind == "f":
        yield picture_note(
            f"the numbers of '{name}' are treated as sRGB, with white at 1",
            "--transfer linear treats them as linear light",
        )
    # Such as 12-bit samples in 16 bits, which use at most a quarter of their range.
    deep = kind.kind in "ui" and kind.itemsize > 1
    if scene.white is None and deep and int(stored.max()) <= int(np.iinfo(kind).max) // 4:
        curve = Colours.of(scene.transfer or colours).text
        yield picture_note(
            f"the samples of '{name}' are converted with {curve} and white at {white_of(kind):g}; "
            f"the largest is {stored.max():g}",
            "--white W sets the sample value of white, such as --white 4095 for 12 bits",
        )


def picture_note(text: str, help_text: str) -> Diagnostic:
    """Return the note NS0773 on the treatment of a picture: `text` is the message and `help_text`
    the remedy."""
    return Diagnostic("NS0773", text, severity=Severity.NOTE, helps=(help_text,))
