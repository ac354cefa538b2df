"""Single gates, and short chains of gates, for a value that matters only in some shutters.

What is wanted is (one, zero): the shutters in which the result must be 1, and those in which it
must be 0. An OR gives it if its sources avoid `zero` and together cover `one`; a NOR if they avoid
`one` and cover `zero`. So the largest set of sources that may be read decides whether there is a
gate at all, and a small cover among them is the gate. Small covers are found greedily: a word costs
the same with one source as with all of them, so only a limit on sources makes it worth more.
"""

from __future__ import annotations

from collections.abc import Sequence

from nscc.logic.improve.code import Content
from nscc.truth import union


def cover(
    wanted: int, sources: Sequence[tuple[int, int]], limit: int | None
) -> tuple[int, ...] | None:
    """Few of `sources` (register, content) that cover `wanted`; None if they cannot.

    Of equally good ones, earlier sources are taken. At most `limit` of them.
    """
    reachable = 0
    for _, content in sources:
        reachable |= content
    if wanted & ~reachable:
        return None
    rest = wanted
    chosen: list[tuple[int, int]] = []
    while rest:
        gain = 0
        best = sources[0]
        for source in sources:
            covered = (source[1] & rest).bit_count()
            if covered > gain:
                gain, best = covered, source
        chosen.append(best)
        rest &= ~best[1]
    if len(chosen) > 2:
        chosen = _irredundant(wanted, chosen)
    if limit is not None and len(chosen) > limit:
        exact = _within(wanted, sources, limit)
        return None if exact is None else tuple(sorted(exact))
    return tuple(sorted(register for register, _ in chosen))


def _irredundant(wanted: int, chosen: list[tuple[int, int]]) -> list[tuple[int, int]]:
    for source in list(chosen):
        if not wanted & ~union(content for other, content in chosen if other != source[0]):
            chosen.remove(source)
    return chosen


def _within(wanted: int, sources: Sequence[tuple[int, int]], limit: int) -> tuple[int, ...] | None:
    """At most `limit` sources that cover `wanted`, found by trying all: those that have the first
    shutter left, one of which must be taken, so the limit is the depth of the search."""
    if not wanted:
        return ()
    if limit == 0:
        return None
    low = wanted & -wanted
    for register, content in sources:
        if content & low:
            more = _within(wanted & ~content, sources, limit - 1)
            if more is not None:
                return (register, *more)
    return None


def gate(
    one: int,
    zero: int,
    state: Sequence[Content],
    readable: Sequence[int],
    limit: int | None,
    *,
    inverted: tuple[bool, ...] = (False, True),
    fewest: int = 0,
) -> tuple[bool, tuple[int, ...]] | None:
    """One gate over `readable` registers for (one, zero): (inverted, sources); None if none does.

    With `fewest` 1 at least one source is read (WHERE cannot do without).
    """
    best: tuple[bool, tuple[int, ...]] | None = None
    for invert in inverted:
        avoid, wanted = (one, zero) if invert else (zero, one)
        allowed = _avoiding(avoid, state, readable)
        found = cover(wanted, allowed, limit)
        if found is None:
            continue
        if len(found) < fewest:
            if not allowed:
                continue
            found = (allowed[0][0],)
        if best is None or len(found) < len(best[1]):
            best = invert, found
    return best


def inner(
    one: int,
    zero: int,
    state: Sequence[Content],
    readable: Sequence[int],
    inverted: tuple[bool, ...] = (False, True),
) -> list[tuple[bool, int, int]]:
    """Ways to give (one, zero) by a gate with one more source that is not there yet.

    Each is (inverted, one', zero'): the outer gate's kind and what the new source must be. It
    reads all other registers that it may.
    """
    ways = []
    for invert in inverted:
        avoid, wanted = (one, zero) if invert else (zero, one)
        rest = wanted & ~union(content for _, content in _avoiding(avoid, state, readable))
        ways.append((invert, rest, avoid))
    return ways


def _avoiding(
    avoid: int, state: Sequence[Content], readable: Sequence[int]
) -> list[tuple[int, int]]:
    """Those of `readable`, with their contents, that hold 0 in all of `avoid`."""
    return [
        (register, content)
        for register in readable
        if (content := state[register]) is not None and not content & avoid
    ]
