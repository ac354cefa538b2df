"""The specification of a shutter class on a tile, without torch."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class ShutterSpec:
    """A shutter class on a tile.

    Attributes
    ----------
    kind : str
        a, b, c, d, e, codebook or looks.
    slots : int
        N, slots per frame.
    tile : tuple of int
        Rows and columns of the tile that repeats over the array; for free codes the array itself.
        For looks (1, looks).
    length : int, optional
        Slots of a bump of class c.
    rows : int, optional
        Shapes of a codebook.
    levels : int, optional
        The largest step of IN, for looks.
    buckets : int
        With two, the second bucket gets the light that the shutters leave out.
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
