"""Numbers as planes: digits in mixed radices, binary digits, Gray codes, thermometer codes.

One NOR selects a group's shutters if every plane that is 1 in its code has been inverted. The step
to the next group inverts two bits on average with binary codes, but always one with a Gray code (F.
Gray, US patent 2 632 058, 1953). All planes must be restored at the frame's end, so the Gray code
with the cheapest restoration is chosen."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cache
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from nscc.logic.problem import Gate, Segment
from nscc.truth import columns, number_planes

Numbers = TypeVar("Numbers", int, NDArray[np.int64])


def gray(number: Numbers) -> Numbers:
    """Return the reflected binary Gray code of a number."""
    return number ^ (number >> 1)


def cycle(groups: int, bits: int) -> tuple[int, ...]:
    """Return a Gray code whose last or second last code is a neighbour of the first.

    Few bits must then be restored at the end."""
    # Count up without the top bit and down with it, which is a cycle. An odd number adds one code
    # after the last.
    half = groups // 2
    ascending = [gray(i) for i in range(half)]
    top = 1 << bits - 1
    codes = ascending + [top | code for code in reversed(ascending)]
    if groups % 2:
        codes.append(codes[-1] ^ max(top >> 1, 1) if half else 0)
    return tuple(codes)


Planes = list[tuple[int, str]]
"""For each plane its truth vector at the start of a frame, and its description."""


def unzipped(planes: Planes) -> tuple[tuple[int, ...], tuple[str, ...]]:
    """Split planes into the fields `planes` and `holders` of a solution."""
    return tuple(plane for plane, _ in planes), tuple(holder for _, holder in planes)


@cache
def radices_of(most: int, least: int) -> tuple[tuple[int, ...], ...]:
    """Return mixed radices, highest digit first, with sum at most `most` and product at least
    `least`.

    Smallest sums come first; radix 1 is left out. The product is the number of distinct values, the
    sum the number of registers: a digit of radix r takes r - 1 thermometer planes and a register
    for its cube (`nested_demands`), or one plane for each of its r values (`events`)."""
    choices: list[tuple[int, ...]] = []

    def extend(chosen: tuple[int, ...], total: int, remaining: int) -> None:
        if remaining <= 1:
            choices.append(chosen)
            return
        for radix in range(2, min(remaining, most - total) + 1):
            # Ascending only, because the order of radices changes neither sum nor product.
            if not chosen or radix >= chosen[-1]:
                extend((*chosen, radix), total + radix, -(-remaining // radix))

    if least <= 1:
        return ((1,),)
    extend((), 0, least)
    return tuple(sorted(choices, key=lambda r: (sum(r), len(r), int(np.prod(r))))[:6])


def binary_planes(name: str, numbers: NDArray[np.int64], bits: int) -> Planes:
    """Return the `bits` lowest binary digits of numbers (shutters,), lowest first: `name 0`, ..."""
    return [(plane, f"{name} {i}") for i, plane in enumerate(number_planes(numbers, bits))]


def digits_of(
    numbers: NDArray[np.int64], radices: Sequence[int]
) -> list[tuple[str, NDArray[np.int64], int]]:
    """Return the name, values (shutters,) and radix of each digit, highest digit first."""
    digits = []
    size = int(np.prod(radices))
    for place, radix in enumerate(radices):
        size //= radix
        digits.append((f"digit {len(radices) - 1 - place}", numbers // size % radix, radix))
    return digits


def thermometers(
    numbers: NDArray[np.int64], radices: Sequence[int], negative: bool | NDArray[np.bool_]
) -> Planes:
    """Return for each digit the planes "digit <= m" for all m, or "digit > m" if `negative`.

    The highest digit comes first. In a thermometer code, a comparison with a constant reads one
    plane; with binary digits it would need several gates. `negative` may be an array (shutters,).
    """
    sign = ">" if negative is True else "<="
    return [
        (columns(((digit <= m) ^ negative)[:, None])[0], f"{name} {sign} {m}")
        for name, digit, radix in digits_of(numbers, radices)
        for m in range(radix - 1)
    ]


def nor(destination: str, sources: Sequence[str]) -> Segment:
    """Return the segment destination := NOR(sources), with at least one source."""
    return (Gate("NOR" if len(sources) > 1 else "NOT", destination, tuple(sources)),)


def turned_over(planes: Iterable[int]) -> tuple[Segment, ...]:
    """Return segments that invert planes in place, one for each plane."""
    return tuple((Gate("NOT", f"p{plane}", (f"p{plane}",)),) for plane in planes)
