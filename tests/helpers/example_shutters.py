"""The shutters of the examples, written down a second time, from what their comments promise.

Nothing here reads an `.nsl` file: a wrong example is found as well as a wrong compiler.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Grid = NDArray[np.int64]
Shutter = NDArray[np.bool_]
Rule = Callable[[Grid, Grid, Grid], tuple[Shutter, ...]]
"""(n, y, x), broadcast against each other, to S[n] of every pixel in every bucket."""

_WALSH = ("1" * 32, "10" * 16, "1100" * 8, "1001" * 8)


def shutters_of(example: str, slots: int, rows: int, cols: int) -> Shutter:
    """S (buckets, rows, cols, N) of an example."""
    y, x, n = np.ogrid[:rows, :cols, :slots]
    shape = (rows, cols, slots)
    return np.stack([np.broadcast_to(open_, shape) for open_ in RULES[example](n, y, x)])


def _picked(rows: list[list[int]], y: Grid, x: Grid) -> Grid:
    tile = np.array(rows)
    return tile[y % tile.shape[0], x % tile.shape[1]]


def class_a(n: Grid, y: Grid, x: Grid) -> tuple[Shutter, ...]:
    return (n >= 0,)


def class_b(n: Grid, y: Grid, x: Grid) -> tuple[Shutter, ...]:
    return (n <= (21 * (x % 8) + 8 * (y % 8)) % 64,)


def class_b_4096(n: Grid, y: Grid, x: Grid) -> tuple[Shutter, ...]:
    return (n < 64 + 64 * ((9 * (x % 8) + 8 * (y % 8)) % 64),)


def class_c(n: Grid, y: Grid, x: Grid) -> tuple[Shutter, ...]:
    since = n - (8 * x + 16 * y) % 57
    return ((since >= 0) & (since < 8),)


def class_d(n: Grid, y: Grid, x: Grid) -> tuple[Shutter, ...]:
    start = (x % 8 + 4 * (y % 4)) % 32
    stop = 33 + (x % 8) * (y % 4) % 32
    return ((n >= start) & (n < stop),)


def class_e(n: Grid, y: Grid, x: Grid) -> tuple[Shutter, ...]:
    return ((2917 * x + 4421 * y) % 8192 // 2**n % 2 == 1,)


def codebook(n: Grid, y: Grid, x: Grid) -> tuple[Shutter, ...]:
    book = np.array([[digit == "1" for digit in row] for row in _WALSH])
    return (book[_picked([[0, 1], [2, 3]], y, x), n],)


def flutter(n: Grid, y: Grid, x: Grid) -> tuple[Shutter, ...]:
    return (n // 4 == (5 * (x % 4) + 12 * (y % 4)) % 16,)


def foveated(n: Grid, y: Grid, x: Grid) -> tuple[Shutter, ...]:
    middle = (x - 128) ** 2 + (y - 128) ** 2 < 72**2
    return (~middle | (n < 8),)


def hdr_2x2(n: Grid, y: Grid, x: Grid) -> tuple[Shutter, ...]:
    return (n < _picked([[256, 64], [16, 4]], y, x),)


def hdr_doubling(n: Grid, y: Grid, x: Grid) -> tuple[Shutter, ...]:
    return (n <= (x + 3 * y) % 8,)


def modulated(n: Grid, y: Grid, x: Grid) -> tuple[Shutter, ...]:
    even = (n + 2 * _picked([[0, 1], [2, 3]], y, x)) % 8 < 4
    return (even, ~even)


def skip_one(n: Grid, y: Grid, x: Grid) -> tuple[Shutter, ...]:
    return ((n <= (x + y) % 8) & (n != (3 * x + 5 * y) % 8),)


def two_buckets(n: Grid, y: Grid, x: Grid) -> tuple[Shutter, ...]:
    early = n < np.where(x % 2 == 0, 16, 48)
    return (early, ~early)


_DIGITS = (
    "1100111101101000",
    "1001101100101011",
    "0010100100001001",
    "0111010101011000",
    "0101000000111110",
    "1110001001010000",
    "0111100110101101",
    "1111000000000111",
)


def coded_two_buckets(n: Grid, y: Grid, x: Grid) -> tuple[Shutter, ...]:
    digits = np.array([[digit == "1" for digit in row] for row in _DIGITS])
    ones = digits[(x + 3 * y) % 8, n]
    return (ones, ~ones)


_EXPOSURES = "51753863 23621457 85437214 12615672 47382483 35643127 41817465 47352534"


def deblur(n: Grid, y: Grid, x: Grid) -> tuple[Shutter, ...]:
    return (n < _picked([[int(digit) for digit in row] for row in _EXPOSURES.split()], y, x),)


def staggered(n: Grid, y: Grid, x: Grid) -> tuple[Shutter, ...]:
    phase = 5 * (x % 4 + 4 * (y % 4)) % 8
    return (((n >= phase) & (n < phase + 4)) | (n < phase - 4),)


_PHASES = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]]


def two_readouts(n: Grid, y: Grid, x: Grid) -> tuple[Shutter, ...]:
    since = n - _picked(_PHASES, y, x)
    return (n >= 0, ((since >= 0) & (since < 4)) | (since < -12))


def three_readouts(n: Grid, y: Grid, x: Grid) -> tuple[Shutter, ...]:
    since = n - _picked([[0, 3], [4, 1]], y, x)
    return (n >= 0, (since >= 0) & (since < 4), (since >= 8) & (since < 12))


def four_readouts(n: Grid, y: Grid, x: Grid) -> tuple[Shutter, ...]:
    quarter = (n - _picked([[0, 2], [3, 1]], y, x)) // 4
    return (n >= 0, quarter == 0, quarter == 1, quarter == 2)


_SEARCHED = """
    51168  3198 64536 12792 61539 64536 12792 61539 31752 36801 33039 16134  1086 33567  7938  3198
    33567 63537 25584 57543 36801 25584 49551 53217 61539 16134  3198 64536 12792  3198 64536 12792
     1599 49287  3969   543 16134 36801 33567 16134 36801  4344 61473 17376 57543 63537 25584 57543
    63504  7938  1086 32268  6396  1599 32268  7422  1599 61539 51168 49551  8067 51168 49551  8067
"""


def searched_bits(n: Grid, y: Grid, x: Grid) -> tuple[Shutter, ...]:
    bits = np.array(_SEARCHED.split(), np.int64).reshape(8, 8)[y % 8, x % 8]
    return (bits // 2**n % 2 == 1,)


RULES: dict[str, Rule] = {
    rule.__name__: rule
    for rule in (
        *(class_a, class_b, class_b_4096, class_c, class_d, class_e),
        *(codebook, coded_two_buckets, deblur, flutter, foveated, hdr_2x2, hdr_doubling, modulated),
        *(searched_bits, skip_one, staggered, two_buckets),
        *(two_readouts, three_readouts, four_readouts),
    )
}
"""By the example's name."""
