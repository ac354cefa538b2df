"""The proof of the words before readout: they leave in registers what codes stand for."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

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
    target = container.target
    replay = Replay(replace(container, encoding=container.encoding[:1]), (), lights=1)
    in_e = (preparation.level or 0) * target.electrons_per_step
    own = {each.register for each in container.readouts}
    before = {name: replay.analog[name].copy() for name in own}
    after = replay.prepared(preparation.words, np.full((1, 1), in_e))
    return {name: (float(before[name][0, 0]), float(after[name][0, 0])) for name in own}


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
