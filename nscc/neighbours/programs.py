"""Programs of one input: sequences of bus words that convolve a register with a kernel.

A program reads the register `x` and never writes it. Every other name, except NEWS and its
directed forms (XN, XE, XS, XW), is a register that is written once. `kernel_of` runs a program on
exact polynomials: a program from a table or a search is used only after this check."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import sqrt
from typing import NamedTuple, TypeVar

from nscc.operations import NEIGHBOURS, STEPS

Offset = tuple[int, int]
"""An offset: columns to the right and rows down."""
UNIT = 1 << 40
"""Weights are multiples of 1 / UNIT, which is exact because all divisors are powers of two."""
Taps = Mapping[Offset, int]
"""A convolution kernel: offset (columns right, rows down) to weight; a missing offset weighs 0."""
Polynomial = dict[Offset, int]
"""A convolution kernel as in `Taps`, without weights of 0, that a function may change."""
Weight = TypeVar("Weight", int, Fraction)


class BusWord(NamedTuple):
    """A word that writes minus the sum of its sources; with two destinations, minus half the
    sum."""

    destinations: tuple[str, ...]
    sources: tuple[str, ...]

    @property
    def halves(self) -> bool:
        """Whether the word halves the sum, that is, has two destinations (`bus2`)."""
        return len(self.destinations) == 2


Program = tuple[BusWord, ...]
"""Words in order; the first destination of the last word holds the result."""

IDENTITY: Taps = {(0, 0): UNIT}
"""The convolution kernel that changes nothing."""


def exact_taps(weights: Mapping[Offset, Fraction]) -> Polynomial:
    """Return a convolution kernel, weights by offset, in units of 1 / UNIT.

    Raises ValueError if a weight is not a multiple of 1 / UNIT."""
    scaled = {at: weight * UNIT for at, weight in weights.items()}
    if any(weight.denominator > 1 for weight in scaled.values()):
        raise ValueError(f"weights finer than 1 / {UNIT}")
    return {at: int(weight) for at, weight in scaled.items()}


def added(*terms: tuple[Weight, Mapping[Offset, Weight]]) -> dict[Offset, Weight]:
    """Return the sum of convolution kernels times factors, without weights of 0.

    `terms` are pairs (factor, weights by offset). Without terms, the result is {}."""
    total: dict[Offset, Weight] = {}
    for factor, taps in terms:
        for at, weight in taps.items():
            total[at] = total.get(at, 0) + factor * weight
    return {at: weight for at, weight in total.items() if weight}


def moved(taps: Mapping[Offset, Weight], right: int, down: int) -> dict[Offset, Weight]:
    """Return a convolution kernel (weights by offset) whose offsets are shifted by `right` columns
    and `down` rows."""
    return {(x + right, y + down): weight for (x, y), weight in taps.items()}


def halved(taps: Taps) -> Polynomial:
    """Return half a convolution kernel, whose weights are in units of 1 / UNIT.

    Raises ValueError if a weight is odd, so that its half is not a multiple of 1 / UNIT."""
    if any(weight % 2 for weight in taps.values()):
        raise ValueError(f"weights finer than 1 / {UNIT}")
    return {at: weight // 2 for at, weight in taps.items()}


def kernel_of(program: Program) -> Polynomial:
    """Return the convolution kernel that a program computes, in units of 1 / UNIT; the identity for
    an empty program.

    Raises KeyError if the program reads a register that it has not written, and ValueError if it
    halves too often."""
    return values_of(program)[-1] if program else dict(IDENTITY)


def values_of(program: Program) -> list[Polynomial]:
    """Return the convolution kernel that each word writes, by running the words on exact
    polynomials.

    A kernel has the nonzero weights by offset, in units of 1 / UNIT. Raises KeyError if the program
    reads a register that it has not written, and ValueError if it halves too often."""
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


# --- noise ---------------------------------------------------------------------------------------


def noise_gain(program: Program) -> float:
    """Return the standard deviation of the error of a program's result, in units of one word's
    error; 0 for an empty program.

    Each word makes an independent error of standard deviation 1 in every destination. The
    convolution of an error with all later weights gives its effect on the result."""
    # The effect on the result of a unit error in each register, from the last word backwards.
    effects: dict[str, Polynomial] = (
        {program[-1].destinations[0]: dict(IDENTITY)} if program else {}
    )
    total = 0.0
    for word in reversed(program):
        effect: Polynomial = {}
        for name in word.destinations:
            right, down = STEPS.get(name, (0, 0))
            written = effects.pop("NEWS" if name in NEIGHBOURS else name, {})
            total += sum((weight / UNIT) ** 2 for weight in written.values())
            effect = added((1, effect), (1, moved(written, -right, -down)))
        if word.halves:
            effect = halved(effect)
        for name in word.sources:
            register = "NEWS" if name in NEIGHBOURS else name
            through = moved(effect, *STEPS.get(name, (0, 0)))
            effects[register] = added((1, effects.get(register, {})), (-1, through))
    return sqrt(total)


# --- symmetries and joining -----------------------------------------------------------------------

_TURNS = (
    (1, 0, 0, 1), (0, -1, 1, 0), (-1, 0, 0, -1), (0, 1, -1, 0),
    (-1, 0, 0, 1), (1, 0, 0, -1), (0, 1, 1, 0), (0, -1, -1, 0),
)  # fmt: skip
"""The eight rotations and reflections of an array: (x, y) becomes (a x + b y, c x + d y)."""
TURNS = range(len(_TURNS))
OF_STEP = {step: name for name, step in STEPS.items()}
"""Offset of a nearest neighbour to the name of the source that reads it."""


def turned_taps(taps: Taps, turn: int) -> Polynomial:
    """Return a convolution kernel (weights by offset) rotated or mirrored; `turn` is one of
    `TURNS`, of which 0 changes nothing."""
    a, b, c, d = _TURNS[turn]
    return {(a * x + b * y, c * x + d * y): weight for (x, y), weight in taps.items()}


def turned(program: Program, turn: int) -> Program:
    """Return the program of a convolution kernel that is rotated or mirrored, from the program of
    the kernel itself.

    `turn` is one of `TURNS`, of which 0 changes nothing."""
    a, b, c, d = _TURNS[turn]  # the matrix ((a, b), (c, d)) of the rotation or reflection
    names = {name: OF_STEP[a * x + b * y, c * x + d * y] for name, (x, y) in STEPS.items()}

    def of(operands: tuple[str, ...]) -> tuple[str, ...]:
        """Return operands with directions replaced as the symmetry `names` requires."""
        return tuple(names.get(name, name) for name in operands)

    return tuple(BusWord(of(word.destinations), of(word.sources)) for word in program)


def renamed(program: Program, names: Mapping[str, str], prefix: str) -> Program:
    """Return the program with registers renamed by `names` (old to new); all other registers get
    `prefix` before their name.

    NEWS (the register that neighbours can read) and its directed forms keep their names."""

    def of(operand: str) -> str:
        """Return an operand's new name of `names`, or the operand with the prefix; NEWS (the
        register that neighbours can read) and its directed forms without one."""
        if operand in names or operand == "NEWS" or operand in NEIGHBOURS:
            return names.get(operand, operand)
        return prefix + operand

    return tuple(
        BusWord(tuple(map(of, word.destinations)), tuple(map(of, word.sources))) for word in program
    )


def chained(first: Program, second: Program) -> Program:
    """Return the program that applies `second` to the result of `first`.

    Either may be empty, which means the identity; the result is then the other. Registers get the
    prefixes a and b."""
    if not first or not second:
        return first or second
    result = first[-1].destinations[0]
    return (*renamed(first, {"x": "x"}, "a"), *renamed(second, {"x": f"a{result}"}, "b"))


# --- text -----------------------------------------------------------------------------------------

_LETTERS = {"n": "NEWS", "N": "XN", "E": "XE", "S": "XS", "W": "XW"}


def program_from_text(text: str) -> Program:
    """Return a program from the text form of tables, such as `n=x a=E b=W c=x,a,b d=c,n`.

    Words are separated by spaces. A word is its destination, `=`, and its sources, separated by
    commas. A lowercase letter is a register; `x` is the input, and `n` is NEWS (the register that
    neighbours can read). `N`, `E`, `S` and `W` are XN, XE, XS and XW. The destination `an` means
    `a` and NEWS, both halved; `a2` means `a` halved, with a second destination that is never read.
    The text must be well formed; it is not checked."""
    words = []
    for assignment in text.split():
        target, _, sources = assignment.partition("=")
        destinations: tuple[str, ...] = (_LETTERS.get(target[0], target[0]),)
        if len(target) == 2:
            second_destination = f"{target[0]}_" if target[1] == "2" else _LETTERS[target[1]]
            destinations = (*destinations, second_destination)
        words.append(BusWord(destinations, tuple(_LETTERS.get(s, s) for s in sources.split(","))))
    return tuple(words)
