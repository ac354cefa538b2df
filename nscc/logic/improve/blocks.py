"""Repeated sequences of segments, found by merging the most frequent pairs.

This is Re-Pair (Larsson and Moffat, Proc. IEEE 2000). Improving a whole sequence gains more than
improving its segments separately. But every sequence that is treated separately has its own
segments in the store."""

from __future__ import annotations

from collections import Counter
from collections.abc import Hashable, Sequence
from dataclasses import dataclass
from itertools import pairwise

from nscc.logic.improve.code import Check, FrameContext, Item

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
        pairs = self._pairs()
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
                self._replace(first, second, merged)
                return True
        return False

    def _pairs(self) -> Counter[tuple[int, int]]:
        """Return the counts of neighbouring pairs; overlapping pairs of equal symbols count
        once."""
        pairs: Counter[tuple[int, int]] = Counter()
        run = 1
        for first, second in pairwise(self.sequence):
            run = run + 1 if first == second else 1
            if run % 2 == 0 or first != second:
                pairs[first, second] += 1
        return pairs

    def _replace(self, first: int, second: int, words: int) -> None:
        symbol = len(self.words)
        self.words.append(words)
        self.lengths.append(self.lengths[first] + self.lengths[second])
        out: list[int] = []
        for following in self.sequence:
            if out and (out[-1], following) == (first, second):
                out[-1] = symbol
            else:
                out.append(following)
        self.sequence = out
