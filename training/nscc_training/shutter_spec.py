"""A shutter class on a grid, known without torch."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class ShutterSpec:
    """A shutter class on a grid.

    `kind` is a, b, c, d, e, codebook or looks; `slots` N; `tile` (rows, cols) repeats over the
    array, and is the array itself for free codes. `length` is the bump of class c, `rows` the
    number of a codebook's shapes. Of looks the tile is (1, looks), `levels` the largest step of IN.
    With two `buckets` the second has the light that the shutters leave out.
    """

    kind: str
    slots: int
    tile: tuple[int, int]
    length: int | None = None
    rows: int | None = None
    levels: int | None = None
    buckets: int = 1

    @property
    def places(self) -> int:
        """Codes in a tile."""
        return self.tile[0] * self.tile[1]
