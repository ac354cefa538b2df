"""Frames by weighted sums: light weighted by the pixel's code, counts drawn once per group of
slots, and converter codes."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects.parts import (
    Codes,
    Converter,
    CountedLight,
    Echo,
    Exchange,
    Moving,
    Response,
    WordGain,
)
from nscc_runtime.effects.views import LIGHT
from nscc_runtime.execution.block_draws import BLOCK, ROOM
from nscc_runtime.execution.chip import SimulatedChip
from nscc_runtime.execution.frame_loop import (
    Adding,
    Counting,
    Reading,
    add_up,
    convert,
    draw_counts,
)
from nscc_runtime.execution.sum_loop import light_sums
from nscc_runtime.frame_file import Frame
from nscc_runtime.light import Light
from nscc_runtime.noise import RATE_CAP, key
from nscc_runtime.pool import in_parts
from nscc_runtime.reference.capture import SUM
from nscc_runtime.reference.weights import WeightModel

Values = NDArray[np.float64]

APPROXIMATIONS: Sequence[str] = (
    "photons are counted once for all slots that a group of buckets shares",
    "charge of closed slots is not counted",
    "counts exchanged with neighbours are spread evenly over the slots of their group",
    "counts from a rate of 10 on follow a formula",
    "noise of words is weighed at the mean leakage, and leakage is linear between two rates",
)
"""The approximations of sums, relative to the reference with the same effects."""


@dataclass(frozen=True, eq=False)
class SummedScene:
    """A scene on the pixels of a chip, whose frames are weighted sums with noise. `known` caches
    sums of the light: planning compares sets of effects that share them."""

    chip: SimulatedChip
    light: Light
    threads: int
    known: dict[Hashable, tuple[Values, Values]] = field(default_factory=dict)

    @cached_property
    def source(self) -> Light:
        """The scene's light, with motion inside its slots if that effect is simulated."""
        return (self.chip.kept_effects.find_part(Moving) and self.light.motion) or self.light

    @cached_property
    def _sums(self) -> tuple[Values, Values]:
        """The light of each counted group of slots (counted groups, pixels), and of each bucket
        (buckets, pixels), in electrons."""
        chip, kept_effects = self.chip, self.chip.kept_effects
        lit = len(chip.counted) if kept_effects.find_part(CountedLight) is not None else 0
        model = chip.program.model(kept_effects)
        of_light = (
            kept_effects.names(part_type) for part_type in (Moving, Echo, Response, Exchange)
        )
        key = chip.array, lit, model, chip.leak_rates, frozenset[str]().union(*of_light)
        if key not in self.known:
            self.known[key] = self._added_up(lit, model)
        return self.known[key]

    def _added_up(self, lit: int, model: WeightModel) -> tuple[Values, Values]:
        chip = self.chip
        groups = chip.counted if lit else ()
        weights = chip.program.sum_weights(model, chip.leak_rates, groups)
        exchanges = chip.kept_effects.find_part(Exchange) is not None
        sums = light_sums(
            self.source, chip.array.flat_lanes, (chip.scale, chip.scale_32), weights,
            lit if exchanges else len(weights.slots), chip.exchanged, self.threads,
        )  # fmt: skip
        by_rate = sums[lit:].reshape(-1, len(chip.leak_rates), sums.shape[1])
        exposure = by_rate[:, 0]
        if len(chip.leak_rates) > 1:
            np.multiply(by_rate, chip.leak_weights, out=by_rate)
            exposure = by_rate.sum(axis=1)
        return sums[:lit], exposure

    @cached_property
    def expected(self) -> Values:
        """Mean exposures (buckets, pixels) with fixed errors of words, without saturation."""
        exposure, dark_e = self._sums[1], self.chip.dark_e
        if dark_e is not None:
            exposure = exposure + dark_e
        if self.chip.kept_effects.find_part(WordGain) is not None:
            exposure = exposure + self.chip.patterns
        return np.ascontiguousarray(exposure)

    @cached_property
    def rates(self) -> list[Values]:
        """Mean counts (counted groups, pixels) of each source of charge."""
        return [
            self._sums[0] if source == LIGHT else self.chip.dark_rates
            for _, source in self.chip.sources
        ]

    def away(self, seed: int, frame: int) -> Values:
        """Return the deviations of a frame's counts (counted groups, pixels) from their means."""
        array, groups = self.chip.array, self.chip.counted
        away = np.empty((len(groups), array.lanes.size))
        # Computed before the threads start: cached properties of one object wait for each other.
        sources = [
            (np.array([key(seed, stream, source, frame, g) for g in groups], np.uint64), rates)
            for (stream, source), rates in zip(self.chip.sources, self.rates, strict=True)
            if groups
        ]

        def run(begin: int, end: int) -> None:
            values, scratch, pending_rates = np.empty(BLOCK), np.empty(ROOM), np.empty(BLOCK)
            for number, (of_groups, rates) in enumerate(sources):
                draw_counts(
                    counting=Counting(
                        begin=begin, end=end, pixels=array.lanes.size, groups=len(groups),
                        accumulates=int(number > 0), rate_cap=RATE_CAP,
                    ),
                    keys=of_groups, rates=rates, places=array.places, away=away, values=values,
                    scratch=scratch, pending_rates=pending_rates,
                    pending_pixels=np.empty(BLOCK, np.int64),
                )  # fmt: skip

        in_parts(run, array.lanes.size, self.threads, BLOCK)
        return away

    def expose(self, seed: int, frame: int, away: Values) -> Values:
        """Return exposures (buckets, pixels) of a frame; `away`: deviations of its counts."""
        chip, (draws, sigma) = self.chip, self.chip.noise
        (rows, cols), expected = chip.array.shape, self.expected
        exposure = np.empty(expected.shape)
        noise = [key(seed, stream, SUM, frame, draw) for stream, draw in draws]
        noise_keys = np.array(noise, np.uint64)
        sizes: dict[str, Any] = {
            "rows": rows, "cols": cols, "pixels": rows * cols, "buckets": len(expected),
            "lane_count": len(chip.program.container.encoding), "groups": len(chip.counted),
            "sources": len(draws), "exchanges": bool(chip.sources) and chip.exchanged > 0,
            "fraction": chip.exchanged,
        }  # fmt: skip
        exchanges = chip.exchanged > 0
        neighbour_weights = chip.beside_weights if exchanges else np.zeros(1, np.float32)

        def run(begin: int, end: int) -> None:
            add_up(
                adding=Adding(begin=begin, end=end, **sizes), noise_keys=noise_keys,
                lanes=chip.array.flat_lanes, places=chip.array.places, expected=expected,
                away=away, own_weights=chip.own_weights, neighbour_weights=neighbour_weights,
                sigma=sigma, total=np.empty(BLOCK * len(expected)), drawn=np.empty(BLOCK),
                exposure=exposure,
            )  # fmt: skip

        in_parts(run, rows, self.threads)
        return exposure


@dataclass(frozen=True, eq=False)
class LoopConverter:
    """The converter for the loop. `figures`: its parameters. `stream`: random stream of its noise,
    0 without noise. `places`: places of the pixels."""

    figures: dict[str, Any]
    stream: int
    places: NDArray[np.int64]

    @classmethod
    def of(cls, chip: SimulatedChip) -> LoopConverter | None:
        """Return the converter of a chip; None if other effects act after the exposure."""
        kept_effects, sensor = chip.kept_effects, chip.program.sensor
        target = chip.program.container.target
        converters, codes = kept_effects.having(Converter), kept_effects.having(Codes)
        known = {effect.name for effect, _ in (*converters, *codes)}
        after = {e.name for at in ("converter", "codes") for e, _ in kept_effects.acting(at)}
        if not after <= known:
            return None
        mark = kept_effects.marking("codes")
        ((_, code),) = codes
        figures = {
            "noisy": len(converters),
            "last_bit": mark.bit if mark else 0,
            "electrons_per_code": code.electrons(sensor),
            "offset": code.offset(sensor),
            "top": float(target.top_code),
            "readout_noise": kept_effects.converter_lsb(sensor),
        }
        stream = converters[0][0].stream if converters else 0
        return cls(figures, stream, chip.array.places)

    def frame(
        self, values: Values, marked: NDArray[np.uint8], shape: tuple[int, int],
        seed_and_number: tuple[int, int], threads: int,
    ) -> Frame:  # fmt: skip
        """Convert exposures (buckets, pixels) to a frame; add marks of codes to `marked`."""
        (buckets, pixels), (seed, number) = values.shape, seed_and_number
        frame, valid = np.empty(values.shape, np.uint8), np.empty(values.shape, np.bool_)
        keys = [key(seed, self.stream, frame=number, group=bucket) for bucket in range(buckets)]

        def run(begin: int, end: int) -> None:
            convert(
                reading=Reading(
                    begin=begin, end=end, pixels=pixels, buckets=buckets, **self.figures
                ),
                keys=np.array(keys, np.uint64),
                places=self.places,
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
