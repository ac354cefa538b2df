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
from nscc_runtime.effects.in_loops import switches
from nscc_runtime.effects.parts import (
    Counted,
    CountedDark,
    CountedLight,
    Exchange,
    Moving,
)
from nscc_runtime.effects.parts import (
    Errors as SmallErrors,
)
from nscc_runtime.execution.charge_loop import SITES, Away, Counts, Sites
from nscc_runtime.execution.entries import (
    Turns,
    device_of,
    numbers_of,
    program_of,
    readouts_of,
    switches_of,
)
from nscc_runtime.execution.error_loop import ERRORS, Errors, Lanes
from nscc_runtime.execution.layout import (
    Fixed,
    Held,
    Keys,
    Numbers,
    OnDevice,
    Program,
    Result,
    Sizes,
)
from nscc_runtime.execution.pixel_loop import run_pixels
from nscc_runtime.execution.site_loop import Laying
from nscc_runtime.execution.sites import Times, needed, sites_of
from nscc_runtime.light import Light
from nscc_runtime.loop import Bound
from nscc_runtime.noise import key
from nscc_runtime.noise.keys import base
from nscc_runtime.pool import in_parts
from nscc_runtime.reference.capture import Reference
from nscc_runtime.reference.noise import PART, SUM
from nscc_runtime.reference.words import START, most_destinations

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
    """A program's words by lane, for `nscc_runtime.execution.pixel_loop.run_pixels`; the `groups`
    (lanes, N) of its slots, and what keys call these."""

    reference: Reference
    program: Program
    lanes: Lanes
    groups: NDArray[np.int32]
    group_ids: NDArray[np.uint64]

    @classmethod
    def of(cls, reference: Reference) -> Pixels:
        """Lay out the words of a program made ready for the reference."""
        container = reference.container
        lanes, buckets = len(container.encoding), len(container.buckets)
        acts = np.array([word.lanes for word in reference.words]).reshape(-1, lanes)
        numbered = most_destinations(container.target)
        most = max((len(word.op.destinations) for word in reference.words), default=0)
        draws = np.zeros((len(reference.words), 1 + most, lanes, buckets))
        for at, numbered_draws in reference.draws.items():
            for number, weight in numbered_draws.items():
                if at == "words":
                    draws[number // numbered, 1 + number % numbered] = weight
                else:
                    draws[number, 0] = weight
        drawn = np.asarray(draws.any(axis=(1, 3)))
        lane, word = np.nonzero((acts | drawn).T)
        program = program_of(container, reference.words, range(container.slots))
        turns = Turns(program.words[word], acts[word, lane], _starts(lane, lanes))
        needed = ~turns.unread | drawn[word, lane]
        lane, word = lane[needed], word[needed]
        start = _starts(lane, lanes)
        # Of long frames each of these is among the largest that planning has: one at a time.
        weights = np.ascontiguousarray(draws[word, :, lane])
        del draws
        of_slot = reference.groups.of_slot
        ids, groups = np.unique(of_slot), np.empty(of_slot.shape, np.int32)
        for number, group in enumerate(ids.tolist()):
            groups[of_slot == group] = number
        listed = Lanes(
            of_pixel=np.require(reference.groups.lane, np.int32, ["C"]),
            start=start,
            word=word.astype(np.int32),
            flags=Turns(program.words[word], acts[word, lane], start).flags,
            weights=weights,
        )
        return cls(reference, program, listed, groups, ids.astype(np.uint64))

    @cached_property
    def times(self) -> Times:
        """Its slots by lane."""
        return Times(self.groups, len(self.group_ids), self.reference.container.slot_s)

    @cached_property
    def numbers(self) -> int:
        """One more than the highest number of a word."""
        return int(self.program.words["number"].max(initial=0)) + 1

    @cached_property
    def stale(self) -> bool:
        """Whether words read what registers held when the frame began."""
        container = self.reference.container
        nowhere = np.zeros(len(container.encoding), np.bool_)
        written = dict.fromkeys((*container.target.analog_registers, "PIX"), nowhere)
        written["IN"] = ~nowhere
        for word in self.reference.words:
            if any((word.lanes & ~written[name]).any() for name in word.sources):
                return True
            for name in ("PIX",) if word.resets else word.destinations:
                written[name] = written[name] | word.lanes
        return not all(written[readout.register].all() for readout in container.readouts)

    @cached_property
    def most_words(self) -> int:
        """The most words of a lane."""
        return int(np.diff(self.lanes.start).max(initial=0))


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
    effects: Selection
    device_seed: int

    def __post_init__(self) -> None:
        slow = [e.name for e in self.effects.effects if isinstance(e.words, CannotHave)]
        if slow:
            raise ValueError(f"the loop over words cannot have {', '.join(slow)}")

    @cached_property
    def numbers(self) -> Numbers:
        """The figures of the effects; 0 of those that are off."""
        reference = self.words.reference
        return numbers_of(reference.container, reference.sensor, self.effects)

    def laid_out(self, light: Light, places: NDArray[np.int64], threads: int) -> Sites:
        """The light of places."""
        return sites_of(
            light, places, self.words.lanes.of_pixel, self.words.times, self.numbers, self._device,
            switches(Laying, self.effects), threads,
        )  # fmt: skip

    @cached_property
    def _device(self) -> OnDevice:
        return device_of(self.device_seed)

    @cached_property
    def loop(self) -> Bound:
        """The loop, with all that scenes have in common."""
        words, container = self.words, self.words.reference.container
        return run_pixels.bound(
            switches=switches_of(container, self.effects),
            numbers=self.numbers,
            device=self._device,
            slot_us=np.array(container.slot_us, np.float64),
            group_ids=words.group_ids,
            start_keys=np.array(
                [
                    key(self.device_seed, START, group=group)
                    for group in range(1 + len(container.target.analog_registers))
                ],
                np.uint64,
            ),
            lanes=words.lanes,
            program=words.program,
            readouts=readouts_of(container),
        )

    def sizes(self, pixels: int, frame: int, given: bool) -> Sizes:
        """Of so many pixels of a frame."""
        common, cols = self._sizes, self.words.lanes.of_pixel.shape[1]
        if pixels <= cols:
            # So few seldom have neighbours in common.
            common = common | {"kept_cols": min(3, cols)}
        return Sizes(pixels=pixels, frame=frame, given=given, **common)

    @cached_property
    def _sizes(self) -> dict[str, int]:
        """Everything of `Sizes` but what frames decide."""
        words = self.words
        container = words.reference.container
        rows, cols = words.lanes.of_pixel.shape
        groups = len(words.group_ids)
        whole = 1 << (container.slots - 1).bit_length()
        # Counts of a site and their stamps, of light and dark.
        each = 16 * groups * 2 * 2 * whole
        return {
            "slots": container.slots,
            "rows": rows,
            "cols": cols,
            "groups": groups,
            "draws": words.lanes.weights.shape[1],
            "numbered": most_destinations(container.target),
            "words": words.numbers,
            "stale": words.stale,
            "whole": whole,
            "kept_cols": cols if 3 * cols * each <= _MOST_KEPT else min(3, cols),
            **switches(Sizes, self.effects),
        }

    def scratch(self, sizes: Sizes) -> dict[str, Any]:
        """What the loop wants beside what it is given."""
        container = self.words.reference.container
        groups, room = sizes.groups, 2 * sizes.whole * sizes.groups
        counts = bool(self.effects.names(Counted))
        sites = 3 * sizes.kept_cols if sizes.exchanges and counts and not sizes.given else 1
        buckets = len(container.buckets)
        most = self.words.most_words * sizes.draws
        return {
            "counts": Counts(
                streams=np.empty(4 * groups, np.uint64),
                heap=np.empty(2 * sites * room),
                stamps=np.full(2 * sites * room, -1, np.int64),
                places=np.empty(SITES, np.int64),
            ),
            "errors": Errors(
                found=np.zeros(ERRORS * (buckets + sizes.words * sizes.numbered), np.uint64),
                missing=np.empty(buckets),
                drawn=np.empty(most),
                draws=np.empty(most, np.int64),
                keys=np.empty(most, np.uint64),
                normals=np.empty(most),
            ),
            "fixed": Fixed.of(1),
            "held": Held.of(len(container.target.analog_registers), 1),
            "result": Result.of(1),
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
        shape = len(words.reference.container.buckets), len(self.chosen)
        out, marked = np.empty(shape), np.empty(shape, np.uint8)
        names = () if given is None else given.groups
        of_group = [names.index(i) if i in names else -1 for i in words.group_ids.tolist()]
        common: dict[str, Any] = {
            "keys": _keys(registered(), seed),
            "away": Away(
                np.array(of_group, np.int64), np.zeros(1) if given is None else given.away
            ),
        }
        for part in self._parts:
            sites = self._sites(part)

            def fill(begin: int, end: int, first: int = part.start, sites: Sites = sites) -> None:
                begin, end = first + begin, first + end
                sizes = wired.sizes(end - begin, frame, given is not None)
                exposure = np.empty((shape[0], end - begin))
                bits = np.empty(exposure.shape, np.uint8)
                wired.loop(
                    sizes=sizes, chosen=self._chosen[begin:end], sites=sites,
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
        slots, groups = words.reference.container.slots, len(words.group_ids)
        tables = sites = len(self._places)
        if self._source.even:
            tables = min(sites, len(words.lanes.start))
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
def _keys(effects: tuple[Effect, ...], seed: int) -> Keys:
    """Keys that a frame's follow from, of all `effects` that there are."""
    found = {}
    for effect in effects:
        for kind, source, name in (
            (CountedLight, LIGHT, "light"), (CountedDark, WITHOUT_LIGHT, "dark"),
        ):  # fmt: skip
            if effect.parts(kind):
                found[f"count_{name}"] = base(seed, effect.stream, source)
                found[f"thin_{name}"] = base(seed, effect.stream, THINNED + source)
        for part in effect.parts(SmallErrors):
            found[f"sum_{part.at}"] = base(seed, effect.stream, SUM)
            found[f"part_{part.at}"] = base(seed, effect.stream, PART)
    return Keys(**found)
