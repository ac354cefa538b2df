"""Stills by convolutional sparse coding (after Serrano et al., Computer Graphics Forum 2016).

A coarse picture, merged from neighbours, is corrected by a sum of few small filters at any place.
FISTA finds their weights from the unsaturated pixels. The method works on the square root of light,
where errors of bright and dark pixels are comparable. Filters are learned from procedural scenes.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor
from torch.nn import functional

from nscc.arrays import Bools, Floats
from nscc_training import made_scenes
from nscc_training.baselines.dictionary import learned

SIDE = 9
FILTERS = 40
WEIGHT = 0.03
ITERATIONS = 60

Picture = Floats

_COARSE = 3.0
"""Standard deviation in pixels of the blur that gives the coarse picture."""


def sparse_coded(
    coarse: Picture,
    measured: Picture,
    confidence: Picture,
    filters: Tensor,
    iterations: int = ITERATIONS,
    weight: float = WEIGHT,
) -> Picture:
    """Return the picture (rows, cols) that follows `measured` where `confidence` (0..1) is high,
    and elsewhere `coarse`, blurred.

    The three arrays are (rows, cols); pictures are square roots of light relative to a full well.
    `filters` (K, 1, side, side) come from `made_filters`. `iterations` of FISTA minimise
    |confidence (measured - blurred coarse - sum of filters)|^2 / 2 + `weight` * sum of the absolute
    filter weights."""
    low_pass = blurred(torch.from_numpy(coarse).float()[None, None])
    mask = torch.from_numpy(confidence).float()[None, None]
    target = mask * (torch.from_numpy(measured).float()[None, None] - low_pass)
    step = 1.0 / largest_gain(filters, mask)
    maps = torch.zeros((1, len(filters), *target.shape[2:]))
    ahead, momentum = maps, 1.0
    for _ in range(iterations):
        error = mask * summed(ahead, filters) - target
        moved = ahead - step * spread(mask * error, filters)
        shrunk = torch.sign(moved) * torch.clamp(moved.abs() - step * weight, min=0)
        # FISTA's momentum: the next gradient is taken at a point ahead of the maps.
        following = (1 + (1 + 4 * momentum**2) ** 0.5) / 2
        ahead = shrunk + (momentum - 1) / following * (shrunk - maps)
        maps, momentum = shrunk, following
    return np.asarray((low_pass + summed(maps, filters))[0, 0].double().numpy())


def coded_still(
    frame: NDArray[np.floating],
    open_share: Picture,
    coarse_e: Picture,
    electrons_per_lsb: float,
    saturated: Bools,
    full_well_e: float,
    iterations: int = ITERATIONS,
) -> Picture:
    """Reconstruct the light over the frame in electrons (rows, cols).

    All arrays are (rows, cols). `frame` are converter codes above the offset, each of
    `electrons_per_lsb`; `open_share` is the open fraction of each pixel, and `coarse_e` an estimate
    of the light by another method. Photon noise of the square root of light depends on the open
    time alone, which is the confidence of a pixel. A saturated pixel has confidence 0, and at least
    the light that saturates it."""
    share = np.where(open_share > 0, open_share, 1.0)
    relative = frame.astype(np.float64) * (electrons_per_lsb / full_well_e) / share
    usable = ~saturated & (open_share > 0)
    root = sparse_coded(
        np.sqrt(np.maximum(coarse_e, 0) / full_well_e),
        np.sqrt(np.maximum(relative, 0)),
        # The variance of the root falls as 1 / share; confidence grows more slowly than its
        # inverse.
        np.where(usable, share**0.25, 0.0),
        made_filters(),
        iterations,
    )
    light = np.square(np.maximum(root, 0.0))
    return np.where(saturated & (open_share > 0), np.maximum(light, relative), light) * full_well_e


@cache
def made_filters() -> Tensor:
    """Learn filters, float32 (FILTERS, 1, SIDE, SIDE), of length 1 from the details of procedural
    stills. They are always the same, and cached."""
    generator = np.random.default_rng([0, SIDE])
    blocks = []
    # 150 blocks from each of 16 pictures of 96 x 96 pixels.
    for _ in range(16):
        light = made_scenes.still(generator, 96)
        root = np.sqrt(light / np.quantile(light, 0.7))
        # At most 16 times the light of the quantile: lamps would dominate the filters.
        picture = torch.from_numpy(np.minimum(root, 4.0)).float()[None, None]
        detail = (picture - blurred(picture))[0, 0].numpy()
        for _ in range(150):
            row, col = generator.integers(0, 96 - SIDE + 1, 2)
            block = detail[row : row + SIDE, col : col + SIDE].ravel()
            # Blocks of length 1, but those with almost no detail are not amplified further.
            blocks.append(block / max(float(np.linalg.norm(block)), 0.05))
    atoms = learned(np.array(blocks, np.float64), atoms=FILTERS, sparsity=3, rounds=8, seed=0)
    return torch.from_numpy(atoms.T.reshape(FILTERS, 1, SIDE, SIDE).copy()).float()


def summed(maps: Tensor, filters: Tensor) -> Tensor:
    """Return the sum (1, 1, rows, cols) of maps (1, K, rows, cols), each convolved with its filter
    of `filters` (K, 1, SIDE, SIDE)."""
    return functional.conv_transpose2d(maps, filters, padding=SIDE // 2)


def spread(picture: Tensor, filters: Tensor) -> Tensor:
    """Return the correlation (1, K, rows, cols) of a picture (1, 1, rows, cols) with each of
    `filters` (K, 1, SIDE, SIDE): the adjoint of `summed`."""
    return functional.conv2d(picture, filters, padding=SIDE // 2)


def blurred(picture: Tensor) -> Tensor:
    """Blur a picture (1, 1, rows, cols) by a Gaussian with the standard deviation `_COARSE`.
    Outside, its edge pixels are repeated."""
    reach = round(3 * _COARSE)
    line = torch.exp(-0.5 * (torch.arange(-reach, reach + 1) / _COARSE) ** 2)
    line = line / line.sum()
    wide = functional.pad(picture, (reach, reach, reach, reach), mode="replicate")
    across = functional.conv2d(wide, line.reshape(1, 1, 1, -1))
    return functional.conv2d(across, line.reshape(1, 1, -1, 1))


def largest_gain(filters: Tensor, mask: Tensor) -> float:
    """Return an upper bound of the largest eigenvalue of A A^T, where A adds maps, each convolved
    with its filter of `filters`, and multiplies the sum by `mask` (1, 1, rows, cols).

    Twelve power iterations estimate it; they begin with the mask itself. The result is at least
    1e-6, also for a mask of 0. Its inverse is the step of FISTA."""
    picture = mask.clone()
    gain = 1.0
    for _ in range(12):
        following = mask * summed(spread(picture, filters), filters)
        gain = float(following.norm() / picture.norm().clamp(min=1e-20))
        picture = following / max(gain, 1e-20)
    # The iteration converges from below.
    # The estimate may still be too small, by less than 10 %.
    return 1.1 * max(gain, 1e-6)
