"""Gray codes: groups that follow one another differ in one bit of their codes.

A group's shutters are found by one NOR if every plane that is 1 in its code has been turned over.
In binary the step from group to group turns two bits over on average, in a Gray code (F. Gray, US
patent 2 632 058, 1953) always one. At the frame's end all must be back as they were; so the order
of the codes, which is free as long as neighbours differ in one bit, is chosen for what that costs.
"""

from __future__ import annotations

from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

Numbers = TypeVar("Numbers", int, NDArray[np.int64])


def gray(number: Numbers) -> Numbers:
    """The reflected binary code: the codes of neighbours differ in one bit."""
    return number ^ (number >> 1)


def cycle(groups: int, bits: int) -> tuple[int, ...]:
    """Codes whose last one, or last but one, is next to the first: few bits are turned back."""
    # There on the codes without the top bit and back on those with it: a circle. If the number is
    # odd, one more follows on the last.
    half = groups // 2
    there = [gray(i) for i in range(half)]
    top = 1 << bits - 1
    codes = there + [top | code for code in reversed(there)]
    if groups % 2:
        codes.append(codes[-1] ^ max(top >> 1, 1) if half else 0)
    return tuple(codes)
