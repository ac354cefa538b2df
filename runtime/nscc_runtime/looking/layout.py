"""What the loop over ways is given beside arrays, by name."""

from __future__ import annotations

import numpy as np

from nscc_runtime.loop import record


@record
class Sizes:
    """How much there is of everything, and what effects do: 0 is off. Their declarations say which
    switches, numbers and keys are theirs (`nscc_runtime.effects.effect.InLoop`).
    """

    pixels: int
    first_place: int
    """The place of the first pixel; the others follow it."""
    intervals: int
    segments: int
    registers: int
    buckets: int
    steps: int
    """The analog words of a frame."""
    numbered: int
    """By how much the numbers of the draws of two words differ."""
    paces: int
    """1 where all pixels have one pace, else as many as there are pixels."""
    frame: int
    holds: int
    reset_errors: int
    read_errors: int
    slow_words: int
    lit_level: int
    word_errors: int
    bends: int
    leaks: int
    compares_off: int
    compares_noisy: int
    well_bit: int
    """Of `saturated_by`: where a full PIX was added, where it was subtracted, where that was the
    level of a reset, where registers lost too much; 0: is not marked."""
    subtracted_bit: int
    level_bit: int
    registers_bit: int


@record
class Numbers:
    """What effects depend on; a variance is that of the logarithm."""

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
    compare_offset: float
    compare_noise: float
    least_lost: float
    """What registers have lost that is too much."""
    frame_s: float


@record
class Keys:
    """Keys of the device, then those from which the keys of a frame's words follow."""

    pattern: np.uint64
    leak: np.uint64
    offset: np.uint64
    reads: np.uint64
    resets: np.uint64
    words: np.uint64
    compares: np.uint64


@record
class Word:
    """An analog word."""

    resets: int
    compares: int
    touches_pix: int
    """Whether it reads or resets PIX."""
    sources: int
    destinations: int
    operands: int
    """Where its registers begin among all operands: sources, then destinations."""
    interval: int
    end_us: float
    """How long after its interval's beginning it ends."""
    time_s: float
    """When its interval begins."""
    divisor: float
    in_e: float
