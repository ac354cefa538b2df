"""Find the registers that words read before they write them."""

from __future__ import annotations

from collections.abc import Iterable

from nscc.chips.target import Target
from nscc.operations import NEIGHBOURS, STEERING, Op, Phase, WordEffect


def live_registers(words: Iterable[Op], target: Target) -> tuple[frozenset[str], frozenset[str]]:
    """Return the registers, including FLAG, that words read before they are written in all pixels,
    and the registers that words write."""
    live: set[str] = set()
    written: set[str] = set()
    whole: set[str] = set()
    everywhere = False
    for op in words:
        effect, phase = op.operation.effect, op.operation.phase
        read = {"NEWS" if name in NEIGHBOURS else name for name in op.sources}
        if effect is WordEffect.DIGITAL_NEIGHBOURS:
            read |= STEERING.keys()
        if not everywhere and (
            effect in (WordEffect.BUS, WordEffect.RESET_PIX)
            or (effect is WordEffect.FLAG_ANALOG and target.where_obeys_flag)
        ):
            read.add("FLAG")
        destinations = {"NEWS" if name in NEIGHBOURS else name for name in op.destinations}
        if effect is WordEffect.RESET_PIX:
            destinations = {"PIX"}
        if effect in (WordEffect.FLAG_ANALOG, WordEffect.FLAG_DIGITAL, WordEffect.FLAG_ALL):
            destinations, everywhere = {"FLAG"}, effect is WordEffect.FLAG_ALL
        partial = destinations & {target.masked_register}
        if effect in (WordEffect.BUS, WordEffect.RESET_PIX) and not everywhere:
            partial = destinations
        if partial and target.masked_register in partial and target.mask_register is not None:
            read.add(target.mask_register)
        if phase is Phase.READ:
            destinations = {"bus"}
        elif phase is Phase.WRITE:
            read.add("bus")
        live |= (read | partial) - whole
        written |= destinations
        whole |= destinations - partial
    return frozenset(live), frozenset(written)
