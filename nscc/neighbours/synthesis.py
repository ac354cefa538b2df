"""Find short programs for a convolution kernel.

Candidates are rows of a table, rotated, chained and added, and one program that works for every
kernel. The search is deterministic and limits its number of steps. Results are ordered by number
of words; a longer program is kept only if its intermediate values are smaller."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from math import sqrt

from nscc.neighbours.programs import (
    IDENTITY,
    OF_STEP,
    TURNS,
    UNIT,
    BusWord,
    Offset,
    Polynomial,
    Program,
    Taps,
    added,
    chained,
    halved,
    kernel_of,
    moved,
    program_from_text,
    renamed,
    turned,
    turned_taps,
    values_of,
)
from nscc.neighbours.table import ROWS
from nscc.operations import NEIGHBOURS, STEPS

STEPS_OF_LEVEL = (100, 400, 2_500, 20_000)
"""Largest number of convolution kernels that a search decomposes, by optimisation level."""
_MOST_KEPT = 6
_MOST_DEPTH = 7

_Key = frozenset[tuple[Offset, int]]
_HALVE: Program = (BusWord(("h", "NEWS"), ("x",)),)
_NEGATE: Program = (BusWord(("m",), ("x",)),)


@cache
def rows() -> dict[_Key, Program]:
    """Return the table's programs and their rotations and reflections, by convolution kernel."""
    shortest: dict[_Key, Program] = {}
    for line in ROWS.split("\n"):
        if line:
            program = program_from_text(line)
            taps = kernel_of(program)
            for turn in TURNS:
                key = frozenset(turned_taps(taps, turn).items())
                if len(program) < len(shortest.get(key, program * 2)):
                    shortest[key] = turned(program, turn)
    return shortest


@dataclass(frozen=True)
class Ranged:
    """A program and `peak`, the largest factor by which one of its values may exceed its input."""

    program: Program
    peak: Fraction


class Synthesis:
    """A search for programs of convolution kernels, with a limited number of steps."""

    def __init__(self, steps: int) -> None:
        self.steps = steps
        self._known: dict[_Key, tuple[int, list[Ranged]]] = {}

    def programs(self, taps: Taps) -> list[Ranged]:
        """Return programs for a convolution kernel, the shortest first, each later one with smaller
        values.

        Each result is checked: running its words yields the kernel."""
        candidates = [*self._programs(dict(taps), _MOST_DEPTH), _ranged(accumulated(taps))]
        candidates = [_ranged(tidied(candidate.program)) for candidate in candidates]
        assert all(kernel_of(candidate.program) == dict(taps) for candidate in candidates)
        return _best(candidates)

    def _programs(self, taps: Polynomial, depth: int) -> list[Ranged]:
        key = frozenset(taps.items())
        if taps == IDENTITY:
            return [Ranged((), Fraction(1))]
        at_depth, known = self._known.get(key, (0, []))
        if at_depth >= depth:
            return known
        if self.steps <= 0 or depth <= 0:
            return known
        self.steps -= 1
        self._known[key] = depth, known
        candidates = [_ranged(program) for program in self._candidates(taps, key, depth)]
        best = _best([*known, *candidates])
        self._known[key] = depth, best
        return best

    def _candidates(self, taps: Polynomial, key: _Key, depth: int) -> Iterator[Program]:
        table = rows()
        if key in table:
            yield table[key]
        inverse = added((-1, taps))
        inverse_key = frozenset(inverse.items())
        if inverse_key in table:
            yield chained(table[inverse_key], _NEGATE)
        if taps == {(0, 0): -UNIT}:
            yield _NEGATE
            return
        if halvings_of(taps):
            doubled = added((-2, taps))
            for remaining in self._programs(doubled, depth - 1):
                yield chained(_HALVE, remaining.program)
                if remaining.program:
                    yield chained(remaining.program, _HALVE)
        for factor in factors():
            quotient = quotient_of(taps, factor)
            if quotient is not None and quotient != IDENTITY:
                for remaining in self._programs(quotient, depth - 1):
                    yield chained(factor.program, remaining.program)
        yield from self._sums(inverse, depth)

    def _sums(self, inverse: Polynomial, depth: int) -> Iterator[Program]:
        """Yield programs whose last word adds two values; `inverse` is the sum of these values."""
        table = rows()
        if len(inverse) < 2:
            return
        middle = inverse.get((0, 0), 0)
        centre_weights: set[int] = set()
        if middle:
            least = min(map(abs, inverse.values()))
            centre_weights = {UNIT, least, 2 * least, -least, -2 * least}
            centre_weights |= {middle - weight for weight in (0, *inverse.values())}
        for centre_weight in sorted(centre_weights - {0}):
            alone: Taps = {(0, 0): centre_weight}
            remainder = added((1, inverse), (-1, alone))
            if remainder and abs(remainder.get((0, 0), 0)) < abs(middle):
                seconds = self._programs(dict(alone), depth - 2) or [_ranged(accumulated(alone))]
                for first in self._programs(remainder, depth - 2):
                    for second in seconds:
                        yield _summed(first.program, second.program)
        for key, program in table.items():
            remainder = added((1, inverse), (-1, dict(key)))
            remainder_program = table.get(frozenset(remainder.items()))
            if remainder_program is not None:
                yield _summed(program, remainder_program)


def _summed(first: Program, second: Program) -> Program:
    """Return both programs followed by a word that adds their results."""
    a, b = renamed(first, {"x": "x"}, "a"), renamed(second, {"x": "x"}, "b")
    results = [program[-1].destinations[0] if program else "x" for program in (a, b)]
    return (*a, *b, BusWord(("s",), tuple(results)))


@dataclass(frozen=True)
class Factor:
    """A convolution kernel of at least two weights, tried as a divisor of others, with its program.

    `lead` is the offset of its last weight, ordered by column, then by row; `size` is its number of
    columns and of rows, each less one; `corner` is its smallest column and row."""

    taps: Taps
    program: Program
    lead: Offset
    size: Offset
    corner: Offset

    @classmethod
    def of(cls, taps: Taps, program: Program) -> Factor:
        corner, size = _box(taps)
        return cls(taps, program, max(taps), size, corner)


def _box(taps: Taps) -> tuple[Offset, Offset]:
    """Return a convolution kernel's smallest column and row, and its columns and rows, each less
    one."""
    columns, rows_ = [x for x, _ in taps], [y for _, y in taps]
    corner = min(columns), min(rows_)
    return corner, (max(columns) - corner[0], max(rows_) - corner[1])


@cache
def factors() -> tuple[Factor, ...]:
    """Return the table's convolution kernels that have at least two weights."""
    return tuple(Factor.of(dict(key), program) for key, program in rows().items() if len(key) > 1)


def quotient_of(taps: Taps, factor: Factor) -> Polynomial | None:
    """Return the convolution kernel whose convolution with `factor` is `taps`, or None."""
    corner, size = _box(taps)
    width, height = size[0] - factor.size[0], size[1] - factor.size[1]
    if width < 0 or height < 0:
        return None
    first_col, first_row = corner[0] - factor.corner[0], corner[1] - factor.corner[1]
    lead_weight = factor.taps[factor.lead]
    dividend, quotient = dict(taps), {}
    while dividend:
        last = max(dividend)
        x, y = last[0] - factor.lead[0], last[1] - factor.lead[1]
        weight, remainder = divmod(dividend[last] * UNIT, lead_weight)
        if remainder or not (
            first_col <= x <= first_col + width and first_row <= y <= first_row + height
        ):
            return None
        quotient[x, y] = weight
        for (right, down), factor_weight in factor.taps.items():
            place = (x + right, y + down)
            difference = dividend.get(place, 0) - weight * factor_weight // UNIT
            if difference:
                dividend[place] = difference
            else:
                dividend.pop(place, None)
    return quotient


def halvings_of(taps: Taps) -> int:
    """Return how often a convolution kernel of integer weights must be halved to give this
    kernel."""
    lowest = min((weight & -weight).bit_length() for weight in taps.values())
    return max(0, UNIT.bit_length() - lowest)


# --- a way that always ends -----------------------------------------------------------------------

_OPPOSITE = {name: OF_STEP[-x, -y] for name, (x, y) in STEPS.items()}


def accumulated(taps: Taps) -> Program:
    """Return a program for any convolution kernel, which adds one neighbour after the other.

    The program halves its input first until all weights are integers. The running sum changes its
    sign with every word."""
    halvings = halvings_of(taps)
    words = [
        BusWord((f"h{number + 1}", "NEWS"), (f"h{number}" if number else "x",))
        for number in range(halvings)
    ]
    multiples = _Multiples(f"h{halvings}" if halvings else "x", words)
    order = sorted(taps, key=lambda at: (-abs(at[0]) - abs(at[1]), at))
    total: tuple[str, ...] = ()
    for index, at in enumerate(order):
        sign = (-1) ** (halvings + len(order) - 1 - index)
        factor = taps[at] * 2**halvings // UNIT * sign
        if at == (0, 0):
            sources = (multiples.of(-factor), *total)
        else:
            sources = (_moved_by(at, multiples.of(factor), words), *total)
        total = (f"s{index}",)
        words.append(BusWord(total, sources))
    return tuple(words)


def _moved_by(at: Offset, register: str, words: list[BusWord]) -> str:
    """Return the source through which the next word reads minus the register of the pixel at `at`.

    The source is NEWS after one step to a neighbour, and a neighbour's NEWS after two steps."""
    x, y = at
    steps = [OF_STEP[1 if x > 0 else -1, 0]] * abs(x) + [OF_STEP[0, 1 if y > 0 else -1]] * abs(y)
    while len(steps) > 2:
        first, second, *steps = steps
        words.append(BusWord((_OPPOSITE[first],), (register,)))
        register = f"{register}{first}{second}"
        words.append(BusWord((register,), (second,)))
    words.append(BusWord((_OPPOSITE[steps[0]],), (register,)))
    return steps[1] if len(steps) == 2 else "NEWS"


class _Multiples:
    """Integer multiples of a register, computed on first request."""

    def __init__(self, source: str, words: list[BusWord]) -> None:
        self.words = words
        self.held = {1: source}

    def of(self, factor: int) -> str:
        """Return the register that holds `factor` times the source."""
        if factor not in self.held:
            name = f"m{factor}"
            sources: tuple[str, ...] = ()
            if -factor in self.held or factor == -1:
                sources = (self.of(-factor),)
            else:
                sign = 1 if factor > 0 else -1
                half = sign << (abs(factor).bit_length() - 1)
                half = half // 2 if half == factor else half
                first, remainder = self.of(-half), factor - half
                if remainder == half:
                    self.words.append(BusWord(("NEWS",), (self.of(half),)))
                    sources = (first, "NEWS")
                else:
                    sources = (first, self.of(-remainder))
            self.words.append(BusWord((name,), sources))
            self.held[factor] = name
        return self.held[factor]


# --- choosing -------------------------------------------------------------------------------------


def _ranged(program: Program) -> Ranged:
    peak = Fraction(1)
    for taps in values_of(program):
        peak = max(peak, *gains(taps))
    return Ranged(program, peak)


def gains(taps: Taps) -> tuple[Fraction, Fraction]:
    """Return the sum of the positive weights, and minus the sum of the negative weights."""
    added_weight = sum(weight for weight in taps.values() if weight > 0)
    subtracted = sum(-weight for weight in taps.values() if weight < 0)
    return Fraction(added_weight, UNIT), Fraction(subtracted, UNIT)


def _best(candidates: list[Ranged]) -> list[Ranged]:
    """Return the shortest program, and longer programs with successively smaller values."""
    best: list[Ranged] = []
    for candidate in sorted(
        candidates, key=lambda candidate: (len(candidate.program), candidate.peak)
    ):
        if not best or candidate.peak < best[-1].peak:
            best.append(candidate)
    return best[:_MOST_KEPT]


def tidied(program: Program) -> Program:
    """Return the program without words whose value is held already or is never read."""
    registers: dict[str, Polynomial] = {"x": dict(IDENTITY)}
    names: dict[str, str] = {"x": "x"}
    words: list[BusWord] = []
    values = values_of(program)
    for number, (word, value) in enumerate(zip(program, values, strict=True)):
        sources = tuple(names.get(name, name) for name in word.sources)
        if len(set(sources)) < len(sources):
            return program  # the same register twice is one source
        first = word.destinations[0]
        if len(word.destinations) == 1:
            if first in NEIGHBOURS or first == "NEWS":
                step = STEPS.get(first, (0, 0))
                placed = moved(value, -step[0], -step[1])
                if registers.get("NEWS") == placed:
                    continue
            else:
                same = next((n for n, v in registers.items() if v == value and n != "NEWS"), None)
                if same is not None and number + 1 < len(program):
                    names[first] = same
                    continue
        for name in word.destinations:
            step = STEPS.get(name, (0, 0))
            registers["NEWS" if name in NEIGHBOURS else name] = moved(value, -step[0], -step[1])
            names[name] = name
        words.append(BusWord(word.destinations, sources))
    return _used(words)


def _used(words: Sequence[BusWord]) -> Program:
    """Return the words whose results are read."""
    used_words: list[BusWord] = []
    live: set[str] = set(words[-1].destinations[:1]) if words else set()
    for word in reversed(words):
        writes = {"NEWS" if name in NEIGHBOURS else name for name in word.destinations}
        if not writes & live:
            continue
        used_words.append(word)
        live -= writes
        live |= {"NEWS" if name in NEIGHBOURS else name for name in word.sources}
    return tuple(reversed(used_words))


def noise_gain(program: Program) -> float:
    """Return the standard deviation of the error of a program's result.

    Each word adds to each destination an independent error of standard deviation 1."""
    last = program[-1].destinations[0] if program else ""
    total = 0.0
    for number in range(len(program)):
        for name in program[number].destinations:
            taps = _error_of(program, number, name).get(last, {})
            total += sum((weight / UNIT) ** 2 for weight in taps.values())
    return sqrt(total)


def _error_of(program: Program, number: int, destination: str) -> dict[str, Polynomial]:
    """Return each register's value at the end if one word makes a unit error in one destination."""
    registers: dict[str, Polynomial] = {}
    for index, word in enumerate(program[number:], number):
        error: Polynomial = {}
        for name in word.sources:
            addend_error = registers.get("NEWS" if name in NEIGHBOURS else name, {})
            error = added((1, error), (-1, moved(addend_error, *STEPS.get(name, (0, 0)))))
        for name in word.destinations:
            right, down = STEPS.get(name, (0, 0))
            value = halved(error) if word.halves else error
            if index == number and name == destination:
                value = added((1, value), (1, IDENTITY))
            registers["NEWS" if name in NEIGHBOURS else name] = moved(value, -right, -down)
    return registers
