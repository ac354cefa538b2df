"""What the loop over pixels is given beside arrays, by name."""

from __future__ import annotations

import numpy as np

from nscc_runtime.loop import record


@record
class Sizes:
    """How much there is of everything, and what effects do: 0 is off. Their declarations say which
    switches, numbers and keys are theirs (`nscc_runtime.effects.effect.InLoop`).
    """

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
    """Columns of the three rows of sites whose counts are kept."""
    words: int
    """Numbers that words have."""
    given: int
    """Whether counts are given: neighbours' ones, and a pixel's own in slots that words see a part
    of, are spread as light is; else drawn and halved."""
    frame: int
    counts_light: int
    """Charge of light, and that without, comes in whole electrons; and so on."""
    counts_dark: int
    exchanges: int
    uneven: int
    reset_errors: int
    read_errors: int
    slow_words: int
    lit_level: int
    word_errors: int
    leaks: int
    holds: int
    """Whether PIX holds no more than it can; `bends`: registers lose what they cannot hold."""
    bends: int
    well_bit: int
    """What `saturated_by` marks: where a full PIX was added, where it was subtracted, where that
    was the level of a reset, where registers lost too much; 0: is not marked."""
    subtracted_bit: int
    level_bit: int
    registers_bit: int


@record
class Numbers:
    """What effects depend on; a variance is that of the logarithm.

    `pix_start` and `register_start`: twice the most that they hold when a frame begins.
    """

    pix_start: float
    register_start: float
    rate_cap: float
    echo: float
    uneven: float
    dark: float
    dark_variance: float
    exchanged: float
    well: float
    reset_error: float
    read_error: float
    gain: float
    word_error: float
    pattern: float
    bias: float
    lowest: float
    highest: float
    knee: float
    leak: float
    leak_variance: float
    least_lost: float
    """What registers have lost that is too much."""


@record
class Keys:
    """Keys of the device, then those that a frame's follow from: of counts, of how counts spread
    over slots, of the sums of small errors in the buckets, and of each of them in the words.
    """

    start: np.uint64
    uneven: np.uint64
    dark: np.uint64
    pattern: np.uint64
    leak: np.uint64
    count_light: np.uint64
    count_dark: np.uint64
    thin_light: np.uint64
    thin_dark: np.uint64
    sum_reads: np.uint64
    sum_resets: np.uint64
    sum_words: np.uint64
    part_reads: np.uint64
    part_resets: np.uint64
    part_words: np.uint64


ACTS, SEEN = 1, 2
"""Of a word in the list of a lane: it acts there; what falls on PIX before it is read, by it or
later, before PIX is reset."""


@record
class Entry:
    """A word."""

    boundary: int
    resets: int
    number: int
    reads_pix: int
    sources: int
    destinations: int
    operands: int
    """Where its registers begin among all operands: sources, then destinations."""
    end: float
    """In parts of the slot."""
    divisor: float
