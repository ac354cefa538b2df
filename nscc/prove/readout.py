"""The proof of the words before readout: they leave in registers what codes stand for."""

from __future__ import annotations

from dataclasses import replace

from nscc.prove.replay import Replay
from nscc.words.container import Container
from nscc.words.legality import target_fault
from nscc.words.readout import Preparation, converter_of, preparation_of

_TOLERANCE = 1e-9


def readout_fault(container: Container) -> tuple[str, str] | None:
    """The bucket whose register is not read out as the target promises, and what is wrong; None
    where all are.

    Random values stand for all exposures, as words on them are linear.
    """
    preparation = preparation_of(container)
    buckets = {readout.register: readout.bucket for readout in container.readouts}
    for word in preparation.words:
        fault = target_fault(word, container.target)
        if fault is not None:
            return next(iter(buckets.values())), f"the target does not take `{word}`: {fault}"
    found = _left(container, preparation)
    for register, (before, after) in found.items():
        if not abs(after - _wanted(container, before)) <= _TOLERANCE * container.target.full_well_e:
            what = "what is converted differs from what its codes stand for"
            return buckets[register], what
    return None


def _left(container: Container, preparation: Preparation) -> dict[str, tuple[float, float]]:
    """What is in each register that is read out, before the words and after them, in electrons."""
    replay = Replay(replace(container, encoding=container.encoding[:1]), ())
    replay.start_frame()
    registers = [readout.register for readout in container.readouts]
    before = {name: float(replay.analog[name][0, 0]) for name in registers}
    replay.set_in(preparation.level or 0)
    for word in preparation.words:
        replay.run(word)
    return {name: (before[name], float(replay.analog[name][0, 0])) for name in registers}


def _wanted(container: Container, exposure_e: float) -> float:
    """What the converter, whose codes are symmetric around a register that holds nothing, has to
    be given so that the code says `exposure_e`."""
    target = converter_of(container)
    own_e = 2 * target.full_well_e / ((1 << target.adc_bits) - 1)
    middle = (1 << (target.adc_bits - 1)) if target.conversion == "full" else 0.0
    if target.conversion == "spread":
        middle = target.full_well_e / own_e
    code = exposure_e / target.electrons_per_lsb + target.zero_lsb - target.adc_offset_lsb
    return (code - middle) * own_e
