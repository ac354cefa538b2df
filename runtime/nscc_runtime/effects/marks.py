"""The marks of clipped values in a frame: `saturated_by`, one bit per cause.

A mark follows the value. A word that reads a full PIX marks its result as added or as subtracted.
Every further word inverts its result and exchanges the two. So a full PIX that no exposure depends
on leaves no mark, and a subtracted full PIX, such as the reset level, differs from an added one.
Losses of registers accumulate in the same way."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from nscc_runtime.effects.sensor import Sensor

MARKED = {
    "well": ("well", "PIX was full when a word added what it held"),
    "subtracted": ("well", "PIX was full when a word subtracted what it held"),
    "level": ("level", "PIX was full when a word read the level of its reset"),
    "registers": ("registers", "registers lost more than `least_e` of what they were to hold"),
    "codes": ("codes", "the code is the last of the scale"),
}
"""The kinds of marks: the stage that sets each, and its meaning. Each belongs to one effect."""


@dataclass(frozen=True)
class Mark:
    """A bit of `saturated_by` and its name. It is set if more than `least_e` electrons are lost."""

    bit: int
    name: str
    least_e: Callable[[Sensor], float] = lambda _sensor: 0.0
