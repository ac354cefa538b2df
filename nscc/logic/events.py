"""Events: each shutter's k-th rise or fall is a time, and a demand picks out the equal times.

A time is a group and a place in it. The place is written in digits. Each value of a digit has a
plane, which is 0 where the digit has that value. Planes of the group's code are inverted as time
goes on, so that those which identify the current group are all 0. An equality is then one NOR. The
codes are chosen such that few planes must be inverted.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import islice, product
from math import prod

import numpy as np
from numpy.typing import NDArray

from nscc.logic.cube_tables import number_cubes
from nscc.logic.cubes import Cube
from nscc.logic.digits import Planes, binary_planes, digits_of, radices_of, turned_over
from nscc.logic.encodings import asked, event_fields, event_name
from nscc.logic.problem import GaveUp, Machine, Problem, Segment, Solution
from nscc.logic.walk import Script, walk
from nscc.truth import columns, members, union, vector


@dataclass(frozen=True)
class _Field:
    """Numbers (shutters,), and for each event, in time order, the demand and its number.

    Shutters without an event have the number after the last, `count` - 1 if there are any. An event
    of shutters of several numbers goes by the lowest one.
    """

    name: str
    numbers: NDArray[np.int64]
    events: tuple[tuple[int, int], ...]
    count: int


@dataclass(frozen=True)
class _Form:
    """A way to hold a field: places in digits of `radices`, groups in `bits`; how often a bit is
    turned over in a frame."""

    radices: tuple[int, ...]
    bits: int
    turns: int

    @property
    def planes(self) -> int:
        """Registers that it takes."""
        return sum(self.radices) + self.bits

    @property
    def size(self) -> int:
        """Numbers in a group."""
        return prod(self.radices)

    @property
    def name(self) -> str:
        """The digits, the highest first."""
        high = [str(1 << self.bits)] if self.bits else []
        return " x ".join(high + [str(r) for r in self.radices]) or "1"


# Choices of digits that are tried, the fewest turns first; choices that are looked at; kinds of
# events, of which there may be more than registers, since several can share a field.
_MOST_TRIED = 6
_MOST_COMBINED = 20_000
_MOST_KINDS = 24


def equalities(problem: Problem, machine: Machine, steps: int) -> Iterator[Solution]:
    """Digits for every field; registers that are left hold the last demands as they are."""
    if all(d.edge == "open" for d in problem.demands):
        raise GaveUp("the demands are levels")
    room = machine.registers - 1
    events = _events(problem)
    fields = [_field(name, known, problem.shutters) for name, known in events]
    fitting = [
        chosen
        for chosen in islice(product(*(_forms(f, room) for f in fields)), _MOST_COMBINED)
        if sum(form.planes for form in chosen) <= room
    ]
    fitting.sort(key=lambda chosen: (sum(f.turns for f in chosen), sum(f.planes for f in chosen)))
    for chosen in fitting[:_MOST_TRIED]:
        stored = room - sum(form.planes for form in chosen)
        for kept in {0, stored}:
            with suppress(GaveUp):
                yield from walk(problem, machine, _script(problem, events, chosen, kept), steps)


_Events = list[tuple[int, int]]
"""Demands in time order, each with the truth vector of the shutters that have this event."""


def _events(problem: Problem) -> list[tuple[str, _Events]]:
    """The events of each field, by its name: one field for each kind and rank of events, and one
    for several whose times tell each other."""
    kinds = event_fields(problem, _MOST_KINDS)
    merged: list[tuple[str, _Events]] = []
    for key, found in kinds.items():
        events = [(demand, vector(shutters)) for demand, shutters in found]
        name = event_name(*key, kinds)
        for i, (other, known) in enumerate(merged):
            both = sorted([*known, *events])
            if _atoms([v for _, v in both]) is not None:
                merged[i] = f"{other} and {name}", both
                break
        else:
            merged.append((name, events))
    return merged


def _field(name: str, events: _Events, shutters: int) -> _Field:
    """The field that numbers these events; raises GaveUp where no numbers tell them apart."""
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
    """The smallest of `vectors`, disjoint, whose unions are all the others, in the order in which
    they come; None if there are none.

    One field then serves all of them: an atom is a number, a union of atoms several equalities.
    """
    atoms: list[int] = []
    covered = 0
    for v in sorted(set(vectors), key=int.bit_count):
        if v & covered:
            if union(atom for atom in atoms if not atom & ~v) != v:
                return None
        else:
            atoms.append(v)
        covered |= v
    return sorted(atoms, key=vectors.index)


def _forms(field: _Field, room: int) -> list[_Form]:
    """Ways to hold a field, those with the fewest planes first."""
    found: list[_Form] = []
    for bits in range(min((field.count - 1).bit_length() + 1, room), -1, -1):
        least = -(-field.count // (1 << bits))
        inner = radices_of(room - bits, least) if least > 1 else ((),)
        for radices in inner[:1]:
            form = _Form(radices, bits, 0)
            turned = sum(len(run) for run in _turns(field, form, 0).values())
            found.append(replace(form, turns=turned))
    return found


def _turns(field: _Field, form: _Form, base: int) -> dict[int, tuple[Segment, ...]]:
    """The bits of the group turned over before each demand and, at -1, after the last one."""
    _, cubes = _groups(field, form)
    standing = [0] * form.bits
    turned: dict[int, tuple[Segment, ...]] = {}
    back = tuple((bit, 0) for bit in range(form.bits))
    for demand, number in (*field.events, (-1, None)):
        # A plane stands turned over where the group's cube asks for a 1: now reads as all zeros.
        cube = back if number is None else cubes[number // form.size]
        flips = [bit for bit, value in cube if standing[bit] != value]
        if flips:
            turned[demand] = turned_over(base + bit for bit in flips)
        for bit in flips:
            standing[bit] ^= 1
    return turned


def _groups(field: _Field, form: _Form) -> tuple[tuple[int, ...], tuple[Cube, ...]]:
    """The code of each group and the cube that identifies it; the first event inverts no plane."""
    if not form.bits:
        return (0,), ((),)
    return number_cubes(-(-field.count // form.size), form.bits)


def _script(
    problem: Problem, events: list[tuple[str, _Events]], chosen: tuple[_Form, ...], stored: int
) -> Script:
    """`stored`: how many of the last demands have a plane of their own."""
    raw = [i for i in range(len(problem.demands)) if not problem.answered(i)]
    raw = raw[len(raw) - stored :]
    planes: Planes = []
    before: dict[int, tuple[Segment, ...]] = {}
    for (name, known), form in zip(events, chosen, strict=True):
        numbered = [(demand, v) for demand, v in known if demand not in raw]
        field = _field(name, numbered, problem.shutters)
        for demand, flips in _turns(field, form, len(planes)).items():
            before[demand] = (*before.get(demand, ()), *flips)
        codes = np.array(_groups(field, form)[0], dtype=np.int64)
        groups = codes[field.numbers // form.size]
        planes += binary_planes(f"{field.name}, group, bit", groups, form.bits)
        for digit_name, digit, radix in digits_of(field.numbers, form.radices):
            held = columns(digit[:, None] != np.arange(radix))
            planes += [(p, f"{field.name}, {digit_name} is not {m}") for m, p in enumerate(held)]
    planes += [(problem.demands[i].predicate, asked(problem.demands[i])) for i in raw]
    closing = before.pop(-1, ())
    name = "event times in digits " + " and ".join(form.name for form in chosen)
    return Script(name, planes, before=before, closing=closing)
