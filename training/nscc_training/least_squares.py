"""Least squares for codes that may nearly depend on each other."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False)
class LeastSquares:
    """The solution of least norm; `rank` of the matrix, and its `condition` (inf below full)."""

    solution: NDArray[np.float64]
    rank: int
    condition: float


def solve(matrix: NDArray[np.float64], right: NDArray[np.float64]) -> LeastSquares:
    """min |matrix x - right| for a matrix (m, n) and a right side (m,) or (m, k).

    By singular values, never by normal equations, whose condition is the square. Directions below
    max(m, n) ulps of the largest are left out and lower the rank. ValueError where anything is not
    finite.
    """
    if not (np.isfinite(matrix).all() and np.isfinite(right).all()):
        raise ValueError("least squares of values that are not finite")
    limit = np.finfo(np.float64).eps * max(matrix.shape)
    if right.ndim == 2 and matrix.shape[0] > 2 * matrix.shape[1]:
        # The same singular values and solution of a much smaller problem: Q only turns.
        turn, matrix = np.linalg.qr(matrix)
        right = turn.T @ right
    solution, _, rank, singular = np.linalg.lstsq(matrix, right, rcond=limit)
    full = int(rank) == min(matrix.shape)
    condition = float(singular[0] / singular[-1]) if full and len(singular) else np.inf
    return LeastSquares(np.asarray(solution, np.float64), int(rank), condition)
