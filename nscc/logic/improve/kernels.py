"""Improvement of kernels that keeps equal segments equal: one rewriting serves all their places.

The problem of a sequence of segments has one shutter for each pair of shutter and place: the truth
vectors of all places are concatenated. A rewriting that is correct for these is correct in every
place, and all passes work unchanged.

Repeated sequences are found by merging the most frequent pairs. This is Re-Pair (Larsson and
Moffat, Proc. IEEE 2000). Improving a whole sequence gains more than improving its segments
separately. But every sequence that is treated separately has its own segments in the store."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass, replace
from itertools import chain, pairwise

from nscc.logic.cubes import Budget
from nscc.logic.improve.code import Check, Content, FrameContext, Illegal, Item
from nscc.logic.improve.tracked_run import TrackedRun
from nscc.truth import union

FEWEST = 2
"""Pairs with fewer occurrences are not merged."""


@dataclass(frozen=True, slots=True)
class SegmentToken:
    """The items[start:end] of a run: a segment, or one check; tokens with equal `key` do
    the same."""

    start: int
    end: int
    key: Hashable


Block = list[tuple[SegmentToken, ...]]
"""Equal sequences of tokens, one for each place where they occur."""


def tokens_of(items: Sequence[Item]) -> list[SegmentToken]:
    """Return the segments and checks of a run as tokens."""
    tokens = []
    k = 0
    while k < len(items):
        first = items[k]
        end = k + 1
        if isinstance(first, Check):
            tokens.append(SegmentToken(k, end, (first.need is None, first.forgets)))
        else:
            while end < len(items):
                item = items[end]
                if isinstance(item, Check) or item.segment != first.segment:
                    break
                end += 1
            key = tuple(item.function for item in items[k:end] if not isinstance(item, Check))
            tokens.append(SegmentToken(k, end, key))
        k = end
    return tokens


def blocks_of(frame: FrameContext, items: Sequence[Item], room: int) -> list[Block]:
    """Return the distinct sequences, most words per frame first.

    All their segments take at most `room` words. Without room, every segment is a sequence."""
    tokens = tokens_of(items)
    merger = _Merger(frame, items, tokens)
    while merger.merge(room):
        pass
    places: dict[int, Block] = {}
    at = 0
    for symbol in merger.sequence:
        length = merger.lengths[symbol]
        places.setdefault(symbol, []).append(tuple(tokens[at : at + length]))
        at += length
    order = sorted(places, key=lambda symbol: -merger.words[symbol] * len(places[symbol]))
    return [places[symbol] for symbol in order if merger.words[symbol]]


class _Merger:
    """The run as a sequence of symbols, each of which represents several tokens."""

    def __init__(
        self, frame: FrameContext, items: Sequence[Item], tokens: Sequence[SegmentToken]
    ) -> None:
        number: dict[Hashable, int] = {}
        self.sequence = [number.setdefault(token.key, len(number)) for token in tokens]
        self.lengths = [1] * len(number)
        self.words = [0] * len(number)
        for token in tokens:
            words = sum(frame.words(item) for item in items[token.start : token.end])
            self.words[number[token.key]] = words

    def merge(self, room: int) -> bool:
        """Merge the most frequent pair of symbols; return False if no pair is worth it."""
        # Neighbouring pairs; overlapping pairs of equal symbols count once.
        pairs: Counter[tuple[int, int]] = Counter()
        run = 1
        for first, second in pairwise(self.sequence):
            run = run + 1 if first == second else 1
            if run % 2 == 0 or first != second:
                pairs[first, second] += 1
        counts = Counter(self.sequence)
        stored = sum(self.words[symbol] for symbol in counts)
        for (first, second), times in pairs.most_common():
            if times < FEWEST:
                return False
            merged = self.words[first] + self.words[second]
            uses_per_pair = 2 if first == second else 1
            # A symbol that occurs only in this pair needs no separate words after the merge.
            gone = sum(self.words[s] for s in {first, second} if counts[s] == times * uses_per_pair)
            if stored + merged - gone <= room:
                symbol = len(self.words)
                self.words.append(merged)
                self.lengths.append(self.lengths[first] + self.lengths[second])
                out: list[int] = []
                for following in self.sequence:
                    if out and (out[-1], following) == (first, second):
                        out[-1] = symbol
                    else:
                        out.append(following)
                self.sequence = out
                return True
        return False


Pass = Callable[[FrameContext, list[Item], Budget], list[Item]]
"""A function that shortens the items of a frame or a part of a frame."""


def improve_kernels(
    frame: FrameContext, items: list[Item], budget: Budget, shorten: Pass, room: int
) -> list[Item]:
    """Shorten each kernel by the pass `shorten`, in the same way in all places.

    Sequences of kernels are improved together if `room` allows (see `blocks_of`)."""
    run = TrackedRun(frame, items, budget)
    # The current items for each original item: rewriting a block replaces them.
    replacements: list[list[Item]] = [[item] for item in run.items]
    for block in blocks_of(frame, run.items, room):
        new = _shortened(frame, run, block, budget, shorten)
        if new is None:
            continue
        for tokens in block:
            start, end = tokens[0].start, tokens[-1].end
            replacements[start:end] = [
                _moved(run.items, block[0], tokens, new),
                *[[]] * (end - start - 1),
            ]
    return list(chain.from_iterable(replacements))


def _shortened(
    frame: FrameContext, run: TrackedRun, block: Block, budget: Budget, shorten: Pass
) -> list[Item] | None:
    """Return shorter items for the first place of a block; None if not found."""
    size = (frame.everything.bit_length() + 7) // 8
    starts = [tokens[0].start for tokens in block]
    length = block[0][-1].end - starts[0]
    live = union(run.live[k + length] for k in starts)
    states = zip(*(run.before[k] for k in starts), strict=True)
    start = tuple(_joined(contents, size) for contents in states)
    everything = _joined([frame.everything] * len(starts), size)
    assert everything is not None
    block_frame = replace(frame, everything=everything, start=start, ends=live)
    items = run.items[starts[0] : starts[0] + length]
    for offset, item in enumerate(items):
        if isinstance(item, Check) and item.need is not None:
            checks = [run.items[k + offset] for k in starts]
            needs = [check.need for check in checks if isinstance(check, Check)]
            items[offset] = replace(item, need=_joined(needs, size))
    try:
        shorter = shorten(block_frame, items, budget)
    except Illegal:
        return None
    return shorter if block_frame.total(shorter) < block_frame.total(items) else None


def _joined(contents: Sequence[Content], size: int) -> Content:
    """Return concatenated truth vectors, each in `size` bytes; None if one of them is unknown."""
    known = [content.to_bytes(size, "little") for content in contents if content is not None]
    return int.from_bytes(b"".join(known), "little") if len(known) == len(contents) else None


def _moved(
    items: Sequence[Item],
    first: Sequence[SegmentToken],
    target_tokens: Sequence[SegmentToken],
    new: Sequence[Item],
) -> list[Item]:
    """Return the items for a block's first place, moved to another place."""
    segments: dict[tuple[int, int], tuple[int, int]] = {}
    checks = []
    for token, target_token in zip(first, target_tokens, strict=True):
        a, b = items[token.start], items[target_token.start]
        if isinstance(a, Check) or isinstance(b, Check):
            checks.append(b)
        else:
            segments[a.place, a.segment] = b.place, b.segment
    out: list[Item] = []
    coming = iter(checks)
    for item in new:
        if isinstance(item, Check):
            out.append(next(coming))
        else:
            place, segment = segments[item.place, item.segment]
            out.append(replace(item, place=place, segment=segment))
    return out
