"""Classes of codes on a tile, names of initial codes and of training methods, without torch."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from nscc.arrays import Array, Bools, Ints

ORDERED = ("two-phase", "staggered", "cyclic")
"""Names of initial codes with staggered bumps (`nscc_training.encoders.encoder_classes`)."""
YARDSTICKS = ("rows", "checker", "overlapping-rows")
"""Names of hand-made codes with two bumps, with which learned codes are compared
(`nscc_training.encoders.encoder_classes`)."""
SCATTERED = ("poisson-disc", "non-adjacent")
"""Names of initial codes in which equal exposure times are far apart
(`nscc_training.encoders.encoder_classes`)."""
RANKS = np.array([[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]])
"""Bayer matrix: the order of 4 x 4 places."""
LOOKS = "looks"
"""The class of pixels that close at the first look above a level.

Its shutters are represented by fields (2 looks, rows, cols), boundaries followed by levels, because
the open time depends on the light (`nscc_training.looking_model`)."""
STARTS = ("random", "uniform", "quad", *ORDERED, *YARDSTICKS, *SCATTERED)

SLOPED = ("straight-through", "sigmoid", "gumbel")
"""Relaxations that pass gradients through the quantisation."""

ARRANGE = "arrange"
SEARCHED = ("search", ARRANGE)
"""Relaxations that propose codes and accept one by its measured loss."""
RELAXATIONS = (*SLOPED, "tried", *SEARCHED)
"""Methods of learning codes.

`straight-through` uses hard shutters in the forward pass and a surrogate slope in the backward
pass. `sigmoid` uses soft shutters in the forward pass, with a temperature that a schedule lowers.
`gumbel` (codebooks; `sigmoid` for other classes) uses soft shapes and a random soft choice of them.
`tried` uses hard shutters without a gradient; the loop tries other codes around them
(`nscc_training.loop.steps`). `search` moves many places of a code together; the decoder, which
is not trained meanwhile, compares the results (`nscc_training.loop.searching`). `arrange` is a
search that gives the initial shutters other places, and changes none of them."""


@dataclass(frozen=True)
class ShutterSpec:
    """A class of shutters (the rule that opens a pixel by its code), with its number of slots and
    its tile (the small array of codes that is repeated over the sensor).

    Parameters
    ----------
    kind : {"a", "b", "c", "d", "e", "codebook", "looks"}
        a: always open; b: open until a stop; c: a bump (consecutive open slots) of fixed length;
        d: a bump of any length; e: free bits; codebook: rows of a table; looks: closed at the
        first
        look at which the light exceeds a level.
    slots : int
        Number N of slots of a frame.
    tile : tuple of int
        Rows and columns of the tile, or of the array for free codes; (1, looks) for looks.
    length : int, optional
        Length of the bump in slots, for class c.
    rows : int, optional
        Number of rows of a codebook.
    levels : int, optional
        Largest step of IN, the chip's analog input that sets levels, for looks.
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


def bits_of(opened: Bools) -> Ints:
    """Return shutters (slots, rows, cols) as codes of class e, int64 (rows, cols): bit n is slot
    n."""
    weights = np.int64(1) << np.arange(len(opened), dtype=np.int64)
    return np.asarray(np.einsum("n,nrc->rc", weights, opened.astype(np.int64)))


def opened_by_bits(bits: Ints, slots: int) -> Bools:
    """Return the shutters (slots, rows, cols) of codes of class e (rows, cols), as `bits_of` takes
    them."""
    return np.asarray(bits >> np.arange(slots, dtype=np.int64).reshape(-1, 1, 1) & 1, np.bool_)


def over_array(tile: Array, rows: int, cols: int) -> Array:
    """Return a tile (.., r, c), repeated from the top left corner over an array, and cut to (..,
    rows, cols). A tile larger than the array is only cut."""
    repeats = (-(-rows // tile.shape[-2]), -(-cols // tile.shape[-1]))
    return np.tile(tile, (1,) * (tile.ndim - 2) + repeats)[..., :rows, :cols]
