"""Records and groups of arrays that are arguments of the loops over words."""

from __future__ import annotations

from typing import Annotated, NamedTuple

import numpy as np

from nscc.arrays import Array, Floats, Ints, Ints32
from nscc_runtime.loop import Written, record

WORD_BLOCK = 256
"""Number of pixels that run through their words together."""


@record
class Switches:
    """Switches of effects in the loops (0: off, 1: on), and the numbers of analog registers and
    buckets.

    The way of an effect, such as the full well: `effects/full_well.py` names its switch
    `well_clips` in an `InLoop` (`effects/effect.py`). `effects/in_loops.py` collects the switches
    of all effects that are on, `block_program.switches_of` fills this record, and functions of
    `word_loop.py` read it."""

    registers: int
    buckets: int
    reset_errors: int
    read_errors: int
    slow_words: int
    lit_level: int
    word_errors: int
    leaks: int
    well_clips: int
    """Whether PIX is clipped to the full well. `registers_bend`: whether registers saturate
    softly."""
    registers_bend: int
    compares_off: int
    compares_noisy: int
    well_bit: int
    """Bits of `saturated_by`, 0 if not marked: a full PIX was added, a full PIX was subtracted, the
    reset level contained a full PIX, a register lost too much charge."""
    subtracted_bit: int
    level_bit: int
    registers_bit: int


@record
class Numbers:
    """Parameters of effects, in electrons and seconds; 0 for effects that are off.

    `well`: the full well. `.._error`, `compare_noise`: standard deviations of one draw. `gain`,
    `move_gain`: of words that add, and of others. `lowest`, `highest`, `knee`: the range of a
    register, and the fraction of it that is linear. `frame_s`: length of the frame."""

    well: float
    reset_error: float
    read_error: float
    gain: float
    move_gain: float
    word_error: float
    move_error: float
    lowest: float
    highest: float
    knee: float
    compare_noise: float
    least_lost: float
    """Charge in electrons from which the loss of a register is marked."""
    frame_s: float


@record
class WordKeys:
    """First halves of a frame's random keys: of reads and resets of PIX (the photodiode), of
    results of words, and of comparisons. The loop completes them with the number of the frame and
    of the draw."""

    reads: np.uint64
    resets: np.uint64
    words: np.uint64
    compares: np.uint64


@record
class LoopWord:
    """An analog word, as the loops read it. `resets` (PIX), `compares`, `reads_pix`, `adds`
    (several sources): 1 if the word does this, else 0. `sources`, `destinations`: how many
    registers it reads and writes. `divisor`: its result is -(sum of its sources) / divisor. PIX is
    the photodiode."""

    resets: int
    compares: int
    reads_pix: int
    adds: int
    sources: int
    destinations: int
    operands: int
    """Index of the first source in `LoopProgram.operands`; then other sources, destinations."""
    last: int
    """Whether the word runs after the last slot."""
    end_us: float
    """The end of the word in microseconds after the beginning of its slot."""
    time_s: float
    """The time in the frame at which that slot begins, in seconds."""
    divisor: float
    in_e: float
    """The value of IN during the word, in electrons."""


OfWords = Annotated[Array, LoopWord]


class LoopProgram(NamedTuple):
    """The words of a program in order, their `operands` (see `LoopWord.operands`: numbers of analog
    registers, then PIX, then IN), and the sign, 1 or -1, of errors in each analog register. PIX is
    the photodiode. IN is the level sent to all pixels."""

    words: OfWords
    operands: Ints
    signs: Annotated[Floats, "registers"]


class Segments(NamedTuple):
    """Segments of words. Segment k runs the words with the numbers word[start[k] : start[k + 1]],
    of which only the last may compare. Before word[e], the first stretch[e] stretches (groups of
    slots between reads or resets of PIX) of the pixel have ended. Pixels whose comparison has the
    answer a (0 or 1; 0 without a comparison) continue with following[k, a]: a segment (a part of a
    path between two comparisons), or -1 - e for ending e."""

    start: Annotated[Ints, "segments+1"]
    word: Annotated[Ints32, "entries"]
    stretch: Annotated[Ints32, "entries"]
    following: Annotated[Ints, "segments 2"]


class Readouts(NamedTuple):
    """For each bucket: the number of its analog register, the gain of its readout, and the seconds
    from the end of the frame to its readout."""

    register: Annotated[Ints, "buckets"]
    gain: Annotated[Floats, "buckets"]
    wait_s: Annotated[Floats, "buckets"]


class FixedPatterns(NamedTuple):
    """Fixed patterns of all pixels of the chip, by place: the error that each addition adds in
    electrons, the leakage rate of registers in 1/s, the offset of the comparator in electrons; 0
    for effects that are off."""

    error_e: Floats
    leak_per_s: Floats
    offset_e: Floats


class PixelState(NamedTuple):
    """The state of the pixels of a block while words run, in rows of `WORD_BLOCK` numbers. The
    pixels that run a word are neighbours in each row, from the index `base` on, so that loops over
    them can be vectorised.

    `pattern`, `leak`, `offset`: see `FixedPatterns`. `level`: the reset level of PIX (the
    photodiode). `reached`: the stretch (slots that are counted as one number) that each pixel
    has reached. `fallen_fraction`: the fraction of this stretch that is collected.

    Contents of the registers, then of PIX, a row each. `value`: electrons. `since_s`: the time of
    writing. `lost_e`: electrons lost by saturation. `full`: PIX flags
    (`nscc_runtime.execution.word_loop`).

    `total`: the sum of a word's sources in each pixel that runs it, with the electrons lost by
    saturation (`total_lost_e`) and the PIX flags (`total_full`). `normals`: the normal numbers of a
    word, by draw."""

    pattern: Written[Floats]
    leak: Written[Floats]
    offset: Written[Floats]
    level: Written[Floats]
    reached: Written[Ints]
    fallen_fraction: Written[Floats]
    value: Written[Floats]
    since_s: Written[Floats]
    lost_e: Written[Floats]
    full: Written[Ints]
    total: Written[Floats]
    total_lost_e: Written[Floats]
    total_full: Written[Ints]
    normals: Written[Floats]

    @classmethod
    def of(cls, registers: int, draws: int) -> PixelState:
        """Allocate the arrays for a block of pixels; the contents are arbitrary. `registers`:
        number of analog registers. `draws`: largest number of draws of a word."""

        def floats(rows: int = 1) -> Floats:
            return np.empty(rows * WORD_BLOCK)

        def ints(rows: int = 1) -> Ints:
            return np.empty(rows * WORD_BLOCK, np.int64)

        rows = registers + 1  # PIX follows the registers
        return cls(
            pattern=floats(),
            leak=floats(),
            offset=floats(),
            level=floats(),
            reached=ints(),
            fallen_fraction=floats(),
            value=floats(rows),
            since_s=floats(rows),
            lost_e=floats(rows),
            full=ints(rows),
            total=floats(),
            total_lost_e=floats(),
            total_full=ints(),
            normals=floats(draws),
        )
