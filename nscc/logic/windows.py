"""Generator for bumps of one length, which only the end of the frame may cut.

Time is divided into groups of the bump's length, so an open bump started in this group or in the
previous one; a start is a group and an offset. If it started in this group, the shutter is open
from its offset on; if it started in the previous group, it is open before its offset. The offset
planes are inverted in every other group, so that both cases read the same plane. Groups are in Gray
code: the planes in which two neighbours agree select both."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from enum import Enum
from itertools import product

import numpy as np

from nscc.logic.bumps import Bumps, bumps_of
from nscc.logic.digits import binary_planes, cycle, gray, radices_of, thermometers, turned_over
from nscc.logic.problem import Gate, GaveUp, Machine, Problem, Segment, Solution
from nscc.logic.script_walk import Script, walk
from nscc.truth import set_bits


def windows(problem: Problem, machine: Machine, steps: int) -> Iterator[Solution]:
    """Yield solutions with offsets in mixed-radix thermometers, and both polarities if there is
    room."""
    bumps = bumps_of(problem)
    length = _length(bumps)
    if length > _LONGEST:
        raise GaveUp("covers of longer bumps become shorter than windows")
    groups = -(-bumps.steps // length)
    bits = max(1, (groups - 1).bit_length())
    codes = cycle(groups, bits)
    room = machine.registers - 1 - bits
    solution_count = 0
    choices = radices_of(room + length.bit_length(), length)
    for chosen in sorted(choices, key=lambda r: (len(r), sum(r))):
        offset_planes = sum(chosen) - len(chosen)
        for doubled, low in product((False, True), range(bits, -1, -1)):
            if offset_planes * (1 + doubled) + low > room:
                continue
            for turns in _Turns if low < bits else (_Turns.WITH,):
                script = _script(bumps, length, chosen, codes, bits, doubled, low, turns)
                for solution in walk(problem, machine, script, steps):
                    yield solution
                    solution_count += 1
            # The time of a walk grows with the steps of a frame.
            if solution_count >= (_MOST_TRIED if bumps.steps <= 256 else _MOST_TRIED // 4):
                return


# Longer bumps take fewer words as covers of the shutter's number, once these are improved.
_LONGEST = 5
_MOST_TRIED = 48


class _Turns(Enum):
    """When the bit is inverted in which a group differs from the previous group.

    This bit is not read in that group, unless the two groups must be distinguished."""

    WITH = "with the group"
    AFTER = "with the next group"
    EVEN = "with the group if that is even, else with the next"


def toggled_windows(problem: Problem, machine: Machine, steps: int) -> Iterator[Solution]:
    """Yield solutions with offsets in Gray code, with few registers.

    Every step toggles the state of the shutters of this group and the previous one whose offset
    equals the step."""
    bumps = bumps_of(problem)
    length = _length(bumps)
    high = max(1, (-(-bumps.steps // length) - 1).bit_length())
    low = (length - 1).bit_length()
    for in_flag in (True, False):
        scratch = machine.registers - high - low - (not in_flag)
        if scratch < 2 or (in_flag and not problem.flag_lasts):
            continue
        script = _toggle_script(bumps, length, high, low, in_flag, scratch > 2)
        yield from walk(problem, machine, script, steps)


def _toggle_script(
    bumps: Bumps, length: int, high: int, low: int, in_flag: bool, roomy: bool
) -> Script:
    if np.any(bumps.never):
        raise GaveUp("shutters that never open have no window")
    planes = binary_planes("offset in its group, Gray bit", gray(bumps.start % length), low)
    planes += binary_planes("group, Gray bit", gray(bumps.start // length), high)
    state = "FLAG" if in_flag else "s0"
    before: dict[int, tuple[Segment, ...]] = {}
    standing = 0
    for step, i in bumps.groups():
        now, place = divmod(step, length)
        target = gray(now) << low | gray(place)
        flips = turned_over(set_bits(standing ^ target))
        standing = target
        # A NOR without the bit in which the codes of this and the previous group differ selects
        # both groups: shutters that open now and those that opened one length ago.
        apart = (now & -now).bit_length() - 1 + low if now else -1
        hit = tuple(f"p{b}" for b in range(high + low) if b != apart)
        if now:
            turn = _turn_state(state, roomy)
        elif in_flag:  # in the first group nothing closes: state := state OR t0
            turn = (Gate("OR", "t0", ("t0", state)), Gate("WHERE", state, ("t0",)))
        else:
            turn = (Gate("OR", state, (state, "t0")),)
        before[i] = (*flips, (Gate("NOR", "t0", hit),), turn)
    closing = turned_over(set_bits(standing))
    opening: tuple[Segment, ...] = ((Gate("CLR", "s0", ()),),)
    if in_flag:
        opening = ((Gate("CLR", "t0", ()), Gate("WHERE", "FLAG", ("t0",))),)
    name = f"groups of {length} and offsets in Gray code, each hit turns the state over"
    return Script(name, planes, 0 if in_flag else 1, opening, before, closing, in_flag)


def _turn_state(state: str, roomy: bool) -> Segment:
    """Return the segment state := state XOR t0, with three scratch registers if `roomy`, else two.

    With t1 := NOR(state, t0), NOR(state, t1) is 1 where only t0 is 1, and NOR(t0, t1) is 1 where
    only the state is 1. Their OR is the XOR."""
    on, off = ("t0", "t2") if roomy else ("t1", "t0")
    last = Gate("WHERE", "FLAG", (on, off)) if state == "FLAG" else Gate("OR", state, (on, off))
    return (
        Gate("NOR", "t1", (state, "t0")),
        Gate("NOR", off, ("t0", "t1")),
        Gate("NOR", on, ("t1", state)),
        last,
    )


def _length(bumps: Bumps) -> int:
    length = bumps.length
    # A bump cut by the end of the frame is complete up to there.
    expected_stop = np.minimum(bumps.start + length, bumps.steps)
    if length < 2 or np.any((bumps.stop != expected_stop) & ~bumps.never):
        raise GaveUp("bumps of different lengths")
    if 2 * length > bumps.steps:
        raise GaveUp("bumps longer than half of the frame")
    return length


def _script(
    bumps: Bumps,
    length: int,
    chosen: Sequence[int],
    codes: Sequence[int],
    bits: int,
    doubled: bool,
    low: int,
    turns: _Turns,
) -> Script:
    """Return the script for these parameters; `codes` are the codes of the groups.

    With `doubled`, the offset planes and the planes of the `low` lowest bits of the group are
    stored in both polarities."""
    # At place m, shutters of this group are open if offset <= m, and those of the previous group if
    # not. One of the two groups is odd, and its planes are inverted, so both read a plane in the
    # same way.
    group = np.where(bumps.never, 0, bumps.start // length)
    everything = (1 << len(bumps.start)) - 1
    planes = [
        (plane, f"offset in its group, {digit}, turned in odd groups")
        for plane, digit in thermometers(bumps.start % length, chosen, group % 2 == 1)
    ]
    if doubled:
        planes += [(everything & ~plane, f"{text}, inverted") for plane, text in planes]
    place: list[int] = []
    coded = np.array(codes, dtype=np.int64)[group]
    for bit, (plane, text) in enumerate(binary_planes("group, Gray bit", coded, bits)):
        place.append(len(planes))
        planes.append((plane, text))
        if bit < low:
            planes.append((everything & ~plane, f"{text}, inverted"))
    before: dict[int, tuple[Segment, ...]] = {}
    standing = 0
    for now, i in bumps.groups(length)[1:]:
        behind = turns is _Turns.AFTER or (turns is _Turns.EVEN and now % 2 == 1)
        code = codes[now - behind]
        before[i] = turned_over(place[b] for b in set_bits(code ^ standing) if b >= low)
        standing = code
    closing = turned_over(place[b] for b in set_bits(standing) if b >= low)
    radices = " x ".join(str(r) for r in chosen)
    name = f"groups of {length} in Gray code, offset in digits {radices}"
    if doubled or low:
        name += ", some both ways round"
    return Script(name, planes, before=before, closing=closing)
