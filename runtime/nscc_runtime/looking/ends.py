"""How pixels that look can end a frame, and the words that brought each of these ends about."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.effects import Selection
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.looking.paths import Paths, paths_of, start_bits
from nscc_runtime.ready import OfContainer
from nscc_runtime.reference.trace import AnalogWord, retention_us
from nscc_runtime.reference.weights import Model, backward
from nscc_runtime.response import ShutterResponse


@dataclass(frozen=True, eq=False)
class Ends:
    """The ends of a program's frames as a pixel tells them: int64 (ends, 1 + states) `told`, its
    behaviour and the states that are read; and the bus and reset `words` of one path that leads to
    each, whose lanes are the ends."""

    told: NDArray[np.int64]
    words: tuple[AnalogWord, ...]


def _looked_response(
    container: Container, sensor: Sensor, effects: Selection
) -> tuple[Ends, ShutterResponse] | None:
    paths = paths_of(container, retention_us(effects, sensor))
    if isinstance(paths, str):
        return None
    ends = ends_of(container, paths)
    weights = backward(container, ends.words, Model.of(effects, sensor))
    return ends, ShutterResponse.of_weights(weights, container.slot_s, sensor, effects)


looked_response = OfContainer(_looked_response)
"""The ends of a program whose pixels look, and the response (ends, buckets) of each, by (container,
sensor, effects); None where the paths of its pixels cannot be followed."""


def ends_of(container: Container, paths: Paths) -> Ends:
    """All ends of a program's frames."""
    machine = container.machine
    assert machine is not None
    bits = start_bits(container)
    nodes = int(machine.first[1])
    first = paths.begins({name: each != 0 for name, each in bits.items()}, (nodes,))
    count = len(next(iter(paths.endings.values()))) if paths.endings else 1
    planes = {name: each.astype(np.bool_) for name, each in paths.endings.items()}
    states = [
        container.state_planes[state.name].read(planes, (count,))
        for state in machine.states
        if state.read
    ]
    found: dict[tuple[int, ...], list[int]] = {}
    by_first = {segment: _paths_from(paths, segment) for segment in set(first.tolist())}
    for behaviour, segment in zip(machine.behaviour[:nodes].tolist(), first.tolist(), strict=True):
        for ending, path in by_first[segment].items():
            told = (behaviour, *(int(values[ending]) for values in states))
            found.setdefault(told, path)
    return Ends(np.array([*found], np.int64), _words(paths, [*found.values()]))


def _paths_from(paths: Paths, first: int) -> Mapping[int, list[int]]:
    """The segments of one path from a segment to each ending that it leads to."""
    if first < 0:
        return {-1 - first: []}
    before, found = {first: -1}, {}
    # Answers lead to later segments only.
    for segment in range(first, len(paths.following)):
        if segment not in before:
            continue
        for leads in paths.following[segment].tolist():
            if leads >= 0:
                before.setdefault(leads, segment)
            elif -1 - leads not in found:
                path = [segment]
                while before[path[-1]] >= 0:
                    path.append(before[path[-1]])
                found[-1 - leads] = path
    return found


def _words(paths: Paths, by_end: list[list[int]]) -> tuple[AnalogWord, ...]:
    """The bus and reset words of a frame, with the ends whose paths run through them."""
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
