"""Convolutional sparse coding: transposes, steps that converge, and what is not seen."""

from __future__ import annotations

import numpy as np
import pytest

torch = pytest.importorskip("torch")

from nscc_training.baselines.merge_loop import merged  # noqa: E402
from nscc_training.baselines.sparse_coding import (  # noqa: E402
    blurred,
    coded_still,
    largest_gain,
    made_filters,
    sparse_coded,
    spread,
    summed,
)


def test_sum_and_spread_are_transposes() -> None:
    """Both give the same inner product of maps and a picture, as a matrix and its transpose do."""
    generator = torch.Generator().manual_seed(1)
    filters = made_filters()
    maps = torch.rand((1, len(filters), 20, 23), generator=generator)
    picture = torch.rand((1, 1, 20, 23), generator=generator)
    left = (summed(maps, filters) * picture).sum()
    right = (maps * spread(picture, filters)).sum()
    assert float(left) == pytest.approx(float(right), rel=1e-4)


def test_filters_have_length_one_and_are_the_same_again() -> None:
    """The squares of each filter sum to 1. Made anew without the cache, the filters are equal."""
    filters = made_filters()
    assert torch.allclose(filters.square().sum(dim=(1, 2, 3)), torch.ones(len(filters)))
    made_filters.cache_clear()
    assert torch.equal(filters, made_filters())


def test_the_largest_gain_bounds_the_energy_of_the_operator() -> None:
    """No picture is amplified by more than the gain."""
    filters, mask = made_filters(), torch.ones(1, 1, 24, 24)
    gain = largest_gain(filters, mask)
    generator = torch.Generator().manual_seed(2)
    for _ in range(5):
        picture = torch.rand((1, 1, 24, 24), generator=generator) - 0.5
        assert float(spread(picture, filters).square().sum()) <= gain * float(
            picture.square().sum()
        )


def test_the_error_of_sparse_coding_falls_with_more_iterations() -> None:
    """With 0 iterations the error is that of the start. After 5 it is lower, and after 60 below a
    fifth of that."""
    rng = np.random.default_rng(3)
    seen = np.repeat(np.repeat(rng.random((8, 8)), 4, axis=0), 4, axis=1)
    coarse, ones = np.full((32, 32), 0.5), np.ones((32, 32))
    errors = [
        float(np.mean((sparse_coded(coarse, seen, ones, made_filters(), n, 1e-3) - seen) ** 2))
        for n in (0, 5, 60)
    ]
    assert errors[0] == pytest.approx(float(np.mean((0.5 - seen) ** 2)), rel=1e-4)
    assert errors[2] < 0.2 * errors[1] < 0.2 * errors[0]


def test_without_confidence_the_coarse_picture_is_left() -> None:
    coarse = np.random.default_rng(4).random((24, 24))
    found = sparse_coded(coarse, np.zeros((24, 24)), np.zeros((24, 24)), made_filters(), 5)
    wanted = blurred(torch.from_numpy(coarse).float()[None, None])[0, 0].numpy()
    np.testing.assert_allclose(found, wanted, atol=1e-6)


def test_sparse_coding_has_less_error_at_edges_than_merging() -> None:
    light = np.full((48, 48), 2000.0)
    light[:, 24:] = 90000.0
    light[20:28] = 300.0
    stops = np.random.default_rng(5).integers(1, 65, (8, 8))
    share = np.tile(stops / 64, (6, 6))
    epl = 30000 / 255
    frame = np.clip(np.rint(light * share / epl), 0, 255).astype(np.float32)
    coarse = merged(frame, share, epl, frame >= 255, 76.0)
    found = coded_still(frame, share, coarse, epl, frame >= 255, 30000.0)
    errors = [
        float(np.mean((np.sqrt(np.maximum(x, 0)) - np.sqrt(light)) ** 2)) for x in (coarse, found)
    ]
    assert errors[1] < errors[0]
    assert np.isfinite(found).all()


def test_dark_codes_below_the_offset_are_finite() -> None:
    """Codes minus the converter's offset may be negative; a small code has little noise."""
    codes = np.random.default_rng(2).integers(-3, 40, (16, 16)).astype(np.float32)
    share, full = np.tile([[1.0, 0.25], [0.5, 0.125]], (8, 8)), np.zeros((16, 16), bool)
    coarse = merged(codes, share, 0.5, full, 0.1)
    low, high = (codes * 0.5 / share).min(), (codes * 0.5 / share).max()
    assert ((low <= coarse) & (coarse <= high)).all()
    light = coded_still(codes, share, coarse, 0.5, full, 100.0, iterations=2)
    assert np.isfinite(light).all()
