"""Running a plan: sums first, one draw a pixel, and single pixels through their words where needed.

Nothing is done for a slot that can be done for all of them: light is added up with the weights of
the pixel's code, counts are drawn for groups of slots, the noise of all words is one draw a bucket.
The draws are those of the reference (`nscc_runtime.effects`), so that what a plan leaves out is the
only difference from it. Pixels that may saturate run through all their words.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import Selection
from nscc_runtime.effects.crosstalk import CROSSTALK, smeared
from nscc_runtime.effects.dark import DARK
from nscc_runtime.effects.photodiode import FULL_WELL
from nscc_runtime.effects.photons import DARK as DARK_SOURCE
from nscc_runtime.effects.photons import LIGHT, PRNU, SHOT, count_key
from nscc_runtime.effects.registers import ANALOG, LEAKAGE, REGISTER
from nscc_runtime.effects.timing import LAG, MOTION
from nscc_runtime.emulator.capture import check_size
from nscc_runtime.interface import Exposure
from nscc_runtime.light import Light
from nscc_runtime.noise import key, normals, poisson
from nscc_runtime.plan import leak_nodes
from nscc_runtime.plan.fused import Fused
from nscc_runtime.plan.plan import Plan
from nscc_runtime.plan.pool import processors
from nscc_runtime.plan.program import Device, Program
from nscc_runtime.plan.sums import smeared_frames, sums_by_slot, weighted_sums
from nscc_runtime.plan.tables import Model
from nscc_runtime.reference.noise import SUM

Values = NDArray[np.float64]

_MOST_LIGHT = 1e36
"""Sums of float32 may have no end."""
SIGMAS = 6.0
"""How far from its mean a pixel is taken to come when it is asked whether it may saturate."""


@dataclass(frozen=True, eq=False)
class Planned:
    """A scene made ready under a plan: what all its frames have in common."""

    program: Program
    light: Light
    plan: Plan
    device_seed: int
    threads: int

    @cached_property
    def fused(self) -> Fused | None:
        """The scene laid out for the loop that does it all, where the plan is simple."""
        return Fused.of(self)

    def expose(self, seed: int, frame: int) -> Exposure:
        """Frame number `frame`; threads change no bit."""
        if self.fused is not None:
            simple = self.fused.expose(seed, frame, read_out=False)
            return Exposure(simple.exposure_e, simple.valid)
        shape = (len(self.program.container.buckets), *self.light.shape)
        if self.plan.slot_loop == "all":
            found = self._words(self.places, self.plan.kept, seed, frame)
        else:
            found = self._sums(seed, frame)
        if len(self.saturating):
            found[:, self.saturating] = self._words(
                self.saturating, self.plan.kept_in_words, seed, frame
            )
        found += 0.0
        return Exposure(found.reshape(shape), np.isfinite(found).reshape(shape))

    def _words(self, chosen: NDArray[np.int64], kept: Selection, seed: int, frame: int) -> Values:
        program = self.program
        return program.words(kept).exposures(
            self.light,
            program.slot_s,
            chosen,
            kept,
            seed=seed,
            device_seed=self.device_seed,
            frame=frame,
            threads=self.threads,
        )

    def _sums(self, seed: int, frame: int) -> Values:
        """Exposures (buckets, pixels) by sums over the slots."""
        program, kept = self.program, self.plan.kept
        away = self._counts(seed, frame)
        found = self.expected + self._spread(away) if away else self.expected.copy()
        if FULL_WELL in kept and REGISTER not in kept:
            np.minimum(found, self.limits, out=found)
        if ANALOG in kept:
            found += self.patterns
        for effect, sigma in program.noises:
            if effect in kept:
                factor = sigma * program.tables.noise(effect.name, self.wanted)[0]
                for draw in range(factor.shape[2]):
                    if factor[:, :, draw].any():
                        z = normals(key(seed, effect.stream, SUM, frame, draw), self.places)
                        for bucket in range(len(found)):
                            found[bucket] += factor[program.lanes, bucket, draw] * z
        return found

    def _counts(self, seed: int, frame: int) -> dict[int, Values]:
        """How far the counts of each group are from their means."""
        kept, found = self.plan.kept, {}
        for group in self.counted:
            total = np.zeros(len(self.places))
            for effect, source, rates in (
                (SHOT, LIGHT, self.light_rates),
                (DARK, DARK_SOURCE, self.dark_rates),
            ):
                if effect in kept:
                    stream = count_key(seed, effect, source, frame, group)
                    counts, _ = poisson(stream, self.places, rates[group], exact=False)
                    total += counts - rates[group]
            found[group] = total
        return found

    def _spread(self, away: dict[int, Values]) -> Values:
        """What the groups' deviations make of the exposures, neighbours' included."""
        program = self.program
        if CROSSTALK in self.plan.kept:
            return program.overlap(program.model(self.plan.kept)).smeared(away)
        weights = program.mean_weights(program.model(self.plan.kept))
        lanes = program.lanes
        buckets = len(program.container.buckets)
        found = np.zeros((buckets, len(self.places)))
        for group, each in away.items():
            for bucket in range(buckets):
                found[bucket] += weights[group][lanes, bucket] * each
        return found

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
        moving = MOTION in self.plan.kept and self.light.motion is not None
        return self.light.motion if moving and self.light.motion is not None else self.light

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
        return 1.0 + (self.program.sensor.lag_fraction if LAG in self.plan.kept else 0.0)

    @property
    def response(self) -> Values:
        """The response of each pixel to light."""
        return self.device.response

    @cached_property
    def scale(self) -> Values:
        """What becomes of the light of each pixel before it is counted: a factor."""
        if PRNU in self.plan.kept:
            return self.factor * self.response
        return np.full(len(self.places), self.factor)

    @cached_property
    def current(self) -> Values:
        """The dark current of each pixel, 0 where there is none."""
        if DARK not in self.plan.kept:
            return np.zeros(len(self.places))
        return self.device.current

    @cached_property
    def counted(self) -> list[int]:
        """The groups whose charge is counted."""
        if not {SHOT.name, DARK.name} & self.plan.kept.on:
            return []
        return [g for g in self.program.group_ids.tolist() if g or self.plan.closed]

    @cached_property
    def light_rates(self) -> dict[int, Values]:
        """The light of each counted group of slots."""
        if SHOT not in self.plan.kept:
            return {}
        sums = self._sum(self.source, [self.program.members(group) for group in self.counted])
        return {g: each * self.scale for g, each in zip(self.counted, sums, strict=True)}

    @cached_property
    def dark_rates(self) -> dict[int, Values]:
        """The dark charge of each counted group of slots."""
        times = {g: self.program.slot_s @ self.program.members(g) for g in self.counted}
        return {g: self.current * time[self.program.lanes] for g, time in times.items()}

    @cached_property
    def leaks(self) -> tuple[Values, Values]:
        """The rates of leakage at which sums are made, and the weights (rates, pixels) with which
        they give that of each pixel.
        """
        program, kept = self.program, self.plan.kept
        if LEAKAGE not in kept or self.plan.leak_nodes == 1:
            return np.array([program.model(kept).leak_per_s]), np.ones((1, len(self.places)))
        nodes = leak_nodes.rates(program.sensor, self.plan.leak_nodes)
        return nodes, leak_nodes.between(nodes, self.device.leak)

    @cached_property
    def expected(self) -> Values:
        """The exposures (buckets, pixels) of the mean charge, nothing saturated."""
        program, kept, sensor = self.program, self.plan.kept, self.program.sensor
        model = program.model(kept)
        nodes, between = self.leaks
        buckets = len(program.container.buckets)
        weights = [program.tables.weights(replace(model, leak_per_s=rate)).slots for rate in nodes]
        stack = [each[:, :, b] for b in range(buckets) for each in weights]
        if CROSSTALK in kept:
            scale = self.scale.reshape(self.light.shape)
            frames = smeared_frames(
                self.source.frames, scale, sensor.crosstalk_fraction, self.threads
            )
            sums = self._sum(replace(self.source, frames=frames, motion=None), stack)
        else:
            sums = self._sum(self.source, stack) * self.scale
        found = (sums.reshape(buckets, len(nodes), -1) * between).sum(axis=1)
        if DARK in kept:
            current = self.current
            if CROSSTALK in kept:
                shaped = current.reshape(self.light.shape)
                current = smeared(shaped, sensor.crosstalk_fraction).reshape(-1)
            open_s = np.einsum("n,nlb->bl", program.slot_s, program.tables.weights(model).slots)
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
        return np.asarray(total * self.device.pattern)

    @cached_property
    def limits(self) -> Values:
        """What the full well lets through, (buckets, pixels); infinite where pixels that may reach
        it run through their words.
        """
        program, found = self.program, np.zeros((len(self.program.container.buckets), 1))
        model = program.model(self.plan.kept)
        unknown = np.isnan(program.tables.single(model))
        for rate, between in zip(*self.leaks, strict=True):
            single = program.tables.single(replace(model, leak_per_s=rate))
            limit = np.where(unknown, 0.0, single * program.sensor.full_well_e)
            found = found + limit.T[:, program.lanes] * between
        return np.where(unknown.T[:, program.lanes], np.inf, found)

    @cached_property
    def saturating(self) -> NDArray[np.int64]:
        """The places of pixels that may saturate in a way that sums do not know."""
        program, kept, sensor = self.program, self.plan.kept, self.program.sensor
        if FULL_WELL not in kept and REGISTER not in kept:
            return np.empty(0, np.int64)
        single = not np.isnan(program.tables.single(program.model(kept))).any()
        limit = np.full(len(program.container.encoding), np.inf)
        if FULL_WELL in kept and not (single and REGISTER not in kept):
            limit[:] = sensor.full_well_e
        if REGISTER in kept:
            low, high = abs(sensor.register_min_e), sensor.register_max_e
            room = sensor.register_knee_fraction * min(low, high) - program.reach.noise_e
            limit = np.minimum(limit, room / program.reach.light)
        if not np.isfinite(limit).any():
            return np.empty(0, np.int64)
        # These pixels run with all effects, so all effects say which they are.
        wanted = self.plan.wanted
        scale = self.response if PRNU in wanted else np.ones(1)
        scale = scale * (1.0 + sensor.lag_fraction * (LAG in wanted))
        bound = float(np.max(self.total * scale, initial=0.0))
        bound *= 1.0 + 4 * sensor.crosstalk_fraction * (CROSSTALK in wanted)
        if DARK in wanted:
            bound += float(self.device.current.max(initial=0.0)) * float(program.slot_s.sum())
        if bound + SIGMAS * np.sqrt(bound) < limit.min():
            return np.empty(0, np.int64)
        seen = program.tables.seen().astype(np.float64)
        charge = self._sum(self.source, [seen])[0] * scale
        if CROSSTALK in wanted:
            # Neighbours' light counts in the pixel's own slots, whatever their own codes are.
            c, lit = sensor.crosstalk_fraction, self.total * scale
            flow = smeared(lit.reshape(self.light.shape), c).reshape(-1) - (1.0 - 4 * c) * lit
            charge = np.maximum(charge, (1.0 - 4 * c) * charge + flow)
        if DARK in wanted:
            charge += self.device.current * (program.slot_s @ seen)[program.lanes]
        near = charge + SIGMAS * np.sqrt(charge)
        return np.flatnonzero(near >= limit[program.lanes])

    def _sum(self, light: Light, weights: list[Values]) -> Values:
        """Sums (len(weights), pixels) of a light, each weighted by slot and lane (N, lanes)."""
        frames = light.frames.reshape(len(light.frames), -1)
        return sums_by_slot(light, frames, self.program.lanes, weights, self.threads)


def prepared(
    program: Program,
    light: Light,
    plan: Plan,
    *,
    device_seed: int = 0,
    threads: int | None = None,
) -> Planned:
    """A scene made ready; raises Rejected as `nscc_runtime.emulator.expose` does."""
    check_size(program.container, light)
    return Planned(program, light, plan, device_seed, processors() if threads is None else threads)
