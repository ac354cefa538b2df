"""The order in which sizes are compiled: powers of two, sizes that need one more bit, then
bisection between fitting and failing sizes.

Searches count compilations, not time, so they end at the same sizes on every machine.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping
from dataclasses import dataclass, field
from typing import Any

from nscc.program.capacity import Count, largest_with

GIVE_UP_AFTER = 2
"""Number of consecutive failing candidates after which larger ones are skipped."""


_ALIKE = 1.02
"""A power of two is skipped if a larger candidate is within this factor."""


@dataclass(frozen=True)
class SizeTrial:
    """A compiled program of one size; `fits` means that its words were proved. `figures` are its
    costs. If it does not fit, `code` and `reason` are those of the error, and `proved` means that
    no compiler can make it fit."""

    size: int
    fits: bool
    figures: Mapping[str, Any] = field(default_factory=dict)
    code: str = ""
    reason: str = ""
    proved: bool = False


def candidates(count: Count, least: int, most: int) -> list[int]:
    """The sizes that a search compiles first, ascending; `count(size)` is the number of
    shutters."""
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
    """Compile the ascending `sizes`, then search beyond the largest that fits. Yields at most
    `budget` trials as they end, and returns all by size. Each step tries the next larger size
    before the middle, because limits often lie where one more bit is needed."""
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
    """The largest size in `least`..`most` that was found to fit in at most `budget` attempts. Tries
    `most` first and then bisects. Exact if every smaller size of a fitting size fits and the budget
    suffices."""
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
