"""A sample of a scene under a program with every effect on: what effects make their fields of."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import everything
from nscc_runtime.effects.field import OnDevice
from nscc_runtime.effects.parts import CountedDark, Echo, Exchange, Leak, Response, WordGain
from nscc_runtime.light import Light
from nscc_runtime.planner.program import Program
from nscc_runtime.planner.sample import Sample
from nscc_runtime.planner.sums import sums_by_slot
from nscc_runtime.planner.tables import Model

Values = NDArray[np.float64]
Frames = NDArray[np.float32]
Lanes = NDArray[np.int32]

_LEAK_STEP = 0.1
_MOST_LIGHT = np.float32(1e30)
"""Beyond it float32 has no room for what neighbours add."""


class Beside(NamedTuple):
    """The neighbours in one direction: 1 where a pixel has one, else 0; the place; the frames,
    0 where there is none; the response.
    """

    there: Frames
    place: NDArray[np.int64]
    frames: Frames
    response: Frames


class SampledScene:
    """As `nscc_runtime.effects.field.Sampled` has it; arrays are (buckets, pixels of the sample).

    `errors_cut` and `left_out` are for the planner's own account of its short cuts.
    """

    def __init__(self, program: Program, light: Light, sample: Sample, device_seed: int) -> None:
        self.program, self.scene, self.sample = program, light, sample
        self.sensor, self.places, self.shape = program.sensor, sample.places, light.shape
        self.device = program.device(device_seed)
        self.lanes = program.lanes[self.places]
        self.buckets = range(len(program.container.buckets))
        self.all = everything()
        self.moving = light.motion or light
        self.exchanged = self.all.the(Exchange).fraction(self.sensor)
        self.echo = 1.0 + self.all.the(Echo).fraction(self.sensor)
        flat = light.frames.reshape(len(light.frames), -1)
        self.frames: Frames = np.minimum(np.take(flat, self.places, axis=1), _MOST_LIGHT)
        self.beside = self._beside() if self.exchanged > 0 else []
        self.slots = program.tables.weights(program.full).slots

    def on_device(self, make: OnDevice) -> Values:
        return self.device.fixed(make)[self.places]

    @cached_property
    def response(self) -> Values:
        """The response of the pixels to light."""
        return self.on_device(self.all.the(Response).factor)

    @cached_property
    def dark(self) -> Values:
        return self.on_device(self.all.the(CountedDark).per_s)

    @cached_property
    def spilt(self) -> Values:
        found, dark = np.zeros_like(self.dark), self.device.fixed(self.all.the(CountedDark).per_s)
        for beside in self.beside:
            found += beside.there * (dark[beside.place] - self.dark)
        return self.exchanged * found

    def _beside(self) -> list[Beside]:
        rows, cols = self.shape
        row, col = self.places // cols, self.places % cols
        flat = self.scene.frames.reshape(len(self.scene.frames), -1)
        response = self.device.fixed(self.all.the(Response).factor)
        found = []
        for inside, step in (
            (row > 0, -cols), (row < rows - 1, cols), (col > 0, -1), (col < cols - 1, 1),
        ):  # fmt: skip
            there, place = inside.astype(np.float32), np.where(inside, self.places + step, 0)
            frames = there * np.minimum(np.take(flat, place, axis=1), _MOST_LIGHT)
            found.append(Beside(there, place, frames, response[place].astype(np.float32)))
        return found

    @cached_property
    def _own(self) -> Frames:
        """Frames of the pixels' own light."""
        return np.asarray(self.frames * self.response.astype(np.float32))

    @cached_property
    def _seen(self) -> tuple[Frames, Frames]:
        """Frames of what falls on the pixels with their neighbours' light; the same as if all
        pixels responded alike.
        """
        c = np.float32(self.exchanged)
        seen, even = self._own.copy(), self.frames.copy()
        for there, _, frames, part in self.beside:
            seen += c * (frames * part - there * self._own)
            even += c * (frames - there * self.frames)
        return seen, even

    def sum(self, light: Light, weights: Sequence[Values], frames: Frames) -> Values:
        """Sums (len(weights), pixels) of a light whose frames are replaced by others."""
        return sums_by_slot(light, frames, self.lanes, weights)

    def by_bucket(self, slots: Values) -> list[Values]:
        """Weights (N, lanes, buckets) of each bucket."""
        return [slots[:, :, bucket] for bucket in self.buckets]

    def _weighed(self, light: Light, frames: Frames) -> Values:
        return self.sum(light, self.by_bucket(self.slots), frames) * self.echo

    @cached_property
    def _light(self) -> dict[Model, Values]:
        """`light` by every model of the words that an effect may ask for, summed in one go."""
        models = {self.program.full, self._faster, *self.program.less.values()}
        known = list({self.program.tables.same(model): None for model in models})
        weights = [
            each
            for model in known
            for each in self.by_bucket(self.program.tables.weights(model).slots)
        ]
        summed = self.sum(self.moving, weights, self._seen[0])
        return dict(zip(known, summed.reshape(len(known), len(self.buckets), -1), strict=True))

    def lit(self, model: Model) -> Values:
        """`light` as the words weigh it under a model."""
        return self._light[self.program.tables.same(model)]

    @property
    def _faster(self) -> Model:
        full = self.program.full
        return replace(full, leak_per_s=full.leak_per_s * (1 + _LEAK_STEP))

    @property
    def light(self) -> Values:
        return self.lit(self.program.full)

    def without(self, name: str) -> Values:
        return self.lit(self.program.less[name])

    @cached_property
    def base(self) -> Values:
        return self.light * self.echo

    @cached_property
    def alone(self) -> Values:
        return self._weighed(self.moving, self._own)

    @cached_property
    def alike(self) -> Values:
        return self._weighed(self.moving, self._seen[1])

    @cached_property
    def still(self) -> Values | None:
        return None if self.scene.motion is None else self._weighed(self.scene, self._seen[0])

    @cached_property
    def pattern(self) -> Values:
        return self._errors(self.program.full)

    def _errors(self, model: Model) -> Values:
        error = self.on_device(self.all.the(WordGain).error_e)
        return self.program.tables.pattern(model).T[:, self.lanes] * error

    def by_rate(self, pattern: bool = False) -> Values:
        if pattern:
            return np.asarray(self._off * (self._errors(self._faster) - self.pattern))
        return np.asarray(self._off * (self.lit(self._faster) - self.light))

    @cached_property
    def _off(self) -> Values:
        """By how much the pixels' leakage is off its mean, in steps of `_LEAK_STEP` of that."""
        per_s = self.on_device(self.all.the(Leak).per_s)
        return np.asarray((per_s / self.program.full.leak_per_s - 1.0) / _LEAK_STEP)

    @cached_property
    def dark_s(self) -> Values:
        return self._seconds(self.slots)

    @cached_property
    def dark_2_s(self) -> Values:
        return self._seconds(self.slots**2)

    def _seconds(self, weights: Values) -> Values:
        return np.asarray(np.einsum("n,nlb->bl", self.program.slot_s, weights)[:, self.lanes])

    def counted(self, moved: bool = False) -> Values:
        c = np.float32(self.exchanged)
        flow = np.zeros_like(self.frames)
        count = np.zeros(len(self.places), np.float32)
        for there, _, frames, part in self.beside:
            flow += frames * part
            count += there
        if moved:
            counts = count**2 * self._own + flow
        else:
            counts = (1 - c * count) ** 2 * self._own + c**2 * flow
        return self.sum(self.moving, self.by_bucket(self.slots**2), counts) * self.echo

    def counted_alone(self) -> Values:
        return self.sum(self.moving, self.by_bucket(self.slots**2), self._own) * self.echo

    def errors(self, at: str, sigma_e: float) -> Values:
        factor, rest = self.program.tables.noise(at, self.program.full)
        total = ((factor**2).sum(axis=2) + rest).T
        return np.asarray(sigma_e**2 * total[:, self.lanes])

    def errors_cut(self, at: str, sigma_e: float) -> Values:
        """The variance that is left out where they are drawn as at the mean leakage."""
        tables = self.program.tables
        factor, rest = tables.noise(at, self.program.full)
        other = tables.noise(at, self._faster)[0] - factor
        by_rate = (other**2).sum(axis=2).T[:, self.lanes] * self._off**2
        return np.asarray(sigma_e**2 * (rest.T[:, self.lanes] + by_rate))

    def left_out(self) -> tuple[dict[bool, Values], dict[bool, Values]]:
        """The variance that sums leave out because counts are not spread over the slots, with
        closed slots counted or not; the same of what neighbours exchange.
        """
        program, (used, lanes) = self.program, _used(self.lanes)
        means, full = program.mean_weights(program.full), self.by_bucket(self.slots[:, used])
        shape = len(self.buckets), len(self.places)
        thinning = {closed: np.zeros(shape) for closed in (False, True)}
        neighbours = {closed: np.zeros(shape) for closed in (False, True)}
        scale = self.echo * self.response
        seen = [each * program.slot_s[:, None] for each in full]
        for group in program.group_ids.tolist():
            members = program.members(group, used)
            weighed = [each * members for each in full]
            # Of all buckets at once: every sum reads the light again.
            weights = [members, *weighed, *(each**2 for each in weighed)]
            sums = sums_by_slot(self.moving, self.frames, lanes, weights) * scale
            rates, *moments = (
                light + (program.slot_s @ each)[lanes] * self.dark
                for light, each in zip(sums, weights, strict=True)
            )
            for bucket in self.buckets:
                one, two = moments[bucket], moments[len(self.buckets) + bucket]
                mean = means[group][self.lanes, bucket]
                counted = np.maximum(two - 2 * mean * one + mean**2 * rates, 0.0)
                thinning[True][bucket] += counted
                thinning[False][bucket] += counted if group else two
            for beside in self.beside:
                lit, overlaps = self._exchanged(beside, group, [(each, lanes) for each in seen])
                for bucket, overlap in enumerate(overlaps):
                    within = np.clip(overlap, 0.0, 1.0)
                    counted = lit * within * (1.0 - within)
                    neighbours[True][bucket] += counted
                    neighbours[False][bucket] += counted if group else lit * within
        return thinning, neighbours

    def _exchanged(
        self, beside: Beside, group: int, seen: Sequence[tuple[Values, Lanes]]
    ) -> tuple[Values, list[Values]]:
        """The variance of what neighbours' counts in a group of slots send over; by weights of the
        pixels (N, lanes) and their lanes, the mean weight over the time of these slots."""
        program, (used, lanes) = self.program, _used(self.program.lanes[beside.place])
        members = program.members(group, used)
        frames = beside.frames * beside.response
        lit = sums_by_slot(self.moving, frames, lanes, [members])[0]
        time = program.slot_s @ members
        parts = np.divide(members, time, out=members, where=time > 0)
        overlaps = [_overlap(each, own, parts, lanes) for each, own in seen]
        return np.asarray(self.exchanged**2 * self.echo * lit), overlaps


def _used(lanes: Lanes) -> tuple[NDArray[np.int64], Lanes]:
    """The lanes that occur, and where each is among them: a sample has few of many."""
    used, local = np.unique(lanes, return_inverse=True)
    return used.astype(np.int64), local.astype(np.int32)


def _overlap(seen: Values, lanes: Lanes, parts: Values, others: Lanes) -> Values:
    """The sum over slots of weights (N, lanes) of pixels and of their neighbours."""
    if seen.shape[1] * parts.shape[1] <= len(lanes) * len(seen):
        return np.asarray((seen.T @ parts)[lanes, others])
    return np.asarray(np.einsum("np,np->p", seen[:, lanes], parts[:, others]))
