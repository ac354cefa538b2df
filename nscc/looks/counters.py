"""Gates that add numbers to a binary counter in some lanes, by ripples of carries or borrows, or
write numbers to it.

A bit b with the carry c takes five words and four scratch registers: with NOR(b, c), the lanes of
only b and those of only c are one NOR each. The new bit is their OR, and the next carry the NOR of
all three. The next borrow are the lanes of only c: one word less. Wide counters thus need no search
for covers, and few registers."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import islice

import numpy as np

from nscc.logic.problem import Gate, Gates, GaveUp
from nscc.looks.boundary_gates import FLAG, RegisterContents
from nscc.record import Record
from nscc.truth import rows, union, vector

_MOST_STEPS = 6
"""Most different steps of a counter at one boundary."""
_MOST_CUBES = 16
"""Most cubes (ANDs of registers and complements) that tell the lanes of a step."""

Cube = tuple[tuple[str, ...], tuple[str, ...]]
"""The registers that must be 1, and those that must be 0."""


class Step(Record):
    """A change of a binary counter in `lanes`, a truth vector (an integer with one bit for each
    lane).

    It adds `number`, modulo two to the number of bits, or writes it if not `adds`. It may do so in
    the lanes `free` also, because they have that number already or are written later."""

    number: int
    adds: bool
    lanes: int
    free: int = 0


def steps_of(
    contents: RegisterContents, names: Sequence[str], new_values: Mapping[str, int]
) -> list[Step]:
    """Return the steps that give the binary counter `names`, its lowest bit first, its new values:
    those that add come first.

    `new_values` are the truth vectors (integers with one bit for each lane) of the registers that
    change, by name. Return [] if no step adds, if there are too many steps, or if fewer than two
    registers of the counter change."""
    if len(set(names) & new_values.keys()) < 2:
        return []
    count, size = contents.everything.bit_length(), 1 << len(names)
    before = [contents.values[name] for name in names]
    after = [new_values.get(name, v) for name, v in zip(names, before, strict=True)]
    weights = 1 << np.arange(len(names))
    old, new = (rows(bits, count) @ weights for bits in (before, after))
    added = (new - old) % size
    left = added != 0
    steps: list[Step] = []
    while left.any():
        # Writing takes fewer words than adding.
        choices = Counter((False, int(number)) for number in new[left])
        choices.update((True, int(number)) for number in added[left])
        (adds, number), _ = max(choices.items(), key=lambda item: (item[1], not item[0][0]))
        chosen = left & ((added if adds else new) == number)
        left &= ~chosen
        steps.append(Step(number, adds, vector(np.flatnonzero(chosen))))
        if len(steps) > _MOST_STEPS:
            return []
    if not any(step.adds for step in steps):
        return []
    written = union(step.lanes for step in steps if not step.adds)
    unchanged = [vector(np.flatnonzero((old == new) & (new == step.number))) for step in steps]
    steps = [
        replace(step, free=written if step.adds else lanes)
        for step, lanes in zip(steps, unchanged, strict=True)
    ]
    return sorted(steps, key=lambda step: not step.adds)


def count(contents: RegisterContents, names: Sequence[str], steps: Sequence[Step]) -> None:
    """Append gates that take the steps of the binary counter `names`, its lowest bit first.

    Raises GaveUp if no gates can compute the lanes of a step."""
    # If the lanes of later steps can no longer be told after a step, registers keep them.
    for kept in (False, True):
        after = contents.copy()
        try:
            chosen = [
                _register(after, names, step.lanes, 0 if step.adds else step.free)
                for step in steps
                if kept
            ]
            for number, step in enumerate(steps):
                register = (
                    chosen[number] if kept else _register(after, names, step.lanes, step.free)
                )
                if step.adds:
                    _add(after, names, register, step.number)
                else:
                    _write(after, names, register, step.number)
        except GaveUp:
            if kept:
                raise
            continue
        contents.values, contents.gates = after.values, after.gates
        return


def _add(contents: RegisterContents, names: Sequence[str], register: str, number: int) -> None:
    """Append gates that add `number` to the counter `names` where `register`, which is none of
    them, is 1: a ripple for each digit 1 or -1 of the number."""
    bit = 0
    while number and bit < len(names):
        if number & 1:
            digit = 2 - (number & 3)  # no two digits in a row differ from 0
            _ripple(contents, names[bit:], register, up=digit > 0)
            number -= digit
        number >>= 1
        bit += 1


def _ripple(contents: RegisterContents, names: Sequence[str], carry: str, *, up: bool) -> None:
    """Append gates that add one to the counter `names`, or subtract one if not `up`, where the
    register `carry` is 1. The result is modulo two to the number of bits."""
    gates = Gates(contents.machine)
    spare = (name for name in contents.unused_scratch() if name != carry)
    neither, only_bit, only_carry, next_carry = islice(spare, 4)
    lanes = contents.values[carry]
    for number, name in enumerate(names):
        v = contents.values[name]
        contents.values[name] = v ^ lanes
        lanes &= v if up else ~v
        gates.nor(neither, [name, carry])
        gates.nor(only_bit, [neither, carry])
        gates.nor(only_carry, [neither, name])
        gates.or_(name, [only_bit, only_carry])
        if not lanes or number + 1 == len(names):
            break
        carry = only_carry
        if up and contents.few:  # in place: a word more, a register fewer
            gates.nor(neither, [neither, only_bit, only_carry])
            carry, neither, next_carry = neither, next_carry, neither
        elif up:
            gates.nor(next_carry, [neither, only_bit, only_carry])
            carry = next_carry
    contents.gates += gates.take()


def _write(contents: RegisterContents, names: Sequence[str], register: str, number: int) -> None:
    """Append gates that write `number` to the counter `names` where `register`, which is none of
    them, is 1."""
    gates = Gates(contents.machine)
    lanes, zero = contents.values[register], contents.first_unused_scratch()
    for bit, name in enumerate(names):
        v = contents.values[name]
        if number >> bit & 1 and lanes & ~v:
            gates.or_(name, [name, register])
            contents.values[name] = v | lanes
        elif not number >> bit & 1 and lanes & v:
            gates.nor(zero, [name])
            gates.nor(name, [zero, register])
            contents.values[name] = v & ~lanes
    contents.gates += gates.take()


def _register(contents: RegisterContents, names: Sequence[str], lanes: int, free: int = 0) -> str:
    """Return a register that is 1 in `lanes`, perhaps in `free`, and 0 in all others, after
    appending gates that compute it if there is none.

    Both are truth vectors (integers with one bit for each lane). The result is none of `names`, the
    registers of the counter. Raises GaveUp if no gates compute it."""
    for name, v in contents.values.items():
        if name not in names and not lanes & ~v and not v & ~(lanes | free):
            return name
    result = contents.first_unused_scratch()
    best: tuple[list[Gate], int] | None = None
    for inverted, wanted in enumerate((lanes, contents.everything & ~(lanes | free))):
        cover = _cover(contents, names, wanted, free)
        if cover is None:
            continue
        cubes, v = cover
        gates = _gates(contents, cubes, inverted=bool(inverted))
        if best is None or sum(gate.words for gate in gates) < sum(gate.words for gate in best[0]):
            best = gates, contents.everything & ~v if inverted else v
    if best is None:
        raise GaveUp("the registers do not tell the lanes that count")
    contents.gates += best[0]
    contents.values[result] = best[1]
    return result


def _cover(
    contents: RegisterContents, names: Sequence[str], lanes: int, free: int
) -> tuple[list[Cube], int] | None:
    """Return cubes whose OR is 1 in `lanes`, perhaps in `free`, and 0 in all others, and that OR;
    None if there is none with few cubes.

    They are truth vectors (integers with one bit for each lane). Of all registers that a cube can
    do without, those of the counter `names` are left out first, and FLAG last."""
    others = contents.everything & ~(lanes | free)
    cubes: list[Cube] = []
    reached = 0
    while left := lanes & ~reached:
        lane = left & -left
        kept = {
            name: v if v & lane else contents.everything & ~v for name, v in contents.values.items()
        }
        # A register that must be 1 takes more words, so it is left out before those that must be 0.
        for name in sorted(
            kept,
            key=lambda name: (name not in names, name == FLAG, -(contents.values[name] & lane)),
        ):
            v = kept.pop(name)
            if others & _intersection(contents, kept):
                kept[name] = v
        cube = _intersection(contents, kept)
        if cube & others or len(cubes) == _MOST_CUBES:
            return None
        reached |= cube
        ones = tuple(name for name in kept if contents.values[name] & lane)
        cubes.append((ones, tuple(name for name in kept if name not in ones)))
    return cubes, reached


def _intersection(contents: RegisterContents, literals: Mapping[str, int]) -> int:
    """Return the AND of truth vectors (integers with one bit for each lane); all lanes if there are
    none."""
    lanes = contents.everything
    for v in literals.values():
        lanes &= v
    return lanes


def _gates(contents: RegisterContents, cubes: Sequence[Cube], *, inverted: bool) -> list[Gate]:
    """Return gates that write the OR of cubes, or its inverse if `inverted`, to the first unused
    scratch register (for intermediate results). Three are used."""
    gates = Gates(contents.machine)
    total, zeros_of, last = islice(contents.unused_scratch(), 3)
    sources = [ones[0] for ones, zeros in cubes if len(ones) == 1 and not zeros]
    products = [cube for cube in cubes if len(cube[0]) != 1 or cube[1]]
    for number, (ones, zeros) in enumerate(products):
        if number > 1:
            gates.or_(total, [total, last])
        for k, one in enumerate(ones):
            gates.nor(last if k else zeros_of, [one])
            if k:
                gates.or_(zeros_of, [zeros_of, last])
        gates.nor(last if number else total, [*zeros, zeros_of] if ones else zeros)
    sources += [total, last][: len(products)]
    if inverted:
        gates.nor(total, sources)
    elif sources != [total]:
        gates.or_(total, sources)
    return list(gates.take())
