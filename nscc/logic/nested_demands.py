"""Generator for nested demands: each contains the next (open until a stop) or the previous one.

Every shutter has a rank, the number of demands that it satisfies, and demand d is rank > d. Ranks
are written in digits for which this comparison is cheap."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from enum import Enum
from functools import cache
from itertools import combinations, pairwise, product

import numpy as np
from numpy.typing import NDArray

from nscc.logic.digits import binary_planes, gray, nor, radices_of, thermometers, turned_over
from nscc.logic.problem import Gate, GaveUp, Machine, Problem, Segment, Solution
from nscc.logic.script_walk import Script, walk
from nscc.truth import columns, rows


@dataclass(frozen=True)
class Nest:
    """The ranks (shutters,) of nested demands, in 0 .. steps.

    Demand i is rank > step[i], or its complement if `complemented[i]`."""

    ranks: NDArray[np.int64]
    step: tuple[int, ...]
    complemented: tuple[bool, ...]
    steps: int


def nest_of(problem: Problem) -> Nest:
    """Return the ranks of nested demands; raise GaveUp if the demands are not nested."""
    kinds: dict[tuple[str, int], list[int]] = {}
    for demand in problem.demands:
        kinds.setdefault((demand.edge, demand.bucket), []).append(demand.predicate)
    rising = {
        kind: any(b & ~a for a, b in pairwise(predicates)) for kind, predicates in kinds.items()
    }
    flips = tuple(rising[d.edge, d.bucket] for d in problem.demands)
    everything = problem.everything
    predicates = [
        everything & ~d.predicate if flip else d.predicate
        for d, flip in zip(problem.demands, flips, strict=True)
    ]
    if len(predicates) < 2 or any(b & ~a for a, b in pairwise(predicates)):
        raise GaveUp("the demands are not nested")
    distinct = list(dict.fromkeys(predicates))
    number = {predicate: i for i, predicate in enumerate(distinct)}
    ranks = rows(distinct, problem.shutters).sum(axis=1).astype(np.int64)
    return Nest(ranks, tuple(number[p] for p in predicates), flips, len(distinct))


def digits(problem: Problem, machine: Machine, steps: int) -> Iterator[Solution]:
    """Yield solutions with mixed-radix digits, each a thermometer; the highest may be inverted
    bits.

    When a digit changes, one cube for each higher digit computes "already greater"; the remaining
    part of each demand is a cube with one plane per digit. For digits a b and time A B, "rank >
    time" is a > A or (a >= A and b > B): the first is computed once for all of A's slots, the
    second is a NOR of two planes."""
    nest = nest_of(problem)
    for bits in range(4):
        flips, most_cubes = _turns(bits)
        room = machine.registers - bits - most_cubes
        stored_tries = 0
        for stored in range(min(room, nest.steps), -1, -1):
            values = nest.steps + 1 - stored
            if bits and values <= 1 << bits:
                continue
            inner = radices_of(room - stored, -(-values // (1 << bits)))
            for radices in inner[:2]:
                for negative in (False, True):
                    # For complemented demands the planes are complemented.
                    if negative and (bits or not any(nest.complemented)):
                        continue
                    script = _digit_script(nest, stored, radices, bits, flips, negative)
                    yield from walk(problem, machine, script, steps)
            stored_tries += bool(inner)
            if stored_tries == _MOST_STORED:
                break


# Numbers of directly stored demands to try, the largest possible first.
_MOST_STORED = 2


_Flips = tuple[tuple[int, ...], ...]
"""The order of inversions for binary digits: the bits inverted at each step."""


@cache
def _turns(bits: int) -> tuple[_Flips, int]:
    """Return the cheapest sequence of inversions of `bits` bits, and the most cubes of a group.

    The sequence is a shortest path through (group, polarities). In group h the bits must mask every
    lower value but not h, and the values above h must be an OR of planes and a few cubes. The path
    starts in group 0 and ends after the last group with the stored polarities. An inversion costs
    two words, a cube one."""
    import networkx as nx  # only from -O2 on: `check` starts without it

    groups, stored = 1 << bits, (0,) * bits
    ways = nx.DiGraph()
    before = [stored]
    for h in range(groups):
        states = [stored] if h == 0 else list(product((0, 1), repeat=bits))
        for new in states:
            cubes = _group_cubes(h, new, bits)
            if cubes is not None:
                ways.add_node((h, new), cubes=cubes)
                for old in before:
                    words = 2 * len(_turned(old, new)) + cubes
                    ways.add_edge((h - 1, old), (h, new), words=words)
        before = states
    for old in before:
        ways.add_edge((groups - 1, old), (groups, stored), words=2 * sum(old))
    path = nx.shortest_path(ways, (-1, stored), (groups, stored), "words")
    polarities = [state for _, state in path]
    flips = tuple(_turned(old, new) for old, new in pairwise(polarities))
    return flips, max(ways.nodes[node]["cubes"] for node in path[1:-1])


def _turned(old: Sequence[int], new: Sequence[int]) -> tuple[int, ...]:
    """Return the bits in which two polarities differ."""
    return tuple(i for i, (was, now) in enumerate(zip(old, new, strict=True)) if was != now)


def _group_cubes(h: int, polarity: Sequence[int], bits: int) -> int | None:
    """Return the number of cubes in group h if the planes have this `polarity`; None if no mask
    exists."""
    # Each plane as the set of values of the highest digit at which it is 1. The NOR of those that
    # are 0 at h selects h, and no lower value if together they contain all of these.
    groups = range(1 << bits)
    planes = [{c for c in groups if (c >> i & 1) ^ polarity[i]} for i in range(bits)]
    masks: set[int] = set().union(*(p for p in planes if h not in p))
    if not set(range(h)) <= masks:
        return None
    # "Above" is an OR: planes inside it are free, cubes cost one word each and are chosen greedily.
    above = {c for c in groups if c > h}
    uncovered = above.difference(*(p for p in planes if p <= above)) if planes else set()
    cubes = []
    for size in range(1, bits + 1):
        for chosen in combinations(planes, size):
            cube = set(groups).difference(*chosen)
            if cube and cube <= above:
                cubes.append(cube)
    count = 0
    while uncovered:
        cube = max(cubes, key=lambda c: len(c & uncovered), default=set())
        if not cube & uncovered:
            return None
        uncovered = uncovered - cube
        count += 1
    return count


def _digit_script(
    nest: Nest, stored: int, radices: tuple[int, ...], bits: int, flips: _Flips, negative: bool
) -> Script:
    per_group = int(np.prod(radices))
    # The last demands have separate planes; before them those ranks are equivalent.
    ranks = np.minimum(nest.ranks, nest.steps - stored)
    planes = binary_planes("highest digit of the rank, bit", ranks // per_group, bits)
    planes += thermometers(ranks % per_group, radices, negative)
    last = range(nest.steps - stored, nest.steps)
    planes += [(columns((nest.ranks > d)[:, None])[0], f"rank > {d}") for d in last]
    before: dict[int, tuple[Segment, ...]] = {}
    turned: list[int] = []
    current_group = 0
    for i, step in enumerate(nest.step):
        while current_group < min(step, nest.steps - stored) // per_group:
            current_group += 1
            turned += flips[current_group]
            before[i] = (*before.get(i, ()), *turned_over(flips[current_group]))
    closing = _back(turned)
    name = "digits " + " x ".join(str(r) for r in ([1 << bits] if bits else []) + list(radices))
    if stored:
        name += f", the last {stored} demands stored"
    return Script(name, planes, before=before, closing=closing)


def _back(turned: Sequence[int]) -> tuple[Segment, ...]:
    """Return segments that restore planes that were inverted an odd number of times."""
    return turned_over(bit for bit in sorted(set(turned)) if turned.count(bit) % 2)


class _Form(Enum):
    """The place of the state of a counted digit: (name, number of registers besides the planes)."""

    DIGITS = "state in a register, digits inside"
    STATE = "state in a register"
    TIGHT = "state in a register, one of scratch"
    PAIR = "state in FLAG and, for two demands, in scratch"
    FLAG = "state in FLAG"


_BESIDE = {_Form.DIGITS: 2, _Form.STATE: 3, _Form.TIGHT: 2, _Form.PAIR: 2, _Form.FLAG: 1}

# The number of bits whose cubes are submasks, the others being inverted: fewer of them need a
# smaller store.
_SUBMASK_BITS = (13, 6, 4, 2)


def counted(problem: Problem, machine: Machine, steps: int) -> Iterator[Solution]:
    """Yield solutions with the highest digit in binary and a state "greater" that each group
    updates.

    The NOR of the planes where h has a 0 selects the submasks of h: h itself and lower values only.
    Removing it from "greater" at each step leaves exactly the greater values, and no plane is
    inverted. High bits in Gray code, which are inverted, let kernels repeat."""
    nest = nest_of(problem)
    values = nest.steps + 1
    for bits in range(2, (values - 1).bit_length() + 1):
        least = -(-values // (1 << bits))
        for form in _Form:
            in_flag = form in (_Form.PAIR, _Form.FLAG)
            if in_flag and (not problem.flag_lasts or any(nest.complemented)):
                continue
            # With inner digits, a group has as many values as they distinguish; a state alone
            # serves a group of one, a pair a group of two.
            room = machine.registers - bits - _BESIDE[form]
            if form is _Form.DIGITS:
                choices = radices_of(room, least)[:2] if least > 1 else ()
            else:
                inner = 2 if form is _Form.PAIR else 1
                choices = ((inner,),) if room >= inner - 1 and least == inner else ()
            for radices in choices:
                for low in sorted({min(low, bits) for low in _SUBMASK_BITS}, reverse=True):
                    script = _counted_script(nest, radices, bits, low, form)
                    yield from walk(problem, machine, script, steps)


def _counted_script(
    nest: Nest, radices: tuple[int, ...], bits: int, low: int, form: _Form
) -> Script:
    per_group = int(np.prod(radices))
    # Submasks count the low bits. The high bits are in Gray code: one of them is inverted each time
    # the low bits overflow.
    groups = nest.ranks // per_group
    high = groups >> low
    coded = gray(high) << low | groups & (1 << low) - 1
    planes = binary_planes("highest digit of the rank, bit", coded, bits)
    planes += thermometers(nest.ranks % per_group, radices, False)
    states = {_Form.DIGITS: 2, _Form.STATE: 1, _Form.TIGHT: 1}.get(form, 0)
    opening: tuple[Segment, ...] = ((Gate("SET", "s0", ()),),) if states else ()
    before: dict[int, tuple[Segment, ...]] = {}
    turned: list[int] = []
    current_group = -1
    for i, step in enumerate(nest.step):
        while current_group < step // per_group:
            current_group += 1
            run: list[Segment] = []
            if current_group and not current_group & (1 << low) - 1:
                # The Gray codes of k and k - 1 differ in the lowest 1 of k.
                flip = ((current_group >> low) & -(current_group >> low)).bit_length() - 1 + low
                turned.append(flip)
                run += turned_over([flip])
            equal = [f"p{b}" for b in range(bits) if b >= low or not current_group >> b & 1]
            before[i] = (*before.get(i, ()), *run, *_advance(form, equal, bits))
        if form is _Form.PAIR and step % 2 and i not in before:
            before[i] = ((Gate("WHERE", "FLAG", ("t1",)),),)
    closing = _back(turned)
    name = " x ".join(str(r) for r in (1 << bits, *radices) if r > 1)
    name = f"digits {name}, the highest counted: {form.value}"
    in_flag = form in (_Form.PAIR, _Form.FLAG)
    return Script(name, planes, states, opening, before, closing, in_flag)


def _advance(form: _Form, equal: Sequence[str], bits: int) -> tuple[Segment, ...]:
    """Return segments that remove the shutters of the cube NOR(equal) from "greater".

    An empty `equal` removes all shutters."""
    # "greater and not equal" is NOR(NOT greater, equal). Before the step "greater" still contains
    # the equal shutters: DIGITS keeps its inverse for the demands that lower digits decide.
    if form in (_Form.DIGITS, _Form.STATE):
        inverse = "s1" if form is _Form.DIGITS else "t1"
        turn = Gate("NOT", inverse, ("s0",))
        if not equal:
            return ((turn, Gate("CLR", "s0", ())),)
        return (turn,), nor("t0", equal), (Gate("NOR", "s0", (inverse, "t0")),)
    if form is _Form.TIGHT:
        # With one scratch register, the cube goes to the state's register, and the inverted state
        # to t0.
        if not equal:
            return ((Gate("CLR", "s0", ()),),)
        turn = Gate("NOT", "t0", ("s0",))
        return (turn,), nor("s0", equal), (Gate("NOR", "s0", ("s0", "t0")),)
    if form is _Form.PAIR:
        # Two demands a group: FLAG, which also reads the plane of the last digit, answers the
        # first; t1, "greater" alone, waits for the second and is the state from then on.
        narrow = Gate("NOR", "t1", ("t1", "t0")) if equal else Gate("CLR", "t1", ())
        both = Gate("NOR", "t0", ("t0", f"p{bits}")), Gate("WHERE", "FLAG", ("t0", "t1"))
        cubes = (nor("t1", equal),) if equal else ()
        return (Gate("NOT", "t0", ("FLAG",)),), *cubes, (narrow, *both)
    load = Gate("WHERE", "FLAG", ("t0",))
    if not equal:
        return ((Gate("CLR", "t0", ()), load),)
    turn, narrow = Gate("NOT", "t0", ("FLAG",)), Gate("NOR", "t0", ("t0", "FLAG"))
    return (turn, load), nor("t0", equal), (narrow, load)
