"""Windows of free codes: a patch meets any part of the array's shutters, and all parts alike."""

from __future__ import annotations

import pytest

torch = pytest.importorskip("torch")

from nscc_training.loop.steps import window  # noqa: E402


def test_a_patch_of_at_least_the_tiles_size_gets_the_whole_tile() -> None:
    """A tile of 4 x 4 and a patch of 8 x 8 or 4 x 4 give the tile itself, uncut."""
    tile = torch.arange(2 * 4 * 4).reshape(2, 4, 4)
    assert window(tile, 8, 8, (1,)) is tile
    assert window(tile, 4, 4, (1,)) is tile


@pytest.mark.parametrize(("rows", "cols"), [(9, 5), (4, 9), (9, 9)])
def test_windows_of_a_larger_array_begin_at_every_possible_corner(rows: int, cols: int) -> None:
    shutters = torch.arange(rows * cols).reshape(1, rows, cols)
    height, width = min(rows, 4), min(cols, 5)
    corners = set()
    for seed in range(400):
        part = window(shutters, 4, 5, (seed, 1))
        assert part.shape == (1, height, width)
        row, col = divmod(int(part[0, 0, 0]), cols)
        assert torch.equal(part, shutters[:, row : row + height, col : col + width])
        corners.add((row, col))
    assert corners == {
        (row, col) for row in range(rows - height + 1) for col in range(cols - width + 1)
    }
