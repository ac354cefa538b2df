"""Windows: bumps of one length, which only the end of the frame may cut.

Time is cut into groups as long as the bump, so that an open bump began in this group or in the one
before, and a start is a group and an offset. In one of the two groups the shutter is open from
its offset on, in the other up to it. The planes of the offset are stored inverted for every other
group, so that both cases read them alike, and groups are in Gray code: the planes that two
neighbours share pick out both at once.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product

import numpy as np
from numpy.typing import NDArray

from nscc.logic.bumps import Bumps, bumps_of
from nscc.logic.chains import Planes, radices_of, turn_over
from nscc.logic.cubes import Budget
from nscc.logic.problem import GaveUp, Machine, Problem, Segment, Solution
from nscc.logic.walk import Script, walk
from nscc.truth import columns


def windows(problem: Problem, machine: Machine, steps: int) -> Iterator[Solution]:
    """Offsets in mixed-radix thermometers, some planes held both ways round where there is room."""
    bumps = bumps_of(problem)
    length = _length(bumps)
    bits = max(1, (-(-bumps.steps // length) - 1).bit_length())
    room = machine.registers - 1 - bits
    tried = 0
    choices = radices_of(room + length.bit_length(), length)
    for chosen in sorted(choices, key=lambda r: (len(r), sum(r))):
        held = sum(chosen) - len(chosen)
        for doubled, low in product((False, True), range(bits, -1, -1)):
            if held * (1 + doubled) + low > room:
                continue
            for early in (True, False) if low < bits else (True,):
                script = _script(bumps, length, chosen, bits, doubled, low, early)
                try:
                    yield walk(problem, machine, script, Budget(steps))
                except GaveUp:
                    continue
                tried += 1
            if tried >= (_MOST_TRIED if bumps.steps <= 256 else _MOST_TRIED // 4):
                return


_MOST_TRIED = 24


def _length(bumps: Bumps) -> int:
    length = bumps.length
    whole = np.minimum(bumps.start + length, bumps.steps)
    if length < 2 or np.any((bumps.stop != whole) & ~bumps.never):
        raise GaveUp("bumps of different lengths")
    if 2 * length > bumps.steps:
        raise GaveUp("bumps longer than half of the frame")
    return length


def _offset_planes(
    offsets: NDArray[np.int64], chosen: Sequence[int], odd: NDArray[np.bool_]
) -> Planes:
    planes: list[int] = []
    holders: list[str] = []
    size = int(np.prod(chosen))
    for place, radix in enumerate(chosen):
        size //= radix
        digit = offsets // size % radix
        for m in range(radix - 1):
            planes += columns(((digit <= m) ^ odd)[:, None])
            name = f"digit {len(chosen) - 1 - place} <= {m}"
            holders.append(f"offset in its group, {name}, turned in odd groups")
    return tuple(planes), tuple(holders)


def _script(
    bumps: Bumps,
    length: int,
    chosen: Sequence[int],
    bits: int,
    doubled: bool,
    low: int,
    early: bool,
) -> Script:
    """`doubled`: offset planes both ways round; so are the `low` lowest bits of the group.

    The bit in which a group differs from the one before is turned over with it, or, where not
    `early`, with the group after each odd one.
    """
    group = np.where(bumps.never, 0, bumps.start // length)
    odd = group % 2 == 1
    offset = _offset_planes(bumps.start % length, chosen, odd)
    gray = group ^ group >> 1
    everything = (1 << len(bumps.start)) - 1
    planes = list(offset[0])
    holders = list(offset[1])
    if doubled:
        planes += [everything & ~p for p in offset[0]]
        holders += [f"{text}, inverted" for text in offset[1]]
    place: dict[int, int] = {}
    for bit in range(bits):
        vector = columns((gray >> bit & 1 == 1)[:, None])[0]
        place[bit] = len(planes)
        planes.append(vector)
        holders.append(f"group, Gray bit {bit}")
        if bit < low:
            planes.append(everything & ~vector)
            holders.append(f"group, Gray bit {bit}, inverted")
    before: dict[int, tuple[Segment, ...]] = {}
    standing = 0
    done = 0
    for i, step in enumerate(bumps.step):
        if step // length == done:
            continue
        done = step // length
        asked = done - 1 if done % 2 and not early else done
        asked ^= asked >> 1
        turned = [b for b in range(low, bits) if (asked ^ standing) >> b & 1]
        standing = asked
        before[i] = tuple((turn_over(place[b]),) for b in turned)
    closing = tuple((turn_over(place[b]),) for b in range(low, bits) if standing >> b & 1)
    digits = " x ".join(str(r) for r in chosen)
    name = f"groups of {length} in Gray code, offset in digits {digits}"
    if doubled or low:
        name += ", some both ways round"
    return Script(name, tuple(planes), tuple(holders), 0, (), before, closing)
