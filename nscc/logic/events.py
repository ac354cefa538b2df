"""Event encoding: each shutter's k-th rise or fall is a time, and a demand selects equal times.

A time consists of a group and a place in it. The codes of all places have equally many ones, so the
planes that are 0 in one of them are not all 0 in any other (E. Sperner, 1928). The planes of the
group's code are inverted as time advances, so that the planes that identify the current group are
all 0. An equality test is then one NOR. The codes are chosen to need few inversions."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import combinations, islice, product
from math import comb

import numpy as np

from nscc.arrays import Ints
from nscc.logic.digits import Planes, binary_planes, cycle, turned_over
from nscc.logic.encodings import describe_demand, event_fields, event_name
from nscc.logic.problem import GaveUp, Machine, Problem, Segment, Solution
from nscc.logic.script import Script
from nscc.logic.script_walk import walk
from nscc.truth import members, set_bits, union, vector


@dataclass(frozen=True)
class _Field:
    """Numbers (shutters,) of the shutters' events, and for each event, in time order, its demand
    and number.

    `name` describes the field. Numbers are below `count`; shutters without an event have the last.
    An event of shutters with several numbers has that of its first shutter. A demand is a set of
    shutters that FLAG must select at a boundary."""

    name: str
    numbers: Ints
    events: tuple[tuple[int, int], ...]
    count: int


@dataclass(frozen=True)
class _Form:
    """A layout of a field: groups in `bits` binary digits, the places of a group in `width` planes,
    `width` // 2 of which are 1 at a place.

    `turns` is the number of inversions in a frame. A plane is the content of a code register."""

    bits: int
    width: int
    turns: int

    @property
    def planes(self) -> int:
        """The number of planes (contents of code registers)."""
        return self.bits + self.width

    @property
    def size(self) -> int:
        """The number of places in a group."""
        return comb(self.width, self.width // 2)

    @property
    def name(self) -> str:
        """The largest numbers of groups and of places as text."""
        return f"{1 << self.bits} x {self.size}"

    def place_codes(self) -> Ints:
        """Return the codes of the places, (size,), each with `width` // 2 ones."""
        ones = combinations(range(self.width), self.width // 2)
        return np.array([sum(1 << bit for bit in bits) for bits in ones], dtype=np.int64)


# Limits: layouts tried (fewest inversions first), layouts considered, and kinds of events, which
# may exceed the registers since several can share a field.
_MOST_TRIED = 6
_MOST_COMBINED = 20_000
_MOST_KINDS = 24


def equalities(problem: Problem, machine: Machine, steps: int) -> Iterator[Solution]:
    """Yield solutions that number the events of each field, and compare these numbers with the code
    by a group and a place in the group. The first have the fewest inversions or planes. Spare
    registers may store the last demands directly.

    `steps` limits the search for the gates of each solution. Yields nothing if no layout fits or no
    search succeeds. Raises GaveUp if the demands are levels (what is open in each slot), if there
    are too many kinds of events, or if numbers cannot distinguish the events of one kind. A demand
    is a set of shutters that FLAG must select at a boundary."""
    if all(d.edge == "open" for d in problem.demands):
        raise GaveUp("the demands are levels")
    room = machine.registers - 1
    events = _events(problem)
    fields = [_field(name, known, problem.shutters) for name, known in events]
    forms = (_forms(field, room) for field in fields)
    fitting = [
        chosen
        for chosen in islice(product(*forms), _MOST_COMBINED)
        if sum(form.planes for form in chosen) <= room
    ]
    fitting.sort(key=lambda chosen: (sum(f.turns for f in chosen), sum(f.planes for f in chosen)))
    # The layout with the fewest planes takes the fewest words at a boundary.
    smallest = sorted(fitting, key=lambda chosen: sum(form.planes for form in chosen))
    choices = [(chosen, 0) for chosen in (*fitting[:1], *smallest[:1])]
    for chosen in fitting[:_MOST_TRIED]:
        # A stored demand takes one word, but spare registers may save more as scratch registers.
        choices += [(chosen, 0), (chosen, room - sum(form.planes for form in chosen))]
    for chosen, stored in dict.fromkeys(choices):
        with suppress(GaveUp):
            yield from walk(problem, machine, _script(problem, events, chosen, stored), steps)


_Events = list[tuple[int, int]]
"""Demands in time order, each with the truth vector of the shutters that have this event."""


def _events(problem: Problem) -> list[tuple[str, _Events]]:
    """Return the events of each field, as (name, events).

    There is one field for each kind and rank of events. A field is merged with the first earlier
    one if numbers can serve the events of both, that is, if their shutters are equal, disjoint or
    unions of each other. Raises GaveUp if there are more than _MOST_KINDS kinds."""
    kinds = event_fields(problem, _MOST_KINDS)
    merged: list[tuple[str, _Events]] = []
    for key, demand_shutters in kinds.items():
        events = [(demand, vector(shutters)) for demand, shutters in demand_shutters]
        name = event_name(*key, kinds)
        for i, (known_name, known) in enumerate(merged):
            both = sorted([*known, *events])
            if _atoms([v for _, v in both]) is not None:
                merged[i] = f"{known_name} and {name}", both
                break
        else:
            merged.append((name, events))
    return merged


def _field(name: str, events: _Events, shutters: int) -> _Field:
    """Return the field that numbers the shutters by their event, so that a demand is a test for
    equality with one number.

    `events` are pairs of a demand and the truth vector (an integer with one bit for each shutter)
    of its shutters; `shutters` is the number of all shutters. Raises GaveUp if numbers cannot
    distinguish the events."""
    atoms = _atoms([v for _, v in events])
    if atoms is None:
        raise GaveUp("the remaining events are not unions of each other")
    numbers = np.full(shutters, len(atoms), dtype=np.int64)
    for i, v in enumerate(atoms):
        numbers[members(v, shutters)] = i
    number = {v: int(numbers[(v & -v).bit_length() - 1]) for _, v in events}
    count = int(numbers.max(initial=0)) + 1
    return _Field(name, numbers, tuple((d, number[v]) for d, v in events), count)


def _atoms(vectors: Sequence[int]) -> list[int] | None:
    """Return the smallest disjoint `vectors` whose unions are all other vectors, in the order of
    `vectors`; None if there are no such vectors.

    One field then serves all events: an atom is a number, and a union of atoms is several equality
    tests. Of an empty list the result is empty. No vector may be 0."""
    atoms: list[int] = []
    covered = 0
    for shutters in sorted(set(vectors), key=int.bit_count):
        if shutters & covered:
            if union(atom for atom in atoms if not atom & ~shutters) != shutters:
                return None
        else:
            atoms.append(shutters)
        covered |= shutters
    return sorted(atoms, key=vectors.index)


def _forms(field: _Field, room: int) -> list[_Form]:
    """Return the layouts that store the number of a field in at most `room` planes; an empty list
    if none fits. A layout divides the numbers into groups and stores the group and the place in the
    group. The layout with the most digits for the group is first. A plane is the content of a code
    register."""
    forms: list[_Form] = []
    for bits in range(min((field.count - 1).bit_length() + 1, room), -1, -1):
        form = _Form(bits, 0, 0)
        while form.size << bits < field.count:
            form = replace(form, width=form.width + 1)
        if form.planes <= room:
            turned = sum(len(run) for run in _turns(field, form, 0).values())
            forms.append(replace(form, turns=turned))
    return forms


def _turns(field: _Field, form: _Form, base: int) -> dict[int, tuple[Segment, ...]]:
    """Return segments that invert group bits before each demand and, at key -1, after the last
    demand. Demands without an inversion have no key.

    `base` is the number of the first plane of the group. Four shutters that rise at the boundaries
    0 to 3 have the groups 00, 01, 11 and 10 (bits 1 and 0). One inversion before each demand makes
    the code of the present group 00:

        >>> numbers = np.array([0, 1, 2, 3])
        >>> field = _Field("rise time", numbers, ((0, 0), (1, 1), (2, 2), (3, 3)), count=4)
        >>> turned = _turns(field, _Form(bits=2, width=0, turns=4), base=0)
        >>> {demand: str(segment[0]) for demand, (segment,) in turned.items()}
        {1: 'p0 = NOT(p0)', 2: 'p1 = NOT(p1)', 3: 'p0 = NOT(p0)', -1: 'p1 = NOT(p1)'}
    """
    codes = _groups(field, form)
    standing = 0
    turned: dict[int, tuple[Segment, ...]] = {}
    for demand, number in (*field.events, (-1, None)):
        # A plane is inverted if the code has a 1, so that the current group reads as zeros.
        code = 0 if number is None else codes[number // form.size]
        if code != standing:
            turned[demand] = turned_over(base + bit for bit in set_bits(code ^ standing))
        standing = code
    return turned


def _groups(field: _Field, form: _Form) -> tuple[int, ...]:
    """Return the code of each group of `form.size` numbers; the first code is 0, so the first event
    needs no inversion. Without group bits there is one group."""
    return cycle(-(-field.count // form.size), form.bits) if form.bits else (0,)


def _script(
    problem: Problem, events: list[tuple[str, _Events]], chosen: tuple[_Form, ...], stored: int
) -> Script:
    """Return the script that stores the events of each field in its chosen layout, and updates the
    groups before demands.

    `events` are the fields as (name, events), `chosen` the layout of each. The last `stored`
    demands that FLAG does not already meet have planes of their own, and their events are left out
    of the fields. Raises GaveUp if numbers cannot distinguish the other events of a field. A demand
    is a set of shutters that FLAG must select at a boundary. FLAG is the bit that lets a pixel act.
    """
    # The numbers of the demands whose predicates are stored as they are.
    raw = [i for i in range(len(problem.demands)) if not problem.answered(i)]
    raw = raw[len(raw) - stored :]
    planes: Planes = []
    before: dict[int, tuple[Segment, ...]] = {}
    for (name, known), form in zip(events, chosen, strict=True):
        numbered = [(demand, v) for demand, v in known if demand not in raw]
        field = _field(name, numbered, problem.shutters)
        for demand, flips in _turns(field, form, len(planes)).items():
            before[demand] = (*before.get(demand, ()), *flips)
        codes = np.array(_groups(field, form), dtype=np.int64)
        groups = codes[field.numbers // form.size]
        planes += binary_planes(f"{field.name}, group, bit", groups, form.bits)
        places = form.place_codes()[field.numbers % form.size]
        planes += binary_planes(f"{field.name}, place, bit", places, form.width)
    planes += [(problem.demands[i].predicate, describe_demand(problem.demands[i])) for i in raw]
    closing = before.pop(-1, ())
    name = "event times in groups and places " + " and ".join(form.name for form in chosen)
    return Script(name, planes, before=before, closing=closing)
