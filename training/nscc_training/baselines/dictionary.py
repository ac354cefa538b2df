"""Clips from one coded frame with a learned dictionary (after Hitomi et al., ICCV 2011). Every
block of the clip is a sum of few atoms, which orthogonal matching pursuit selects from the coded
block. The dictionary is learned by the method of optimal directions."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from nscc.arrays import Floats, Floats32
from nscc_training import made_scenes
from nscc_training.baselines.tv_loop import Clip
from nscc_training.least_squares import solve

SIDE = 8
"""Side of a block in pixels; blocks lie `STRIDE` pixels apart. A dictionary has `ATOMS` atoms, of
which a block uses at most `SPARSITY`."""
STRIDE = 4
ATOMS = 512
SPARSITY = 8
"""A dictionary has `ATOMS` atoms, of which a block uses at most `SPARSITY`. Blocks have a side of
`SIDE` pixels and begin every `STRIDE` pixels."""

Matrix = Floats

_CLIPS = 24
_BLOCKS = 4000
_ROUNDS = 6
_ENOUGH = 0.02
"""The pursuit ends when the root mean square residual is below this, in units of white."""


def dictionary_clip(measurement: Floats32, mask: Clip, atoms: Matrix) -> Clip:
    """Reconstruct the clip (T, rows, cols) of a measurement (rows, cols), by sparse coding of
    overlapping blocks, which are averaged.

    `mask` (T, rows, cols) is the code of the measurement. `atoms` (T * SIDE * SIDE, K) are a
    dictionary, one atom in each column, with pixels in the order (T, SIDE, SIDE). Raises ValueError
    for a picture smaller than a block, or atoms of another length."""
    frames, rows, cols = mask.shape
    if min(rows, cols) < SIDE or len(atoms) != frames * SIDE * SIDE:
        raise ValueError(f"{mask.shape} with atoms of {len(atoms)} numbers")
    volume = atoms.reshape(frames, SIDE * SIDE, -1)
    total, count = np.zeros(mask.shape), np.zeros((rows, cols))
    for row in _places(rows):
        for col in _places(cols):
            block = (slice(row, row + SIDE), slice(col, col + SIDE))
            opened = mask[:, block[0], block[1]].reshape(frames, -1, 1).astype(np.float64)
            coded = (opened * volume).sum(axis=0)
            weights = pursued(coded, measurement[block].astype(np.float64).ravel(), SPARSITY)
            total[:, block[0], block[1]] += (atoms @ weights).reshape(frames, SIDE, SIDE)
            count[block] += 1
    return np.asarray(total / count, np.float32)


def pursued(matrix: Matrix, right: Floats, sparsity: int) -> Floats:
    """Solve matrix @ weights = right for a matrix (n, K), with at most `sparsity` nonzero weights.
    Return the weights (K,).

    Orthogonal matching pursuit selects one column after another. It stops when the root mean square
    residual is below `_ENOUGH`, and never selects a column that depends linearly on the selected
    ones."""
    weights = np.zeros(matrix.shape[1])
    norms = np.linalg.norm(matrix, axis=0)
    usable = norms > 1e-9 * max(float(norms.max()), 1e-300)
    chosen: list[int] = []
    residual = right
    solution = np.zeros(0)
    # The norm of a residual whose root mean square is `_ENOUGH`.
    enough = _ENOUGH * len(right) ** 0.5
    while len(chosen) < sparsity and np.linalg.norm(residual) > enough and usable.any():
        gain = np.where(usable, np.abs(matrix.T @ residual) / np.where(usable, norms, 1.0), -1.0)
        best = int(gain.argmax())
        usable[best] = False
        system = solve(matrix[:, [*chosen, best]], right)
        if system.rank <= len(chosen):
            continue
        chosen.append(best)
        solution = system.solution
        residual = right - matrix[:, chosen] @ solution
    weights[chosen] = solution
    return weights


def learned(blocks: Matrix, atoms: int, sparsity: int, rounds: int, seed: int) -> Matrix:
    """Learn a dictionary (d, `atoms`) with columns of length 1 for `blocks` (n, d), so that each
    block is nearly a sum of at most `sparsity` atoms.

    Each of `rounds` rounds finds the weights of the blocks, then the best atoms for them. The first
    atom is constant. An unused atom is replaced by the block with the largest error. `seed` chooses
    the first atoms. Raises ValueError for fewer blocks than atoms."""
    if len(blocks) < atoms:
        raise ValueError(f"{len(blocks)} blocks for {atoms} atoms")
    generator = np.random.default_rng(seed)
    chosen = blocks[generator.permutation(len(blocks))[: atoms - 1]]
    dictionary = _unit(np.concatenate([np.ones((1, blocks.shape[1])), chosen]).T)
    for _ in range(rounds):
        weights = _encoded(dictionary, blocks, sparsity)
        used = np.flatnonzero(np.any(weights != 0, axis=0))
        # blocks = weights @ atoms.T: one least-squares problem for all the atoms in use.
        improved = solve(weights[:, used], blocks).solution.T
        error = np.square(blocks - weights @ dictionary.T).sum(axis=1)
        spare = np.setdiff1d(np.arange(atoms), used)
        dictionary[:, used] = improved
        dictionary[:, spare] = blocks[np.argsort(-error)[: len(spare)]].T
        dictionary[:, 0] = 1.0
        dictionary = _unit(dictionary)
    return dictionary


@lru_cache(maxsize=4)
def made_dictionary(frames: int) -> Matrix:
    """Learn a dictionary (frames * SIDE * SIDE, ATOMS) for clips of `frames` frames from procedural
    scenes; no data is needed.

    The result is cached and always the same."""
    generator = np.random.default_rng([0, frames])
    blocks = []
    for _ in range(_CLIPS):
        scene = made_scenes.clip(generator, frames, 64)
        for _ in range(_BLOCKS // _CLIPS):
            row, col = generator.integers(0, 64 - SIDE + 1, 2)
            blocks.append(scene[:, row : row + SIDE, col : col + SIDE].ravel())
    return learned(np.array(blocks, np.float64), ATOMS, SPARSITY, _ROUNDS, seed=0)


def _encoded(atoms: Matrix, blocks: Matrix, sparsity: int) -> Matrix:
    """Return the weights (n, K) that represent blocks (n, d) by atoms (d, K), at most `sparsity` of
    them nonzero in a row.

    The same orthogonal matching pursuit as `pursued`, but for all blocks together, with the inner
    products of atoms computed once. It always uses `sparsity` atoms, at most as many as there are.
    Atoms have length 1."""
    products, right = atoms.T @ atoms, blocks @ atoms
    count = len(blocks)
    chosen = np.zeros((count, 0), np.int64)
    fit = right.copy()
    weights: Matrix = np.zeros((count, 0))
    for size in range(1, sparsity + 1):
        # Atoms that are chosen already are not chosen again.
        fit[np.arange(count)[:, None], chosen] = 0.0
        chosen = np.concatenate([chosen, np.abs(fit).argmax(axis=1)[:, None]], axis=1)
        # The addition keeps the system solvable if chosen atoms are nearly equal.
        gram = products[chosen[:, :, None], chosen[:, None, :]] + 1e-9 * np.eye(size)
        projections = np.take_along_axis(right, chosen, axis=1)
        weights = np.asarray(np.linalg.solve(gram, projections[..., None])[..., 0], np.float64)
        fit = right - np.einsum("ns,nsk->nk", weights, products[chosen])
    all_weights = np.zeros((count, atoms.shape[1]))
    np.put_along_axis(all_weights, chosen, weights, axis=1)
    return all_weights


def _unit(atoms: Matrix) -> Matrix:
    """Return the columns of `atoms`, scaled to length 1; columns of zeros stay."""
    lengths = np.linalg.norm(atoms, axis=0)
    return np.asarray(atoms / np.where(lengths > 0, lengths, 1.0))


def _places(size: int) -> list[int]:
    """Return the first pixels of blocks along an axis of `size` pixels: every `STRIDE`-th, and the
    last at which a block fits. `size` is at least `SIDE`."""
    return sorted({*range(0, size - SIDE + 1, STRIDE), size - SIDE})
