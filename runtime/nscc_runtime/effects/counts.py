"""Random keys of counted charge: one count per pixel, source, frame and group of slots."""

from __future__ import annotations

import numpy as np

from nscc_runtime.noise import key

LIGHT, WITHOUT_LIGHT = 0, 1
"""Numbers of the sources of charge."""
THINNED = 2
"""Added to a source number for the key that distributes counts over the slots of a group."""


def count_key(seed: int, stream: int, source: int, frame: int, group: int) -> np.uint64:
    """Return the random key of a group's counts; `stream` belongs to the effect that counts."""
    return key(seed, stream, source, frame, group)


def thinning_key(seed: int, stream: int, source: int, frame: int, group: int) -> np.uint64:
    """Return the random key for distributing the counts of a group over its slots."""
    return key(seed, stream, THINNED + source, frame, group)
