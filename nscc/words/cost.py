"""Costs of words in store and time, from the target's parameters."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import fsum

from nscc.chips.target import Target
from nscc.operations import Op, Phase, Word
from nscc.record import Record
from nscc.words.container import Container, StoredKernel
from nscc.words.encoding import matching

_CLOCK_CLASS = 7 << 19
"""The bits of a word's first integer that select its clock; all 0 for the analog one."""


class WordsCost(Record):
    """A number of words, and their time `us` in microseconds."""

    words: int
    us: float


class FrameCost(Record):
    """The costs of one frame of a container (a compiled program), without the words of images and
    planes.

    `stored_words` are in the instruction store. `words` are executed per frame, in `busy_us`, with
    `launches` starts of kernels (lists of words). `frame_us` is the sum of all slots, `busiest_us`
    the longest time of words at one boundary. Times are in microseconds and include those of
    launches."""

    stored_words: int
    words: int
    launches: int
    busy_us: float
    busiest_us: float
    frame_us: float


def words_cost(words: Iterable[Word], target: Target) -> WordsCost:
    """Return number and time of words on `target`, without the time of a launch (start of a
    kernel).

    Each of `words` is five integers of 32 bits; it need not be valid. Words that only the target
    has may have a time of their own. A kernel is a list of words."""
    analog = digital = 0
    own_us = []
    for word in words:
        op = matching(word, target.words) if target.words else None
        if op is not None and op.operation.us is not None:
            own_us.append(op.operation.us)
        elif word[0] & _CLOCK_CLASS:
            digital += 1
        else:
            analog += 1
    us = words_us(analog, digital, target) + fsum(own_us)
    return WordsCost(analog + digital + len(own_us), us)


def word_us(word: Op, target: Target) -> float:
    """Return the time of one word in microseconds: its own if it has one, else that of an analog or
    a digital word."""
    if word.operation.us is not None:
        return word.operation.us
    return target.analog_word_us if word.analog else target.digital_word_us


def words_us(analog: int, digital: int, target: Target) -> float:
    """Return the time in microseconds of `analog` analog and `digital` digital words, without a
    launch (start of a kernel). A kernel is a list of words."""
    return analog * target.analog_word_us + digital * target.digital_word_us


def refresh_count(words: Sequence[Op]) -> int:
    """Return the number of `words`, in order, that only write a register again, before it loses its
    bits.

    These are REFRESH pairs. A masked register can be written only where its mask is 1, so the words
    around its refresh count, too: SET of the mask, and those that save the mask's own code in FLAG
    (the bit that lets a pixel act) and restore it."""
    count = 0
    for i, word in enumerate(words):
        if not word.operation.name.startswith("REFRESH"):
            continue
        count += 1
        before = [w.operation.name for w in words[max(0, i - 2) : i]]
        if word.operation.phase is Phase.READ and before[-1:] == ["SET"]:
            count += 1
            if before == ["WHERE", "SET"] and words[i - 2].sources == words[i - 1].destinations:
                count += 2  # the WHERE before, and the word after that restores the mask's code
    return count


def kernel_cost(kernel: StoredKernel, target: Target) -> WordsCost:
    """Return the number of words of a kernel (a list of words), and the time of starting and
    running it once."""
    cost = words_cost(kernel.words, target)
    return WordsCost(cost.words, cost.us + target.launch_us)


def frame_cost(container: Container) -> FrameCost:
    """Return the cost of one frame of a container (a compiled program), without the words of images
    and planes.

    A container without words costs only the time of its slots."""
    costs = [kernel_cost(kernel, container.target) for kernel in container.kernels]
    at_instant = [0.0] * (container.slots + 1)
    words = 0
    for launch in container.launches:
        at_instant[launch.instant] += costs[launch.kernel].us
        words += costs[launch.kernel].words
    return FrameCost(
        stored_words=sum(cost.words for cost in costs),
        words=words,
        launches=len(container.launches),
        busy_us=fsum(at_instant),
        busiest_us=max(at_instant),
        frame_us=fsum(container.slot_us),
    )
