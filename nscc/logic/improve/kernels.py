"""Improvement of kernels that keeps equal segments equal: one rewriting serves all their places.

The problem of a sequence of segments has one shutter for each pair of shutter and place: the truth
vectors of all places are concatenated. A rewriting that is correct for these is correct in every
place, and all passes work unchanged."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import chain

from nscc.logic.cubes import Budget
from nscc.logic.improve.blocks import Block, SegmentToken, blocks_of
from nscc.logic.improve.code import Check, Content, FrameContext, Illegal, Item
from nscc.logic.improve.tracked_run import TrackedRun
from nscc.truth import union

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
