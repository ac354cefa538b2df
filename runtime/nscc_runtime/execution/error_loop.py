"""Small errors of single words, consistent with the sum of errors that frames by sums draw at once.

This is part of the loop over single pixels (`nscc_runtime.execution.pixel_loop`)."""

from __future__ import annotations

from typing import Annotated, NamedTuple

import numpy as np

from nscc_runtime.execution.layout import LoopWord, OfWords, Sizes
from nscc_runtime.loop import Bytes, Floats, Ints, Ints32, Words, Written, compiled
from nscc_runtime.noise.counter import bits
from nscc_runtime.noise.gaussian import normal
from nscc_runtime.noise.noise_loops import uniform

READS, RESETS, WORDS = 0, 1, 2
ERRORS = 3
"""Number of kinds of small errors."""
_UNKNOWN = np.uint64(0)


class Lanes(NamedTuple):
    """The words of each lane (code number).

    `of_pixel`: the lane of each pixel. The words of lane l are at start[l] to start[l + 1] - 1 of
    `word` (their index among the program's words), `flags`, and `weights` (the weights of their
    draws in the buckets)."""

    of_pixel: Annotated[Ints32, "rows cols"]
    start: Annotated[Ints, "lanes+1"]
    word: Annotated[Ints32, "listed"]
    flags: Annotated[Bytes, "listed"]
    weights: Annotated[Floats, "listed draws buckets"]


class ErrorScratch(NamedTuple):
    """Working memory: `streams`, cached random keys (0 at first); `missing`, the part of the
    buckets' draws that words do not explain; `drawn`, the errors of the words of a lane. `draws`,
    `keys` and `normals` are the indices, keys and values of draws that are made together."""

    streams: Written[Words]
    missing: Written[Floats]
    drawn: Written[Floats]
    draws: Written[Ints]
    keys: Written[Words]
    normals: Written[Floats]


@compiled
def _stream_of(
    sizes: Sizes, base: np.uint64, at: int, number: np.uint64, streams: Words
) -> np.uint64:
    """Return the random key of draw `number` in this frame, cached in streams[at]."""
    if streams[at] == _UNKNOWN:
        streams[at] = bits(base, sizes.frame, number)
    stream: np.uint64 = streams[at]
    return stream


@compiled
def draw_errors(
    sizes: Sizes, buckets: int, of_sum: np.uint64, of_part: np.uint64, place: int, lane: int,
    lanes: Lanes, words: OfWords, kind: int, errors: ErrorScratch,
) -> None:  # fmt: skip
    """Draw the standard normal errors of one kind for each word of a lane into `errors.drawn`.

    Q (z - Q^T x) is added to the draws x of the words, where z are the draws of the buckets and Q
    are their weights. The weighted sum of the errors then equals z."""
    # The streams of a kind are those of the buckets, then those of the words.
    row = kind * (buckets + sizes.words * sizes.numbered)
    count, first = 0, lanes.start[lane]
    for bucket in range(buckets):
        stream = _stream_of(sizes, of_sum, row + bucket, np.uint64(bucket), errors.streams)
        errors.missing[bucket] = normal(uniform(stream, place))
    for e in range(first, lanes.start[lane + 1]):
        word = words[lanes.word[e]]
        for draw in range(sizes.draws):
            if _draws(word, kind, draw):
                number = word.number
                if kind == WORDS:
                    number = number * sizes.numbered + draw - 1
                at = row + buckets + number
                errors.keys[count] = _stream_of(
                    sizes, of_part, at, np.uint64(number), errors.streams
                )
                errors.draws[count] = (e - first) * sizes.draws + draw
                count += 1
    # A separate loop over all draws, so that LLVM vectorises it.
    for i in range(count):
        errors.normals[i] = normal(uniform(errors.keys[i], place))
    for i in range(count):
        at = (first * sizes.draws + errors.draws[i]) * buckets
        for bucket in range(buckets):
            errors.missing[bucket] -= lanes.weights[at + bucket] * errors.normals[i]
    for i in range(count):
        at = (first * sizes.draws + errors.draws[i]) * buckets
        error = errors.normals[i]
        for bucket in range(buckets):
            error += lanes.weights[at + bucket] * errors.missing[bucket]
        errors.drawn[errors.draws[i]] = error


@compiled
def _draws(word: LoopWord, kind: int, draw: int) -> bool:
    """Return whether a word has this draw of this kind of noise."""
    if kind == RESETS:
        return draw == 0 and word.resets == 1
    if kind == READS:
        return draw == 0 and word.reads_pix == 1
    return draw > 0 and draw <= word.destinations
