"""The keys of counted charge: one count per pixel, source, frame and group of slots."""

from __future__ import annotations

import numpy as np

from nscc_runtime.noise import key

LIGHT, WITHOUT_LIGHT = 0, 1
"""Sources of charge."""
THINNED = 2
"""Offset on a source, for the key that distributes its counts over the slots of a group."""


def count_key(seed: int, stream: int, source: int, frame: int, group: int) -> np.uint64:
    """Return the key of the counts of a group of slots; `stream` is the counting effect's."""
    return key(seed, stream, source, frame, group)


def thinning_key(seed: int, stream: int, source: int, frame: int, group: int) -> np.uint64:
    """Return the key that distributes these counts over the slots of the group."""
    return key(seed, stream, THINNED + source, frame, group)
