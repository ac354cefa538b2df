"""Small errors of words: those of single words, so that they add up to what sums draw at once.

Part of the loop over single pixels (`nscc_runtime.execution.pixel_loop`).
"""

from __future__ import annotations

from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.execution.charge_loop import stream_key
from nscc_runtime.execution.layout import Entry, Sizes
from nscc_runtime.loop import Floats, Ints, Ints32, Words, compiled
from nscc_runtime.noise.gaussian import normal
from nscc_runtime.noise.noise_loops import uniform

READS, RESETS, WORDS = 0, 1, 2
ERRORS = 3
"""Kinds of small errors."""
_UNKNOWN = np.uint64(0)

Entries = Annotated[NDArray[Any], Entry]


@compiled
def _stream_of(
    sizes: Sizes, base: np.uint64, at: int, number: np.uint64, found: Words
) -> np.uint64:
    """The key of draw `number` in this frame, kept in found[at] from when it is first asked for."""
    if found[at] == _UNKNOWN:
        found[at] = stream_key(base, sizes.frame, number)
    stream: np.uint64 = found[at]
    return stream


@compiled
def missing_of(
    sizes: Sizes, of_sum: np.uint64, of_part: np.uint64, place: int, first: int, stop: int,
    entry_of: Ints32, entries: Entries, weights: Floats, kind: int, missing: Floats, drawn: Floats,
    found: Words, draws: Ints, draw_keys: Words, normals: Floats,
) -> None:  # fmt: skip
    """What the draws x of the words lack of the draws z of the buckets: z - Q^T x. `drawn`: x.

    Scratch for as many draws: their places in `drawn`, their keys, themselves.
    """
    # Of each kind the streams of the buckets come first, then those of the words.
    row = kind * (sizes.buckets + sizes.words * sizes.numbered)
    buckets, count = sizes.buckets, 0
    for bucket in range(buckets):
        stream = _stream_of(sizes, of_sum, row + bucket, np.uint64(bucket), found)
        missing[kind * buckets + bucket] = normal(uniform(stream, place))
    for e in range(first, stop):
        entry = entries[entry_of[e]]
        for draw in range(sizes.draws):
            if _draws(entry, kind, draw):
                number = _drawn_number(sizes, entry, kind, draw)
                key_at = row + buckets + number
                draw_keys[count] = _stream_of(sizes, of_part, key_at, np.uint64(number), found)
                draws[count] = (e - first) * sizes.draws + draw
                count += 1
    # All draws together: LLVM makes vectors of them.
    for i in range(count):
        normals[i] = normal(uniform(draw_keys[i], place))
    for i in range(count):
        drawn[draws[i]] = normals[i]
        for bucket in range(buckets):
            at = (first * sizes.draws + draws[i]) * buckets + bucket
            missing[kind * buckets + bucket] -= weights[at] * normals[i]


@compiled
def _draws(entry: Entry, kind: int, draw: int) -> bool:
    """Whether a word has this draw of this kind of noise."""
    if kind == RESETS:
        return draw == 0 and entry.resets == 1
    if kind == READS:
        return draw == 0 and entry.reads_pix == 1
    return draw > 0 and draw <= entry.destinations


@compiled
def _drawn_number(sizes: Sizes, entry: Entry, kind: int, draw: int) -> int:
    """The number under which the reference draws it."""
    number = entry.number
    return number * sizes.numbered + draw - 1 if kind == WORDS else number


@compiled
def error_of(
    sizes: Sizes, e: int, first: int, weights: Floats, kind: int, draw: int, missing: Floats,
    drawn: Floats,
) -> float:  # fmt: skip
    """The unit normal error of one draw of word e of a lane whose words begin with `first`."""
    buckets = sizes.buckets
    found: float = drawn[(e - first) * sizes.draws + draw]
    for bucket in range(buckets):
        at = (e * sizes.draws + draw) * buckets + bucket
        found += weights[at] * missing[kind * buckets + bucket]
    return found
