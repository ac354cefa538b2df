"""The specification of a shutter class on a tile, without torch."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class ShutterSpec:
    """A shutter class with its number of slots and its tile.

    Parameters
    ----------
    kind : {"a", "b", "c", "d", "e", "codebook", "looks"}
    slots : int
        N.
    tile : tuple of int
        Rows and columns of the tile, or of the array for free codes; (1, looks) for looks.
    length : int, optional
        Length of the bump in slots, for class c.
    rows : int, optional
        Number of rows of a codebook.
    levels : int, optional
        Largest step of IN, for looks.
    buckets : int
        1 or 2. The second bucket collects the light in slots in which the first is closed.
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
        """Number of codes in the tile."""
        return self.tile[0] * self.tile[1]
