"""Light from a frame whose pixels looked: each pixel's exposure over the time that it was open.

No decoder and no neighbour has a part in it. The estimate is that of greatest likelihood for a
steady light: what saturates softly is bent back, gain, leakage and dark charge are taken away as
the sensor's figures have them in the mean, and the rest is divided by the time. Its standard
deviation adds what the same figures say of counts, reads, words, converter and unequal pixels; it
is infinite where a pixel was full, for there the light was at least so much.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc.words.machine import Machine
from nscc_runtime.effects import Selection
from nscc_runtime.effects.parts import (
    CountedDark,
    CountedLight,
    Leak,
    Response,
    Soft,
    WordGain,
)
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.frame_file import Frame

Values = NDArray[np.float64]

LIGHT, DEVIATION = "light_e_per_s", "light_sd_e_per_s"
"""The keys of the frame file: (buckets, rows, cols), electrons a second."""
OPEN = "open_slots"
"""The key of how many slots each bucket was open (buckets, rows, cols)."""

_READS, _WORDS = 2, 3
"""An exposure is PIX less its reset level: each is read once, and three words bring them together,
four where shutters open again."""
_PIXELS = np.arange(4096, dtype=np.int64)
"""Of a chip, for the mean and the spread of what differs from pixel to pixel."""


def told_by(
    container: Container,
    planes: Mapping[str, NDArray[np.bool_]],
    frame: Frame,
    sensor: Sensor,
    effects: Selection,
) -> dict[str, NDArray[Any]]:
    """What a frame file says beside the exposure, from the digital planes that came with one frame:
    `states_NAME` (rows, cols) of the states that are read, `open_slots` (buckets, rows, cols), and
    the light as `light_of` has it."""
    machine = container.machine
    assert machine is not None
    assert container.pixel_codes is not None
    found = {
        state.name: container.state_planes[state.name].read(planes, frame.frame.shape[1:])
        for state in machine.states
        if state.read
    }
    behaviour = container.table.shutter_of_code[container.pixel_codes]
    slots, open_us = open_times(machine, behaviour, found)
    states = {f"states_{name}": each for name, each in found.items()}
    light = light_of(frame, open_us, container, sensor, effects)
    return {**states, OPEN: slots, **light}


def open_us_of(container: Container, told: Mapping[str, NDArray[Any]]) -> Values:
    """How long each bucket of a pixel was open, in microseconds (buckets, rows, cols), from what
    `told_by` says of a frame; -1 where the states are those of no pixel."""
    assert container.machine is not None
    assert container.pixel_codes is not None
    behaviour = container.table.shutter_of_code[container.pixel_codes]
    prefix = "states_"
    states = {k.removeprefix(prefix): v for k, v in told.items() if k.startswith(prefix)}
    return open_times(container.machine, behaviour, states)[1]


def open_times(
    machine: Machine, behaviour: NDArray[np.int32], states: Mapping[str, NDArray[np.int64]]
) -> tuple[NDArray[np.int64], Values]:
    """How many slots each bucket of a pixel was open, and for how many microseconds, (buckets,
    rows, cols), from its behaviour and the states that were read; -1 where no pixel ends so."""
    last = machine.nodes(machine.stages - 1)
    read = [k for k, state in enumerate(machine.states) if state.read]
    ends = np.column_stack([machine.behaviour[last], machine.values[last][:, read]])
    pixels: list[NDArray[np.integer]] = [behaviour]
    pixels += [states[machine.states[k].name] for k in read]
    row, there = _row_of(ends, pixels)
    slots = np.where(there[..., None], machine.open_slots[last][row], -1)
    us = np.where(there[..., None], machine.open_us[last][row], -1.0)
    return np.moveaxis(slots.astype(np.int64), -1, 0), np.moveaxis(us, -1, 0)


def _row_of(
    rows: NDArray[np.int64], columns: Sequence[NDArray[np.integer]]
) -> tuple[NDArray[np.intp], NDArray[np.bool_]]:
    """Which of `rows` (R, K) has the values of these K arrays, element by element, and where there
    is one."""
    number = np.zeros(len(rows), np.int64)
    found = np.zeros(columns[0].shape, np.int64)
    there = np.ones(found.shape, np.bool_)
    for column, values in zip(rows.T, columns, strict=True):
        low, span = int(column.min()), int(np.ptp(column)) + 1
        known, number = np.unique(number * span + column - low, return_inverse=True)
        there &= (values >= low) & (values < low + span)
        wanted = found * span + values - low
        found = np.minimum(np.searchsorted(known, wanted), len(known) - 1)
        there &= known[found] == wanted
    first = np.unique(number, return_index=True)[1]
    return first[found], there


def light_of(
    frame: Frame,
    open_us: Values,
    container: Container,
    sensor: Sensor,
    effects: Selection,
) -> dict[str, Values]:
    """The light and its standard deviation, by key, each (buckets, rows, cols).

    `frame` is one frame, `open_us` (buckets, rows, cols) is -1 where the states are those of no
    pixel. `effects` are those of the chip: all, or what an emulator had on. Of a pixel that never
    opened, or whose time is unknown, both are NaN.
    """
    frame_us = float(sum(container.slot_us))
    step_e = sensor.electrons_per_lsb
    read_e = (frame.frame.astype(np.float64) - sensor.adc_offset_lsb) * step_e
    gain = _gain(container, sensor, effects, open_us, frame_us)
    held_e = _unbent(read_e, sensor, effects) - _offset_e(container, sensor, effects)
    open_s = np.where(open_us > 0, open_us, np.nan) * 1e-6
    dark_e = _dark_e_per_s(sensor, effects) * open_s
    electrons = held_e / gain
    light_e = electrons - dark_e
    variance = variance_e2(np.maximum(electrons, 0.0), gain, sensor, effects)
    deviation = np.where(frame.saturated, np.inf, np.sqrt(variance) / open_s)
    deviation[np.isnan(open_s)] = np.nan
    return {LIGHT: light_e / open_s, DEVIATION: deviation}


def _offset_e(container: Container, sensor: Sensor, effects: Selection) -> float:
    """The mean error of the words of an exposure: three of one copy, of which each adds its own.
    Of four, with the reset level copied twice, they cancel."""
    words = effects.part(WordGain)
    if words is None or container.notes.get("lowering") != "latch":
        return 0.0
    return float(_WORDS * words.mean_e(sensor))


def _gain(
    container: Container, sensor: Sensor, effects: Selection, open_us: Values, frame_us: float
) -> Values:
    """What of the light is left in the exposure."""
    words, leak = effects.part(WordGain), effects.part(Leak)
    gain = np.full(open_us.shape, 1.0 if words is None else words.gain(sensor) ** 2)
    if leak is not None:
        # A copy is made when the shutter closes; a sum is half that old in the mean.
        closed_us = frame_us - np.maximum(open_us, 0.0)
        share = 1.0 if container.notes.get("lowering") == "latch" else 0.5
        readout_us = container.target.readout_us * np.arange(len(open_us))[:, None, None]
        gain *= np.exp(-(share * closed_us + readout_us) * 1e-6 / leak.tau_s(sensor))
    return gain


def _unbent(read_e: Values, sensor: Sensor, effects: Selection) -> Values:
    """What two registers were to hold, one after the other, that saturate softly."""
    soft = effects.part(Soft)
    if soft is None:
        return read_e
    meant = np.linspace(0.0, 2.0 * soft.linear_e(sensor), 4097)
    held = meant
    for _ in range(2):
        held = held - soft.lost_e(sensor, held)
    unbent = np.interp(read_e, held, meant)
    return np.where(read_e > soft.linear_e(sensor), unbent, read_e)


def _dark_e_per_s(sensor: Sensor, effects: Selection) -> float:
    dark = effects.part(CountedDark)
    return 0.0 if dark is None else float(dark.per_s(sensor, 0, _PIXELS).mean())


def variance_e2(electrons: Values, gain: Values, sensor: Sensor, effects: Selection) -> Values:
    """Of the estimate, in square electrons on PIX."""
    found = np.full(electrons.shape, sensor.electrons_per_lsb**2 / 12.0)
    found += (effects.converter_lsb(sensor) * sensor.electrons_per_lsb) ** 2
    times = {"reads": _READS, "words": _WORDS, "resets": 0}
    for _, errors in effects.errors():
        found += times[errors.at] * errors.sigma_e(sensor) ** 2
    found /= gain**2
    if effects.part(CountedLight) is not None:
        found += electrons
    response = effects.part(Response)
    if response is not None:
        found += (float(response.factor(sensor, 0, _PIXELS).std()) * electrons) ** 2
    return found


def merged_image(light: Values, deviation: Values) -> Values:
    """One light (rows, cols) of all buckets, each weighted by what it knows; where every one was
    full, the greatest."""
    with np.errstate(divide="ignore", invalid="ignore"):
        weight = np.nan_to_num(1.0 / deviation**2, nan=0.0, posinf=0.0)
    known = weight.sum(axis=0)
    mean = (np.nan_to_num(light) * weight).sum(axis=0) / np.where(known > 0, known, 1.0)
    least = np.nan_to_num(np.fmax.reduce(light, axis=0))
    return np.asarray(np.where(known > 0, mean, least))
