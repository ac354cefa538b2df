"""The dictionary baseline: pursuit finds what was planted, learning explains blocks better."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from nscc_training.baselines.dictionary import SIDE, dictionary_clip, learned, pursued
from nscc_training.least_squares import solve


def test_pursuit_finds_the_planted_atoms() -> None:
    rng = np.random.default_rng(1)
    matrix = rng.standard_normal((40, 25)) * 10.0 ** rng.uniform(-1, 1, 25)
    for places in itertools.islice(itertools.combinations(range(25), 3), 0, None, 97):
        weights = np.zeros(25)
        weights[list(places)] = rng.uniform(1, 2, 3) / np.linalg.norm(matrix, axis=0)[list(places)]
        weights *= 20
        found = pursued(matrix, matrix @ weights, 6)
        # The pursuit stops at an error of 2 % of a unit in each of 40 numbers.
        assert np.linalg.norm(matrix @ (found - weights)) <= 0.02 * 40**0.5 * 1.01


def test_pursuit_leaves_dependent_and_empty_columns_alone() -> None:
    """Of two equal columns one is used, and a column of zeros is not. A matrix of zeros gives
    zeros."""
    matrix = np.array([[1.0, 1.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 0.0]])
    found = pursued(matrix, np.array([2.0, 2.0, 5.0]), 3)
    np.testing.assert_allclose(matrix @ found, [2.0, 2.0, 0.0])
    assert np.count_nonzero(found) == 1
    assert not pursued(np.zeros((3, 2)), np.ones(3), 2).any()


def test_learning_explains_blocks_better() -> None:
    """Blocks of three planted atoms each: a few rounds halve the error of the start."""
    rng = np.random.default_rng(2)
    planted = rng.standard_normal((30, 12))
    weights = np.zeros((400, 12))
    for row in weights:
        row[rng.choice(12, 3, replace=False)] = rng.standard_normal(3)
    blocks = weights @ planted.T

    def error(rounds: int) -> float:
        atoms = learned(blocks, 16, 3, rounds, seed=3)
        np.testing.assert_allclose(np.linalg.norm(atoms, axis=0), 1)
        return float(
            np.mean([np.square(b - atoms @ pursued(atoms, b, 3)).sum() for b in blocks[:60]])
        )

    assert error(12) < 0.5 * error(0)
    with pytest.raises(ValueError, match="blocks"):
        learned(blocks[:5], 16, 3, 1, seed=3)


def test_a_clip_of_atoms_is_reconstructed() -> None:
    """The clip is a single block, the sum of two atoms. Its coded frame has eight times fewer
    numbers."""
    rng = np.random.default_rng(4)
    frames = 8
    atoms = rng.random((frames * SIDE * SIDE, 20))
    truth = (0.7 * atoms[:, 3] + 0.4 * atoms[:, 11]).reshape(frames, SIDE, SIDE)
    mask = (rng.random(truth.shape) < 0.5).astype(np.float32)
    measurement = (truth * mask).sum(axis=0).astype(np.float32)
    found = dictionary_clip(measurement, mask, atoms)
    assert np.abs(found - truth).max() < 0.05
    with pytest.raises(ValueError, match="atoms"):
        dictionary_clip(measurement, mask, atoms[:-1])
    with pytest.raises(ValueError, match="atoms"):
        dictionary_clip(measurement[:4], mask[:, :4], atoms)


def test_blocks_cover_the_frame_up_to_its_edges() -> None:
    flat = np.ones((2 * SIDE * SIDE, 1))
    mask = np.ones((2, 13, 18), np.float32)
    found = dictionary_clip(np.full((13, 18), 0.6, np.float32), mask, flat)
    np.testing.assert_allclose(found, 0.3, rtol=1e-6)


def test_dependent_equations_get_the_solution_of_least_norm() -> None:
    """Columns that depend on each other: the solution of least norm, by the pseudoinverse."""
    rng = np.random.default_rng(5)
    matrix = rng.normal(size=(90, 6)) @ np.diag([1, 1e-3, 1, 1, 1e3, 1]) @ rng.normal(size=(6, 9))
    right = rng.normal(size=(90, 4))
    found = solve(matrix, right)
    assert found.rank == 6
    assert np.allclose(found.solution, np.linalg.pinv(matrix, rcond=1e-12) @ right, rtol=1e-6)
    one = solve(matrix, right[:, 0])
    assert np.allclose(one.solution, found.solution[:, 0], rtol=1e-6)
