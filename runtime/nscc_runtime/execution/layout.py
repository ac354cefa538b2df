"""Records and groups of arrays that are arguments of the loops over words."""

from __future__ import annotations

from typing import Annotated, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.loop import Floats, Ints, Written, record


@record
class Switches:
    """Switches of effects in the loops (0: off), and the numbers of registers and buckets. Each
    effect names its switches, numbers and keys in an `nscc_runtime.effects.effect.InLoop`."""

    registers: int
    buckets: int
    reset_errors: int
    read_errors: int
    slow_words: int
    lit_level: int
    word_errors: int
    leaks: int
    holds: int
    """Whether PIX is clipped to the full well. `bends`: whether registers saturate softly."""
    bends: int
    compares_off: int
    compares_noisy: int
    well_bit: int
    """Bits of `saturated_by`, 0 if not marked: a full PIX was added, a full PIX was subtracted, the
    reset level contained a full PIX, a register lost too much charge."""
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
    """Number of draws of a word: one for its read or reset, and one for each destination."""
    numbered: int
    """Difference between the draw numbers of consecutive words."""
    words: int
    """Number of different word numbers."""
    stale: int
    """Whether words read registers that were not written in the same frame."""
    padded_slots: int
    """Smallest power of two that is at least the number of slots."""
    kept_cols: int
    """Number of columns of the three rows of sites whose counts are cached."""
    counts_known: int
    """Whether counts are known. If so, neighbours' counts, and a pixel's own counts in slots that
    words divide, are split in proportion to light. Otherwise counts are drawn and halved."""
    frame: int
    counts_light: int
    """Whether photons are drawn as counts; `counts_dark`: whether dark electrons are."""
    counts_dark: int
    exchanges: int


@record
class Numbers:
    """Parameters of effects, in electrons and seconds. Variances are those of the logarithm.
    `pix_start`, `register_start`: twice the largest content at the start of a frame."""

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
    """Charge in electrons from which the loss of a register is marked."""
    frame_s: float


@record
class OnDevice:
    """First halves of the random keys of the fixed patterns of a chip, one key for each effect."""

    uneven: np.uint64
    dark: np.uint64
    pattern: np.uint64
    leak: np.uint64
    offset: np.uint64


@record
class Keys:
    """First halves of the random keys of a run: of counts (`count_`), of their splits over slots
    (`thin_`), of the sums of small errors in buckets (`sum_`), and of the errors of single words
    (`part_`)."""

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
    """An analog word, as the loops read it. `resets`, `compares`, `reads_pix`: whether it does so.
    `sources`, `destinations`: numbers of registers."""

    resets: int
    compares: int
    reads_pix: int
    number: int
    """The number of the word among the words of a frame."""
    sources: int
    destinations: int
    operands: int
    """Index of the first source in `LoopProgram.operands`; then other sources, destinations."""
    begins: int
    """The slot or interval at whose beginning the word runs."""
    end_us: float
    """The end of the word in microseconds after the beginning of that slot."""
    time_s: float
    """The time in the frame at which that slot begins, in seconds."""
    divisor: float
    in_e: float
    """The value of IN during the word, in electrons."""


OfWords = Annotated[NDArray[Any], LoopWord]


class LoopProgram(NamedTuple):
    """The words of a program, their `operands`, and the `signs` of errors in each register."""

    words: OfWords
    operands: Ints
    signs: Annotated[Floats, "registers"]


class Readouts(NamedTuple):
    """For each bucket: the number of its register, the gain of its readout, and the seconds from
    the end of the frame to its readout."""

    register: Annotated[Ints, "buckets"]
    gain: Annotated[Floats, "buckets"]
    wait_s: Annotated[Floats, "buckets"]


class PixelState(NamedTuple):
    """The state of the pixels of a block while words run.

    `pattern`, `leak`, `offset`: fixed patterns of the pixels: the error of words in electrons, the
    leakage rate of registers in 1/s, the offset of the comparator in electrons.

    Contents of the registers, then of PIX and IN. `value`: electrons. `since_s`: the time of
    writing. `lost_e`: electrons lost by saturation. `full`: saturation marks
    (`nscc_runtime.execution.word_loop`). `level`: the reset level of PIX.

    `running`: the pixels that run a word. `total`: the sum of its sources in each of them, with the
    electrons lost by saturation (`total_lost_e`) and the saturation marks (`total_full`)."""

    pattern: Written[Floats]
    leak: Written[Floats]
    offset: Written[Floats]
    value: Written[Floats]
    since_s: Written[Floats]
    lost_e: Written[Floats]
    full: Written[Ints]
    level: Written[Floats]
    running: Written[Ints]
    total: Written[Floats]
    total_lost_e: Written[Floats]
    total_full: Written[Ints]

    @classmethod
    def of(cls, registers: int, block: int) -> PixelState:
        """Allocate the arrays for a block of pixels."""

        def floats(count: int = 1) -> Floats:
            return np.empty(count * block)

        rows = registers + 2
        return cls(
            pattern=floats(), leak=floats(), offset=floats(), value=floats(rows),
            since_s=floats(rows), lost_e=floats(rows), full=np.empty(rows * block, np.int64),
            level=floats(), running=np.zeros(block, np.int64), total=floats(),
            total_lost_e=floats(), total_full=np.empty(block, np.int64),
        )  # fmt: skip


ACTS, SEEN = 1, 2
"""Flags of a word in a lane. ACTS: the word acts there. SEEN: the charge before the word is read
before PIX is reset."""
