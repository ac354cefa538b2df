"""Digits of numbers as planes: mixed radices, binary digits, thermometers."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cache

import numpy as np
from numpy.typing import NDArray

from nscc.logic.problem import Gate, Segment
from nscc.truth import columns, number_planes

Planes = list[tuple[int, str]]
"""Of each plane the truth vector at the start of a frame, and in words what it carries."""


def unzipped(planes: Planes) -> tuple[tuple[int, ...], tuple[str, ...]]:
    """`planes` and `holders` of a solution."""
    return tuple(plane for plane, _ in planes), tuple(holder for _, holder in planes)


@cache
def radices_of(most: int, least: int) -> tuple[tuple[int, ...], ...]:
    """Mixed radices, highest first, whose sum is at most `most` and product at least `least`.

    Those of the smallest sum first; without digits of 1. The product is how many numbers they tell
    apart, the sum how many registers they take: a digit of radix r has r - 1 planes of a
    thermometer and a register for a cube of its own (`nested`), or a plane for each of r values
    (`events`).
    """
    choices: list[tuple[int, ...]] = []

    def extend(chosen: tuple[int, ...], total: int, remaining: int) -> None:
        if remaining <= 1:
            choices.append(chosen)
            return
        for radix in range(2, min(remaining, most - total) + 1):
            # Rising only: which place a radix has changes neither sum nor product.
            if not chosen or radix >= chosen[-1]:
                extend((*chosen, radix), total + radix, -(-remaining // radix))

    if least <= 1:
        return ((1,),)
    extend((), 0, least)
    return tuple(sorted(choices, key=lambda r: (sum(r), len(r), int(np.prod(r))))[:6])


def binary_planes(name: str, numbers: NDArray[np.int64], bits: int) -> Planes:
    """The lowest `bits` binary digits of numbers (shutters,), the lowest first: `name 0`, .."""
    return [(plane, f"{name} {i}") for i, plane in enumerate(number_planes(numbers, bits))]


def digits_of(
    numbers: NDArray[np.int64], radices: Sequence[int]
) -> list[tuple[str, NDArray[np.int64], int]]:
    """For each digit, the highest first: its name, its values (shutters,) and its radix."""
    digits = []
    size = int(np.prod(radices))
    for place, radix in enumerate(radices):
        size //= radix
        digits.append((f"digit {len(radices) - 1 - place}", numbers // size % radix, radix))
    return digits


def thermometers(
    numbers: NDArray[np.int64], radices: Sequence[int], negative: bool | NDArray[np.bool_]
) -> Planes:
    """For each digit, the highest first, a plane for each m: digit <= m, or > m if `negative`.

    (Thermometer codes: 3 of 0..4 is 1110 in "> m". To compare with a constant is to look at one
    plane, where binary digits would take a gate of several levels.) `negative` may differ from
    shutter to shutter (shutters,).
    """
    sign = ">" if negative is True else "<="
    return [
        (columns(((digit <= m) ^ negative)[:, None])[0], f"{name} {sign} {m}")
        for name, digit, radix in digits_of(numbers, radices)
        for m in range(radix - 1)
    ]


def nor(destination: str, sources: Sequence[str]) -> Segment:
    """destination := NOR(sources), of which there are some."""
    return (Gate("NOR" if len(sources) > 1 else "NOT", destination, tuple(sources)),)


def turned_over(planes: Iterable[int]) -> tuple[Segment, ...]:
    """Inverts planes in place, each in a segment of its own."""
    return tuple((Gate("NOT", f"p{plane}", (f"p{plane}",)),) for plane in planes)
