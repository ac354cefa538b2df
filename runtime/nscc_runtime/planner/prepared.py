"""What all frames of a scene under a plan have in common: sums over the slots, and what they mean.

Nothing is done for a slot that can be done for all of them: light is added up with the weights of
the pixel's code, and counts are drawn for groups of slots.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects.parts import (
    Counted,
    CountedDark,
    CountedLight,
    Echo,
    Exchange,
    Leak,
    Moving,
    Response,
    Soft,
    Well,
    WordGain,
)
from nscc_runtime.effects.selection import Selection
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Device
from nscc_runtime.light import Light
from nscc_runtime.planner import leak_nodes
from nscc_runtime.planner.plan import Plan
from nscc_runtime.planner.program import Program
from nscc_runtime.planner.sums import scene_sums, sums_by_slot, weighted_sums
from nscc_runtime.planner.tables import Model

Values = NDArray[np.float64]

_MOST_LIGHT = 1e36
"""Sums of float32 may have no end."""
_SIGMAS = 6.0
"""How far from its mean a pixel is taken to come when it is asked whether it may saturate."""


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
class Prepared:
    """A scene under a plan, on one chip; arrays are made when they are asked for."""

    program: Program
    light: Light
    plan: Plan
    device_seed: int
    threads: int

    @property
    def kept(self) -> Selection:
        """The effects that are simulated."""
        return self.plan.kept

    @property
    def wanted(self) -> Model:
        """The weights of all effects but those that the user wants off: what is left out by choice
        is still the better account of where noise goes.
        """
        return self.program.model(self.plan.wanted)

    @cached_property
    def places(self) -> NDArray[np.int64]:
        """Every pixel's place."""
        return np.arange(len(self.program.lanes), dtype=np.int64)

    @cached_property
    def source(self) -> Light:
        """The scene's light, with or without motion inside its slots."""
        return (self.kept.part(Moving) and self.light.motion) or self.light

    @cached_property
    def total(self) -> Values:
        """All the light of each pixel, to float32."""
        weight = self.source.on_frames(np.ones((self.light.slots, 1)))
        frames = self.source.frames.reshape(len(self.source.frames), -1)
        if np.all(weight == weight[0]):
            with np.errstate(over="ignore"):
                even = np.asarray(frames.sum(axis=0) * weight[0], np.float64)
            return np.asarray(np.minimum(even, _MOST_LIGHT))
        lanes = np.zeros(len(self.places), np.int32)
        found: Values = weighted_sums(frames, lanes, weight.T[:, :, None], self.threads)[0]
        return found

    @property
    def device(self) -> Device:
        """What is fixed on the chip."""
        return self.program.device(self.device_seed)

    @property
    def factor(self) -> float:
        """What becomes of the light of every pixel: the previous frame's is the same."""
        return 1.0 + self._fraction(self.kept.part(Echo))

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
        return np.full(len(self.places), self.factor)

    @cached_property
    def current(self) -> Values:
        """The dark current of each pixel, 0 where there is none."""
        part = self.kept.part(CountedDark)
        return np.zeros(len(self.places)) if part is None else self.device.fixed(part.per_s)

    @cached_property
    def counted(self) -> list[int]:
        """The groups whose charge is counted."""
        if self.kept.part(Counted) is None:
            return []
        return [g for g in self.program.group_ids.tolist() if g or self.plan.closed]

    @cached_property
    def _sums(self) -> tuple[Values, Values]:
        """All sums over the scene in one go: the light (counted groups, pixels) of each group of
        slots that is counted, and the light (buckets, leak nodes, pixels) of each bucket.
        """
        program, exchange = self.program, self.kept.part(Exchange)
        buckets, nodes = range(len(program.container.buckets)), self.leaks[0]
        lit = self.counted if self.kept.part(CountedLight) is not None else ()
        groups = [program.members(group) for group in lit]
        model = program.model(self.kept)
        weights = [program.tables.weights(replace(model, leak_per_s=rate)).slots for rate in nodes]
        stack = [each[:, :, b] for b in buckets for each in weights]
        plain, smeared = (groups + stack, []) if exchange is None else (groups, stack)
        found = scene_sums(
            self.source, program.lanes, self.scale, plain, smeared, self._fraction(exchange),
            self.threads,
        )  # fmt: skip
        return found[: len(groups)], found[len(groups) :].reshape(len(buckets), len(nodes), -1)

    @property
    def light_rates(self) -> Values:
        """The light (groups, pixels) of each counted group of slots."""
        return self._sums[0]

    @cached_property
    def dark_rates(self) -> Values:
        """The dark charge (groups, pixels) of each counted group of slots."""
        times = [self.program.slot_s @ self.program.members(group) for group in self.counted]
        return np.array([self.current * time[self.program.lanes] for time in times])

    @cached_property
    def leaks(self) -> tuple[Values, Values]:
        """The rates of leakage at which sums are made, and the weights (rates, pixels) with which
        they give that of each pixel.
        """
        program, leak = self.program, self.kept.part(Leak)
        if leak is None or self.plan.leak_nodes == 1:
            rate = program.model(self.kept).leak_per_s
            return np.array([rate]), np.ones((1, 1))
        nodes = leak_nodes.rates(leak, program.sensor, self.plan.leak_nodes)
        return nodes, leak_nodes.between(nodes, self.device.fixed(leak.per_s))

    @cached_property
    def expected(self) -> Values:
        """The exposures (buckets, pixels) of the mean charge, nothing saturated."""
        program, exchange, sums = self.program, self.kept.part(Exchange), self._sums[1]
        found = sums[:, 0] if sums.shape[1] == 1 else (sums * self.leaks[1]).sum(axis=1)
        if self.kept.part(CountedDark) is not None:
            current = self.current
            if exchange is not None:
                dark = self.kept.the(CountedDark)
                current = self.device.fixed(_SmearedDark(dark, exchange, self.light.shape))
            weights = program.tables.weights(program.model(self.kept)).slots
            open_s = np.einsum("n,nlb->bl", program.slot_s, weights)
            found = found + current * open_s[:, program.lanes]
        return np.asarray(found)

    @cached_property
    def patterns(self) -> Values:
        """The fixed errors (buckets, pixels) of the analog words."""
        program = self.program
        total = 0.0
        for rate, between in zip(*self.leaks, strict=True):
            # Leakage that is left out is still the better account of where errors go.
            model = replace(self.wanted, leak_per_s=rate) if rate else self.wanted
            total = total + program.tables.pattern(model).T[:, program.lanes] * between
        return np.asarray(total * self.device.fixed(self.kept.the(WordGain).error_e))

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
        return np.where(unknown.T[:, program.lanes], np.inf, found)

    @property
    def full_e(self) -> float:
        """What PIX holds; no end where that is not simulated."""
        well = self.kept.part(Well)
        return np.inf if well is None else well.full_e(self.program.sensor)

    @cached_property
    def saturating(self) -> NDArray[np.int64]:
        """The places of pixels that may saturate in a way that sums do not know."""
        limit = self._limit(self.kept)
        if self._most_charge < limit.min():
            return np.empty(0, np.int64)
        return np.flatnonzero(self._charge >= limit[self.program.lanes])

    def saturating_with(self, fewer: Selection) -> NDArray[np.int64]:
        """The same with fewer of the effects that saturate: some of these pixels."""
        some = self.saturating
        if not len(some):
            return some
        return some[self._charge[some] >= self._limit(fewer)[self.program.lanes[some]]]

    def _limit(self, kept: Selection) -> Values:
        """The least charge (lanes,) with which a pixel may saturate so."""
        program, sensor = self.program, self.program.sensor
        well, soft = kept.part(Well), kept.part(Soft)
        limit = np.full(len(program.container.encoding), np.inf)
        if well is not None:
            single = not np.isnan(program.tables.single(program.model(kept))).any()
            if soft is not None or not single:
                limit[:] = well.full_e(sensor)
        if soft is not None:
            room = soft.linear_e(sensor) - program.reach.noise_e
            limit = np.minimum(limit, room / program.reach.light)
        return limit

    @property
    def _most_charge(self) -> float:
        """More than any pixel sees."""
        # These pixels run with all effects, so all effects say which they are.
        part = self._fraction(self.plan.wanted.part(Exchange))
        bound = float(np.max(self.total * self._wanted_scale, initial=0.0))
        bound *= 1.0 + 4 * part
        bound += float(self._wanted_current.max(initial=0.0)) * float(self.program.slot_s.sum())
        return float(bound + _SIGMAS * np.sqrt(bound))

    @property
    def _wanted_scale(self) -> Values:
        wanted = self.plan.wanted
        response = wanted.part(Response)
        scale = np.ones(1) if response is None else self.device.fixed(response.factor)
        return np.asarray(scale * (1.0 + self._fraction(wanted.part(Echo))))

    @property
    def _wanted_current(self) -> Values:
        dark = self.plan.wanted.part(CountedDark)
        return np.zeros(1) if dark is None else self.device.fixed(dark.per_s)

    @cached_property
    def _charge(self) -> Values:
        """The most charge (pixels,) that each pixel is taken to see at a read."""
        program, scale, exchange = self.program, self._wanted_scale, self.plan.wanted.part(Exchange)
        seen = program.tables.seen().astype(np.float64)
        charge = self._sum(self.source, [seen])[0] * scale
        if exchange is not None:
            # Neighbours' light counts in the pixel's own slots, whatever their own codes are.
            own = 1.0 - 4 * self._fraction(exchange)
            charge = np.maximum(charge, own * charge + self.inflow_e(exchange))
        charge += self._wanted_current * (program.slot_s @ seen)[program.lanes]
        return np.asarray(charge + _SIGMAS * np.sqrt(charge))

    def inflow_e(self, exchange: Exchange) -> Values:
        """What neighbours give each pixel of their light, in a whole frame."""
        part, lit = self._fraction(exchange), self.total * self._wanted_scale
        flow = exchange.smeared(lit.reshape(self.light.shape), part).reshape(-1)
        return np.asarray(flow - (1.0 - 4 * part) * lit)

    def _fraction(self, part: Echo | Exchange | None) -> float:
        return 0.0 if part is None else part.fraction(self.program.sensor)

    def _sum(self, light: Light, weights: list[Values]) -> Values:
        """Sums (len(weights), pixels) of a light, each weighted by slot and lane (N, lanes)."""
        frames = light.frames.reshape(len(light.frames), -1)
        return sums_by_slot(light, frames, self.program.lanes, weights, self.threads)
