"""Running a plan: sums first, one draw a pixel, and single pixels through their words where needed.

The noise of all words is one draw a bucket. The draws are those of the reference
(`nscc_runtime.effects`), so that what a plan leaves out is the only difference from it. Pixels that
may saturate run through all their words. What only the reference has, the reference simulates.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import Selection
from nscc_runtime.effects.parts import Counted, Exchange
from nscc_runtime.emulator.capture import check_size
from nscc_runtime.frame_file import Frame, converted
from nscc_runtime.interface import Exposure
from nscc_runtime.light import Light
from nscc_runtime.planner.fused import Fused
from nscc_runtime.planner.lacking import by_spilt
from nscc_runtime.planner.pixels import Given, Running
from nscc_runtime.planner.plan import Plan
from nscc_runtime.planner.prepared import Prepared
from nscc_runtime.planner.program import Program
from nscc_runtime.planner.summed import Readout, Summed
from nscc_runtime.pool import threads_of
from nscc_runtime.reference.capture import Reference, scene_of

Values = NDArray[np.float64]
Marked = NDArray[np.uint8]


@dataclass(frozen=True, eq=False)
class Planned(Prepared):
    """A scene made ready under a plan, to be exposed: on a device of torch, where one is named."""

    torch_device: str | None = None

    @cached_property
    def fused(self) -> Fused | None:
        """The scene laid out for the loop that does it all, where the plan is simple."""
        return Fused.of(self)

    def expose(self, seed: int, frame: int) -> Exposure:
        """Frame number `frame`; threads change no bit."""
        if self.fused is not None:
            simple = self.fused.expose(seed, frame, read_out=False)
            return Exposure(simple.exposure_e, simple.valid, simple.saturated_by)
        if self.plan.slot_loop == "reference":
            return self._reference.expose(
                scene_of(self.program.container, self.light), seed, self.device_seed, frame,
                self.threads,
            )  # fmt: skip
        return self._exposure(*self._exposed(seed, frame))

    def _exposed(self, seed: int, frame: int) -> tuple[Values, Marked]:
        """Exposures (buckets, pixels) of frame number `frame` by sums and by the loop over words,
        and what cut them off."""
        if self.plan.slot_loop == "all":
            shape = len(self.program.container.buckets), len(self.places)
            found, marked = np.empty(shape), np.empty(shape, np.uint8)
            for places, pixels in self._running:
                found[:, places], marked[:, places] = pixels.expose(seed, frame)
            return found, marked
        if not self._running:
            return self._summed.expose(seed, frame)
        away = self._summed.away(seed, frame)
        found, marked = self._summed.expose(seed, frame, away)
        self._run(found, marked, away, seed, frame)
        return found, marked

    def _run(self, found: Values, marked: Marked, away: Values, seed: int, frame: int) -> None:
        """Have pixels that may saturate run through their words: their neighbours' counts are those
        that sums have."""
        given = Given(self.counted, away)
        for places, pixels in self._running:
            effects = pixels.wired.effects
            # Without some of what counts, they are other counts.
            alike = effects.names(Counted) == self.kept.names(Counted) and effects.part(Exchange)
            found[:, places], marked[:, places] = pixels.expose(
                seed, frame, given if alike else None
            )

    def _exposure(self, found: Values, marked: Marked) -> Exposure:
        shape = (len(found), *self.light.shape)
        valid = np.isfinite(found)
        return Exposure(found.reshape(shape), valid.reshape(shape), marked.reshape(shape))

    @cached_property
    def _by_words(self) -> list[tuple[NDArray[np.int64], Selection]]:
        """The pixels that run through their words because they may saturate, by the effects that
        they have there."""
        most, plan = self.saturating, self.plan
        found = []
        lost = by_spilt(frozenset(plan.saturating_lack))
        if len(most) and len(lost) < len(plan.saturating_lack):
            beside = self.near.spilt
            most = np.setdiff1d(most, beside, assume_unique=True)
            found.append((beside, plan.in_words(lost)))
        found.append((most, plan.kept_in_words))
        return [each for each in found if len(each[0])]

    def frames(self, seed: int, count: int) -> Iterator[Frame]:
        """Frames 0 .. `count` - 1, read out."""
        if self.torch_device is None or self.plan.slot_loop in ("all", "reference"):
            yield from (self.frame(seed, number) for number in range(count))
            return
        import torch

        from nscc_runtime.planner.torch_frames import OnTorch

        on_torch = OnTorch(self._summed, torch.device(self.torch_device))
        step = on_torch.together
        for first in range(0, count, step):
            numbers = range(first, min(first + step, count))
            exposed = on_torch.expose(seed, numbers)
            for number, found, marked in zip(numbers, *exposed, strict=True):
                if len(self.saturating):
                    self._run(found, marked, self._summed.away(seed, number), seed, number)
                yield self._read_out(found, marked, seed, number)

    def frame(self, seed: int, frame: int) -> Frame:
        """Frame number `frame`, read out."""
        if self.fused is not None:
            return self.fused.expose(seed, frame, read_out=True)
        if self.plan.slot_loop == "reference":
            return self._converted(self.expose(seed, frame), seed, frame)
        return self._read_out(*self._exposed(seed, frame), seed, frame)

    def _read_out(self, found: Values, marked: Marked, seed: int, frame: int) -> Frame:
        if self._readout is None:
            return self._converted(self._exposure(found, marked), seed, frame)
        return self._readout.frame(found, marked, self.light.shape, (seed, frame), self.threads)

    def _converted(self, exposure: Exposure, seed: int, frame: int) -> Frame:
        target, seeds = self.program.container.target, (seed, self.device_seed)
        return converted(exposure, target, self.program.sensor, self.kept, seeds, frame)

    @property
    def _summed(self) -> Summed:
        # Not kept: it holds this scene, and what holds each other lives until somebody collects it.
        return Summed(self)

    @cached_property
    def _readout(self) -> Readout | None:
        return self.chip.own(Readout.of)

    @cached_property
    def _reference(self) -> Reference:
        return Reference.of(self.program.container, self.program.sensor, self.kept)

    @cached_property
    def _running(self) -> list[tuple[NDArray[np.int64], Running]]:
        """The pixels that run through their words: all of them, or those that may saturate."""
        some = self._by_words
        if self.plan.slot_loop == "all":
            # Those that may saturate have all effects here, too, as predictions take them to.
            rest = np.setdiff1d(self.places, self.saturating, assume_unique=True)
            some = [(rest, self.kept), *some]
        return [
            (places, Running(self.chip.wired(self._there(kept)), self.light, places, self.threads))
            for places, kept in some if len(places)
        ]  # fmt: skip

    def _there(self, kept: Selection) -> Selection:
        """Effects without those that are nothing on this sensor: pixels that exchange nothing have
        no need of their neighbours' counts."""
        exchange = kept.part(Exchange)
        if exchange is None or exchange.fraction(self.program.sensor) > 0:
            return kept
        return kept.without(*kept.names(Exchange))


def prepared(
    program: Program,
    light: Light,
    plan: Plan,
    *,
    device_seed: int = 0,
    threads: int | None = None,
    torch_device: str | None = None,
) -> Planned:
    """A scene made ready; raises Rejected as `nscc_runtime.emulator.expose` does."""
    check_size(program.container, light)
    return Planned(program, light, plan, device_seed, threads_of(threads), torch_device)
