"""Frames by weighted sums: what all of them have in common, laid out for the loops over pixels."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import Selection
from nscc_runtime.effects.counts import LIGHT, WITHOUT_LIGHT, count_key
from nscc_runtime.effects.parts import (
    Codes,
    Converter,
    CountedDark,
    CountedLight,
    Exchange,
    Soft,
    Well,
    WordGain,
)
from nscc_runtime.frame_file import Frame
from nscc_runtime.interface import Exposure
from nscc_runtime.loop import Bound
from nscc_runtime.noise import RATE_CAP, key
from nscc_runtime.planner.drawn import BLOCK, ROOM
from nscc_runtime.planner.frame_loop import (
    Adding,
    Counting,
    Reading,
    add_up,
    convert,
    draw_counts,
)
from nscc_runtime.planner.prepared import Prepared
from nscc_runtime.pool import in_parts
from nscc_runtime.reference.noise import SUM

Values = NDArray[np.float64]
Weights = NDArray[np.float32]

ROUNDING = 1e-12
"""Of sums of charge: the part by which a well that is just full may seem to hold more."""
_IN_CACHE = 1 << 15
"""Counts that are drawn before they are added up."""
_NONE, _NONE_32 = np.zeros((1, 1)), np.zeros(1, np.float32)


@dataclass(frozen=True, eq=False)
class Summed:
    """A scene under a plan whose frames are weighted sums, with noise."""

    scene: Prepared

    def away(self, seed: int, frame: int) -> Values:
        """How far the counts (counted groups, pixels) of frame `frame` are from their means."""
        pixels = len(self.scene.places)
        found, keys = np.empty((len(self.scene.counted), pixels)), self._keys(seed, frame)

        def run(begin: int, end: int) -> None:
            self._count(keys, begin, end, 0, found)

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
        noise = [key(seed, stream, SUM, frame, draw) for stream, draw in self.noise[0]]
        noise_keys, keys = np.array(noise, np.uint64), self._keys(seed, frame)
        strip = rows if away is not None else max(1, _IN_CACHE // max(1, cols * groups))
        # Neighbours' counts are wanted, too.
        more = 1 if self.sizes["exchanges"] else 0

        def run(begin: int, end: int) -> None:
            total, drawn = np.empty(BLOCK * buckets), np.empty(BLOCK)
            room = np.empty(groups * min(strip + 2 * more, rows) * cols if away is None else 0)
            for first in range(begin, end, strip):
                stop = min(first + strip, end)
                counts, from_ = away, 0
                if counts is None:
                    from_, last = max(first - more, 0) * cols, min(stop + more, rows) * cols
                    counts = room[: groups * (last - from_)].reshape(groups, last - from_)
                    self._count(keys, from_, last, from_, counts)
                self._adding(
                    adding=Adding(
                        begin=first, end=stop, room=counts.shape[1], from_=from_, **self.sizes
                    ),
                    noise_keys=noise_keys, away=counts, total=total, drawn=drawn, exposure=found,
                    marked=marked,
                )  # fmt: skip

        in_parts(run, rows, scene.threads)
        return found, marked

    def _keys(self, seed: int, frame: int) -> list[NDArray[np.uint64]]:
        """The keys of the counted groups, of each source."""
        groups = self.scene.counted
        return [
            np.array([count_key(seed, stream, source, frame, group) for group in groups], np.uint64)
            for stream, source, _ in self.counts
        ]

    def _count(
        self, keys: list[NDArray[np.uint64]], begin: int, end: int, from_: int, away: Values
    ) -> None:
        """away[:, p - from_] := how far the counts of pixels `begin` .. `end` - 1 are from their
        means."""
        groups, room = away.shape
        for number, count in enumerate(self._drawing):
            count(
                counting=Counting(
                    begin=begin, end=end, pixels=len(self.scene.places), groups=groups,
                    room=room, from_=from_, more=number > 0, rate_cap=RATE_CAP,
                ),
                keys=keys[number],
                away=away,
                values=np.empty(BLOCK),
                scratch=np.empty(ROOM),
                few=np.empty(BLOCK),
                places=np.empty(BLOCK, np.int64),
            )  # fmt: skip

    @cached_property
    def counts(self) -> list[tuple[int, int, Values]]:
        """What counts charge: the effect's stream, the source, the rates (groups, pixels)."""
        scene = self.scene
        kept = scene.kept
        found = [(e.stream, LIGHT, scene.light_rates) for e, _ in kept.having(CountedLight)]
        for effect, _ in kept.having(CountedDark):
            found.append((effect.stream, WITHOUT_LIGHT, scene.chip.dark_rates(scene.counted)))
        return found

    @cached_property
    def _drawing(self) -> list[Bound]:
        """The loop that counts, with the rates of each source."""
        return [draw_counts.bound(rates=rates) for _, _, rates in self.counts]

    @cached_property
    def noise(self) -> tuple[list[tuple[int, int]], Values]:
        """The streams and draws of small errors, and how much (draws, buckets, lanes) each is."""
        program, kept = self.scene.program, self.scene.kept
        draws, sigmas = [], []
        for effect, part in kept.errors():
            factor = (
                part.sigma_e(program.sensor) * program.tables.noise(part.at, self.scene.wanted)[0]
            )
            for draw in range(factor.shape[2]):
                if factor[:, :, draw].any():
                    draws.append((effect.stream, draw))
                    sigmas.append(factor[:, :, draw].T)
        shape = len(draws), len(program.container.buckets), len(program.container.encoding)
        return draws, np.ascontiguousarray(np.array(sigmas).reshape(shape))

    @cached_property
    def sizes(self) -> dict[str, Any]:
        """Everything of `Adding` but the rows."""
        scene, program = self.scene, self.scene.program
        exchange, mark = scene.kept.part(Exchange), scene.kept.marking("well")
        counts = bool(self.counts)
        return {
            "rows": scene.light.shape[0],
            "cols": scene.light.shape[1],
            "pixels": len(scene.places),
            "buckets": len(program.container.buckets),
            "lane_count": len(program.container.encoding),
            "groups": len(scene.counted),
            "sources": len(self.noise[0]),
            "exchanges": counts and exchange is not None,
            "clipped": scene.kept.part(Well) is not None and scene.kept.part(Soft) is None,
            "patterned": scene.kept.part(WordGain) is not None,
            "well_bit": mark.bit if mark else 0,
            "fraction": 0.0 if exchange is None else exchange.fraction(program.sensor),
            "full": 1.0 + ROUNDING,
        }

    @cached_property
    def weights(self) -> Values:
        """Mean weights (groups, buckets, lanes) of the deviations of a group's counts."""
        scene, program = self.scene, self.scene.program
        means = program.mean_weights(program.model(scene.kept))
        shape = len(scene.counted), len(program.container.buckets), len(program.container.encoding)
        each = [means[group].T for group in scene.counted]
        return np.ascontiguousarray(np.array(each).reshape(shape))

    @cached_property
    def overlap(self) -> tuple[Weights, Weights]:
        """Where pixels exchange counts: weights of their own, and of their neighbours'."""
        program = self.scene.program
        found = program.overlap(program.model(self.scene.kept), self.scene.counted)
        return found.own, found.neighbours

    @cached_property
    def _adding(self) -> Bound:
        """The loop that adds up, with all that frames have in common."""
        own, neighbours = self.overlap if self.sizes["exchanges"] else (_NONE_32, _NONE_32)
        chip = self.scene.chip
        return add_up.bound(
            lanes=self.scene.program.lanes,
            expected=self.scene.expected,
            weights=self.weights,
            own=own,
            neighbours=neighbours,
            limits=chip.limits if self.sizes["clipped"] else _NONE,
            patterns=chip.patterns if self.sizes["patterned"] else _NONE,
            sigma=self.noise[1],
        )


@dataclass(frozen=True, eq=False)
class Readout:
    """The converter as the loop knows it: `given` are its figures, `stream` is that of its noise,
    0 where it has none.
    """

    given: dict[str, Any]
    stream: int

    @classmethod
    def of(cls, scene: Prepared) -> Readout | None:
        """None where an effect that is kept does something else after the exposure."""
        kept, sensor = scene.kept, scene.program.sensor
        target = scene.program.container.target
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

    def frame(self, exposure: Exposure, seed: int, number: int, threads: int) -> Frame:
        """The codes of frame number `number`."""
        values, marked = exposure.exposure_e, exposure.saturated_by
        assert marked is not None  # plans mark what they cut off
        buckets = len(values)
        frame, valid = np.empty(values.shape, np.uint8), np.empty(values.shape, np.bool_)
        flat: dict[str, NDArray[Any]] = {
            "exposure": values,
            "frame": frame,
            "valid": valid.view(np.uint8),
            "marked": marked,
        }
        filled = {name: each.reshape(buckets, -1) for name, each in flat.items()}
        keys = [key(seed, self.stream, frame=number, group=bucket) for bucket in range(buckets)]
        pixels = values[0].size

        def run(begin: int, end: int) -> None:
            convert(
                reading=Reading(
                    begin=begin, end=end, pixels=pixels, buckets=buckets, **self.given
                ),
                keys=np.array(keys, np.uint64),
                scratch=np.empty(BLOCK),
                **filled,
            )  # fmt: skip

        in_parts(run, pixels, threads, BLOCK)
        return Frame(frame, values, valid, marked)


def _after(kept: Selection) -> set[str]:
    """The effects that act after the exposure."""
    return {effect.name for at in ("converter", "codes") for effect, _ in kept.acting(at)}
