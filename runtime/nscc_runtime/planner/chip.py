"""What all scenes under a choice of effects have in common on one chip: nothing of it is light."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects.effect import CannotHave
from nscc_runtime.effects.parts import (
    CountedDark,
    Echo,
    Exchange,
    Leak,
    Response,
    Soft,
    Well,
    WordGain,
)
from nscc_runtime.effects.selection import Selection, everything
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Device
from nscc_runtime.planner import leak_nodes
from nscc_runtime.planner.pixels import Wired
from nscc_runtime.planner.program import Program
from nscc_runtime.remembered import remembered

T = TypeVar("T")
Values = NDArray[np.float64]


@dataclass(frozen=True)
class _SmearedDark:
    """The dark current of pixels (rows, cols) that exchange charge: fixed on a chip."""

    dark: CountedDark
    exchange: Exchange
    shape: tuple[int, int]

    def __call__(self, sensor: Sensor, device_seed: int, places: NDArray[np.int64]) -> Values:
        current = self.dark.per_s(sensor, device_seed, places).reshape(self.shape)
        return self.exchange.smeared(current, self.exchange.fraction(sensor)).reshape(-1)


@dataclass(frozen=True, eq=False)
class Chip:
    """A program on one chip under the effects in `kept`; `chip_of` keeps the last ones.

    `wanted` has what is left out by choice as well, `nodes` is the number of rates of leakage at
    which sums are made. Arrays are made when they are asked for, and not to be written to.
    """

    program: Program
    device_seed: int
    kept: Selection
    wanted: Selection
    nodes: int

    @property
    def device(self) -> Device:
        """What is fixed on the chip."""
        return self.program.device(self.device_seed)

    @property
    def factor(self) -> float:
        """What becomes of the light of every pixel: the previous frame's is the same."""
        echo = self.kept.part(Echo)
        return 1.0 + (0.0 if echo is None else echo.fraction(self.program.sensor))

    @property
    def response(self) -> Values | None:
        """The response of each pixel to light; None where all are alike."""
        part = self.kept.part(Response)
        return None if part is None else self.device.fixed(part.factor)

    @cached_property
    def scale(self) -> Values:
        """What becomes of the light of each pixel before it is counted: a factor."""
        if self.response is not None:
            return self.factor * self.response
        return np.full(len(self.program.lanes), self.factor)

    @cached_property
    def scale_32(self) -> NDArray[np.float32]:
        """The same in float32, for light that is smeared."""
        return self.scale.astype(np.float32)

    @cached_property
    def current(self) -> Values:
        """The dark current of each pixel, 0 where there is none."""
        part = self.kept.part(CountedDark)
        if part is None:
            return np.zeros(len(self.program.lanes))
        return self.device.fixed(part.per_s)

    @cached_property
    def frame_dark_e(self) -> Values:
        """The dark charge (pixels,) of a frame."""
        return np.asarray(self.current * self.program.slot_s.sum())

    @remembered
    def dark_rates(self, groups: tuple[int, ...]) -> Values:
        """The dark charge (groups, pixels) of some groups of slots."""
        program = self.program
        times = [program.slot_s @ program.members(group) for group in groups]
        return np.array([self.current * time[program.lanes] for time in times])

    @cached_property
    def leaks(self) -> tuple[Values, Values]:
        """The rates of leakage at which sums are made, and the weights (rates, pixels) with which
        they give that of each pixel.
        """
        program, leak = self.program, self.kept.part(Leak)
        if leak is None or self.nodes == 1:
            rate = program.model(self.kept).leak_per_s
            return np.array([rate]), np.ones((1, 1))
        nodes = leak_nodes.rates(leak, program.sensor, self.nodes)
        return nodes, leak_nodes.between(nodes, self.device.fixed(leak.per_s))

    @cached_property
    def dark_e(self) -> Values | None:
        """What dark current adds to exposures (buckets, pixels), nothing saturated."""
        dark, program = self.kept.part(CountedDark), self.program
        if dark is None:
            return None
        exchange, current = self.kept.part(Exchange), self.current
        if exchange is not None:
            rows, cols = program.reference.groups.lane.shape
            current = self.device.fixed(_SmearedDark(dark, exchange, (rows, cols)))
        weights = program.tables.weights(program.model(self.kept)).slots
        open_s = np.einsum("n,nlb->bl", program.slot_s, weights)
        return np.asarray(current * open_s[:, program.lanes])

    @cached_property
    def patterns(self) -> Values:
        """The fixed errors (buckets, pixels) of the analog words."""
        program = self.program
        # What is left out by choice is still the better account of where errors go.
        wanted, total = program.model(self.wanted), 0.0
        for rate, between in zip(*self.leaks, strict=True):
            model = replace(wanted, leak_per_s=rate) if rate else wanted
            total = total + program.tables.pattern(model).T[:, program.lanes] * between
        return np.ascontiguousarray(total * self.device.fixed(self.kept.the(WordGain).error_e))

    @cached_property
    def limits(self) -> Values:
        """What the full well lets through, (buckets, pixels); infinite where pixels that may reach
        it run through their words.
        """
        program, found = self.program, np.zeros((len(self.program.container.buckets), 1))
        model, full_e = program.model(self.kept), self.full_e
        unknown = np.isnan(program.tables.single(model))
        for rate, between in zip(*self.leaks, strict=True):
            single = program.tables.single(replace(model, leak_per_s=rate))
            limit = np.where(unknown, 0.0, single * full_e)
            found = found + limit.T[:, program.lanes] * between
        return np.ascontiguousarray(np.where(unknown.T[:, program.lanes], np.inf, found))

    @property
    def full_e(self) -> float:
        """What PIX holds; no end where that is not simulated."""
        well = self.kept.part(Well)
        return np.inf if well is None else well.full_e(self.program.sensor)

    @cached_property
    def near_e(self) -> Values:
        """The least charge (kinds, lanes) with which a pixel may saturate in a way that sums do not
        know, infinite where none does: of what PIX sees, and of each kind of what registers hold
        (`nscc_runtime.planner.reach`)."""
        program, soft = self.program, self.kept.part(Soft)
        # Beside registers the well is never left out by itself: it says what took the light.
        well, reach = (self.kept if soft is None else self.wanted).part(Well), program.reach
        kinds = 1 if reach.held is None else 1 + len(reach.held)
        found = np.full((kinds, len(program.container.encoding)), np.inf)
        if well is not None:
            # Of what is left out by choice the words of these pixels know.
            single = not np.isnan(program.tables.single(program.model(self.wanted))).any()
            if soft is not None or not single:
                found[0] = well.full_e(program.sensor)
        if soft is not None and reach.held is None:
            np.minimum(found, reach.least_e, out=found)
        elif soft is not None:
            found[1:] = reach.least_e
        return found

    @remembered
    def wired(self, effects: Selection) -> Wired:
        """The words of pixels that have these effects."""
        program = self.program
        return Wired(program.words(effects), program.slot_s, effects, self.device_seed)

    @remembered
    def own(self, make: Callable[..., T], *given: Hashable) -> T:
        """What else scenes have in common here, `make(self, *given)`: made once."""
        return make(self, *given)


def chip_of(
    program: Program, device_seed: int, kept: Selection, wanted: Selection, nodes: int = 1
) -> Chip:
    """The chip with these effects, kept with the program for a while."""
    key = Chip, device_seed, kept.on, wanted.on, nodes
    return program.recent.of(key, lambda: Chip(program, device_seed, kept, wanted, nodes))


def whole_chip(program: Program, device_seed: int) -> Chip:
    """The chip with every effect, kept alike."""
    every = everything()
    return chip_of(program, device_seed, every, every)


def all_by_words() -> Selection:
    """All effects that the loop over words can have."""
    every = everything()
    return every.without(*(e.name for e in every.effects if isinstance(e.words, CannotHave)))
