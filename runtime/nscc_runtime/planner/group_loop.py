"""The loops that add up, group by group of slots, what a sample's pixels and their neighbours
count."""

from __future__ import annotations

from typing import Annotated

from nscc_runtime.loop import Floats, Floats32, Ints, Ints32, Written, loop, record
from nscc_runtime.planner.sample_loop import SIDES

TOGETHER = 16
"""Slots of a lane that lie beside each other in memory."""


@record
class Grouping:
    """How much there is of everything: `pixels` of the sample, `frames` of light, of which slot n
    has the `entries` from `row_start[n]` on."""

    pixels: int
    slots: int
    lanes: int
    groups: int
    buckets: int
    frames: int
    entries: int


@loop
def of_groups(
    grouping: Grouping,
    frames: Annotated[Floats32, "frames pixels"],
    row_start: Annotated[Ints, "slots+1"],
    frame_index: Annotated[Ints32, "entries"],
    frame_part: Annotated[Floats, "entries"],
    lane: Annotated[Ints32, "pixels"],
    of_slot: Annotated[Ints32, "lanes slots"],
    weights: Annotated[Floats, "buckets slots lanes"],
    light: Written[Annotated[Floats, "groups pixels"]],
    one: Written[Annotated[Floats, "groups buckets pixels"]],
    two: Written[Annotated[Floats, "groups buckets pixels"]],
) -> None:
    """light := that of each group's slots, which are those with its number in `of_slot`; one, two
    := it by the weights of slots in the buckets, and by their squares."""
    pixels, slots, buckets, lanes = (
        grouping.pixels, grouping.slots, grouping.buckets, grouping.lanes
    )  # fmt: skip
    for i in range(grouping.groups * pixels):
        light[i] = 0.0
    for i in range(grouping.groups * buckets * pixels):
        one[i], two[i] = 0.0, 0.0
    for n in range(slots):
        for k in range(row_start[n], row_start[n + 1]):
            source, part = frame_index[k] * pixels, frame_part[k]
            for p in range(pixels):
                group = of_slot[lane[p] * slots + n]
                seen = part * frames[source + p]
                light[group * pixels + p] += seen
                for bucket in range(buckets):
                    at = (group * buckets + bucket) * pixels + p
                    weight = weights[(bucket * slots + n) * lanes + lane[p]]
                    one[at] += weight * seen
                    two[at] += weight * weight * seen


@loop
def of_groups_beside(
    grouping: Grouping,
    frames: Annotated[Floats32, "frames 4 pixels"],
    row_start: Annotated[Ints, "slots+1"],
    frame_index: Annotated[Ints32, "entries"],
    frame_part: Annotated[Floats, "entries"],
    lane: Annotated[Ints32, "pixels"],
    beside: Annotated[Ints32, "4 pixels"],
    of_slot: Annotated[Ints32, "lanes slots"],
    slot_s: Annotated[Floats, "slots"],
    weights: Annotated[Floats, "buckets slots lanes"],
    light: Written[Annotated[Floats, "groups 4 pixels"]],
    open_s: Written[Annotated[Floats, "groups 4 buckets pixels"]],
) -> None:
    """light := that of each group of the slots of the neighbours, whose lanes are `beside`; open_s
    := for how long, by its weights, the pixel sees what falls on a neighbour in that group."""
    pixels, slots, buckets, lanes = (
        grouping.pixels, grouping.slots, grouping.buckets, grouping.lanes
    )  # fmt: skip
    for i in range(grouping.groups * SIDES * pixels):
        light[i] = 0.0
    for i in range(grouping.groups * SIDES * buckets * pixels):
        open_s[i] = 0.0
    for first in range(0, slots, TOGETHER):
        stop = min(first + TOGETHER, slots)
        for p in range(pixels):
            for side in range(SIDES):
                row = beside[side * pixels + p] * slots
                for n in range(first, stop):
                    at = of_slot[row + n] * SIDES + side
                    for bucket in range(buckets):
                        weight = weights[(bucket * slots + n) * lanes + lane[p]]
                        open_s[(at * buckets + bucket) * pixels + p] += weight * slot_s[n]
                    for k in range(row_start[n], row_start[n + 1]):
                        seen = frames[(frame_index[k] * SIDES + side) * pixels + p]
                        light[at * pixels + p] += frame_part[k] * seen
