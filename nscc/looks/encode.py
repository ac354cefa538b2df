"""Encodings of behaviours and states in a pixel's registers.

The behaviour of a pixel is determined by its code. The host loads it, so any injective encoding is
possible. Every state starts with all its registers at 0."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import chain, combinations, product

import numpy as np

from nscc.arrays import Bools, Ints
from nscc.record import Record
from nscc.words.machine import StateMachine

Rows = Bools
"""The bits of values: (values, registers)."""


COUNTER = "binary counter"
"""The kind of a binary encoding of numbers that count from the start of the state, upwards and
downwards."""


class ValueBits(Record, eq=False):
    """The register contents for the values of a state, or for the behaviours (sets of codes that
    act alike) of codes.

    Row k of `bits`, bool (values, registers), belongs to `values[k]`. For codes, `values` number
    the behaviours from 0 and `name` is "code". `kind` names the encoding, such as "one-hot"."""

    name: str
    kind: str
    values: tuple[int, ...]
    bits: Rows

    @property
    def registers(self) -> int:
        """The number of registers."""
        return int(self.bits.shape[1])


class LooksEncoding(Record, eq=False):
    """The register contents for codes and for every state of a program with senses.

    `code` has a row for each behaviour: a set of codes whose pixels act alike for all answers.
    `states` are in the order of the state machine's."""

    code: ValueBits
    states: tuple[ValueBits, ...]

    @property
    def name(self) -> str:
        """The description for reports, such as "code binary, closed_at one-hot"; "nothing to hold"
        without registers."""
        holders = [self.code] if self.code.registers else []
        holders += [holder for holder in self.states if holder.registers]
        return ", ".join(f"{holder.name} {holder.kind}" for holder in holders) or "nothing to hold"


def encodings(machine: StateMachine, registers: int) -> Iterator[LooksEncoding]:
    """Yield encodings of codes and states in at most `registers` registers; nothing if none is
    small enough.

    They are all combinations of encodings of the code and of each state, binary ones last. At the
    end, binary states are counters (`COUNTER`), which gates can count up and
    down."""
    behaviours = int(machine.behaviour.max()) + 1  # sets of codes that act alike
    behaviour_numbers = tuple(range(behaviours))
    codes = [
        ValueBits("code", kind, behaviour_numbers, bits) for kind, bits in _of_code(behaviours)
    ]
    states = []
    for k, state in enumerate(machine.states):
        reached = sorted(set(machine.values[:, k].tolist()))
        values = tuple(dict.fromkeys([state.start, *reached]))
        bit_choices = list(_of_state(len(values)))
        if state.sense and not _outlasts(machine, k):
            bit_choices = [("not held", np.zeros((len(values), 0), np.bool_))]
        states.append([ValueBits(state.name, kind, values, bits) for kind, bits in bit_choices])
    # The last choice of each state is binary.
    counters = [[_counter(last) if last.registers > 1 else last] for *_, last in states]
    for code, *chosen in chain(product(codes, *states), product(codes, *counters)):
        if sum(value_bits.registers for value_bits in (code, *chosen)) <= registers:
            yield LooksEncoding(code, tuple(chosen))


def _counter(binary: ValueBits) -> ValueBits:
    """Return a binary encoding of a state with other numbers: values above the start, which is
    `values[0]`, count from 0, and values below it down from 0, modulo two to the number of bits."""
    ranks = np.argsort(np.argsort(binary.values))
    numbers = (ranks - ranks[0]) % (1 << binary.registers)
    return replace(binary, kind=COUNTER, bits=_binary(numbers, binary.registers))


def _outlasts(machine: StateMachine, k: int) -> bool:
    """Return whether pixels that differ only in one answer act differently after the boundary at
    which it was given.

    `k` is the index of the state that holds the answer. An answer that rules read only at its own
    boundary needs no register, because FLAG (the bit that lets a pixel act) has it there."""
    other_values = np.delete(machine.values, k, axis=1)
    alike = np.unique(
        np.column_stack([machine.behaviour, other_values]), axis=0, return_inverse=True
    )[1].reshape(-1)
    # Nodes of the next stage that differ only in the answer count as one; -1 stands for none.
    after = np.where(machine.steps >= 0, alike[machine.steps], -1)
    for stage in range(machine.stages):
        span, begin = machine.nodes(stage), machine.starts(stage)
        # Resets at the stage's own boundary do not count: FLAG still has the answer there.
        does = [
            alike[span],
            machine.opens[span].reshape(span.stop - span.start, -1),
            machine.resets[span, begin + 1 :],
            after[span],
        ]
        distinct = {row.tobytes() for row in np.column_stack(does)}
        if len(distinct) > len(set(alike[span].tolist())):
            return True
    return False


def _of_code(behaviours: int) -> Iterator[tuple[str, Rows]]:
    """Yield encodings of `behaviours` different codes (at least one): their kind and bits, bool
    (behaviours, registers).

    The kinds are thermometer, one-hot and binary. A single behaviour (set of codes that act alike)
    needs no register ("none")."""
    if behaviours == 1:
        yield "none", np.zeros((1, 0), np.bool_)
        return
    yield "thermometer", np.tri(behaviours, behaviours - 1, -1, dtype=np.bool_)
    yield "one-hot", np.eye(behaviours, dtype=np.bool_)[:, 1:]
    yield "binary", _binary(range(behaviours), (behaviours - 1).bit_length())


def _of_state(count: int) -> Iterator[tuple[str, Rows]]:
    """Yield encodings of a state with `count` values (at least one): their kind and bits, bool
    (count, registers); a binary one is last.

    Row 0 belongs to the value with which the state starts, and is all zeros. One value needs no
    register ("constant"), two need one ("bit")."""
    if count == 1:
        yield "constant", np.zeros((1, 0), np.bool_)
        return
    one_hot = np.eye(count, dtype=np.bool_)[:, 1:]
    if count == 2:
        yield "bit", one_hot
        return
    yield "one-hot", one_hot
    yield "thermometer", np.tri(count, count - 1, -1, dtype=np.bool_)
    yield "few ones", _few_ones(count)
    yield "binary", _binary(range(count), (count - 1).bit_length())


def _binary(numbers: Sequence[int] | Ints, width: int) -> Rows:
    """Return the `width` lowest binary digits of numbers, which are at least 0, bool (numbers,
    width), lowest digit first."""
    return (np.array(numbers)[:, None] >> np.arange(width) & 1).astype(np.bool_)


def _few_ones(count: int) -> Rows:
    """Return `count` different rows of bits with as few ones as possible, bool (count, registers),
    the fewest first.

    There are as many registers as a binary encoding needs. Each one costs a word, because states
    start at 0."""
    width = (count - 1).bit_length()
    codes = [ones for size in range(width + 1) for ones in combinations(range(width), size)]
    rows = np.zeros((count, width), np.bool_)
    for row, ones in enumerate(codes[:count]):
        rows[row, list(ones)] = True
    return rows
