"""Estimate light from a frame whose pixels looked: each pixel's exposure divided by its open time.

The estimate of a pixel uses no decoder and no neighbours. It is the maximum likelihood estimate for
steady light: soft saturation is inverted, gain, leakage and dark charge are corrected with the
sensor's mean values, and the result is divided by the open time. Its standard deviation includes
photon counts, reads, words, converter and unequal pixels. It is infinite where a pixel was full,
because the light is then only a lower bound."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from nscc.arrays import Array, Bools, Floats, Indices, Ints, Ints32
from nscc.words.container import Container
from nscc.words.machine import StateMachine
from nscc_runtime.caches import OfContainer
from nscc_runtime.effects import Selection, Sensor
from nscc_runtime.effects.parts import CountedLight, Soft
from nscc_runtime.frame_file import Frame
from nscc_runtime.looking.paths import Paths, paths_of, start_bits
from nscc_runtime.reference.trace import AnalogWord, retention_us
from nscc_runtime.reference.weights import WeightModel, backward
from nscc_runtime.response import ShutterResponse, converter_e2, gain_spread


@OfContainer
def looked_response(
    container: Container, sensor: Sensor, effects: Selection
) -> tuple[Ints, ShutterResponse] | None:
    """Return the ways in which a frame of pixels that look can end, and the response (ends,
    buckets) of each end; None if the paths of the pixels cannot be followed.

    Ends are int64 (ends, 1 + states): the behaviour number, then the values of the states that are
    read."""
    paths = paths_of(container, retention_us(effects, sensor))
    if isinstance(paths, str):
        return None
    path_by_outcome = _paths_by_outcome(container, paths)
    words = _words(paths, [*path_by_outcome.values()])
    weights = backward(container, words, WeightModel.of(effects, sensor))
    response = ShutterResponse.of_weights(weights, container.slot_s, sensor, effects)
    return np.array([*path_by_outcome], np.int64), response


def _paths_by_outcome(container: Container, paths: Paths) -> dict[tuple[int, ...], list[int]]:
    """Return for each end of a frame, a tuple of the behaviour's number and the values of the
    states that are read, the numbers of the segments in `paths` of one path to it, last segment
    first. Of several paths to an end, the first that is found stands for all."""
    machine = container.machine
    bits = start_bits(container)
    nodes = int(machine.first[1])
    first = paths.begins({name: plane_bits != 0 for name, plane_bits in bits.items()}, (nodes,))
    count = len(next(iter(paths.endings.values()))) if paths.endings else 1
    planes = {name: plane_bits.astype(np.bool_) for name, plane_bits in paths.endings.items()}
    states = [
        container.state_planes[state.name].read(planes, (count,))
        for state in machine.states
        if state.read
    ]
    path_by_outcome: dict[tuple[int, ...], list[int]] = {}
    by_first = {segment: _paths_from(paths, segment) for segment in set(first.tolist())}
    for behaviour, segment in zip(machine.behaviour[:nodes].tolist(), first.tolist(), strict=True):
        for ending, path in by_first[segment].items():
            outcome = (behaviour, *(int(values[ending]) for values in states))
            path_by_outcome.setdefault(outcome, path)
    return path_by_outcome


def _paths_from(paths: Paths, first: int) -> Mapping[int, list[int]]:
    """Return for each ending that can be reached from the segment number `first` the segments of
    one path to it, last segment first. If `first` is -1 - e, the only ending is e, without
    segments."""
    if first < 0:
        return {-1 - first: []}
    before, path_by_ending = {first: -1}, {}
    # Answers lead only to later segments.
    for segment in range(first, len(paths.following)):
        if segment not in before:
            continue
        for leads in paths.following[segment].tolist():
            if leads >= 0:
                before.setdefault(leads, segment)
            elif -1 - leads not in path_by_ending:
                path = [segment]
                while before[path[-1]] >= 0:
                    path.append(before[path[-1]])
                path_by_ending[-1 - leads] = path
    return path_by_ending


def _words(paths: Paths, by_end: list[list[int]]) -> tuple[AnalogWord, ...]:
    """Return the bus and reset words of a frame in order, each with the lanes in which it acts.
    Here lane k is the k-th end, and `by_end` has the segments of its path, in any order."""
    acts = np.zeros((len(paths.words), len(by_end)), np.bool_)
    for end, path in enumerate(by_end):
        for segment in path:
            acts[paths.acting[paths.start[segment] : paths.start[segment + 1]], end] = True
    return tuple(
        AnalogWord(**vars(word), lanes=lanes)
        for word, lanes in zip(paths.words, acts, strict=True)
        if not word.compares
    )


def row_of(rows: Ints, columns: Sequence[NDArray[np.integer]]) -> tuple[Indices, Bools]:
    """Return for each pixel the index of the row of `rows` (R, K) that equals its values in the K
    arrays `columns` of equal shape, and where such a row exists.

    Both results have the shape of these arrays. Of equal rows it is the first; where no row
    matches, the index is that of any row. R and K are at least 1."""
    number = np.zeros(len(rows), np.int64)
    row_number = np.zeros(columns[0].shape, np.int64)
    is_present = np.ones(row_number.shape, np.bool_)
    # After k columns, rows and pixels have a number for their first k values. Numbers are made
    # consecutive for each column, so that products stay small.
    for column, values in zip(rows.T, columns, strict=True):
        low, span = int(column.min()), int(np.ptp(column)) + 1
        known, number = np.unique(number * span + column - low, return_inverse=True)
        is_present &= (values >= low) & (values < low + span)
        combined = row_number * span + values - low
        row_number = np.minimum(np.searchsorted(known, combined), len(known) - 1)
        is_present &= known[row_number] == combined
    first = np.unique(number, return_index=True)[1]
    return first[row_number], is_present


LIGHT, DEVIATION = "light_e_per_s", "light_sd_e_per_s"
"""Keys of light (buckets, rows, cols) in electrons per second, and of its standard deviation."""
OPEN = "open_slots"
"""Key in the frame file: number of slots in which each bucket was open, (buckets, rows, cols)."""


def told_by(
    container: Container,
    planes: Mapping[str, Bools],
    frame: Frame,
    sensor: Sensor,
    effects: Selection,
) -> dict[str, Array]:
    """Return the arrays of a frame file that follow from the digital `planes` of one frame.

    These are `states_NAME` (rows, cols) of the states that are read, `open_slots` (buckets, rows,
    cols), and the light and its standard deviation, `light_e_per_s` and `light_sd_e_per_s`
    (buckets, rows, cols). `planes`: bits (rows, cols) by digital register; those of the states that
    are read are needed. `effects`: those that the simulation had; all for a chip."""
    machine = container.machine
    assert container.pixel_codes is not None
    state_values = {
        state.name: container.state_planes[state.name].read(planes, frame.frame.shape[1:])
        for state in machine.states
        if state.read
    }
    behaviour = container.table.shutter_of_code[container.pixel_codes]
    slots, open_us = open_times(machine, behaviour, state_values)
    outcomes: list[NDArray[np.integer]] = [behaviour, *state_values.values()]
    states = {f"states_{name}": values for name, values in state_values.items()}
    light = light_of(frame, outcomes, open_us, container, sensor, effects)
    return {**states, OPEN: slots, **light}


def open_us_of(container: Container, told_arrays: Mapping[str, Array]) -> Floats:
    """Return the open time of each bucket of a pixel in microseconds, (buckets, rows, cols).

    It follows from `told_arrays`, of which the arrays `states_NAME` (rows, cols) of all states that
    are read are used; -1 where no pixel can end in these states. Raises KeyError if one is
    missing."""
    assert container.pixel_codes is not None
    behaviour = container.table.shutter_of_code[container.pixel_codes]
    prefix = "states_"
    states = {k.removeprefix(prefix): v for k, v in told_arrays.items() if k.startswith(prefix)}
    return open_times(container.machine, behaviour, states)[1]


def open_times(
    machine: StateMachine, behaviour: Ints32, states: Mapping[str, Ints]
) -> tuple[Ints, Floats]:
    """Return the number of open slots and the open time in microseconds, both (buckets, rows,
    cols).

    They follow from the number `behaviour` (rows, cols) of each pixel's behaviour and the values
    (rows, cols) of the states that were read, by name; both are -1 where no pixel can end so."""
    last = machine.nodes(machine.stages - 1)
    read = [k for k, state in enumerate(machine.states) if state.read]
    ends = np.column_stack([machine.behaviour[last], machine.values[last][:, read]])
    pixels: list[NDArray[np.integer]] = [behaviour]
    pixels += [states[machine.states[k].name] for k in read]
    row, is_known = row_of(ends, pixels)
    slots = np.where(is_known[..., None], machine.open_slots[last][row], -1)
    us = np.where(is_known[..., None], machine.open_us[last][row], -1.0)
    return np.moveaxis(slots.astype(np.int64), -1, 0), np.moveaxis(us, -1, 0)


def light_of(
    frame: Frame,
    outcomes: Sequence[NDArray[np.integer]],
    open_us: Floats,
    container: Container,
    sensor: Sensor,
    effects: Selection,
) -> dict[str, Floats]:
    """Return the light and its standard deviation, by key, each (buckets, rows, cols).

    `frame`: one frame. `outcomes` (rows, cols): the behaviour of each pixel and the states that are
    read. `open_us` (buckets, rows, cols): -1 if no pixel can end in these states. `effects`: all
    effects for a chip, or those that the emulator simulated. Both results are NaN for a pixel that
    never opened or whose open time is unknown. The deviation is also NaN where the words that acted
    in a pixel are unknown."""
    codes = frame.frame.astype(np.float64)
    read_e = (codes - sensor.adc_offset_lsb) * sensor.electrons_per_lsb
    open_s = np.where(open_us > 0, open_us, np.nan) * 1e-6
    response = looked_response(container, sensor, effects)
    if response is None:
        deviation = np.where(frame.saturated, np.inf, np.nan)
        return {LIGHT: read_e / open_s, DEVIATION: np.where(np.isnan(open_s), np.nan, deviation)}
    ends, by_end = response
    row, _ = row_of(ends, outcomes)
    seen_s, bias_e, variance_e2 = (
        np.moveaxis(values[row], -1, 0)
        for values in (by_end.seen_s, by_end.bias_e, by_end.variance_e2)
    )
    light = np.full(open_s.shape, np.nan)
    is_seen = ~np.isnan(open_s) & (seen_s > 0)
    np.divide(_unbent(read_e, sensor, effects) - bias_e, seen_s, out=light, where=is_seen)
    electrons = np.maximum(light, 0.0) * open_s
    # In electrons of the whole open time, of which exposures contain the part seen_s / open_s.
    variance_e2 = (variance_e2 + converter_e2(sensor, effects)) * (open_s / seen_s) ** 2
    if effects.find_part(CountedLight) is not None:
        variance_e2 += electrons
    variance_e2 += (gain_spread(sensor, effects) * electrons) ** 2
    deviation = np.where(frame.saturated, np.inf, np.sqrt(variance_e2) / open_s)
    deviation[~is_seen] = np.nan
    return {LIGHT: light, DEVIATION: deviation}


def _unbent(read_e: Floats, sensor: Sensor, effects: Selection) -> Floats:
    """Return the charge before soft saturation of two registers in a row: `read_e`, in electrons of
    any shape, passed through both. Charge in the linear range stays as it is, and the result is at
    most twice the linear range. If registers do not saturate, all charge stays."""
    soft = effects.find_part(Soft)
    if soft is None:
        return read_e
    meant = np.linspace(0.0, 2.0 * soft.linear_e(sensor), 4097)
    register_e = meant
    for _ in range(2):
        register_e = register_e - soft.lost_e(sensor, register_e)
    unbent = np.interp(read_e, register_e, meant)
    return np.where(read_e > soft.linear_e(sensor), unbent, read_e)


def merged_image(light: Floats, deviation: Floats) -> Floats:
    """Return one light (rows, cols) from all buckets, weighted by inverse variance. Where every
    bucket was full or unknown, it is the largest of their values, or 0 if all are NaN.

    `light`, `deviation` (buckets, rows, cols): electrons per second and their standard deviation,
    which is infinite where a pixel was full and NaN where it is unknown."""
    with np.errstate(divide="ignore", invalid="ignore"):
        weight = np.nan_to_num(1.0 / deviation**2, nan=0.0, posinf=0.0)
    known = weight.sum(axis=0)
    mean = (np.nan_to_num(light) * weight).sum(axis=0) / np.where(known > 0, known, 1.0)
    least = np.nan_to_num(np.fmax.reduce(light, axis=0))
    return np.asarray(np.where(known > 0, mean, least))
