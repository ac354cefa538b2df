"""Single pixels of a frame, each run through all of its words: exact, and dear.

`Pixels` lays a program, a sensor and a choice of effects out as `nscc_runtime.planner.pixel_loop`
takes them. With the same effects it gives what `nscc_runtime.reference` gives, to rounding.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import CannotHave, Selection, registered
from nscc_runtime.effects.counts import LIGHT, THINNED, WITHOUT_LIGHT
from nscc_runtime.effects.in_loops import device_keys, figures, switches
from nscc_runtime.effects.parts import CountedDark, CountedLight, Errors, Moving
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.light import Light
from nscc_runtime.noise import RATE_CAP
from nscc_runtime.noise.keys import base
from nscc_runtime.planner.charge_loop import SITES
from nscc_runtime.planner.layout import Entry, Keys, Numbers, Sizes
from nscc_runtime.planner.pixel_loop import ERRORS, run_pixels
from nscc_runtime.pool import in_parts
from nscc_runtime.reference.capture import START, Reference, most_destinations
from nscc_runtime.reference.noise import PART, SUM

_ENTRY = np.dtype(Entry)
_MOST_KEPT = 1 << 23
"""Bytes a thread may keep of neighbours' charge."""
_FEWEST = 64
"""Pixels that are worth a thread."""


@dataclass(frozen=True, eq=False)
class Pixels:
    """A program's words by lane, for the loop; see `nscc_runtime.planner.pixel_loop.run_pixels`."""

    program: Reference
    entry_start: NDArray[np.int64]
    entries: NDArray[Any]
    operands: NDArray[np.int64]
    weights: NDArray[np.float64]
    groups: NDArray[np.int32]
    group_ids: NDArray[np.uint64]

    @classmethod
    def of(cls, program: Reference) -> Pixels:
        """Lay out the words of a program made ready for the reference."""
        container = program.container
        lanes, buckets = len(container.encoding), len(container.buckets)
        acts = np.array([word.lanes for word in program.words]).reshape(-1, lanes)
        numbered = most_destinations(container.target)
        most = max((len(word.op.destinations) for word in program.words), default=0)
        draws = np.zeros((len(program.words), 1 + most, lanes, buckets))
        for at, drawn in program.draws.items():
            for number, weight in drawn.items():
                if at == "words":
                    draws[number // numbered, 1 + number % numbered] = weight
                else:
                    draws[number, 0] = weight
        needed = acts | draws.any(axis=(1, 3))
        lane, word = np.nonzero(needed.T)
        rows, operands = _entries(program)
        entries = rows[word]
        entries["acts"] = acts[word, lane]
        entry_start = np.searchsorted(lane, np.arange(lanes + 1)).astype(np.int64)
        entries["seen"] = _seen(entries, entry_start)
        ids, groups = np.unique(program.groups.of_slot, return_inverse=True)
        return cls(
            program,
            entry_start,
            entries,
            operands,
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
    ) -> tuple[NDArray[np.float64], NDArray[np.uint8]]:
        """Electrons (buckets, pixels) at the places `chosen` = row * cols + col, and what cut them
        off (`nscc_runtime.effects.marks`).

        The frame before was the same scene. Threads and the order of places change no bit.
        ValueError for effects that the loop cannot have.
        """
        slow = [e.name for e in effects.effects if isinstance(e.words, CannotHave)]
        if slow:
            raise ValueError(f"the loop over words cannot have {', '.join(slow)}")
        program = self.program
        source = (effects.part(Moving) and light.motion) or light
        container = program.container
        names = (*container.target.analog_registers, "PIX")
        signs = np.array([-1.0 if n == container.target.analog_scratch else 1.0 for n in names])
        readouts = {readout.bucket: readout for readout in container.readouts}
        order = {readout.bucket: i for i, readout in enumerate(container.readouts)}
        waited_s = container.target.readout_us * 1e-6
        chosen = np.require(chosen, np.int64, ["C", "A"])
        bound = run_pixels.bound(
            numbers=_numbers(program.sensor, effects),
            keys=_keys(seed, device_seed),
            lanes=np.require(program.groups.lane, np.int32, ["C"]),
            frames=np.require(source.frames, np.float32, ["C", "A"]),
            row_start=np.require(source.row_start, np.int64, ["C", "A"]),
            frame_index=np.require(source.frame_index, np.int32, ["C", "A"]),
            weight=np.require(source.weight, np.float64, ["C", "A"]),
            slot_s=np.require(slot_s, np.float64, ["C", "A"]),
            start_s=np.concatenate(([0.0], np.cumsum(slot_s))),
            groups=self.groups,
            group_ids=self.group_ids,
            entry_start=self.entry_start,
            entries=self.entries,
            operands=self.operands,
            weights=self.weights,
            signs=signs,
            readout_register=np.array(
                [names.index(readouts[b].register) for b in container.buckets], np.int64
            ),
            readout_gain=np.array([float(readouts[b].gain) for b in container.buckets]),
            readout_wait_s=np.array([order[b] * waited_s for b in container.buckets], np.float64),
        )

        out = np.empty((len(container.buckets), len(chosen)))
        marked = np.empty(out.shape, np.uint8)

        def fill(begin: int, end: int) -> None:
            sizes = self._sizes(end - begin, light, frame, effects)
            part = np.empty((len(container.buckets), end - begin))
            bits = np.empty(part.shape, np.uint8)
            bound(
                sizes=sizes, chosen=chosen[begin:end], out=part, marked=bits, **self._scratch(sizes)
            )
            out[:, begin:end], marked[:, begin:end] = part, bits

        in_parts(fill, len(chosen), threads, _FEWEST)
        return out, marked

    def _sizes(self, count: int, light: Light, frame: int, effects: Selection) -> Sizes:
        container = self.program.container
        rows, cols = light.shape
        groups = len(self.group_ids)
        whole = 1 << (container.slots - 1).bit_length()
        # What a site's charge takes: sums of rates, counts and their stamps, of light and dark.
        each = 16 * groups * (container.slots + 1 + 2 * 2 * whole)
        marks = {at: effects.marking(at) for at in ("well", "subtracted", "level", "registers")}
        return Sizes(
            pixels=count,
            slots=container.slots,
            rows=rows,
            cols=cols,
            buckets=len(container.buckets),
            groups=groups,
            registers=len(container.target.analog_registers),
            draws=self.weights.shape[1],
            numbered=most_destinations(container.target),
            whole=whole,
            kept_cols=cols if 3 * cols * each <= _MOST_KEPT else min(3, cols),
            frame=frame,
            **switches(Sizes, effects),
            **{f"{at}_bit": mark.bit if mark else 0 for at, mark in marks.items()},
        )

    def _scratch(self, sizes: Sizes) -> dict[str, NDArray[Any]]:
        slots, groups, room = sizes.slots, sizes.groups, 2 * sizes.whole * sizes.groups
        sites = 3 * sizes.kept_cols if sizes.exchanges else 1
        return {
            "sums": np.empty(2 * sites * groups * (slots + 1)),
            "streams": np.empty(4 * groups, np.uint64),
            "heap": np.empty(2 * sites * room),
            "stamps": np.full(2 * sites * room, -1, np.int64),
            "tags": np.full(sites, -1, np.int64),
            "missing": np.empty(ERRORS * sizes.buckets),
            "drawn": np.empty(int(np.diff(self.entry_start).max(initial=0)) * sizes.draws),
            "registers": np.empty(sizes.registers + 3),
            "full": np.empty(sizes.registers + 3, np.int64),
            "lost": np.empty(sizes.registers + 3),
            "places": np.empty(SITES, np.int64),
        }


def _entries(program: Reference) -> tuple[NDArray[Any], NDArray[np.int64]]:
    """The words as they are where they act, and the registers of all of them."""
    container = program.container
    names = (*container.target.analog_registers, "PIX", "reset level", "IN")
    rows: list[tuple[float, ...]] = []
    operands: list[int] = []
    for word in program.words:
        sources, destinations = word.op.sources, word.op.destinations
        if word.resets:
            sources = destinations = ()
        last = word.boundary == container.slots
        end = word.after_us / container.slot_us[min(word.boundary, container.slots - 1)]
        entry = {
            "boundary": word.boundary,
            "resets": word.resets,
            "number": word.number,
            "reads_pix": "PIX" in sources,
            "sources": len(sources),
            "destinations": len(destinations),
            "operands": len(operands),
            "end": end if last else min(end, 1.0),
            "divisor": word.op.operation.divisor,
            "acts": True,
            "seen": False,
        }
        rows.append(tuple(entry[name] for name in _ENTRY.names or ()))
        operands += [names.index(name) for name in sources + destinations]
    return np.array(rows, _ENTRY), np.array(operands, np.int64)


def _seen(entries: NDArray[Any], entry_start: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Whether what falls on PIX before each word is read, by it or later, before PIX is reset."""
    count = len(entries)
    turns = entries["acts"].astype(bool) & (entries["resets"] | entries["reads_pix"]).astype(bool)
    # The next word that reads or resets PIX; none of another lane.
    here = np.where(turns, np.arange(count), count)
    next_turn = np.minimum.accumulate(here[::-1])[::-1]
    within = next_turn < np.repeat(entry_start[1:], np.diff(entry_start))
    return np.asarray(within & ~entries["resets"].astype(bool)[np.minimum(next_turn, count - 1)])


def _numbers(sensor: Sensor, effects: Selection) -> Numbers:
    """The figures of the effects; 0 of those that are off."""
    mark = effects.marking("registers")
    return Numbers(
        least_lost=mark.least_e(sensor) if mark else 0.0,
        pix_start=sensor.full_well_e,
        register_start=sensor.register_max_e,
        rate_cap=RATE_CAP,
        **figures(Numbers, sensor, effects),
    )


def _keys(seed: int, device_seed: int) -> Keys:
    """Keys of the device, and those that a frame's follow from, whether effects are on or not."""
    found = {"start": base(device_seed, START), **device_keys(Keys, device_seed)}
    for effect in registered():
        for kind, source, name in (
            (CountedLight, LIGHT, "light"), (CountedDark, WITHOUT_LIGHT, "dark"),
        ):  # fmt: skip
            if effect.parts(kind):
                found[f"count_{name}"] = base(seed, effect.stream, source)
                found[f"thin_{name}"] = base(seed, effect.stream, THINNED + source)
        for part in effect.parts(Errors):
            found[f"sum_{part.at}"] = base(seed, effect.stream, SUM)
            found[f"part_{part.at}"] = base(seed, effect.stream, PART)
    return Keys(**found)
