"""Words before the readout, which make converter codes mean what the target defines.

A converter that is symmetric around 0 would use only half of its codes for an exposure x >= 0. If a
register is free, 2 x - w is converted instead, with the full well w, so that all codes are used.
This takes three words with IN = -w. Two compute w - x in the scratch register and in the free
register; the third adds both to IN and inverts the sum."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from nscc.chips.target import Target
from nscc.operations import Op, op
from nscc.record import Record
from nscc.words.container import Container

SPREADING_ERRORS = 3 / 4
"""The variance that these words add to an exposure, relative to the variance of one word's error.

Three words each add an error to twice the exposure, so the variance is 3 / 4."""


class Preparation(Record):
    """The words before the readout.

    `level` is the value of IN (the level sent to all pixels), in steps, that they need; None if
    they do not read IN."""

    words: tuple[Op, ...]
    level: int | None


def preparation_of(container: Container) -> Preparation:
    """Return the words that run before the readout.

    They set FLAG (the bit that lets a pixel act) in all pixels. If the chip spreads exposures, an
    analog register is free, and buckets are read out, they also spread the exposures over all
    converter codes."""
    target = container.target
    copy = free_register(target, _read(container))
    # Readout would skip pixels without FLAG.
    everywhere = op("all")
    if target.spread_level is None or copy is None:
        return Preparation((everywhere,), level=None)
    registers = converted_buckets(container)
    if not registers:
        return Preparation((everywhere,), level=None)
    words = (word for register in registers for word in spreading(target, register, copy))
    return Preparation((everywhere, *words), target.spread_level)


def converted_buckets(container: Container) -> dict[str, str]:
    """Return the names of the buckets that the converter reads, by their registers; {} if only
    images are read out.

    Exposures that only images use are not converted, and other values may be in their registers."""
    registers = {readout.bucket: readout.register for readout in container.readouts}
    registers |= container.pictures.registers
    return {registers[name]: name for name in container.buckets_read}


def spreading(target: Target, register: str, copy: str) -> tuple[Op, Op, Op]:
    """Return three words that replace the exposure x in `register` by 2 x minus a full well.

    They overwrite the register `copy` and the scratch register, and need IN (the level sent to all
    pixels) at minus a full well."""
    scratch = target.analog_scratch
    return (
        op("bus", [copy], [register, "IN"]),
        op("bus", [scratch], [register, "IN"]),
        op("bus", [register], [scratch, copy, "IN"]),
    )


def converter_of(container: Container) -> Target:
    """Return the container's target with the conversion that is used for its readout.

    It is the target itself or, if it would spread exposures but no register is free for that, one
    with `readout` "full"."""
    return converter_of_registers(container.target, _read(container))


def converter_of_registers(target: Target, read: Iterable[str]) -> Target:
    """Return the target with the conversion that is used if the registers `read` are read out.

    It is the target itself or, if it would spread exposures but no register is free for that, one
    with `readout` "full"."""
    if target.spread_level is None or free_register(target, read) is not None:
        return target
    return replace(target, readout="full")


def _read(container: Container) -> Iterable[str]:
    """Return the registers that are read out after the frame.

    These are all registers of images, planes and states or, without these, those of the exposures.
    """
    return container.pictures.registers.values() or [each.register for each in container.readouts]


def free_register(target: Target, read: Iterable[str]) -> str | None:
    """Return the last analog register, except the scratch register, that is not in `read`, the
    registers that are read out; None if there is none."""
    unavailable = {*read}
    free = [name for name in target.analog_available if name not in unavailable]
    return free[-1] if free else None
