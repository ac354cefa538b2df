"""Least squares for nearly singular matrices."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from nscc.arrays import Floats


class LeastSquares(NamedTuple):
    """The result of `solve`: the solution with the smallest norm, the `rank` of the matrix, and its
    `condition` (largest over smallest singular value; infinite below full rank)."""

    solution: Floats
    rank: int
    condition: float


def solve(matrix: Floats, right: Floats) -> LeastSquares:
    """Minimise |matrix x - right| for a matrix (m, n) and a right side (m,) or (m, k).

    Uses the singular value decomposition, because normal equations would square the condition
    number. Singular values below max(m, n) ulps of the largest count as 0. Of several solutions, as
    below full rank, the one with the smallest norm is returned, (n,) or (n, k). Raises ValueError
    for values that are not finite."""
    if not (np.isfinite(matrix).all() and np.isfinite(right).all()):
        raise ValueError("a least-squares fit needs finite values, but some are NaN or infinite")
    limit = np.finfo(np.float64).eps * max(matrix.shape)
    if right.ndim == 2 and matrix.shape[0] > 2 * matrix.shape[1]:
        # Q is orthogonal: the smaller problem has the same singular values and solution.
        turn, matrix = np.linalg.qr(matrix)
        right = turn.T @ right
    solution, _, rank, singular = np.linalg.lstsq(matrix, right, rcond=limit)
    full = int(rank) == min(matrix.shape)
    condition = float(singular[0] / singular[-1]) if full and len(singular) else np.inf
    return LeastSquares(np.asarray(solution, np.float64), int(rank), condition)
