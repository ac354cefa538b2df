"""Run single pixels of a frame through all of their words: exact, and slow.

The classes prepare the arguments of `nscc_runtime.execution.pixel_loop`. With the same effects the
results equal those of `nscc_runtime.reference`, except for rounding."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import CannotHave, Effect, Selection, registered
from nscc_runtime.effects.in_loops import device_keys, switches
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
from nscc_runtime.effects.views import LIGHT, THINNED, WITHOUT_LIGHT
from nscc_runtime.execution.charge_loop import SITES, Away, CountScratch, Sites
from nscc_runtime.execution.layout import (
    Keys,
    LoopProgram,
    Numbers,
    OnDevice,
    PixelState,
    Sizes,
)
from nscc_runtime.execution.loop_words import (
    numbers_of,
    program_of,
    readouts_of,
    switches_of,
    turns_of,
)
from nscc_runtime.execution.pixel_loop import run_pixels
from nscc_runtime.execution.site_loop import Laying, Times, needed_places, sites_of
from nscc_runtime.execution.word_loop import ERRORS, ErrorScratch, Lanes
from nscc_runtime.light import Light
from nscc_runtime.noise import key
from nscc_runtime.noise.keys import base
from nscc_runtime.pool import in_parts
from nscc_runtime.reference.capture import PART, SUM, Reference
from nscc_runtime.reference.words import START, most_destinations

_MOST_KEPT = 1 << 23
"""Largest number of bytes of neighbours' counts that a thread stores."""
_MOST_LIGHT = 1 << 26
"""Largest number of bytes of light, slot by slot, that is stored from frame to frame."""
_FEWEST = 64
"""Smallest number of pixels per thread."""
_MOST_KEYS = 16
"""Number of seeds whose keys are cached."""


@dataclass(frozen=True, eq=False)
class LaneWords:
    """The words of a program by lane, for `nscc_runtime.execution.pixel_loop.run_pixels`. `groups`
    (lanes, N): the group of each slot. `group_ids`: the numbers of the groups in random keys."""

    reference: Reference
    program: LoopProgram
    lanes: Lanes
    groups: NDArray[np.int32]
    group_ids: NDArray[np.uint64]

    @classmethod
    def of(cls, reference: Reference) -> LaneWords:
        """Prepare the words of a reference's program for the loop."""
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
        unread, _ = turns_of(program.words[word], acts[word, lane], _starts(lane, lanes))
        needed_places = ~unread | drawn[word, lane]
        lane, word = lane[needed_places], word[needed_places]
        start = _starts(lane, lanes)
        # For long frames these arrays are among the largest of planning, so free each one early.
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
            flags=turns_of(program.words[word], acts[word, lane], start)[1],
            weights=weights,
        )
        return cls(reference, program, listed, groups, ids.astype(np.uint64))

    @cached_property
    def times(self) -> Times:
        """The slots of the program by lane."""
        return Times(self.groups, len(self.group_ids), self.reference.container.slot_s)

    @cached_property
    def numbers(self) -> int:
        """The highest word number plus one."""
        return int(self.program.words["number"].max(initial=0)) + 1

    @cached_property
    def stale(self) -> bool:
        """Whether words read registers that were not written in the same frame."""
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
        """Largest number of words of a lane."""
        return int(np.diff(self.lanes.start).max(initial=0))


@dataclass(frozen=True, eq=False)
class KnownCounts:
    """Known counts of `groups` of slots: deviations `away` (groups, pixels) from their means."""

    groups: tuple[int, ...]
    away: NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Wired:
    """The words of a program under some effects on one chip, bound to the loop, for any scene.
    Raises ValueError for effects that the loop does not support."""

    words: LaneWords
    effects: Selection
    device_seed: int

    def __post_init__(self) -> None:
        slow = [e.name for e in self.effects.effects if isinstance(e.words, CannotHave)]
        if slow:
            raise ValueError(f"the loop over words cannot have {', '.join(slow)}")

    @cached_property
    def numbers(self) -> Numbers:
        """The parameters of the effects; 0 for effects that are off."""
        reference = self.words.reference
        return numbers_of(reference.container, reference.sensor, self.effects)

    def laid_out(self, light: Light, places: NDArray[np.int64], threads: int) -> Sites:
        """Return the light of the pixels at `places`, prepared for the loop."""
        return sites_of(
            light, places, self.words.lanes.of_pixel, self.words.times, self.numbers, self._device,
            switches(Laying, self.effects), threads,
        )  # fmt: skip

    @cached_property
    def _device(self) -> OnDevice:
        return OnDevice(**device_keys(OnDevice, self.device_seed))

    @cached_property
    def arguments(self) -> dict[str, Any]:
        """The arguments of `run_pixels` that do not depend on the scene."""
        words, container = self.words, self.words.reference.container
        start_groups = range(1 + len(container.target.analog_registers))
        start_keys = [key(self.device_seed, START, group=group) for group in start_groups]
        return {
            "switches": switches_of(container, self.effects),
            "numbers": self.numbers,
            "device": self._device,
            "slot_us": np.array(container.slot_us, np.float64),
            "group_ids": words.group_ids,
            "start_keys": np.array(start_keys, np.uint64),
            "lanes": words.lanes,
            "program": words.program,
            "readouts": readouts_of(container),
        }

    def sizes(self, pixels: int, frame: int, counts_known: bool) -> Sizes:
        """Return the sizes for exposing `pixels` pixels of frame number `frame`."""
        common, cols = self._sizes, self.words.lanes.of_pixel.shape[1]
        if pixels <= cols:
            # A few pixels rarely share neighbours.
            common = common | {"kept_cols": min(3, cols)}
        return Sizes(pixels=pixels, frame=frame, counts_known=counts_known, **common)

    @cached_property
    def _sizes(self) -> dict[str, int]:
        words = self.words
        container = words.reference.container
        rows, cols = words.lanes.of_pixel.shape
        groups = len(words.group_ids)
        padded_slots = 1 << (container.slots - 1).bit_length()
        # Counts of a site and their stamps, for light and dark charge.
        site_bytes = 16 * groups * 2 * 2 * padded_slots
        return {
            "slots": container.slots,
            "rows": rows,
            "cols": cols,
            "groups": groups,
            "draws": words.lanes.weights.shape[1],
            "numbered": most_destinations(container.target),
            "words": words.numbers,
            "stale": words.stale,
            "padded_slots": padded_slots,
            "kept_cols": cols if 3 * cols * site_bytes <= _MOST_KEPT else min(3, cols),
            **switches(Sizes, self.effects),
        }

    def scratch(self, sizes: Sizes) -> dict[str, Any]:
        """Allocate working memory for the loop."""
        container = self.words.reference.container
        groups, room = sizes.groups, 2 * sizes.padded_slots * sizes.groups
        counts = bool(self.effects.names(Counted))
        sites = 3 * sizes.kept_cols if sizes.exchanges and counts and not sizes.counts_known else 1
        buckets = len(container.buckets)
        most = self.words.most_words * sizes.draws
        return {
            "counts": CountScratch(
                streams=np.empty(4 * groups, np.uint64),
                heap=np.empty(2 * sites * room),
                stamps=np.full(2 * sites * room, -1, np.int64),
                places=np.empty(SITES, np.int64),
            ),
            "errors": ErrorScratch(
                streams=np.zeros(ERRORS * (buckets + sizes.words * sizes.numbered), np.uint64),
                missing=np.empty(buckets),
                drawn=np.empty(most),
                draws=np.empty(most, np.int64),
                keys=np.empty(most, np.uint64),
                normals=np.empty(most),
            ),
            "state": PixelState.of(len(container.target.analog_registers), 1),
        }


@dataclass(frozen=True, eq=False)
class Running:
    """Pixels of a scene that run through their words.

    `chosen`: places of the pixels (row * cols + col). At most `_MOST_LIGHT` bytes of their light
    are stored; larger light is prepared again for every frame, in slices. Results do not depend on
    `threads` or on the order of places."""

    wired: Wired
    light: Light
    chosen: NDArray[np.int64]
    threads: int

    def expose(
        self, seed: int, frame: int, known_counts: KnownCounts | None = None
    ) -> tuple[NDArray[np.float64], NDArray[np.uint8]]:
        """Return exposures (buckets, pixels) of a frame in electrons, and their saturation marks.

        `known_counts`: counts of neighbours, split between slots in proportion to light. If None,
        counts are drawn and halved, as in the reference."""
        wired, words = self.wired, self.wired.words
        shape = len(words.reference.container.buckets), len(self.chosen)
        out, marked = np.empty(shape), np.empty(shape, np.uint8)
        names = () if known_counts is None else known_counts.groups
        of_group = [names.index(i) if i in names else -1 for i in words.group_ids.tolist()]
        common: dict[str, Any] = {
            "keys": _keys(registered(), seed),
            "away": Away(
                np.array(of_group, np.int64),
                np.zeros(1) if known_counts is None else known_counts.away,
            ),
        }
        for pixel_slice in self._pixel_slices:
            sites = (
                self._all_sites
                if len(self._pixel_slices) == 1
                else self.wired.laid_out(self._source, self._needed(pixel_slice), self.threads)
            )

            def fill(
                begin: int, end: int, first: int = pixel_slice.start, sites: Sites = sites
            ) -> None:
                begin, end = first + begin, first + end
                sizes = wired.sizes(end - begin, frame, known_counts is not None)
                exposure = np.empty((shape[0], end - begin))
                bits = np.empty(exposure.shape, np.uint8)
                run_pixels(
                    **wired.arguments, sizes=sizes, chosen=self.chosen[begin:end], sites=sites,
                    out=exposure, marked=bits, **common, **wired.scratch(sizes),
                )  # fmt: skip
                out[:, begin:end], marked[:, begin:end] = exposure, bits

            in_parts(fill, pixel_slice.stop - pixel_slice.start, self.threads, _FEWEST)
        return out, marked

    @cached_property
    def _source(self) -> Light:
        return (self.wired.effects.find_part(Moving) and self.light.motion) or self.light

    @cached_property
    def _places(self) -> NDArray[np.int64]:
        """Places whose charge is needed: chosen pixels and, with crosstalk, their neighbours."""
        return self._needed(slice(None))

    def _needed(self, pixel_slice: slice) -> NDArray[np.int64]:
        beside = self.wired.effects.find_part(Exchange) is not None
        return needed_places(self.chosen[pixel_slice], self.light.shape, beside)

    @cached_property
    def _pixel_slices(self) -> list[slice]:
        """Slices of the chosen pixels whose light is prepared together."""
        words = self.wired.words
        slots, groups = words.reference.container.slots, len(words.group_ids)
        tables = sites = len(self._places)
        if self._source.even:
            tables = min(sites, len(words.lanes.start))
        bytes_, count = 16 * tables * groups * (slots + 1), len(self.chosen)
        slice_pixels = max(1, count // max(1, -(-bytes_ // _MOST_LIGHT)))
        return [
            slice(first, min(first + slice_pixels, count))
            for first in range(0, count, slice_pixels)
        ]

    @cached_property
    def _all_sites(self) -> Sites:
        return self.wired.laid_out(self._source, self._places, self.threads)


def _starts(lane: NDArray[np.int64], lanes: int) -> NDArray[np.int64]:
    """Return the first index of each lane in the sorted `lane`, followed by its length."""
    return np.searchsorted(lane, np.arange(lanes + 1)).astype(np.int64)


@lru_cache(_MOST_KEYS)
def _keys(effects: tuple[Effect, ...], seed: int) -> Keys:
    """Return the first halves of the random keys of all `effects`."""
    keys_by_name = {}
    for effect in effects:
        for kind, source, name in (
            (CountedLight, LIGHT, "light"), (CountedDark, WITHOUT_LIGHT, "dark"),
        ):  # fmt: skip
            if effect.parts_of_kind(kind):
                keys_by_name[f"count_{name}"] = base(seed, effect.stream, source)
                keys_by_name[f"thin_{name}"] = base(seed, effect.stream, THINNED + source)
        for error_part in effect.parts_of_kind(SmallErrors):
            keys_by_name[f"sum_{error_part.at}"] = base(seed, effect.stream, SUM)
            keys_by_name[f"part_{error_part.at}"] = base(seed, effect.stream, PART)
    return Keys(**keys_by_name)
