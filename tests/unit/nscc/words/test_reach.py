"""How far pixels depend on others: the edge of the array, and values of pixels beside them."""

from __future__ import annotations

from fractions import Fraction
from itertools import product

import numpy as np
import pytest

from nscc.words.pictures import Weights
from nscc.words.reach import Reach

REACHES = [Reach(*sides) for sides in product((0, 1, 3), (0, 2), (0, 1, 5), (0, 4))]


@pytest.mark.parametrize("shape", [(7, 9), (3, 2), (1, 1)])
def test_the_margin_is_what_depends_on_pixels_that_are_not_there(shape: tuple[int, int]) -> None:
    rows, cols = shape
    for reach in REACHES:
        expected = [
            [
                x - reach.left < 0
                or x + reach.right >= cols
                or y - reach.up < 0
                or y + reach.down >= rows
                for x in range(cols)
            ]
            for y in range(rows)
        ]
        assert np.array_equal(reach.margin(shape), expected), reach


def test_a_value_from_a_pixel_away_depends_on_what_is_around_that_pixel() -> None:
    """The box around both, as long as the box still holds the pixel itself."""
    for reach in REACHES:
        for right, down in product((-4, -1, 0, 2), (-3, 0, 1)):
            columns = [right - reach.left, right + reach.right, 0]
            rows = [down - reach.up, down + reach.down, 0]
            expected = Reach(-min(columns), max(columns), -min(rows), max(rows))
            assert reach.moved(right, down) == expected
            assert reach.joined(expected) == Reach(*map(max, reach, expected))


@pytest.mark.parametrize("shape", [(1, 1), (3, 5), (5, 3), (7, 1), (1, 9)])
def test_the_middle_of_a_kernel_is_the_pixel_itself(shape: tuple[int, int]) -> None:
    """For kernels of odd sizes, tap (0, 0) is the middle weight divided by 4. The upper right
    weight is that of the pixel there."""
    weights = 1 + np.arange(shape[0] * shape[1]).reshape(shape)
    taps = Weights("k", tuple(map(tuple, weights.tolist())), 4).taps
    assert len(taps) == weights.size
    assert taps[0, 0] == Fraction(int(np.median(weights)), 4)
    assert taps[shape[1] // 2, -(shape[0] // 2)] == Fraction(int(weights[0, -1]), 4)
