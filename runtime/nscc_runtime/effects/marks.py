"""How a frame tells which of its values lost something to a limit: `saturated_by`, a bit a cause.

What PIX lost goes where its value goes. A word that reads PIX when it is full marks what it writes,
as added or as subtracted, and every further word, whose result is inverted, exchanges the two. So a
full PIX that no exposure depends on marks none, and one that was subtracted, as the reset level is,
can be told from one that was added. What registers lose adds up along the same way.
"""

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
"""What an effect may mark, each with the stage at which it acts. One effect has each."""


@dataclass(frozen=True)
class Mark:
    """A bit of `saturated_by` and its name, of a loss of more than `least_e` electrons."""

    bit: int
    name: str
    least_e: Callable[[Sensor], float] = lambda _sensor: 0.0
