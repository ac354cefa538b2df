"""What runs before registers are read out, so that codes mean what the target says.

A converter that is symmetric around 0 gives an exposure, which is never negative, half of its
codes. As far as a register is free, 2 x exposure - full well is read out instead: all codes for
nothing up to a full well. IN supplies the full well.
"""

from __future__ import annotations

from dataclasses import dataclass

from nscc.emit.cpp.kernels import calls_words
from nscc.emit.cpp.text import Call
from nscc.words.container import Container


@dataclass(frozen=True)
class Preparation:
    """The calls of one kernel, and the steps of IN that it needs; None: it reads none."""

    calls: tuple[Call, ...]
    level: int | None

    @property
    def words(self) -> int:
        """How many words it has."""
        return calls_words(self.calls)


def preparation_of(container: Container) -> Preparation:
    """What comes before the readout of a container's registers."""
    target = container.target
    # Pixels that FLAG leaves out would be left out of readout.
    everywhere: Call = ("all", ())
    own = [readout.register for readout in container.readouts]
    free = [name for name in target.analog_available if name not in own]
    scaled = any(readout.gain != 1 for readout in container.readouts)
    if target.spread_level is None or not free or scaled:
        return Preparation((everywhere,), None)
    calls = [everywhere]
    scratch, copy = target.analog_scratch, free[-1]
    for register in own:
        calls += [
            ("bus", (scratch, register)),
            ("bus", (copy, scratch)),
            ("bus", (scratch, register, copy, "IN")),
            ("bus", (register, scratch)),
        ]
    return Preparation(tuple(calls), target.spread_level)
