"""Sets of points as bit arrays, and all cubes that one NOR of planes can compute.

A set is an array of uint64 words (.., W); bit i of word w is point 64 w + i."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nscc.arrays import Bools, Ints
from nscc.logic.problem import Machine, words_of

Points = NDArray[np.uint64]


class Planes:
    """Code planes (contents of code registers) and all cubes (NORs of registers) that one NOR of
    them can compute, by cost.

    `planes` (P, W) are sets of points in W words of 64 points, `everything` (W,) is the set of all
    points. `groups` are tuples (cost in words, cubes (M, W), bit masks (M,) of the planes that each
    cube reads), the cheapest group first."""

    def __init__(self, planes: Points, points: int, machine: Machine) -> None:
        """Compute all different cubes (NORs of registers) of these planes, in groups of equal cost
        in words, cheapest first.

        `planes`, uint64 (planes, words of 64 points), are sets of `points` points. Each group holds
        its cost, the cubes as sets, and the mask of planes that each cube's NOR reads. Of equal
        cubes, the one that reads fewest planes is kept; empty cubes are left out. There may be
        2^planes cubes, so the caller keeps the number of planes small."""
        self.planes = planes
        self.everything: Points = packed(np.ones((1, points), dtype=np.bool_))[0]
        # The union of every subset of the planes, doubled for each plane: row m belongs to mask m.
        limit = machine.or_sources
        ors = np.zeros((1, planes.shape[1]), dtype=np.uint64)
        for plane in planes:
            ors = np.concatenate((ors, ors | plane))
        masks = np.arange(len(ors), dtype=np.int64)
        size = np.bitwise_count(masks)
        order = np.lexsort((masks, size))[1:]
        cubes = self.everything & ~ors[order]
        # Of equal cubes, keep the one with the fewest planes; drop the empty cube.
        _, first = np.unique(cubes, axis=0, return_index=True)
        first = np.sort(first[cubes[first].any(axis=1)])
        cubes, masks, size = cubes[first], masks[order][first], size[order][first]
        price = np.array([words_of(n, limit) for n in range(len(planes) + 1)])[size]
        self.groups = [
            (words, cubes[price == words], masks[price == words])
            for words in sorted(set(price.tolist()))
        ]


def packed(bits: Bools) -> Points:
    """Return the rows of `bits` (n, points) as sets of points, uint64 (n, W), W words of 64 points.
    The bits of the last word behind the last point are 0."""
    width = -(-bits.shape[1] // 64) * 8
    raw = np.packbits(bits, axis=1, bitorder="little")
    padded = np.zeros((len(bits), width), dtype=np.uint8)
    padded[:, : raw.shape[1]] = raw
    return padded.view("<u8").astype(np.uint64)


def sizes(sets: Points) -> Ints:
    """Return the number of points in each set of an array (.., W), as int64 (..)."""
    counts: Ints = np.bitwise_count(sets).sum(axis=-1, dtype=np.int64)
    return counts


def disjoint(first_sets: Points, second_sets: Points) -> Bools:
    """Return whether each set of `first_sets` (.., W) is disjoint from its partner in
    `second_sets`, as bool (..). The arrays are broadcast; the empty set is disjoint from every
    set."""
    none: Bools = ~np.any(first_sets & second_sets, axis=-1)
    return none


def gains(cubes: Points, on: Points, off: Points) -> NDArray[np.uint16]:
    """Return the number of points of each set of `on` in each cube, 0 if the cube contains a point
    of `off`, as uint16 (n, M).

    `cubes` are M sets (M, W); `on` and `off` are n sets each (n, W), in pairs; W is at most 1023.
    A cube is a NOR of registers."""
    gain = np.zeros((len(on), len(cubes)), dtype=np.uint16)
    pure = np.ones(gain.shape, dtype=np.bool_)
    for row, inside, outside in zip(cubes.T, on.T[..., None], off.T[..., None], strict=True):
        pure &= (row & outside) == 0
        gain += np.bitwise_count(row & inside)
    gain *= pure
    return gain
