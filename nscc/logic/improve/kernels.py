"""Segments that are equal stay equal: one rewriting serves all places where a kernel runs.

What a kernel does is a problem of its own, in which every shutter counts once for each place where
the kernel runs: the truth vectors of all places are laid end to end.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from nscc.logic.cubes import Budget
from nscc.logic.improve.code import Check, Content, Frame, Illegal, Item, Op
from nscc.logic.improve.run import Run

Kernel = tuple[tuple[bool, int, int], ...]
"""The functions of a segment's operations."""

Pass = Callable[[Run], None]


def kernels_of(items: Sequence[Item]) -> dict[Kernel, list[int]]:
    """Every distinct segment, and the items with which it begins."""
    found: dict[Kernel, list[int]] = {}
    k = 0
    while k < len(items):
        first = items[k]
        if isinstance(first, Check):
            k += 1
            continue
        end = _end(items, k)
        key = tuple(item.function for item in items[k:end] if isinstance(item, Op))
        found.setdefault(key, []).append(k)
        k = end
    return found


def _end(items: Sequence[Item], k: int) -> int:
    first = items[k]
    assert isinstance(first, Op)
    end = k
    while end < len(items):
        item = items[end]
        if isinstance(item, Check) or item.segment != first.segment:
            break
        end += 1
    return end


def improve_kernels(frame: Frame, items: list[Item], budget: Budget, shorten: Pass) -> list[Item]:
    """`items` with each kernel shortened by `shorten`, in all its places alike.

    Kernels come in the order of the words that they take in a frame.
    """
    queue = kernels_of(items)
    order = sorted(queue, key=lambda kernel: -len(queue[kernel]) * len(kernel))
    run = Run(frame, items, budget)
    for kernel in order:
        places = kernels_of(run.items).get(kernel)
        if places is None:
            continue
        new = _shortened(frame, run, places, len(kernel), budget, shorten)
        if new is None:
            continue
        try:
            run = Run(frame, _replaced(run.items, places, len(kernel), new), budget)
        except Illegal:
            continue
    return run.items


def _shortened(
    frame: Frame, run: Run, places: Sequence[int], length: int, budget: Budget, shorten: Pass
) -> list[Op] | None:
    """The operations of a shorter kernel; None if there is none."""
    size = (frame.everything.bit_length() + 7) // 8
    live = 0
    for k in places:
        live |= run.live[k + length]
    start = tuple(
        _joined([run.before[k][register] for k in places], size)
        for register in range(frame.flag + 1)
    )
    everything = _joined([frame.everything] * len(places), size)
    assert everything is not None
    part = replace(frame, everything=everything, start=start, ends=live)
    kernel = run.items[places[0] : places[0] + length]
    try:
        inner = Run(part, kernel, budget)
    except Illegal:
        return None
    before = part.total(kernel)
    shorten(inner)
    if inner.words() >= before:
        return None
    return [item for item in inner.items if isinstance(item, Op)]


def _joined(contents: Sequence[Content], size: int) -> Content:
    """Truth vectors end to end, each in `size` bytes; None if one of them is unknown."""
    known = [content.to_bytes(size, "little") for content in contents if content is not None]
    return int.from_bytes(b"".join(known), "little") if len(known) == len(contents) else None


def _replaced(
    items: Sequence[Item], places: Sequence[int], length: int, new: Sequence[Op]
) -> list[Item]:
    out: list[Item] = []
    at = 0
    for k in places:
        out.extend(items[at:k])
        first = items[k]
        assert isinstance(first, Op)
        out.extend(replace(item, place=first.place, segment=first.segment) for item in new)
        at = k + length
    out.extend(items[at:])
    return out
