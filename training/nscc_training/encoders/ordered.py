"""Tiles of bumps that begin one after the other: starts of codes for clips, of every class.

A pixel tells the light of its bump, and its neighbours that of others. In the 2 x 2 pattern all
edges within the frame come at the same three moments; here they come at more of them.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nscc_training.encoders.base import Codes, ShutterSpec

_SIDE = 4
"""Rows and columns after which each of them repeats."""
_RANKS = np.array([[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]])
"""Bayer's order of 4 x 4 places: those of each 2 x 2 block of it are a quarter of all apart."""

Places = NDArray[np.int64]


def ordered(name: str, spec: ShutterSpec) -> Codes:
    """The codes of a tile as ORDERED names it, of bumps of the class's length or a quarter of the
    frame; of a codebook with its shapes as `book`. ValueError for classes and tiles without.

    `two-phase`: the 2 x 2 pattern, but in every other 2 x 2 block half a bump later, or as late as
    the frame allows. `staggered`: sixteen moments from the frame's begin to the last at which a
    bump fits. `cyclic`: sixteen moments around the frame; bumps that reach its end go on at its
    begin.
    """
    if spec.kind not in _CODES:
        raise ValueError(f"{name} is for bumps of clips, classes {', '.join(_CODES)}")
    if any(side % _SIDE for side in spec.tile):
        raise ValueError(f"{name} repeats after {_SIDE} x {_SIDE} places: a tile is a multiple of "
                         f"that, and not {spec.tile[0]} x {spec.tile[1]}")  # fmt: skip
    if name == "cyclic" and spec.kind in "cd":
        raise ValueError(f"bumps of class {spec.kind} end with the frame, those of cyclic go on "
                         "at its begin: class e and a codebook of 16 rows have them")  # fmt: skip
    length = spec.length or -(-spec.slots // 4)
    return _CODES[spec.kind](spec, _first(name, spec, length), length)


def _first(name: str, spec: ShutterSpec, length: int) -> Places:
    """The slot that each place of the tile opens in."""
    y, x = np.mgrid[: spec.tile[0], : spec.tile[1]]
    last = spec.slots - length
    if name == "two-phase":
        late = (y // 2 + x // 2) % 2 * (length // 2)
        first = np.minimum(np.rint((y % 2 * 2 + x % 2) * (last / 3)) + late, last)
    else:
        rank = _RANKS[y % _SIDE, x % _SIDE]
        around = name == "cyclic"
        first = rank * (spec.slots / _RANKS.size if around else last / (_RANKS.size - 1))
        first = np.floor(first + 0.5)
    return np.asarray(first, np.int64)


def _opened(spec: ShutterSpec, first: Places, length: int) -> NDArray[np.bool_]:
    """(N, rows, cols), around the frame's end."""
    n = np.arange(spec.slots).reshape(-1, 1, 1)
    return np.asarray((n - first) % spec.slots < length)


def _starts(_spec: ShutterSpec, first: Places, _length: int) -> Codes:
    return {"start": first}


def _edges(_spec: ShutterSpec, first: Places, length: int) -> Codes:
    return {"start": first, "stop": first + length}


def _bits(spec: ShutterSpec, first: Places, length: int) -> Codes:
    weights = np.int64(1) << np.arange(spec.slots, dtype=np.int64)
    return {"bits": np.einsum("n,nrc->rc", weights, _opened(spec, first, length).astype(np.int64))}


def _shapes(spec: ShutterSpec, first: Places, length: int) -> Codes:
    begins, row_of_place = np.unique(first, return_inverse=True)
    if spec.rows is None or len(begins) > spec.rows:
        raise ValueError(
            f"its {len(begins)} shutters are more than the codebook's {spec.rows} rows"
        )
    # Rows that no place needs repeat the others.
    begins = np.resize(begins, spec.rows)
    book = _opened(spec, begins[:, None], length)[..., 0].T
    return {"id": row_of_place.reshape(spec.tile), "book": book.astype(np.int64)}


_CODES = {"c": _starts, "d": _edges, "e": _bits, "codebook": _shapes}
