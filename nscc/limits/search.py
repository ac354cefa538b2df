"""Search for the largest size that fits: the sizes to compile, in order.

First come powers of two and the last sizes before another bit is needed, then bisection between
fitting and failing sizes. The search counts compilations instead of time, so that it ends at the
same sizes on every machine."""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping
from dataclasses import dataclass, field
from typing import Any

from nscc.program.limits import Count, largest_with

GIVE_UP_AFTER = 2
"""Number of consecutive failing candidates after which larger candidates are skipped."""


_ALIKE = 1.02
"""A power of two is skipped if a larger candidate is within this factor."""


@dataclass(frozen=True)
class SizeTrial:
    """The result of compiling a program of one size.

    `fits` means that the program fits and its words were proved; `figures` are its costs. Otherwise
    `code` and `reason` are those of the error, and `proved` means that no compiler can make the
    program fit."""

    size: int
    fits: bool
    figures: Mapping[str, Any] = field(default_factory=dict)
    code: str = ""
    reason: str = ""
    proved: bool = False


def candidates(count: Count, least: int, most: int) -> list[int]:
    """Return the sizes that a search compiles first, ascending.

    `count(size)` is the number of shutters."""
    steps = {least, most}
    bits = 0
    while (size := largest_with(count, 1 << bits, least, most)) < most:
        steps.add(size)
        bits += 1
    powers = [1 << k for k in range(most.bit_length())]
    telling = [p for p in powers if not any(p < step < p * _ALIKE for step in steps)]
    return sorted(size for size in {*steps, *telling} if least <= size <= most)


def explore(
    sizes: list[int], attempt: Callable[[int], SizeTrial], budget: int
) -> Generator[SizeTrial, None, dict[int, SizeTrial]]:
    """Compile the ascending `sizes`, then search beyond the largest that fits.

    Yields at most `budget` trials as they end, and returns all trials by size. Each step tries the
    next larger size before the middle, because limits often lie where another bit is needed."""
    trials: dict[int, SizeTrial] = {}

    def make(size: int) -> Generator[SizeTrial, None, bool]:
        trials[size] = attempt(size)
        yield trials[size]
        return trials[size].fits

    failures = 0
    for size in sizes:
        if len(trials) == budget or failures == GIVE_UP_AFTER:
            break
        failures = 0 if (yield from make(size)) else failures + 1
    largest_fit = max((t.size for t in trials.values() if t.fits), default=None)
    if largest_fit is None:
        return trials
    smallest_misfit = min((size for size in trials if size > largest_fit), default=largest_fit + 1)
    probe = largest_fit + 1
    while smallest_misfit - largest_fit > 1 and len(trials) < budget:
        if (yield from make(probe)):
            largest_fit = probe
        else:
            smallest_misfit = probe
        probe = (largest_fit + smallest_misfit) // 2
    return trials


def largest(least: int, most: int, fits: Callable[[int], bool], budget: int) -> int | None:
    """Return the largest size in `least`..`most` that fits, found by bisection; None if none was
    found.

    At most `budget` sizes are tried, `most` first. The result is exact if all sizes below a fitting
    size fit and the budget suffices."""
    if most < least or budget < 1:
        return None
    if fits(most):
        return most
    low, high = least - 1, most
    for _ in range(budget - 1):
        if high - low <= 1:
            break
        middle = (low + high) // 2
        if fits(middle):
            low = middle
        else:
            high = middle
    return low if low >= least else None
