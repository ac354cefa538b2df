"""The analog words of a program and the codes in which each acts, found by replaying digital words.

A lane is a row of the container's encoding: all pixels with that code run the same words. Undefined
bits (registers that no word wrote, SELECT) read 0 here; the compiler's proof finds programs that
depend on them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import inf

import numpy as np

from nscc.arrays import Bools, Floats
from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.operations import Op, WordEffect
from nscc.words.container import Container
from nscc.words.cost import word_us
from nscc.words.legality import decoded
from nscc_runtime.caches import OfContainer
from nscc_runtime.effects import Selection, Sensor
from nscc_runtime.reference.digital import Digital

Bits = Bools

_ANALOG = WordEffect.BUS, WordEffect.RESET_PIX, WordEffect.FLAG_ANALOG


def opens_no_shutters(problem: str) -> Rejected:
    """Return the error NS0442 that the reference cannot simulate sensor effects of a program, for
    the caller to raise. `problem`: what is wrong, a clause that begins the message."""
    return rejected(
        "NS0442",
        f"{problem}, and sensor effects are defined by shutters",
        helps=("use --effects none: the words are executed exactly",),
        status=1,
    )


@dataclass(frozen=True, eq=False)
class RunningWord:
    """A word executed at `boundary`, ending `after_us` microseconds after it.

    `number`: number of the word among the analog words of a frame (bus, reset and compare words),
    from 0; a digital word has the number of the next analog one. `in_e`: value of IN (the level
    sent to all pixels) in electrons while the word runs."""

    number: int
    boundary: int
    after_us: float
    op: Op
    in_e: float

    @property
    def resets(self) -> bool:
        """Whether the word resets PIX (the photodiode)."""
        return self.op.operation.effect is WordEffect.RESET_PIX

    @property
    def compares(self) -> bool:
        """Whether the word compares (`where`)."""
        return self.op.operation.effect is WordEffect.FLAG_ANALOG

    @property
    def sources(self) -> tuple[str, ...]:
        """Names of the analog registers, PIX (the photodiode) and IN (the level sent to all pixels)
        that the word reads; a register that is read twice occurs twice. A reset reads nothing."""
        return () if self.resets else self.op.sources

    @property
    def adds(self) -> bool:
        """Whether the word adds sources; other words move or load a value."""
        return len(self.sources) > 1

    @property
    def destinations(self) -> tuple[str, ...]:
        """Names of the analog registers that the word writes; none for a reset or a comparison."""
        return () if self.resets or self.compares else self.op.destinations


@dataclass(frozen=True, eq=False)
class AnalogWord(RunningWord):
    """A bus or reset word, and the mask `lanes` (lanes,) of the lanes (the pixels of one distinct
    shutter each) in which it acts."""

    lanes: Bits


def running_words(container: Container) -> Iterator[RunningWord]:
    """Yield every word of the exposure of a frame in execution order. Launches at one boundary run
    in their order in the container (a compiled program), one after the other. IN (the level sent to
    all pixels) is 0 e before a launch sets it.

    Raises Rejected for words that are no operations of the chip (`nscc.words.legality.decoded`)."""
    kernels, target, number = decoded(container), container.target, 0
    boundary, after_us, in_e = -1, 0.0, 0.0
    for launch in sorted(container.launches, key=lambda launch: launch.instant):
        if launch.instant != boundary:
            boundary, after_us = launch.instant, 0.0
        if launch.level is not None:
            in_e = launch.level * target.electrons_per_step
        after_us += target.launch_us
        for op in kernels[launch.kernel]:
            after_us += word_us(op, target)
            yield RunningWord(number, boundary, after_us, op, in_e)
            number += op.operation.effect in _ANALOG


def retention_us(effects: Selection, sensor: Sensor) -> float:
    """Return how long digital registers of `sensor` keep values, in microseconds: infinite if none
    of the effects lets them decay, the shortest time if several do."""
    return min([kept_us(sensor) for kept_us in effects.at("digital")], default=inf)


def readout_waits_s(container: Container) -> Floats:
    """Return the time in seconds from the end of the exposure to the readout of each bucket,
    (buckets,).

    Readouts happen one after the other, so the first waits 0 s. Also 0 for all buckets of a program
    with images, whose registers the words of images use at once, and for buckets that are not read
    out."""
    if container.pictures.launches:
        return np.zeros(len(container.buckets))
    order = {readout.bucket: i for i, readout in enumerate(container.readouts)}
    readout_us = container.target.readout_us
    return np.array([order.get(b, 0) * readout_us * 1e-6 for b in container.buckets], np.float64)


@OfContainer
def analog_words(container: Container, retention_us: float = inf) -> tuple[AnalogWord, ...]:
    """Return every bus and reset word of a frame in the order of execution, with the lanes in which
    each acts; cached with the container.

    A digital register reads 0 if no word wrote it for more than `retention_us`. Raises Rejected for
    words that are no operations of the chip (`nscc.words.legality.decoded`), and with NS0442 if
    FLAG depends on the light. A lane is the pixels of one distinct shutter. FLAG is the bit that
    lets a pixel act."""
    target, encoding = container.target, container.encoding
    nothing = np.zeros(len(encoding), np.bool_)
    column = {name: i for i, name in enumerate(target.digital_registers)}
    codes = {name: encoding[:, column[name]] for name in container.code_registers}
    pixel = Digital(target, {**dict.fromkeys((*column, "FLAG"), nothing), **codes}, retention_us)
    start_us = np.concatenate(([0.0], np.cumsum(container.slot_us)))
    words: list[AnalogWord] = []
    for word in running_words(container):
        pixel.now_us = float(start_us[word.boundary])
        if word.compares:
            raise opens_no_shutters(
                f"`{word.op}` makes FLAG depend on the light: this program opens no shutters"
            )
        if word.resets or word.op.operation.effect is WordEffect.BUS:
            everywhere = word.resets and target.reset_honours_flag == "no"
            lanes = ~nothing if everywhere else pixel.read("FLAG") == 1
            words.append(AnalogWord(**vars(word), lanes=lanes))
        else:
            pixel.run(word.op)
    return tuple(words)
