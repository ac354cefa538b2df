"""The analog words of a program, and in which codes each acts: digital words replayed over codes.

A lane is a row of the container's encoding: all pixels with that code run the same words. What a
pixel leaves open (registers that nobody wrote, SELECT) reads 0 here; the proof is where a program
that hangs on it is found.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import inf

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected
from nscc.operations import Effect, Op, Phase
from nscc.words.container import Container
from nscc.words.cost import word_us
from nscc.words.legality import decoded
from nscc_runtime.effects import Selection
from nscc_runtime.effects.sensor import Sensor

Bits = NDArray[np.bool_]


def opens_no_shutters(what: str) -> Rejected:
    """NS0442, for what the reference cannot simulate effects of."""
    return rejected(
        "NS0442",
        f"{what}, but sensor effects are defined for shutters",
        helps=("use --effects none: the words are then executed exactly",),
        status=1,
    )


@dataclass(frozen=True, eq=False)
class AnalogWord:
    """A bus or reset word executed at `boundary`, ending `after_us` after it.

    `number` counts the analog words of a frame; `lanes` bool (lanes,): where it acts.
    """

    number: int
    boundary: int
    after_us: float
    op: Op
    lanes: Bits

    @property
    def resets(self) -> bool:
        """Whether it resets PIX; else it is a bus word."""
        return self.op.operation.effect is Effect.RESET_PIX


def retention_us(effects: Selection, sensor: Sensor) -> float:
    """For how long digital registers keep their values, in microseconds; infinite where no effect
    takes them away."""
    return min([kept_us(sensor) for kept_us in effects.at("digital")], default=inf)


def analog_words(container: Container, retention_us: float = inf) -> tuple[AnalogWord, ...]:
    """Every bus and reset word of a frame in the order of execution.

    A digital register reads 0 when no word wrote it for more than `retention_us`. Raises Rejected
    as `nscc.words.legality.decoded` does, and NS0442 where FLAG hangs on the light.
    """
    kernels = decoded(container)
    target = container.target
    pixel = _Digital(container, retention_us)
    start_us = np.concatenate(([0.0], np.cumsum(container.slot_us)))
    found: list[AnalogWord] = []
    boundary, after_us = -1, 0.0
    for launch in sorted(container.launches, key=lambda launch: launch.instant):
        if launch.instant != boundary:
            boundary, after_us = launch.instant, 0.0
            pixel.now_us = float(start_us[boundary])
        after_us += target.launch_us
        for op in kernels[launch.kernel]:
            after_us += word_us(op, target)
            effect = op.operation.effect
            if effect in (Effect.BUS, Effect.RESET_PIX):
                everywhere = effect is Effect.RESET_PIX and target.reset_honours_flag == "no"
                lanes = np.ones(pixel.lanes, np.bool_) if everywhere else pixel.read("FLAG")
                found.append(AnalogWord(len(found), boundary, after_us, op, lanes))
            else:
                pixel.run(op)
    return tuple(found)


class _Digital:
    """The digital registers of all lanes."""

    def __init__(self, container: Container, retention_us: float) -> None:
        target = container.target
        self.lanes = len(container.encoding)
        self.mask, self.masked = target.mask_register, target.masked_register
        self.retention_us = retention_us
        self.now_us = 0.0
        names = (*target.digital_registers, "FLAG", "SELECT")
        self.bits = {name: np.zeros(self.lanes, np.bool_) for name in names}
        column = {name: i for i, name in enumerate(target.digital_registers)}
        for name in container.code_registers:
            self.bits[name] = container.encoding[:, column[name]].copy()
        self.written_us = {name: np.zeros(self.lanes) for name in names}
        self.bus = np.zeros(self.lanes, np.bool_)

    def read(self, name: str) -> Bits:
        """The bit of each lane, 0 where it has decayed."""
        fresh = self.now_us - self.written_us[name] <= self.retention_us
        return np.asarray(self.bits[name] & fresh)

    def run(self, op: Op) -> None:
        """One word that is neither a bus word nor a reset."""
        row = op.operation
        everywhere = np.ones(self.lanes, np.bool_)
        match row.effect:
            case Effect.NONE | Effect.BUS | Effect.RESET_PIX:
                return
            case Effect.FLAG_ALL:
                self._write("FLAG", everywhere, everywhere)
            case Effect.FLAG_ANALOG:
                raise opens_no_shutters(
                    f"`{op}` makes FLAG depend on the light: this program does not "
                    "implement shutters"
                )
            case Effect.FLAG_DIGITAL:
                self._write("FLAG", self._some(op), everywhere)
            case Effect.DIGITAL:
                self._digital(op, everywhere)

    def _digital(self, op: Op, everywhere: Bits) -> None:
        row = op.operation
        if row.phase is not Phase.WRITE:
            self.bus = self._some(op) ^ row.inverted
        if row.phase is not Phase.READ:
            # What guards the masked register is the mask as it was before this word.
            guard = everywhere if self.mask is None else self.read(self.mask)
            for name in op.destinations:
                self._write(name, self.bus, guard if name == self.masked else everywhere)

    def _some(self, op: Op) -> Bits:
        some = np.zeros(self.lanes, np.bool_)
        for name in op.sources:
            some |= self.read(name)
        return some

    def _write(self, name: str, value: Bits, where: Bits) -> None:
        self.bits[name] = np.where(where, value, self.bits[name])
        self.written_us[name] = np.where(where, self.now_us, self.written_us[name])
