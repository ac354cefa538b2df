"""Single pixels of a frame, each run through all of its words: exact, and dear.

`Pixels` lays a program, a sensor and a choice of effects out as `nscc_runtime.execution.pixel_loop`
takes them. With the same effects it gives what `nscc_runtime.reference` gives, to rounding.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import CannotHave, Effect, Selection, registered
from nscc_runtime.effects.counts import LIGHT, THINNED, WITHOUT_LIGHT
from nscc_runtime.effects.in_loops import device_keys, figures, switches
from nscc_runtime.effects.parts import (
    Counted,
    CountedDark,
    CountedLight,
    Errors,
    Exchange,
    Moving,
)
from nscc_runtime.execution.charge_loop import SITES
from nscc_runtime.execution.entries import Turns, entries_of
from nscc_runtime.execution.error_loop import ERRORS
from nscc_runtime.execution.layout import Keys, Numbers, Sizes
from nscc_runtime.execution.pixel_loop import run_pixels
from nscc_runtime.execution.site_loop import Laying
from nscc_runtime.execution.sites import Sites, Times, needed, sites_of
from nscc_runtime.light import Light
from nscc_runtime.loop import Bound
from nscc_runtime.noise import RATE_CAP
from nscc_runtime.noise.keys import base
from nscc_runtime.pool import in_parts
from nscc_runtime.reference.capture import (
    START,
    Reference,
    most_destinations,
    readout_waits_s,
)
from nscc_runtime.reference.noise import PART, SUM

_MOST_KEPT = 1 << 23
"""Bytes a thread may keep of neighbours' counts."""
_MOST_LIGHT = 1 << 26
"""Bytes of light, slot by slot, that are kept from frame to frame."""
_FEWEST = 64
"""Pixels that are worth a thread."""
_MOST_KEYS = 16
"""Seeds whose keys are kept."""


@dataclass(frozen=True, eq=False)
class Pixels:
    """A program's words by lane, for `nscc_runtime.execution.pixel_loop.run_pixels`."""

    program: Reference
    entry_start: NDArray[np.int64]
    entry_of: NDArray[np.int32]
    flags: NDArray[np.uint8]
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
        for at, numbered_draws in program.draws.items():
            for number, weight in numbered_draws.items():
                if at == "words":
                    draws[number // numbered, 1 + number % numbered] = weight
                else:
                    draws[number, 0] = weight
        drawn = np.asarray(draws.any(axis=(1, 3)))
        lane, word = np.nonzero((acts | drawn).T)
        entries, operands = entries_of(program)
        turns = Turns(entries[word], acts[word, lane], _starts(lane, lanes))
        needed = ~turns.unread | drawn[word, lane]
        lane, word = lane[needed], word[needed]
        entry_start = _starts(lane, lanes)
        # Of long frames each of these is among the largest that planning has: one at a time.
        weights = np.ascontiguousarray(draws[word, :, lane])
        del draws
        of_slot = program.groups.of_slot
        ids, groups = np.unique(of_slot), np.empty(of_slot.shape, np.int32)
        for number, group in enumerate(ids.tolist()):
            groups[of_slot == group] = number
        return cls(
            program,
            entry_start,
            np.append(word, 0).astype(np.int32),  # the loop looks at one more
            Turns(entries[word], acts[word, lane], entry_start).flags,
            entries,
            operands,
            weights,
            groups,
            ids.astype(np.uint64),
        )

    @cached_property
    def times(self) -> Times:
        """Its slots by lane."""
        return Times(self.groups, len(self.group_ids), self.program.container.slot_s)

    @cached_property
    def numbers(self) -> int:
        """One more than the highest number of a word."""
        return int(self.entries["number"].max(initial=0)) + 1

    @cached_property
    def most_entries(self) -> int:
        """The most words of a lane."""
        return int(np.diff(self.entry_start).max(initial=0))


@dataclass(frozen=True, eq=False)
class Given:
    """Counts that are drawn already: how far `away` (groups, pixels) from their means, in these
    groups of slots."""

    groups: tuple[int, ...]
    away: NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Wired:
    """A program's words under some effects on one chip, given to the loop: what scenes have in
    common. ValueError for effects that the loop cannot have.
    """

    words: Pixels
    slot_s: NDArray[np.float64]
    effects: Selection
    device_seed: int

    def __post_init__(self) -> None:
        slow = [e.name for e in self.effects.effects if isinstance(e.words, CannotHave)]
        if slow:
            raise ValueError(f"the loop over words cannot have {', '.join(slow)}")

    @cached_property
    def lanes(self) -> NDArray[np.int32]:
        """The lane (rows, cols) of every pixel."""
        return np.require(self.words.program.groups.lane, np.int32, ["C"])

    @cached_property
    def numbers(self) -> Numbers:
        """The figures of the effects; 0 of those that are off."""
        sensor, mark = self.words.program.sensor, self.effects.marking("registers")
        return Numbers(
            least_lost=mark.least_e(sensor) if mark else 0.0,
            pix_start=sensor.full_well_e,
            register_start=sensor.register_max_e,
            rate_cap=RATE_CAP,
            **figures(Numbers, sensor, self.effects),
        )

    def laid_out(self, light: Light, places: NDArray[np.int64], threads: int) -> Sites:
        """The light of places."""
        keys = _keys(registered(), 0, self.device_seed)
        return sites_of(
            light, places, self.lanes, self.words.times, self.numbers, keys, self._laying, threads
        )

    @cached_property
    def _laying(self) -> dict[str, int]:
        return switches(Laying, self.effects)

    @cached_property
    def loop(self) -> Bound:
        """The loop, with all that scenes have in common."""
        words, container = self.words, self.words.program.container
        names = (*container.target.analog_registers, "PIX")
        signs = np.array([-1.0 if n == container.target.analog_scratch else 1.0 for n in names])
        readouts = {readout.bucket: readout for readout in container.readouts}
        return run_pixels.bound(
            numbers=self.numbers,
            lanes=self.lanes,
            start_s=np.concatenate(([0.0], np.cumsum(self.slot_s))),
            group_ids=words.group_ids,
            entry_start=words.entry_start,
            entry_of=words.entry_of,
            flags=words.flags,
            entries=words.entries,
            operands=words.operands,
            weights=words.weights,
            signs=signs,
            readout_register=np.array(
                [names.index(readouts[b].register) for b in container.buckets], np.int64
            ),
            readout_gain=np.array([float(readouts[b].gain) for b in container.buckets]),
            readout_wait_s=readout_waits_s(container),
        )

    def sizes(self, pixels: int, frame: int, given: bool) -> Sizes:
        """Of so many pixels of a frame."""
        common, cols = self._sizes, self.lanes.shape[1]
        if pixels <= cols:
            # So few seldom have neighbours in common.
            common = common | {"kept_cols": min(3, cols)}
        return Sizes(pixels=pixels, frame=frame, given=given, **common)

    @cached_property
    def _sizes(self) -> dict[str, int]:
        """Everything of `Sizes` but what frames decide."""
        words, effects = self.words, self.effects
        container = words.program.container
        rows, cols = self.lanes.shape
        groups = len(words.group_ids)
        whole = 1 << (container.slots - 1).bit_length()
        # Counts of a site and their stamps, of light and dark.
        each = 16 * groups * 2 * 2 * whole
        return {
            "slots": container.slots,
            "rows": rows,
            "cols": cols,
            "buckets": len(container.buckets),
            "groups": groups,
            "registers": len(container.target.analog_registers),
            "draws": words.weights.shape[1],
            "numbered": most_destinations(container.target),
            "words": words.numbers,
            "whole": whole,
            "kept_cols": cols if 3 * cols * each <= _MOST_KEPT else min(3, cols),
            **switches(Sizes, effects),
            **{
                f"{at}_bit": mark.bit if (mark := effects.marking(at)) else 0
                for at in ("well", "subtracted", "level", "registers")
            },
        }

    def scratch(self, sizes: Sizes) -> dict[str, NDArray[Any]]:
        """What the loop wants beside what it is given."""
        groups, room = sizes.groups, 2 * sizes.whole * sizes.groups
        counts = bool(self.effects.names(Counted))
        sites = 3 * sizes.kept_cols if sizes.exchanges and counts and not sizes.given else 1
        keys = ERRORS * (sizes.buckets + sizes.words * sizes.numbered)
        most = self.words.most_entries * sizes.draws
        return {
            "streams": np.empty(4 * groups, np.uint64),
            "found": np.zeros(keys, np.uint64),
            "heap": np.empty(2 * sites * room),
            "stamps": np.full(2 * sites * room, -1, np.int64),
            "missing": np.empty(ERRORS * sizes.buckets),
            "drawn": np.empty(most),
            "draws": np.empty(most, np.int64),
            "draw_keys": np.empty(most, np.uint64),
            "normals": np.empty(most),
            "registers": np.empty(sizes.registers + 3),
            "full": np.empty(sizes.registers + 3, np.int64),
            "lost": np.empty(sizes.registers + 3),
            "places": np.empty(SITES, np.int64),
        }


@dataclass(frozen=True, eq=False)
class Running:
    """Pixels of a scene that run through their words: what its frames have in common.

    `chosen` are their places, row * cols + col. Of their light at most `_MOST_LIGHT` bytes are
    kept: where it takes more, every frame lays it out again, part by part. Threads and the order of
    places change no bit.
    """

    wired: Wired
    light: Light
    chosen: NDArray[np.int64]
    threads: int

    def expose(
        self, seed: int, frame: int, given: Given | None = None
    ) -> tuple[NDArray[np.float64], NDArray[np.uint8]]:
        """Electrons (buckets, pixels) of frame number `frame`, and what cut them off.

        With counts `given`, those of neighbours are these, spread over the slots as their light is;
        else they are drawn, and halved from node to node, as the reference does.
        """
        wired, words = self.wired, self.wired.words
        shape = len(words.program.container.buckets), len(self.chosen)
        out, marked = np.empty(shape), np.empty(shape, np.uint8)
        names = () if given is None else given.groups
        of_group = [names.index(i) if i in names else -1 for i in words.group_ids.tolist()]
        common: dict[str, Any] = {
            "keys": _keys(registered(), seed, wired.device_seed),
            "of_group": np.array(of_group, np.int64),
            "away": np.zeros(1) if given is None else given.away,
        }
        for part in self._parts:
            sites = self._sites(part)

            def fill(begin: int, end: int, first: int = part.start, sites: Sites = sites) -> None:
                begin, end = first + begin, first + end
                sizes = wired.sizes(end - begin, frame, given is not None)
                exposure = np.empty((shape[0], end - begin))
                bits = np.empty(exposure.shape, np.uint8)
                wired.loop(
                    sizes=sizes, chosen=self._chosen[begin:end],
                    sites=sites.number, rows=sites.rows, scales=sites.scales, sums=sites.sums,
                    out=exposure, marked=bits, **common, **wired.scratch(sizes),
                )  # fmt: skip
                out[:, begin:end], marked[:, begin:end] = exposure, bits

            in_parts(fill, part.stop - part.start, self.threads, _FEWEST)
        return out, marked

    @cached_property
    def _chosen(self) -> NDArray[np.int64]:
        return np.require(self.chosen, np.int64, ["C", "A"])

    @cached_property
    def _source(self) -> Light:
        return (self.wired.effects.part(Moving) and self.light.motion) or self.light

    @cached_property
    def _places(self) -> NDArray[np.int64]:
        """The places whose charge matters."""
        return self._needed(slice(None))

    def _needed(self, part: slice) -> NDArray[np.int64]:
        beside = self.wired.effects.part(Exchange) is not None
        return needed(self._chosen[part], self.light.shape, beside)

    @cached_property
    def _parts(self) -> list[slice]:
        """The pixels whose light is laid out together."""
        words = self.wired.words
        slots, groups = words.program.container.slots, len(words.group_ids)
        tables = sites = len(self._places)
        if self._source.even:
            tables = min(sites, len(words.entry_start))
        bytes_, count = 16 * tables * groups * (slots + 1), len(self._chosen)
        each = max(1, count // max(1, -(-bytes_ // _MOST_LIGHT)))
        return [slice(first, min(first + each, count)) for first in range(0, count, each)]

    def _sites(self, part: slice) -> Sites:
        """Their light, laid out."""
        if len(self._parts) == 1:
            return self._kept
        return self.wired.laid_out(self._source, self._needed(part), self.threads)

    @cached_property
    def _kept(self) -> Sites:
        return self.wired.laid_out(self._source, self._places, self.threads)


def _starts(lane: NDArray[np.int64], lanes: int) -> NDArray[np.int64]:
    """Where the words of each lane begin, and the last one's end, in a list of their lanes."""
    return np.searchsorted(lane, np.arange(lanes + 1)).astype(np.int64)


@lru_cache(_MOST_KEYS)
def _keys(effects: tuple[Effect, ...], seed: int, device_seed: int) -> Keys:
    """Keys of the device, and those that a frame's follow from, of all `effects` that there are."""
    found = {"start": base(device_seed, START), **device_keys(Keys, device_seed)}
    for effect in effects:
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
