"""What the loops over words are given beside arrays, by name."""

from __future__ import annotations

from typing import Annotated, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.loop import Floats, Ints, Written, record


@record
class Switches:
    """What words do to pixels: 0 is off. The effects' declarations say which switches, numbers and
    keys are theirs (`nscc_runtime.effects.effect.InLoop`).
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
    """Of single pixels: how much there is of everything, and which effects of charge are on."""

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
    whole: int
    """The least power of two that is not below the number of slots."""
    kept_cols: int
    """Columns of the three rows of sites whose counts are kept."""
    given: int
    """Whether counts are given: neighbours' ones, and a pixel's own in slots that words see a part
    of, are spread as light is; else drawn and halved."""
    frame: int
    counts_light: int
    """Charge of light, and that without, comes in whole electrons."""
    counts_dark: int
    exchanges: int


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
    compare_offset: float
    compare_noise: float
    least_lost: float
    """What registers have lost that is too much."""
    frame_s: float


@record
class OnDevice:
    """Keys of what is fixed on the device."""

    uneven: np.uint64
    dark: np.uint64
    pattern: np.uint64
    leak: np.uint64
    offset: np.uint64


@record
class Keys:
    """Of single pixels: keys that a frame's follow from, of counts, of how counts spread over
    slots, of the sums of small errors in the buckets, and of each of them in the words.
    """

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
class Word:
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


OfWords = Annotated[NDArray[Any], Word]


class Program(NamedTuple):
    """Words and their `operands`; `signs` of the errors of what is written to each register."""

    words: OfWords
    operands: Ints
    signs: Annotated[Floats, "registers"]


class Readouts(NamedTuple):
    """Of each bucket: the register that holds it, the readout's gain, and how long it waits."""

    register: Annotated[Ints, "buckets"]
    gain: Annotated[Floats, "buckets"]
    wait_s: Annotated[Floats, "buckets"]


class Fixed(NamedTuple):
    """What is fixed of each pixel of a block: the error of its words, the rate at which its
    registers leak, and the offset of its comparator."""

    pattern: Written[Floats]
    leak: Written[Floats]
    offset: Written[Floats]

    @classmethod
    def of(cls, block: int) -> Fixed:
        """Room for a block."""
        return cls(np.empty(block), np.empty(block), np.empty(block))


class Held(NamedTuple):
    """What the registers of a block hold, PIX after them and IN last: the `value`, the time
    `since_s` when it holds that, how much was `lost` on the way, and what is `full` of it
    (`nscc_runtime.execution.word_loop`). `level`: the reset level of PIX."""

    value: Written[Floats]
    since_s: Written[Floats]
    lost: Written[Floats]
    full: Written[Ints]
    level: Written[Floats]

    @classmethod
    def of(cls, registers: int, block: int) -> Held:
        """Room for a block."""
        count = (registers + 2) * block
        return cls(
            np.empty(count), np.empty(count), np.empty(count), np.empty(count, np.int64),
            np.empty(block),
        )  # fmt: skip


class Result(NamedTuple):
    """What a word makes of its sources at each pixel that runs it: their sum, what was lost on the
    way, and what is full in it. `some`: the pixels of the block that do."""

    some: Written[Ints]
    total: Written[Floats]
    lost: Written[Floats]
    full: Written[Ints]

    @classmethod
    def of(cls, block: int) -> Result:
        """Room for a block."""
        ints = np.empty(block, np.int64)
        return cls(np.zeros(block, np.int64), np.empty(block), np.empty(block), ints)


ACTS, SEEN = 1, 2
"""Of a word in the list of a lane: it acts there; what falls on PIX before it is read, by it or
later, before PIX is reset."""
