"""What runs before registers are read out, so that codes mean what the target says.

A converter that is symmetric around 0 gives an exposure x, which is never negative, half of its
codes. As far as a register is free, 2 x - w is converted instead, w a full well: all codes for
nothing up to a full well. Three words make it, all with IN = -w. Two leave w - x, in the scratch
register and in the free one; the third adds both to IN, and what a word adds up it inverts.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from nscc.chips.target import Target
from nscc.operations import Op, op
from nscc.words.container import Container

SPREADING_ERRORS = 3 / 4
"""The variance that these words add to an exposure, in that of one word: three errors, on twice the
exposure."""


@dataclass(frozen=True)
class Preparation:
    """The words of one kernel, and the steps of IN that they need; None: they read none."""

    words: tuple[Op, ...]
    level: int | None


def preparation_of(container: Container) -> Preparation:
    """What comes before the readout of a container's registers."""
    target = container.target
    copy = _free(container)
    # Pixels that FLAG leaves out would be left out of readout.
    everywhere = op("all")
    if target.spread_level is None or copy is None:
        return Preparation((everywhere,), None)
    registers = [readout.register for readout in container.readouts]
    words = (word for register in registers for word in spreading(target, register, copy))
    return Preparation((everywhere, *words), target.spread_level)


def spreading(target: Target, register: str, copy: str) -> tuple[Op, Op, Op]:
    """The words that make a register twice what it holds, less a full well, by way of `copy`."""
    scratch = target.analog_scratch
    return (
        op("bus", [copy], [register, "IN"]),
        op("bus", [scratch], [register, "IN"]),
        op("bus", [register], [scratch, copy, "IN"]),
    )


def converter_of(container: Container) -> Target:
    """The container's target, with the readout that its exposures have: where no register is left
    to spread them with, the converter's own."""
    target = container.target
    if target.readout != "spread" or target.streamed or _free(container) is not None:
        return target
    return replace(target, readout="full")


def _free(container: Container) -> str | None:
    """A register that is not read out."""
    return free_register(container.target, (readout.register for readout in container.readouts))


def free_register(target: Target, read: Iterable[str]) -> str | None:
    """The last register that keeps a value and is not among those that are `read` out; None where
    all are."""
    unavailable = {*read}
    free = [name for name in target.analog_available if name not in unavailable]
    return free[-1] if free else None
