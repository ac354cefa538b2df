"""Initial codes for clips: tiles of bumps with staggered starts, for every class.

A pixel measures the light of its bump, and its neighbours the light of other bumps. The 2 x 2
pattern has edges at three times within the frame; these tiles have edges at more times."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nscc_training.code_choices import RANKS
from nscc_training.encoders.base import Codes, ShutterSpec

_SIDE = 4
"""Rows and columns of the repeating tile."""

Places = NDArray[np.int64]


def ordered(name: str, spec: ShutterSpec) -> Codes:
    """Return the codes of a tile for the start `name`, one of ORDERED.

    Bumps have the length of the class, or a quarter of the frame. For a codebook, the item `book`
    contains the shapes. Raises ValueError for classes and tiles without such a start.

    `two-phase`: the 2 x 2 pattern, with every other 2 x 2 block later by half a bump, or by as much
    as the frame allows. `staggered`: sixteen start times from the beginning of the frame to the
    last at which a bump fits. `cyclic`: sixteen start times around the frame; a bump that reaches
    the end continues at the beginning."""
    if spec.kind not in _CODES:
        raise ValueError(f"{name} needs bumps for clips, classes {', '.join(_CODES)}")
    if any(side % _SIDE for side in spec.tile):
        raise ValueError(f"{name} repeats every {_SIDE} x {_SIDE} places: the tile must be a "
                         f"multiple of that, but is {spec.tile[0]} x {spec.tile[1]}")  # fmt: skip
    if name == "cyclic" and spec.kind in "cd":
        raise ValueError(f"bumps of class {spec.kind} end with the frame, but those of cyclic "
                         "continue at its start: use class e or a codebook of 16 rows")  # fmt: skip
    length = spec.length or -(-spec.slots // 4)
    return _CODES[spec.kind](spec, _first(name, spec, length), length)


def _first(name: str, spec: ShutterSpec, length: int) -> Places:
    """Return the slot in which each place of the tile opens."""
    y, x = np.mgrid[: spec.tile[0], : spec.tile[1]]
    last = spec.slots - length
    if name == "two-phase":
        late = (y // 2 + x // 2) % 2 * (length // 2)
        first = np.minimum(np.rint((y % 2 * 2 + x % 2) * (last / 3)) + late, last)
    else:
        rank = RANKS[y % _SIDE, x % _SIDE]
        around = name == "cyclic"
        first = rank * (spec.slots / RANKS.size if around else last / (RANKS.size - 1))
        first = np.floor(first + 0.5)
    return np.asarray(first, np.int64)


def _opened(spec: ShutterSpec, first: Places, length: int) -> NDArray[np.bool_]:
    """Return the shutters (N, rows, cols) of bumps that wrap around the end of the frame."""
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
            f"its {len(begins)} shutters do not fit into the codebook's {spec.rows} rows"
        )
    # Unused rows of the codebook repeat used ones.
    begins = np.resize(begins, spec.rows)
    book = _opened(spec, begins[:, None], length)[..., 0].T
    return {"id": row_of_place.reshape(spec.tile), "book": book.astype(np.int64)}


_CODES = {"c": _starts, "d": _edges, "e": _bits, "codebook": _shapes}
