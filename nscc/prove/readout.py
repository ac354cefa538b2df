"""The proof of the words before the readout, which make converter codes mean what the target
defines."""

from __future__ import annotations

from dataclasses import replace

from nscc.prove.replay import Replay
from nscc.words.container import Container
from nscc.words.legality import target_fault
from nscc.words.readout import Preparation, converter_of, preparation_of

_TOLERANCE = 1e-9


def readout_fault(container: Container) -> tuple[str, str] | None:
    """Return the first bucket that is not read out as the target defines, and the error; None if
    all are.

    Random values suffice, because the words are linear."""
    preparation = preparation_of(container)
    buckets = {readout.register: readout.bucket for readout in container.readouts}
    for word in preparation.words:
        fault = target_fault(word, container.target)
        if fault is not None:
            return next(iter(buckets.values())), f"the target does not support `{word}`: {fault}"
    contents = _contents_around_readout(container, preparation)
    for register, (before, after) in contents.items():
        if (
            not abs(after - _converter_input_e(container, before))
            <= _TOLERANCE * container.target.full_well_e
        ):
            message = "the converted value does not match the meaning of its codes"
            return buckets[register], message
    return None


def _contents_around_readout(
    container: Container, preparation: Preparation
) -> dict[str, tuple[float, float]]:
    """Return the content in electrons of each register that is read, before and after the words."""
    replay = Replay(replace(container, encoding=container.encoding[:1]), ())
    replay.start_frame()
    registers = [readout.register for readout in container.readouts]
    before = {name: float(replay.analog[name][0, 0]) for name in registers}
    replay.set_in(preparation.level or 0)
    for word in preparation.words:
        replay.run(word)
    return {name: (before[name], float(replay.analog[name][0, 0])) for name in registers}


def _converter_input_e(container: Container, exposure_e: float) -> float:
    """Return the converter input, in electrons, for which the code means `exposure_e`.

    The converter's codes are symmetric around an empty register."""
    target = converter_of(container)
    own_e = 2 * target.full_well_e / ((1 << target.adc_bits) - 1)
    middle = (1 << (target.adc_bits - 1)) if target.conversion == "full" else 0.0
    if target.conversion == "spread":
        middle = target.full_well_e / own_e
    code = exposure_e / target.electrons_per_lsb + target.zero_lsb - target.adc_offset_lsb
    return (code - middle) * own_e
