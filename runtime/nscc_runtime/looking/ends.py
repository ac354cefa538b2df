"""The possible ends of a frame of a pixel that looks, and a path of words to each end."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.container_cache import OfContainer
from nscc_runtime.effects import Selection
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.looking.paths import Paths, paths_of, start_bits
from nscc_runtime.reference.trace import AnalogWord, retention_us
from nscc_runtime.reference.weights import WeightModel, backward
from nscc_runtime.response import ShutterResponse


@dataclass(frozen=True, eq=False)
class Ends:
    """The ways in which a frame of a pixel can end.

    `outcomes` int64 (ends, 1 + states): the behaviour number, then the values of the states that
    are read. `words`: the bus and reset words of one path to each end; their lanes are the ends."""

    outcomes: NDArray[np.int64]
    words: tuple[AnalogWord, ...]


@OfContainer
def looked_response(
    container: Container, sensor: Sensor, effects: Selection
) -> tuple[Ends, ShutterResponse] | None:
    """Return the ends of a program whose pixels look, and the response (ends, buckets) of each end;
    None if the paths of its pixels cannot be followed."""
    paths = paths_of(container, retention_us(effects, sensor))
    if isinstance(paths, str):
        return None
    ends = ends_of(container, paths)
    weights = backward(container, ends.words, WeightModel.of(effects, sensor))
    return ends, ShutterResponse.of_weights(weights, container.slot_s, sensor, effects)


def ends_of(container: Container, paths: Paths) -> Ends:
    """Return all ends of a program's frames."""
    machine = container.machine
    assert machine is not None
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
    return Ends(np.array([*path_by_outcome], np.int64), _words(paths, [*path_by_outcome.values()]))


def _paths_from(paths: Paths, first: int) -> Mapping[int, list[int]]:
    """Return for each ending that `first` leads to the segments of one path, last segment first."""
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
    """Return the bus and reset words of a frame; lanes are the ends whose paths contain them."""
    acts = np.zeros((len(paths.words), len(by_end)), np.bool_)
    for end, path in enumerate(by_end):
        for segment in path:
            acts[paths.acting[paths.start[segment] : paths.start[segment + 1]], end] = True
    return tuple(
        AnalogWord.of(word, lanes)
        for word, lanes in zip(paths.words, acts, strict=True)
        if not word.compares
    )


def row_of(
    rows: NDArray[np.int64], columns: Sequence[NDArray[np.integer]]
) -> tuple[NDArray[np.intp], NDArray[np.bool_]]:
    """Return the index of the row of `rows` (R, K) that equals the values of K arrays, and where it
    exists.

    Both results have the shape of the arrays; the index is arbitrary where no row matches."""
    number = np.zeros(len(rows), np.int64)
    row_number = np.zeros(columns[0].shape, np.int64)
    is_present = np.ones(row_number.shape, np.bool_)
    for column, values in zip(rows.T, columns, strict=True):
        low, span = int(column.min()), int(np.ptp(column)) + 1
        known, number = np.unique(number * span + column - low, return_inverse=True)
        is_present &= (values >= low) & (values < low + span)
        combined = row_number * span + values - low
        row_number = np.minimum(np.searchsorted(known, combined), len(known) - 1)
        is_present &= known[row_number] == combined
    first = np.unique(number, return_index=True)[1]
    return first[row_number], is_present
