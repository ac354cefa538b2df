"""Digits of numbers as planes: mixed radices, binary digits, thermometers."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cache

import numpy as np
from numpy.typing import NDArray

from nscc.logic.problem import Gate, Segment
from nscc.truth import columns, number_planes

Planes = list[tuple[int, str]]
"""For each plane its truth vector at the start of a frame, and its description."""


def unzipped(planes: Planes) -> tuple[tuple[int, ...], tuple[str, ...]]:
    """Split planes into the fields `planes` and `holders` of a solution."""
    return tuple(plane for plane, _ in planes), tuple(holder for _, holder in planes)


@cache
def radices_of(most: int, least: int) -> tuple[tuple[int, ...], ...]:
    """Mixed radices, highest digit first, with sum at most `most` and product at least `least`.

    Smallest sums first, without radix 1. The product is the number of distinct values, the sum the
    number of registers: a digit of radix r takes r - 1 thermometer planes and a register for its
    cube (`nested_demands`), or one plane for each of its r values (`events`).
    """
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
    """The `bits` lowest binary digits of numbers (shutters,), lowest first: `name 0`, ..."""
    return [(plane, f"{name} {i}") for i, plane in enumerate(number_planes(numbers, bits))]


def digits_of(
    numbers: NDArray[np.int64], radices: Sequence[int]
) -> list[tuple[str, NDArray[np.int64], int]]:
    """For each digit, highest first: its name, its values (shutters,) and its radix."""
    digits = []
    size = int(np.prod(radices))
    for place, radix in enumerate(radices):
        size //= radix
        digits.append((f"digit {len(radices) - 1 - place}", numbers // size % radix, radix))
    return digits


def thermometers(
    numbers: NDArray[np.int64], radices: Sequence[int], negative: bool | NDArray[np.bool_]
) -> Planes:
    """For each digit, highest first, the planes "digit <= m" for all m, or "digit > m" if
    `negative`. In a thermometer code, comparison with a constant reads one plane; binary digits
    would need several gates. `negative` may be an array (shutters,)."""
    sign = ">" if negative is True else "<="
    return [
        (columns(((digit <= m) ^ negative)[:, None])[0], f"{name} {sign} {m}")
        for name, digit, radix in digits_of(numbers, radices)
        for m in range(radix - 1)
    ]


def nor(destination: str, sources: Sequence[str]) -> Segment:
    """destination := NOR(sources), with at least one source."""
    return (Gate("NOR" if len(sources) > 1 else "NOT", destination, tuple(sources)),)


def turned_over(planes: Iterable[int]) -> tuple[Segment, ...]:
    """Invert planes in place, each in its own segment."""
    return tuple((Gate("NOT", f"p{plane}", (f"p{plane}",)),) for plane in planes)
