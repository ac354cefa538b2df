"""Records and groups of arrays that the loops over words take as arguments."""

from __future__ import annotations

from typing import Annotated, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.loop import Floats, Ints, Written, record


@record
class Switches:
    """Switches of effects in the loops; 0 is off. `nscc_runtime.effects.effect.InLoop` of an effect
    names its switches, numbers and keys.
    """

    registers: int
    buckets: int
    reset_errors: int
    read_errors: int
    slow_words: int
    lit_level: int
    word_errors: int
    leaks: int
    holds: int
    """Whether PIX holds no more than it can; `bends`: registers lose what they cannot hold."""
    bends: int
    compares_off: int
    compares_noisy: int
    well_bit: int
    """What `saturated_by` marks: where a full PIX was added, where it was subtracted, where that
    was the level of a reset, where registers lost too much; 0: is not marked."""
    subtracted_bit: int
    level_bit: int
    registers_bit: int


@record
class Sizes:
    """Sizes for the loop over single pixels, and switches of effects of charge."""

    pixels: int
    slots: int
    rows: int
    cols: int
    groups: int
    draws: int
    """Of a word: one for what it reads or resets, and one for each destination."""
    numbered: int
    """By how much the numbers of the draws of two words differ."""
    words: int
    """Numbers that words have."""
    stale: int
    """Whether words read what registers held when the frame began."""
    padded_slots: int
    """The least power of two that is not below the number of slots."""
    kept_cols: int
    """Columns of the three rows of sites whose counts are kept."""
    counts_known: int
    """Whether counts are given: neighbours' ones, and a pixel's own in slots that words see a part
    of, are spread as light is; else drawn and halved."""
    frame: int
    counts_light: int
    """Charge of light, and that without, comes in whole electrons."""
    counts_dark: int
    exchanges: int


@record
class Numbers:
    """Parameters of effects; variances are those of the logarithm.

    `pix_start` and `register_start`: twice the largest content at the start of a frame.
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
    compare_offset: float
    compare_noise: float
    least_lost: float
    """What registers have lost that is too much."""
    frame_s: float


@record
class OnDevice:
    """Keys of the fixed patterns of the device."""

    uneven: np.uint64
    dark: np.uint64
    pattern: np.uint64
    leak: np.uint64
    offset: np.uint64


@record
class Keys:
    """Base keys for the loop over single pixels: of counts, of their split over slots, of the sums
    of small errors in buckets, and of the errors of single words."""

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


@record
class LoopWord:
    """An analog word."""

    resets: int
    compares: int
    reads_pix: int
    number: int
    """Its number among those of a frame."""
    sources: int
    destinations: int
    operands: int
    """Where its registers begin among all operands: sources, then destinations."""
    begins: int
    """The slot or the interval at whose beginning it runs."""
    end_us: float
    """How long after that it ends."""
    time_s: float
    """When that is."""
    divisor: float
    in_e: float
    """What IN holds meanwhile."""


OfWords = Annotated[NDArray[Any], LoopWord]


class LoopProgram(NamedTuple):
    """Words and their `operands`; `signs` of the errors of what is written to each register."""

    words: OfWords
    operands: Ints
    signs: Annotated[Floats, "registers"]


class Readouts(NamedTuple):
    """For each bucket: its register, the gain of its readout, and the time until it is read."""

    register: Annotated[Ints, "buckets"]
    gain: Annotated[Floats, "buckets"]
    wait_s: Annotated[Floats, "buckets"]


class Fixed(NamedTuple):
    """Fixed patterns of the pixels of a block: the error of words, the leakage rate of registers,
    and the offset of the comparator."""

    pattern: Written[Floats]
    leak: Written[Floats]
    offset: Written[Floats]

    @classmethod
    def of(cls, block: int) -> Fixed:
        """Room for a block."""
        return cls(np.empty(block), np.empty(block), np.empty(block))


class RegisterContents(NamedTuple):
    """The registers of a block, then PIX, then IN: the `value`, the time `since_s` when it was
    written, the electrons `lost_e` by saturation, and the marks `full`
    (`nscc_runtime.execution.word_loop`). `level`: the reset level of PIX."""

    value: Written[Floats]
    since_s: Written[Floats]
    lost_e: Written[Floats]
    full: Written[Ints]
    level: Written[Floats]

    @classmethod
    def of(cls, registers: int, block: int) -> RegisterContents:
        """Room for a block."""
        count = (registers + 2) * block
        return cls(
            np.empty(count), np.empty(count), np.empty(count), np.empty(count, np.int64),
            np.empty(block),
        )  # fmt: skip


class WordResult(NamedTuple):
    """The result of a word in each of the `pixels` of a block that run it: the sum of its sources,
    the electrons lost by saturation, and the marks `full`."""

    pixels: Written[Ints]
    total: Written[Floats]
    lost_e: Written[Floats]
    full: Written[Ints]

    @classmethod
    def of(cls, block: int) -> WordResult:
        """Room for a block."""
        ints = np.empty(block, np.int64)
        return cls(np.zeros(block, np.int64), np.empty(block), np.empty(block), ints)


ACTS, SEEN = 1, 2
"""Flags of a word in a lane: it acts there; the charge before it is read before PIX is reset."""
