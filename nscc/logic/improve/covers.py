"""Single gates, and short chains of gates, for values with don't-cares.

A target is (ones, zeros): the shutters in which the result must be 1 and those in which it must be
0. An OR computes it if its sources avoid `zeros` and together cover `ones`; a NOR if they avoid
`ones` and cover `zeros`. So a gate exists if all sources that may be read cover the target. Covers
are made small greedily; their size matters only if the number of sources is limited, because a word
costs the same with any number of sources."""

from __future__ import annotations

from collections.abc import Sequence

from nscc.logic.improve.code import Content
from nscc.truth import union


def cover(
    target: int, sources: Sequence[tuple[int, int]], limit: int | None
) -> tuple[int, ...] | None:
    """Return a small set of `sources` (register, content) that covers `target`, at most `limit` of
    them.

    None if all sources together do not cover it. Of equally good sources, earlier ones are taken.
    """
    reachable = 0
    for _, content in sources:
        reachable |= content
    if target & ~reachable:
        return None
    uncovered = target
    chosen: list[tuple[int, int]] = []
    while uncovered:
        gain = 0
        best = sources[0]
        for source in sources:
            covered = (source[1] & uncovered).bit_count()
            if covered > gain:
                gain, best = covered, source
        chosen.append(best)
        uncovered &= ~best[1]
    if len(chosen) > 2:
        for source in list(chosen):
            other_contents = [content for register, content in chosen if register != source[0]]
            if not target & ~union(other_contents):
                chosen.remove(source)
    if limit is not None and len(chosen) > limit:
        exact = _within(target, sources, limit)
        return None if exact is None else tuple(sorted(exact))
    return tuple(sorted(register for register, _ in chosen))


def _within(target: int, sources: Sequence[tuple[int, int]], limit: int) -> tuple[int, ...] | None:
    """Return at most `limit` sources that cover `target`, by exhaustive search; None if there are
    none.

    Each step tries the sources that contain the first uncovered shutter."""
    if not target:
        return ()
    if limit == 0:
        return None
    low = target & -target
    for register, content in sources:
        if content & low:
            deeper = _within(target & ~content, sources, limit - 1)
            if deeper is not None:
                return (register, *deeper)
    return None


def gate(
    ones: int,
    zeros: int,
    state: Sequence[Content],
    readable: Sequence[int],
    limit: int | None,
    *,
    inverted: tuple[bool, ...] = (False, True),
    fewest: int = 0,
) -> tuple[bool, tuple[int, ...]] | None:
    """Return a gate over `readable` registers that is 1 on `ones` and 0 on `zeros`, as (inverted,
    sources).

    None if there is no such gate. With `fewest` 1 at least one source is read, as WHERE requires.
    """
    best: tuple[bool, tuple[int, ...]] | None = None
    for invert in inverted:
        avoid, target = (ones, zeros) if invert else (zeros, ones)
        allowed = _avoiding(avoid, state, readable)
        chosen = cover(target, allowed, limit)
        if chosen is None:
            continue
        if len(chosen) < fewest:
            if not allowed:
                continue
            chosen = (allowed[0][0],)
        if best is None or len(chosen) < len(best[1]):
            best = invert, chosen
    return best


def inner(
    ones: int,
    zeros: int,
    state: Sequence[Content],
    readable: Sequence[int],
    inverted: tuple[bool, ...] = (False, True),
) -> list[tuple[bool, int, int]]:
    """Return gates that would be 1 on `ones` and 0 on `zeros` if they had one additional source.

    Each item is (inverted, ones', zeros'). `inverted` means a NOR, otherwise the gate is an OR. The
    additional source must be 1 on ones' and 0 on zeros'. The gate also reads all other registers
    that it may read."""
    ways = []
    for invert in inverted:
        avoid, target = (ones, zeros) if invert else (zeros, ones)
        for _, content in _avoiding(avoid, state, readable):
            target &= ~content
        ways.append((invert, target, avoid))
    return ways


def _avoiding(
    avoid: int, state: Sequence[Content], readable: Sequence[int]
) -> list[tuple[int, int]]:
    """Return the `readable` registers, with their contents, that are 0 in all of `avoid`."""
    return [
        (register, content)
        for register in readable
        if (content := state[register]) is not None and not content & avoid
    ]
