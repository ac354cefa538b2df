"""Hard case 19: nearly dependent codes; least squares by QR, with rank and condition told."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from nscc_training.least_squares import solve

UNIT = 2.0**-52


def hilbert(size: int) -> np.ndarray:
    return np.array([[1.0 / (r + c + 1) for c in range(size)] for r in range(size)])


def exact(matrix: np.ndarray, right: np.ndarray) -> list[float]:
    """Gauss-Jordan with fractions: no rounding at all."""
    rows = [[Fraction(float(v)) for v in row] for row in matrix]
    values = [Fraction(float(v)) for v in right]
    for k in range(len(rows)):
        pivot = next(r for r in range(k, len(rows)) if rows[r][k] != 0)
        rows[k], rows[pivot] = rows[pivot], rows[k]
        values[k], values[pivot] = values[pivot], values[k]
        for r in range(len(rows)):
            if r != k and rows[r][k] != 0:
                factor = rows[r][k] / rows[k][k]
                rows[r] = [a - factor * b for a, b in zip(rows[r], rows[k], strict=True)]
                values[r] -= factor * values[k]
    return [float(v / rows[k][k]) for k, v in enumerate(values)]


@pytest.mark.parametrize("size", [3, 6, 9])
def test_the_error_grows_with_the_condition_number_and_not_with_its_square(size: int) -> None:
    matrix = hilbert(size)
    right = matrix @ np.arange(1.0, size + 1)
    found = solve(matrix, right)
    wanted = np.array(exact(matrix, right))
    assert found.rank == size
    error = np.linalg.norm(found.solution - wanted) / np.linalg.norm(wanted)
    assert error <= 10 * found.condition * UNIT
    if size == 9:
        # A factorisation may find the square singular, a decomposition never refuses.
        normal = np.linalg.lstsq(matrix.T @ matrix, matrix.T @ right, rcond=0)[0]
        assert np.linalg.norm(normal - wanted) / np.linalg.norm(wanted) > 100 * error


def test_nearly_equal_shutters_have_rank_two_and_a_large_condition() -> None:
    """Two shutters of a thousand slots that differ in one: rank 2, and the condition says so."""
    codes = np.ones((40, 2))
    codes[0, 1] = 1 + 1e-6
    found = solve(codes, codes @ np.array([2.0, 3.0]))
    assert found.rank == 2
    assert found.condition == pytest.approx(np.linalg.cond(codes), rel=1e-3)
    np.testing.assert_allclose(found.solution, [2, 3], rtol=10 * found.condition * UNIT)


def test_dependent_codes_have_the_least_solution_and_a_lower_rank() -> None:
    codes = np.array([[1.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    found = solve(codes, np.array([4.0, 5.0, 4.0, 5.0]))
    assert found.rank == 2
    assert found.condition == np.inf
    np.testing.assert_allclose(found.solution, [2, 2, 5], atol=1e-12)


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_values_that_are_not_finite_are_refused(bad: float) -> None:
    with pytest.raises(ValueError, match="finite"):
        solve(np.array([[1.0, bad]]), np.array([1.0]))
