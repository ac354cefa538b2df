"""Keys and uniform numbers: the published hash, its range, and no sign of a pattern."""

from __future__ import annotations

import math

import numpy as np
import pytest
from noise_oracle import uniform_of
from scipy import stats

from nscc_runtime.noise import key, normals, uniforms
from nscc_runtime.noise.keys import philox, unit

# Counter, key and result, from the file kat_vectors of the authors' library Random123.
KNOWN = (
    (
        "00000000 00000000 00000000 00000000",
        "00000000 00000000",
        "6627e8d5 e169c58d bc57ac4c 9b00dbd8",
    ),
    (
        "ffffffff ffffffff ffffffff ffffffff",
        "ffffffff ffffffff",
        "408f276d 41c83b0e a20bc7c6 6d5451fd",
    ),
    (
        "243f6a88 85a308d3 13198a2e 03707344",
        "a4093822 299f31d0",
        "d16cfe09 94fdcceb 5001e420 24126ea1",
    ),
)


def words(text):
    return tuple(int(word, 16) for word in text.split())


@pytest.mark.parametrize(("counter", "under", "result"), KNOWN)
def test_philox_gives_the_published_answers(counter, under, result):
    """The published inputs of the generator Philox give the published words."""
    assert philox(words(counter), words(under)) == words(result)


def test_compiled_hash_is_the_published_one():
    pixels = np.array([0, 1, 2, 65535, 2**32 - 1, 2**32, 2**40 + 7, 2**63 - 1])
    for stream in (key(0, 0), key(2**64 - 1, 3, 1, 9, 4)):
        expected = [uniform_of(int(stream), int(pixel)) for pixel in pixels]
        assert uniforms(stream, pixels).tolist() == expected


def test_uniform_numbers_lie_strictly_between_0_and_1_and_are_symmetric():
    """The least and the largest word give 2^-53 and 1 - 2^-53, never 0 or 1."""
    assert unit(np.uint64(0)) == 2.0**-53
    assert unit(np.uint64(2**64 - 1)) == 1 - 2.0**-53
    assert unit(np.uint64(2**63)) == 0.5 + 2.0**-53


def test_uniform_numbers_are_evenly_spread():
    """A million numbers pass a Kolmogorov-Smirnov test. Each lies in the middle of one of 2^52
    intervals."""
    found = uniforms(key(5, 1), np.arange(1_000_000))
    assert stats.kstest(found, "uniform").pvalue > 1e-3
    # Numbers lie in the middles of 2^52 intervals.
    scaled = found * 2.0**53
    assert np.all(scaled % 2 == 1)


@pytest.mark.parametrize(
    "other",
    [
        lambda pixels: uniforms(key(7, 1), pixels + 1),
        lambda pixels: uniforms(key(7, 1), pixels + 256),
        lambda pixels: uniforms(key(8, 1), pixels),
        lambda pixels: uniforms(key(7, 2), pixels),
        lambda pixels: uniforms(key(7, 1, 1), pixels),
        lambda pixels: uniforms(key(7, 1, 0, 1), pixels),
        lambda pixels: uniforms(key(7, 1, 0, 0, 1), pixels),
    ],
    ids=["next pixel", "next row", "seed", "effect", "source", "frame", "group"],
)
def test_neighbours_are_independent(other):
    pixels = np.arange(256 * 1024)
    table, _, _ = np.histogram2d(uniforms(key(7, 1), pixels), other(pixels), bins=16)
    assert stats.chisquare(table.reshape(-1)).pvalue > 1e-3
    correlation = np.corrcoef(uniforms(key(7, 1), pixels), other(pixels))[0, 1]
    # Five standard errors of a correlation of independent numbers.
    assert abs(correlation) < 5 / math.sqrt(len(pixels))


def test_keys_differ_if_seed_effect_source_frame_or_group_differ():
    """No two of 324 combinations, with the ends of the ranges among them, have the same key."""
    keys = {
        int(key(seed, effect, source, frame, group))
        for seed in (0, 1, 2**32, 2**64 - 1)
        for effect in range(3)
        for source in range(3)
        for frame in (0, 1, 2**32)
        for group in (0, 1, 2**32)
    }
    assert len(keys) == 4 * 3 * 3 * 3 * 3
    assert isinstance(key(1, 2), np.uint64)


@pytest.mark.parametrize(
    "wrong", [(-1, 0), (2**64, 0), (0, -1), (0, 2**32), (0, 0, 2**32), (0, 0, 0, -1)]
)
def test_numbers_too_large_for_a_key_are_refused(wrong):
    """A negative number, and one beyond 64 bits for the seed or 32 for the others, gives a
    ValueError."""
    with pytest.raises(ValueError, match="outside 0"):
        key(*wrong)


def test_draws_keep_the_shape_and_ignore_the_order_of_pixels():
    """A pixel's number depends on its place alone: transposed pixels give transposed numbers. No
    pixels give none."""
    pixels = np.arange(60).reshape(3, 20)
    whole = normals(key(1, 1), pixels)
    assert whole.shape == (3, 20)
    assert np.array_equal(normals(key(1, 1), pixels.T[::-1]), whole.T[::-1])
    assert normals(key(1, 1), np.arange(0)).shape == (0,)
