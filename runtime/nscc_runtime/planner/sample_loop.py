"""The loops that draw a sample of a scene's pixels, and gather the light there and beside them."""

from __future__ import annotations

from typing import Annotated

from nscc_runtime.loop import Floats, Floats32, Ints, Written, inlined, loop, record

SIDES = 4
"""Neighbours of a pixel: above, below, left and right."""


@record
class Array:
    """The array that is looked at."""

    rows: int
    cols: int


@record
class Drawing:
    """How many pixels there are, and how many are drawn."""

    pixels: int
    wanted: int


@record
class Gathering:
    """How many frames there are, of how many pixels; how many of these are gathered, and what is
    the most light that counts."""

    count: int
    pixels: int
    places: int
    most: float


@inlined
def _scored(
    light: Floats, p: int, up: int, down: int, left: int, right: int, score: Floats
) -> None:  # fmt: skip
    """Pixel p; where it has no neighbour, the place is its own."""
    here = light[p]
    found = here + abs(here - light[up]) + abs(here - light[down])
    score[p] = found + abs(here - light[left]) + abs(here - light[right])


@loop
def scores(
    array: Array,
    light: Annotated[Floats, "rows cols"],
    score: Written[Annotated[Floats, "rows cols"]],
) -> None:
    """score := the light of each pixel and how much that of its neighbours is more or less."""
    rows, cols = array.rows, array.cols
    for row in range(rows):
        first, last = row * cols, (row + 1) * cols - 1
        up, down = -cols if row > 0 else 0, cols if row + 1 < rows else 0
        for p in range(first + 1, last):
            _scored(light, p, p + up, p + down, p - 1, p + 1, score)
        for p in (first, last):
            left, right = 1 if p > first else 0, 1 if p < last else 0
            _scored(light, p, p + up, p + down, p - left, p + right, score)


@loop
def draw(
    drawing: Drawing,
    chance: Annotated[Floats, "pixels"],
    points: Annotated[Floats, "wanted"],
    drawn: Written[Annotated[Ints, "wanted"]],
) -> None:
    """drawn[k] := the first pixel up to which there is more of all chance than points[k] parts of
    `wanted`, the last one at most; points rise."""
    pixels, wanted = drawing.pixels, drawing.wanted
    total = 0.0
    for p in range(pixels):
        total += chance[p]
    part, upto, k = total / wanted, 0.0, 0
    for p in range(pixels):
        upto += chance[p]
        while k < wanted and points[k] * part < upto:
            drawn[k] = p
            k += 1
    while k < wanted:
        drawn[k] = pixels - 1
        k += 1


@loop
def gather(
    gathering: Gathering,
    frames: Annotated[Floats32, "count pixels"],
    chosen: Annotated[Ints, "places"],
    beside: Annotated[Ints, "4 places"],
    there: Annotated[Floats, "4 places"],
    response: Annotated[Floats, "4 places"],
    lit: Written[Annotated[Floats32, "count 2 places"]],
    others: Written[Annotated[Floats32, "count 4 places"]],
    even: Written[Annotated[Floats32, "count places"]],
) -> None:
    """lit, others := the frames at the places `chosen`, and at those `beside` them. The second of
    `lit`: what of these is `there`, by their `response`, in sum; even := the same if all responded
    alike."""
    count, pixels, places, most = (
        gathering.count, gathering.pixels, gathering.places, gathering.most
    )  # fmt: skip
    for t in range(count):
        for i in range(places):
            at = 2 * t * places + i
            lit[at] = min(frames[t * pixels + chosen[i]], most)
            counted, alike = 0.0, 0.0
            for side in range(SIDES):
                k = side * places + i
                light = min(frames[t * pixels + beside[k]], most)
                others[(t * SIDES + side) * places + i] = light
                alike += there[k] * light
                counted += there[k] * light * response[k]
            lit[at + places] = counted
            even[t * places + i] = alike
