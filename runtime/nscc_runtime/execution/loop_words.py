"""Prepare the arguments of the loops over words: words, readouts, numbers and switches."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.effects import Selection
from nscc_runtime.effects.in_loops import figures, switches
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.execution.layout import (
    ACTS,
    SEEN,
    LoopProgram,
    LoopWord,
    Numbers,
    Readouts,
    Switches,
)
from nscc_runtime.noise import RATE_CAP
from nscc_runtime.reference.trace import RunningWord
from nscc_runtime.reference.weights import error_sign
from nscc_runtime.reference.words import readout_waits_s

_WORD = np.dtype(LoopWord)


def program_of(
    container: Container, words: Sequence[RunningWord], starts: Sequence[int]
) -> LoopProgram:
    """Return the words as arrays for loops; `starts`: first slots of the frame's intervals."""
    registers = (*container.target.analog_registers, "PIX", "IN")
    ends, slot_us = [*starts, container.slots], container.slot_us
    start_s = np.concatenate(([0.0], np.cumsum(slot_us)))[ends] * 1e-6
    number = {slot: k for k, slot in enumerate(ends)}
    rows: list[tuple[float, ...]] = []
    operands: list[int] = []
    for word in words:
        last = word.boundary == container.slots
        row = {
            "resets": word.resets,
            "compares": word.compares,
            "reads_pix": "PIX" in word.sources,
            "number": word.number,
            "sources": len(word.sources),
            "destinations": len(word.destinations),
            "operands": len(operands),
            "begins": number[word.boundary],
            "end_us": word.after_us if last else min(word.after_us, slot_us[word.boundary]),
            "time_s": start_s[number[word.boundary]],
            "divisor": word.op.operation.divisor,
            "in_e": word.in_e,
        }
        rows.append(tuple(row[name] for name in _WORD.names or ()))
        operands += [registers.index(name) for name in word.sources + word.destinations]
    signs = [error_sign(name, container) for name in container.target.analog_registers]
    return LoopProgram(np.array(rows, _WORD), np.array(operands, np.int64), np.array(signs))


def readouts_of(container: Container) -> Readouts:
    """Return the register, gain and waiting time of each bucket's readout."""
    of_bucket = {readout.bucket: readout for readout in container.readouts}
    readouts = [of_bucket[bucket] for bucket in container.buckets]
    place = container.target.analog_registers.index
    return Readouts(
        np.array([place(readout.register) for readout in readouts], np.int64),
        np.array([float(readout.gain) for readout in readouts]),
        readout_waits_s(container),
    )


def numbers_of(container: Container, sensor: Sensor, effects: Selection) -> Numbers:
    """Return the parameters of the effects; 0 for effects that are off."""
    mark = effects.marking("registers")
    return Numbers(
        least_lost=mark.least_e(sensor) if mark else 0.0,
        pix_start=sensor.full_well_e,
        register_start=sensor.register_max_e,
        rate_cap=RATE_CAP,
        frame_s=float(np.cumsum(container.slot_us)[-1]) * 1e-6,
        **figures(Numbers, sensor, effects),
    )


def switches_of(container: Container, effects: Selection) -> Switches:
    """Return the switches of the effects."""
    marks = {at: effects.marking(at) for at in ("well", "subtracted", "level", "registers")}
    return Switches(
        registers=len(container.target.analog_registers),
        buckets=len(container.buckets),
        **switches(Switches, effects),
        **{f"{at}_bit": mark.bit if mark else 0 for at, mark in marks.items()},
    )


def turns_of(
    entries: NDArray[Any], acts: NDArray[np.bool_], start: NDArray[np.int64]
) -> tuple[NDArray[np.bool_], NDArray[np.uint8]]:
    """Return a mask (words,) of resets without effect, because PIX is reset again before it is
    read, and the flags of each word: `ACTS` and `SEEN` (the charge before it is read before a
    reset).

    The words of lane l are at start[l] to start[l + 1] - 1. A turn is a word that reads or resets
    PIX."""
    count, end = len(entries), np.repeat(start[1:], np.diff(start))
    resets = acts & entries["resets"].astype(bool)
    turns = resets | acts & entries["reads_pix"].astype(bool)
    turn_index = np.where(turns, np.arange(count), count)
    coming = np.minimum.accumulate(turn_index[::-1])[::-1]
    following = np.append(coming, count)[1:]
    is_reset = (following < end) & np.append(resets, False)[following]
    is_read = (coming < end) & np.append(turns & ~resets, False)[coming]
    return resets & is_reset, np.asarray(ACTS * acts + SEEN * is_read, np.uint8)
