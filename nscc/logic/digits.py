"""Numbers as planes: binary digits and Gray codes.

One NOR selects a group's shutters if every plane that is 1 in its code has been inverted. The step
to the next group inverts two bits on average with binary codes, but always one with a Gray code (F.
Gray, US patent 2 632 058, 1953). All planes must be restored at the frame's end, so the Gray code
with the cheapest restoration is chosen."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TypeVar

from nscc.arrays import Ints
from nscc.logic.problem import Gate, Segment
from nscc.truth import number_planes

Numbers = TypeVar("Numbers", int, Ints)


def gray(number: Numbers) -> Numbers:
    """Return the reflected binary Gray code of a number, or of each number of an array. Codes of
    successive numbers differ in one bit."""
    return number ^ (number >> 1)


def cycle(groups: int, bits: int) -> tuple[int, ...]:
    """Return a Gray code of `groups` different codes of `bits` bits, whose last or second last code
    is a neighbour of the first.

    Few bits must then be restored at the end. The caller ensures 1 <= `bits` and `groups` <=
    2^`bits`."""
    # Count up without the top bit and down with it, which is a cycle. An odd number adds one code
    # after the last.
    half = groups // 2
    ascending = [gray(i) for i in range(half)]
    top = 1 << bits - 1
    codes = ascending + [top | code for code in reversed(ascending)]
    if groups % 2:  # a neighbour of the last code, beside the cycle
        codes.append(codes[-1] ^ max(top >> 1, 1) if half else 0)
    return tuple(codes)


Planes = list[tuple[int, str]]
"""For each plane its truth vector at the start of a frame, and its description."""


def unzipped(planes: Planes) -> tuple[tuple[int, ...], tuple[str, ...]]:
    """Split planes into the fields `planes` and `holders` of a solution. A plane is the content of
    a code register."""
    return tuple(plane for plane, _ in planes), tuple(holder for _, holder in planes)


def binary_planes(name: str, numbers: Ints, bits: int) -> Planes:
    """Return the `bits` lowest binary digits of numbers (shutters,), as planes (contents of code
    registers), lowest digit first. They are described as `name` and the number of the digit: `name
    0`, `name 1`, and so on."""
    return [(plane, f"{name} {i}") for i, plane in enumerate(number_planes(numbers, bits))]


def turned_over(planes: Iterable[int]) -> tuple[Segment, ...]:
    """Return segments (groups of gates that run together) that invert these planes (by number) in
    place, one for each plane. A plane is the content of a code register."""
    return tuple((Gate("NOT", f"p{plane}", (f"p{plane}",)),) for plane in planes)
