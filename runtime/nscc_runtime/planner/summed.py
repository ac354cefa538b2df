"""Frames by weighted sums: counts drawn and added up, pixel by pixel, and codes made of them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import Selection
from nscc_runtime.effects.counts import LIGHT, count_key
from nscc_runtime.effects.parts import Codes, Converter
from nscc_runtime.frame_file import Frame
from nscc_runtime.noise import RATE_CAP, key
from nscc_runtime.planner.chip import Chip
from nscc_runtime.planner.drawn import BLOCK, ROOM
from nscc_runtime.planner.frame_loop import Adding, Counting, Reading, convert, draw_counts
from nscc_runtime.planner.prepared import Prepared
from nscc_runtime.planner.weighing import Weighing
from nscc_runtime.pool import in_parts
from nscc_runtime.reference.noise import SUM

Values = NDArray[np.float64]

_IN_CACHE = 1 << 15
"""Counts that are drawn before they are added up."""


@dataclass(frozen=True, eq=False)
class Summed:
    """A scene under a plan whose frames are weighted sums, with noise."""

    scene: Prepared

    @cached_property
    def weighing(self) -> Weighing:
        """What it has in common with other scenes under the plan."""
        return self.scene.chip.own(Weighing, self.scene.counted)

    def away(self, seed: int, frame: int) -> Values:
        """How far the counts (counted groups, pixels) of frame `frame` are from their means."""
        pixels = len(self.scene.places)
        found = np.empty((len(self.scene.counted), pixels))
        if not len(found):
            return found
        # Made here: who makes them waits for the threads that run.
        keys, rates = self._keys(seed, frame), self.rates

        def run(begin: int, end: int) -> None:
            self._count(rates, keys, begin, end, 0, found)

        in_parts(run, pixels, self.scene.threads, BLOCK)
        return found

    def expose(
        self, seed: int, frame: int, away: Values | None = None
    ) -> tuple[Values, NDArray[np.uint8]]:
        """Exposures (buckets, pixels) of frame number `frame`, and what cut them off. Counts are so
        far `away` from their means, or drawn rows by rows, while they are in the cache."""
        scene = self.scene
        (rows, cols), pixels = scene.light.shape, len(scene.places)
        buckets, groups = len(scene.program.container.buckets), len(scene.counted)
        found, marked = np.empty((buckets, pixels)), np.empty((buckets, pixels), np.uint8)
        sizes, draws = self.weighing.sizes, self.weighing.noise[0]
        noise = [key(seed, stream, SUM, frame, draw) for stream, draw in draws]
        noise_keys, keys = np.array(noise, np.uint64), self._keys(seed, frame)
        strip = rows if away is not None else max(1, _IN_CACHE // max(1, cols * groups))
        rates, expected = self.rates if away is None else [], scene.expected
        # Neighbours' counts are wanted, too.
        more = 1 if sizes["exchanges"] else 0

        def run(begin: int, end: int) -> None:
            total, drawn = np.empty(BLOCK * buckets), np.empty(BLOCK)
            room = np.empty(groups * min(strip + 2 * more, rows) * cols if away is None else 0)
            for first in range(begin, end, strip):
                stop = min(first + strip, end)
                counts, from_ = away, 0
                if counts is None:
                    from_, last = max(first - more, 0) * cols, min(stop + more, rows) * cols
                    counts = room[: groups * (last - from_)].reshape(groups, last - from_)
                    self._count(rates, keys, from_, last, from_, counts)
                self.weighing.adding(
                    adding=Adding(
                        begin=first, end=stop, room=counts.shape[1], from_=from_, **sizes
                    ),
                    noise_keys=noise_keys, expected=expected, away=counts, total=total,
                    drawn=drawn, exposure=found, marked=marked,
                )  # fmt: skip

        in_parts(run, rows, scene.threads)
        return found, marked

    def _keys(self, seed: int, frame: int) -> list[NDArray[np.uint64]]:
        """The keys of the counted groups, of each source."""
        groups = self.scene.counted
        return [
            np.array([count_key(seed, stream, source, frame, group) for group in groups], np.uint64)
            for stream, source in self.weighing.sources
        ]

    def _count(
        self, every: list[Values], keys: list[NDArray[np.uint64]], begin: int, end: int,
        from_: int, away: Values,
    ) -> None:  # fmt: skip
        """away[:, p - from_] := how far the counts of pixels `begin` .. `end` - 1 are from their
        means, the rates of `every` source."""
        groups, room = away.shape
        for number, rates in enumerate(every):
            draw_counts(
                counting=Counting(
                    begin=begin, end=end, pixels=len(self.scene.places), groups=groups,
                    room=room, from_=from_, more=number > 0, rate_cap=RATE_CAP,
                ),
                keys=keys[number],
                rates=rates,
                away=away,
                values=np.empty(BLOCK),
                scratch=np.empty(ROOM),
                few=np.empty(BLOCK),
                places=np.empty(BLOCK, np.int64),
            )  # fmt: skip

    @cached_property
    def rates(self) -> list[Values]:
        """The mean counts (counted groups, pixels) of each source."""
        scene = self.scene
        return [
            scene.light_rates if source == LIGHT else scene.chip.dark_rates(scene.counted)
            for _, source in self.weighing.sources
        ]


@dataclass(frozen=True, eq=False)
class Readout:
    """The converter as the loop knows it: `given` are its figures, `stream` is that of its noise,
    0 where it has none.
    """

    given: dict[str, Any]
    stream: int

    @classmethod
    def of(cls, chip: Chip) -> Readout | None:
        """None where an effect that is kept does something else after the exposure."""
        kept, sensor = chip.kept, chip.program.sensor
        target = chip.program.container.target
        converters, codes = kept.having(Converter), kept.having(Codes)
        known = {effect.name for effect, _ in (*converters, *codes)}
        if not _after(kept) <= known:
            return None
        mark = kept.marking("codes")
        ((_, code),) = codes
        given = {
            "noisy": len(converters),
            "last_bit": mark.bit if mark else 0,
            "electrons_per_code": code.electrons(sensor),
            "offset": code.offset(sensor),
            "top": float(target.top_code),
            "readout_noise": kept.converter_lsb(sensor),
        }
        return cls(given, converters[0][0].stream if converters else 0)

    def frame(
        self, values: Values, marked: NDArray[np.uint8], shape: tuple[int, int],
        seed_and_number: tuple[int, int], threads: int,
    ) -> Frame:  # fmt: skip
        """The codes of exposures (buckets, pixels) of an array, in the frame of a seed with a
        number; what they are marked with is added to."""
        (buckets, pixels), (seed, number) = values.shape, seed_and_number
        frame, valid = np.empty(values.shape, np.uint8), np.empty(values.shape, np.bool_)
        keys = [key(seed, self.stream, frame=number, group=bucket) for bucket in range(buckets)]

        def run(begin: int, end: int) -> None:
            convert(
                reading=Reading(
                    begin=begin, end=end, pixels=pixels, buckets=buckets, **self.given
                ),
                keys=np.array(keys, np.uint64),
                exposure=values,
                scratch=np.empty(BLOCK),
                frame=frame,
                valid=valid.view(np.uint8),
                marked=marked,
            )  # fmt: skip

        in_parts(run, pixels, threads, BLOCK)
        whole = buckets, *shape
        return Frame(
            frame.reshape(whole), values.reshape(whole), valid.reshape(whole), marked.reshape(whole)
        )


def _after(kept: Selection) -> set[str]:
    """The effects that act after the exposure."""
    return {effect.name for at in ("converter", "codes") for effect, _ in kept.acting(at)}
