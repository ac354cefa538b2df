"""Programs for dense kernels, by the binary digits of the weights.

Each weight is written in signed binary digits -1, 0 and 1, no two neighbours of which are nonzero
(the non-adjacent form: G. W. Reitwiesner, Binary arithmetic, 1960). The kernel of all digits of one
place value is a digit plane. A moving sum walks over the places of a plane: two words move it by up
to two pixels and add or subtract the input at the pixel that it reaches. After each plane, a total
takes the mean of itself and the plane's sum, so that the planes of higher digits count more.

Five registers suffice for any number of weights: the input, its negative, the moving sum, and the
old and the new total. Four suffice if the negative is computed again for each plane."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from nscc.neighbours.programs import OF_STEP, UNIT, BusWord, Offset, Program, Taps
from nscc.neighbours.table import WordForms
from nscc.operations import STEPS

_OPPOSITE = {name: OF_STEP[-x, -y] for name, (x, y) in STEPS.items()}
_MOST_EXCHANGES = 40_000
"""Largest number of exchanges of two legs that are tried for a path."""


def digit_plane_programs(taps: Taps, forms: WordForms) -> list[Program]:
    """Return two or four programs of a convolution kernel, each with five registers and with four.

    `taps` are the nonzero weights by offset, in units of 1 / UNIT, at least one. `forms` are the
    words that the chip allows. The first two programs halve the input until no digit plane exceeds
    it, so the total may have to be doubled at the end. The last two halve it no more than needed;
    they are left out if that is the same number."""
    weights = {at: weight // _common_unit(taps) for at, weight in taps.items()}
    divisor = UNIT // _common_unit(taps)
    # The divisor of all weights is a power of two.
    halvings = divisor.bit_length() - 1
    planes = _digit_planes(weights)
    paths = [_path(list(plane)) for plane in planes]
    largest = max(
        sum(digit == sign for digit in plane.values()) for plane in planes for sign in (1, -1)
    )
    # Each plane's total halves once. With `safe` more, the sum of a plane's digits stays in range.
    exact, safe = max(0, halvings - len(planes)), (largest - 1).bit_length()
    return [
        forms.allowed(
            _program(planes, paths, first, halvings - len(planes) - first, keeps_negative)
        )
        for first in dict.fromkeys((safe, exact))
        for keeps_negative in (True, False)
    ]


def _common_unit(taps: Taps) -> int:
    """Return the largest power of two that divides all weights, which are integers other than 0; at
    most UNIT."""
    return min(UNIT, *(weight & -weight for weight in taps.values()))


def _digit_planes(weights: Taps) -> list[dict[Offset, int]]:
    """Return for each place value the nonzero digits (1 or -1) of all weights by offset, lowest
    place value first.

    `weights` are integers. A place value at which no weight has a nonzero digit has an empty
    dictionary."""
    planes: list[dict[Offset, int]] = []
    for at, weight in sorted(weights.items()):
        place_value, rest = 0, weight
        while rest:
            # 1 or -1, whichever makes the next digit 0.
            digit = 2 - (rest & 3) if rest & 1 else 0
            if place_value == len(planes):
                planes.append({})
            if digit:
                planes[place_value][at] = digit
            place_value, rest = place_value + 1, (rest - digit) >> 1
    return planes


# --- paths ----------------------------------------------------------------------------------------


def _moves(start: Offset, end: Offset) -> int:
    """Return the number of moves, of one or two pixels each, between two offsets (column, row)."""
    return (abs(start[0] - end[0]) + abs(start[1] - end[1]) + 1) // 2


def _path(offsets: list[Offset]) -> list[Offset]:
    """Return the offsets in an order with few moves that ends at the centre, (0, 0), which need not
    be one of them.

    The path from the centre to the nearest offset and so on is shortened by reversing parts of it
    (2-opt: G. A. Croes, 1958), then reversed. Without offsets, the path is the centre."""
    path, unvisited = [(0, 0)], set(offsets) - {(0, 0)}
    while unvisited:
        path.append(min(unvisited, key=lambda offset: (_moves(path[-1], offset), offset)))
        unvisited.remove(path[-1])
    tried, improved = 0, True
    while improved and tried < _MOST_EXCHANGES:
        improved = False
        for first in range(len(path) - 2):
            # Reversing a single place would change nothing.
            for last in range(first + 2, len(path)):
                tried += 1
                # Reversing the part from b to c replaces the moves before and after it.
                a, b, c = path[first], path[first + 1], path[last]
                after = path[last + 1 : last + 2]  # empty if the part ends the path
                saved = _moves(a, b) - _moves(a, c)
                if after:
                    saved += _moves(c, after[0]) - _moves(b, after[0])
                if saved > 0:
                    path[first + 1 : last + 1] = path[last:first:-1]
                    improved = True
    return path[::-1]


# --- words ----------------------------------------------------------------------------------------


def _program(
    planes: Sequence[dict[Offset, int]],
    paths: Sequence[list[Offset]],
    first: int,
    last: int,
    keeps_negative: bool,
) -> Program:
    """Return the program that halves the input `first` times, and then the total `last` times.

    `planes` are the digits by offset of each place value, lowest first; `paths` are the orders in
    which they are added, one for each plane. A negative `last` is a number of doublings. Without
    `keeps_negative`, the register of the negative input is free while the total is computed. At
    least one digit must be nonzero."""
    writer = _Writer(first)
    total: str | None = None
    sign = 1
    for plane, path in zip(planes, paths, strict=True):
        # `total` holds sign times the value; the halving word inverts.
        sums = [name for name in (total, writer.plane_sum(plane, path, sign)) if name is not None]
        if sums:
            total, sign = writer.halved(*sums), -sign
        if not keeps_negative:
            writer.forget_negative()
    assert total is not None
    # One of these two loops is empty: a negative number of steps is none.
    for _ in range(last):
        total, sign = writer.halved(total), -sign
    for _ in range(-last):
        writer.words.append(BusWord(("NEWS",), (writer.summed(total),)))
        total, sign = writer.summed(total, "NEWS"), -sign
    if sign < 0:  # one more word inverts the result
        writer.summed(total)
    return tuple(writer.words)


class _Writer:
    """The words of a program under construction, which begin with words that halve the input.

    `inputs` has the registers of the halved input times 1 and times -1, by this sign; a missing one
    is computed when first read. `first_input` has the one that the halvings gave."""

    def __init__(self, halvings: int) -> None:
        """Begin with the words that halve the input `halvings` times; each of them also inverts the
        sign."""
        self.words: list[BusWord] = []
        name, sign = "x", 1
        for _ in range(halvings):
            name, sign = self.halved(name), -sign
        self.first_input = {sign: name}
        self.inputs = dict(self.first_input)

    def forget_negative(self) -> None:
        """Forget the register of the input's negative, which is then computed again when it is
        read."""
        self.inputs = dict(self.first_input)

    def summed(self, *sources: str) -> str:
        """Add a word that writes minus the sum of the source registers, and return its register."""
        self.words.append(BusWord((f"r{len(self.words)}",), sources))
        return self.words[-1].destinations[0]

    def halved(self, *sources: str) -> str:
        """Add a word that writes minus half the sum of the source registers, and return its
        register.

        A halving word has two destinations; the second is NEWS, which is overwritten."""
        name = f"r{len(self.words)}"
        self.words.append(BusWord((name, "NEWS"), sources))
        return name

    def plane_sum(self, digits: Taps, path: Sequence[Offset], sign: int) -> str | None:
        """Append words that compute the sum of a digit plane times `sign` (1 or -1); return its
        register.

        `digits` are those of the plane (1 or -1) by offset. `path` is the order of their offsets,
        and ends at (0, 0). Return None for a plane without digits."""
        if not digits:
            return None
        start = path[0]
        moving = self._input(sign * digits[start])
        for offset, target in pairwise(path):
            while offset != target:
                offset, moving = self._moved(offset, target, moving, digits, sign)
        return moving

    def _moved(
        self, offset: Offset, target: Offset, moving: str, digits: Taps, sign: int
    ) -> tuple[Offset, str]:
        """Append the two words that move the sum by at most two pixels from `offset` towards
        `target`.

        `moving` is the register of the sum so far, `digits` are those of the plane by offset, and
        `sign` (1 or -1) is that of the sum. At the target its digit is added. Return the offset
        reached, and the new sum's register. `offset` and `target` must differ."""
        steps = [
            (step_x, step_y)
            for step_x, step_y, count in (
                (1 if target[0] > offset[0] else -1, 0, abs(target[0] - offset[0])),
                (0, 1 if target[1] > offset[1] else -1, abs(target[1] - offset[1])),
            )
            for _ in range(count)
        ][:2]
        # The sum of this pixel belongs to another pixel after the move: it is read backwards.
        names = [OF_STEP[-x, -y] for x, y in steps]
        # With two steps, the first word moves by writing a neighbour, the second by reading one.
        written = _OPPOSITE[names[0]] if len(names) == 2 else "NEWS"
        reached = offset[0] + sum(x for x, _ in steps), offset[1] + sum(y for _, y in steps)
        digit = digits.get(reached, 0) if reached == target else 0
        # Two words keep the sign of the sum, and the second inverts what it adds.
        added = (self._input(-sign * digit),) if digit else ()
        self.words.append(BusWord((written,), (moving,)))
        return reached, self.summed(names[-1], *added)

    def _input(self, sign: int) -> str:
        """Return the register that holds the halved input times `sign`, 1 or -1; it is computed if
        no register holds it."""
        if sign not in self.inputs:
            self.inputs[sign] = self.summed(self.inputs[-sign])
        return self.inputs[sign]
