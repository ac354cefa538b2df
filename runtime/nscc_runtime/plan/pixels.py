"""Single pixels of a frame, each run through all of its words: exact, and dear.

`Pixels` lays a program, a sensor and a choice of effects out as `nscc_runtime.plan.pixel_loop`
takes them. With the same effects it gives what `nscc_runtime.reference` gives, to rounding.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import CannotHave, Effect, InLoop, Selection, registered
from nscc_runtime.effects.counts import LIGHT, THINNED, WITHOUT_LIGHT
from nscc_runtime.effects.parts import CountedDark, CountedLight, Errors, Moving
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.light import Light
from nscc_runtime.noise import RATE_CAP, key
from nscc_runtime.noise.keys import base
from nscc_runtime.plan.layout import ENTRY_COLUMNS, MOST_DESTINATIONS, Entry, Key, Number, Size
from nscc_runtime.plan.pool import in_parts
from nscc_runtime.reference.capture import DESTINATIONS, START, Reference
from nscc_runtime.reference.noise import PART, SUM
from nscc_runtime.reference.trace import AnalogWord

_DRAWN = ("reads", "resets", "words")
"""Small errors, in the order of the loop."""
_SITES = 5
_MOST_KEPT = 1 << 23
"""Bytes a thread may keep of neighbours' charge."""
_FEWEST = 64
"""Pixels that are worth a thread."""


@dataclass(frozen=True, eq=False)
class Pixels:
    """A program's words by lane, for the loop; see `nscc_runtime.plan.pixel_loop.run_pixels`."""

    program: Reference
    entry_start: NDArray[np.int64]
    entries: NDArray[np.int64]
    times: NDArray[np.float64]
    weights: NDArray[np.float64]
    groups: NDArray[np.int32]
    group_ids: NDArray[np.uint64]

    @classmethod
    def of(cls, program: Reference) -> Pixels:
        """Lay out the words of a program made ready for the reference."""
        container = program.container
        lanes, buckets = len(container.encoding), len(container.buckets)
        acts = np.array([word.lanes for word in program.words]).reshape(-1, lanes)
        draws = np.zeros((len(program.words), 1 + MOST_DESTINATIONS, lanes, buckets))
        for at in _DRAWN:
            for number, weight in program.draws[at].items():
                if at == "words":
                    draws[number // DESTINATIONS, 1 + number % DESTINATIONS] = weight
                else:
                    draws[number, 0] = weight
        needed = acts | draws.any(axis=(1, 3))
        lane, word = np.nonzero(needed.T)
        rows = np.array([_row(each, program) for each in program.words], np.int64)
        entries = rows.reshape(-1, ENTRY_COLUMNS)[word]
        entries[:, Entry.ACTS] = acts[word, lane]
        times = np.array([_times(each, program) for each in program.words]).reshape(-1, 2)
        ids, groups = np.unique(program.groups.of_slot, return_inverse=True)
        return cls(
            program,
            np.searchsorted(lane, np.arange(lanes + 1)).astype(np.int64),
            np.ascontiguousarray(entries),
            np.ascontiguousarray(times[word]),
            np.ascontiguousarray(draws[word, :, lane]),
            groups.reshape(program.groups.of_slot.shape).astype(np.int32),
            ids.astype(np.uint64),
        )

    def exposures(
        self,
        light: Light,
        slot_s: NDArray[np.float64],
        chosen: NDArray[np.int64],
        effects: Selection,
        *,
        seed: int = 0,
        device_seed: int = 0,
        frame: int = 0,
        threads: int = 1,
    ) -> NDArray[np.float64]:
        """Electrons (buckets, pixels) at the places `chosen` = row * cols + col.

        The frame before was the same scene. Threads and the order of places change no bit.
        ValueError for effects that the loop cannot have.
        """
        program = self.program
        source = (effects.part(Moving) and light.motion) or light
        present = np.zeros((len(self.groups), len(self.group_ids)), np.uint8)
        np.put_along_axis(present, self.groups.astype(np.intp), 1, axis=1)
        slow = [e.name for e in effects.effects if isinstance(e.words, CannotHave)]
        if slow:
            raise ValueError(f"the loop over words cannot have {', '.join(slow)}")
        container = program.container
        names = (*container.target.analog_registers, "PIX")
        signs = np.array([-1.0 if n == container.target.analog_scratch else 1.0 for n in names])
        readouts = {readout.bucket: readout for readout in container.readouts}
        order = {readout.bucket: i for i, readout in enumerate(container.readouts)}
        waited_s = container.target.readout_us * 1e-6
        fixed = (
            _numbers(program.sensor, effects),
            _keys(seed, device_seed),
        )
        scene = (
            np.require(program.groups.lane, np.int32, ["C"]),
            np.require(source.frames, np.float32, ["C", "A"]),
            np.require(source.row_start, np.int64, ["C", "A"]),
            np.require(source.frame_index, np.int32, ["C", "A"]),
            np.require(source.weight, np.float64, ["C", "A"]),
            np.require(slot_s, np.float64, ["C", "A"]),
            np.concatenate(([0.0], np.cumsum(slot_s))),
            self.groups,
            present,
            self.group_ids,
            self.entry_start,
            self.entries,
            self.times,
            self.weights,
            signs,
            np.array([names.index(readouts[b].register) for b in container.buckets], np.int64),
            np.array([(readouts[b].gain, order[b] * waited_s) for b in container.buckets]),
        )
        switches = _switches(effects)
        chosen = np.require(chosen, np.int64, ["C", "A"])

        def run(part: NDArray[np.int64]) -> NDArray[np.float64]:
            sizes = self._sizes(len(part), light, frame, switches)
            scratch = _scratch(sizes)
            out = np.empty((len(container.buckets), len(part)))
            arrays = (sizes, *fixed, part, *scene, *scratch, out)
            entry_point()(*(array.ctypes.data for array in arrays))
            return out

        out = np.empty((len(container.buckets), len(chosen)))

        def fill(begin: int, end: int) -> None:
            out[:, begin:end] = run(chosen[begin:end])

        in_parts(fill, len(chosen), threads, _FEWEST)
        return out

    def _sizes(
        self, count: int, light: Light, frame: int, switches: Sequence[tuple[Size, int]]
    ) -> NDArray[np.int64]:
        container = self.program.container
        sizes = np.zeros(len(Size), np.int64)
        sizes[Size.PIXELS] = count
        sizes[Size.SLOTS] = container.slots
        sizes[Size.ROWS], sizes[Size.COLS] = light.shape
        sizes[Size.BUCKETS] = len(container.buckets)
        sizes[Size.GROUPS] = len(self.group_ids)
        sizes[Size.REGISTERS] = len(container.target.analog_registers)
        sizes[Size.WHOLE] = 1 << (container.slots - 1).bit_length()
        sizes[Size.FRAME] = frame
        for size, value in switches:
            sizes[size] = value
        cols, each = int(sizes[Size.COLS]), _kept_bytes(sizes)
        sizes[Size.KEPT_COLS] = cols if 3 * cols * each <= _MOST_KEPT else min(3, cols)
        return sizes


def entry_point() -> Callable[..., None]:
    """`run_pixels` as machine code."""
    from nscc_runtime.plan.compiled import entry_points

    return entry_points()["run_pixels"]


def _row(word: AnalogWord, program: Reference) -> list[int]:
    """The columns of a word, as it is where it acts."""
    names = (*program.container.target.analog_registers, "PIX", "reset level", "IN")
    row = [0] * ENTRY_COLUMNS
    row[Entry.BOUNDARY], row[Entry.RESETS] = word.boundary, int(word.resets)
    row[Entry.NUMBER] = word.number
    if not word.resets:
        row[Entry.READS_PIX] = int("PIX" in word.op.sources)
        row[Entry.SOURCES], row[Entry.DESTINATIONS] = (
            len(word.op.sources),
            len(word.op.destinations),
        )
        for i, name in enumerate(word.op.sources):
            row[Entry.FIRST_SOURCE + i] = names.index(name)
        for i, name in enumerate(word.op.destinations):
            row[Entry.FIRST_DESTINATION + i] = names.index(name)
    return row


def _times(word: AnalogWord, program: Reference) -> tuple[float, float]:
    """When a word ends, in parts of the slot, and its divisor."""
    container = program.container
    last = word.boundary == container.slots
    end = word.after_us / container.slot_us[min(word.boundary, container.slots - 1)]
    return end if last else min(end, 1.0), float(word.op.operation.divisor)


def _numbers(sensor: Sensor, effects: Selection) -> NDArray[np.float64]:
    """The figures of the effects that are on; those of the others are not read, or 0."""
    values = np.zeros(len(Number))
    values[Number.FULL_WELL] = sensor.full_well_e
    values[Number.REGISTER_MAX] = sensor.register_max_e
    values[Number.RATE_CAP] = RATE_CAP
    for _, loop in _in_loop(effects.effects):
        for name, figure in loop.numbers.items():
            values[Number[name]] = figure(sensor)
    return values


def _keys(seed: int, device_seed: int) -> NDArray[np.uint64]:
    """Keys of the device, and those that a frame's follow from, whether effects are on or not."""
    values = np.zeros(Key.PART + len(_DRAWN), np.uint64)
    values[Key.START] = base(device_seed, START)
    for effect, loop in _in_loop(registered()):
        if loop.device_key is not None:
            values[Key[loop.device_key]] = key(device_seed, effect.stream)
        for kind, source in ((CountedLight, LIGHT), (CountedDark, WITHOUT_LIGHT)):
            if effect.parts(kind):
                values[Key.COUNT + source] = base(seed, effect.stream, source)
                values[Key.THIN + source] = base(seed, effect.stream, THINNED + source)
        for part in effect.parts(Errors):
            values[Key.SUM + _DRAWN.index(part.at)] = base(seed, effect.stream, SUM)
            values[Key.PART + _DRAWN.index(part.at)] = base(seed, effect.stream, PART)
    return values


def _switches(effects: Selection) -> list[tuple[Size, int]]:
    loops = (loop for _, loop in _in_loop(effects.effects))
    return [(Size[loop.switch], 1) for loop in loops if loop.switch is not None]


def _in_loop(effects: Iterable[Effect]) -> Iterator[tuple[Effect, InLoop]]:
    """Those that the loop has."""
    for effect in effects:
        if isinstance(effect.words, InLoop):
            yield effect, effect.words


def _kept_bytes(sizes: NDArray[np.int64]) -> int:
    """What the charge of one site takes: rates, counts and their stamps, of light and dark."""
    room = 2 * int(sizes[Size.WHOLE]) * int(sizes[Size.GROUPS])
    return 16 * (int(sizes[Size.SLOTS]) + 2 * room)


def _scratch(sizes: NDArray[np.int64]) -> tuple[NDArray[np.generic], ...]:
    slots, room = int(sizes[Size.SLOTS]), 2 * int(sizes[Size.WHOLE]) * int(sizes[Size.GROUPS])
    sites = 3 * int(sizes[Size.KEPT_COLS]) if sizes[Size.CROSSTALK] else 1
    return (
        np.empty(2 * sites * slots),
        np.empty(2 * sites * room),
        np.full(2 * sites * room, -1, np.int64),
        np.full(sites, -1, np.int64),
        np.empty(len(_DRAWN) * int(sizes[Size.BUCKETS])),
        np.empty(int(sizes[Size.REGISTERS]) + 3),
        np.empty(_SITES, np.int64),
    )
