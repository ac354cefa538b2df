"""What the loop over pixels is given beside arrays, by name."""

from __future__ import annotations

import numpy as np

from nscc_runtime.loop import record


@record
class Sizes:
    """How much there is of everything, and which effects there are: 0 is off."""

    pixels: int
    slots: int
    rows: int
    cols: int
    buckets: int
    groups: int
    registers: int
    draws: int
    """Of a word: one for what it reads or resets, and one for each destination."""
    numbered: int
    """By how much the numbers of the draws of two words differ."""
    whole: int
    """The least power of two that is not below the number of slots."""
    kept_cols: int
    """Columns of the three rows of sites whose charge is kept."""
    frame: int
    shot: int
    dark: int
    """1: counted; 2: its mean."""
    full_well: int
    read: int
    reset: int
    dead_time: int
    analog: int
    """1: gain, pattern and noise; 2: gain and pattern."""
    register: int
    leakage: int
    crosstalk: int
    prnu: int


@record
class Numbers:
    """The sensor's numbers; a variance is that of the logarithm."""

    full_well: float
    register_min: float
    register_max: float
    knee: float
    crosstalk: float
    lag: float
    prnu: float
    dark: float
    dark_variance: float
    read: float
    reset: float
    gain: float
    analog_noise: float
    pattern: float
    bias: float
    leak: float
    leak_variance: float
    rate_cap: float


@record
class Keys:
    """Keys of the device, then those that a frame's follow from: of counts, of how counts spread
    over slots, of the sums of noise in the buckets, and of its parts in the words.
    """

    start: np.uint64
    prnu: np.uint64
    dark: np.uint64
    pattern: np.uint64
    leak: np.uint64
    count_light: np.uint64
    count_dark: np.uint64
    thin_light: np.uint64
    thin_dark: np.uint64
    sum_read: np.uint64
    sum_reset: np.uint64
    sum_analog: np.uint64
    part_read: np.uint64
    part_reset: np.uint64
    part_analog: np.uint64


@record
class Entry:
    """A word in the list of a lane."""

    boundary: int
    resets: int
    acts: int
    number: int
    reads_pix: int
    sources: int
    destinations: int
    operands: int
    """Where its registers begin among all operands: sources, then destinations."""
    end: float
    """In parts of the slot."""
    divisor: float
