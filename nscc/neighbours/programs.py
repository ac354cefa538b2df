"""Programs of one input: lists of bus words that weigh a register's neighbours by a kernel.

A program reads the register `x` and never writes it. Every other name but NEWS and its directed
forms is a register of its own, written once. `kernel_of` runs a program on exact polynomials: what
a table or a search claims is believed only when this says so.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import TypeVar

from nscc.operations import NEIGHBOURS, STEPS

Offset = tuple[int, int]
UNIT = 1 << 40
"""Weights are whole numbers of 1 / UNIT: exact, as all divisors are powers of two."""
Taps = Mapping[Offset, int]
"""A kernel's weights by where their pixels lie: columns to the right, rows down. None is 0."""
Polynomial = dict[Offset, int]
Weight = TypeVar("Weight", int, Fraction)


@dataclass(frozen=True)
class BusWord:
    """A bus word: each destination takes minus the sum of the sources, halved for two of them."""

    destinations: tuple[str, ...]
    sources: tuple[str, ...]

    @property
    def halves(self) -> bool:
        """Whether it is a bus2 word."""
        return len(self.destinations) == 2


Program = tuple[BusWord, ...]
"""Its result is in the first destination of the last word."""

IDENTITY: Taps = {(0, 0): UNIT}


def exact_taps(weights: Mapping[Offset, Fraction]) -> Polynomial:
    """A kernel in units of 1 / UNIT; ValueError for weights that are finer."""
    scaled = {at: weight * UNIT for at, weight in weights.items()}
    if any(weight.denominator > 1 for weight in scaled.values()):
        raise ValueError(f"weights finer than 1 / {UNIT}")
    return {at: int(weight) for at, weight in scaled.items()}


def added(*terms: tuple[Weight, Mapping[Offset, Weight]]) -> dict[Offset, Weight]:
    """The sum of kernels times factors, without weights that are 0."""
    total: dict[Offset, Weight] = {}
    for factor, taps in terms:
        for at, weight in taps.items():
            total[at] = total.get(at, 0) + factor * weight
    return {at: weight for at, weight in total.items() if weight}


def moved(taps: Mapping[Offset, Weight], right: int, down: int) -> dict[Offset, Weight]:
    """The kernel of the pixel so far away."""
    return {(x + right, y + down): weight for (x, y), weight in taps.items()}


def halved(taps: Taps) -> Polynomial:
    """Half a kernel; ValueError for weights that are too fine for it."""
    if any(weight % 2 for weight in taps.values()):
        raise ValueError(f"weights finer than 1 / {UNIT}")
    return {at: weight // 2 for at, weight in taps.items()}


def kernel_of(program: Program) -> Polynomial:
    """The kernel that a program computes."""
    return values_of(program)[-1] if program else dict(IDENTITY)


def values_of(program: Program) -> list[Polynomial]:
    """What each word writes, as a kernel, by running the words on exact polynomials.

    KeyError for a program that reads what it has not written.
    """
    registers: dict[str, Polynomial] = {"x": dict(IDENTITY)}
    values: list[Polynomial] = []
    for word in program:
        addends = [
            moved(registers["NEWS"], *STEPS[name]) if name in NEIGHBOURS else registers[name]
            for name in word.sources
        ]
        value = added(*((-1, addend) for addend in addends))
        if word.halves:
            value = halved(value)
        values.append(value)
        for name in word.destinations:
            if name in NEIGHBOURS:
                right, down = STEPS[name]
                registers["NEWS"] = moved(value, -right, -down)
            else:
                registers[name] = value
    return values


# --- symmetries and joining -----------------------------------------------------------------------

_TURNS = (
    (1, 0, 0, 1), (0, -1, 1, 0), (-1, 0, 0, -1), (0, 1, -1, 0),
    (-1, 0, 0, 1), (1, 0, 0, -1), (0, 1, 1, 0), (0, -1, -1, 0),
)  # fmt: skip
"""The eight ways to turn and mirror an array: (x, y) becomes (a x + b y, c x + d y)."""
TURNS = range(len(_TURNS))
OF_STEP = {step: name for name, step in STEPS.items()}
"""The source that reads the neighbour at a step."""


def turned_taps(taps: Taps, turn: int) -> Polynomial:
    """A kernel, turned or mirrored."""
    a, b, c, d = _TURNS[turn]
    return {(a * x + b * y, c * x + d * y): weight for (x, y), weight in taps.items()}


def turned(program: Program, turn: int) -> Program:
    """The program of the turned kernel."""
    a, b, c, d = _TURNS[turn]
    names = {
        name: OF_STEP[a * x + b * y, c * x + d * y] for name, (x, y) in STEPS.items()
    }  # fmt: skip

    def of(operands: tuple[str, ...]) -> tuple[str, ...]:
        return tuple(names.get(name, name) for name in operands)

    return tuple(BusWord(of(word.destinations), of(word.sources)) for word in program)


def renamed(program: Program, names: Mapping[str, str], prefix: str) -> Program:
    """A program with other names of registers: those of `names`, and others behind a prefix."""

    def of(operand: str) -> str:
        if operand in names or operand == "NEWS" or operand in NEIGHBOURS:
            return names.get(operand, operand)
        return prefix + operand

    return tuple(
        BusWord(tuple(map(of, word.destinations)), tuple(map(of, word.sources))) for word in program
    )


def chained(first: Program, second: Program) -> Program:
    """The program whose second part takes the result of the first as its input."""
    if not first or not second:
        return first or second
    result = first[-1].destinations[0]
    return (*renamed(first, {"x": "x"}, "a"), *renamed(second, {"x": f"a{result}"}, "b"))


# --- text -----------------------------------------------------------------------------------------

_LETTERS = {"n": "NEWS", "N": "XN", "E": "XE", "S": "XS", "W": "XW"}


def program_from_text(text: str) -> Program:
    """A program as tables have it, such as `n=x a=E b=W c=x,a,b d=c,n`.

    A word is its destination, `=`, and its sources. Small letters are registers, `n` is NEWS, `N`,
    `E`, `S` and `W` are XN, XE, XS and XW. `an` are the register `a` and NEWS, both halved; `a2`
    is `a`, halved beside a register that nobody reads.
    """
    words = []
    for assignment in text.split():
        target, _, sources = assignment.partition("=")
        destinations: tuple[str, ...] = (_LETTERS.get(target[0], target[0]),)
        if len(target) == 2:
            second_destination = f"{target[0]}_" if target[1] == "2" else _LETTERS[target[1]]
            destinations = (*destinations, second_destination)
        words.append(BusWord(destinations, tuple(_LETTERS.get(s, s) for s in sources.split(","))))
    return tuple(words)
