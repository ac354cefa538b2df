"""A sample of a scene under a program with every effect on: what effects make their fields of."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import CannotHave, everything
from nscc_runtime.effects.field import OnDevice
from nscc_runtime.effects.parts import CountedDark, Echo, Exchange, Leak, Response, WordGain
from nscc_runtime.light import Light
from nscc_runtime.planner.chip import whole_chip
from nscc_runtime.planner.pixels import Running
from nscc_runtime.planner.program import Program
from nscc_runtime.planner.sample import Sample
from nscc_runtime.planner.sample_loop import SIDES, Gathering, gather
from nscc_runtime.planner.sums import sums_by_slot
from nscc_runtime.planner.tables import Model

Values = NDArray[np.float64]
Frames = NDArray[np.float32]
Lanes = NDArray[np.int32]

_LEAK_STEP = 0.1
_MOST_LIGHT = 1e30
"""Beyond it float32 has no room for what neighbours add."""


class Beside(NamedTuple):
    """The neighbours above, below, left and right, (4, pixels) each: 1 where a pixel has one, else
    0; the place; the response.
    """

    there: Values
    place: NDArray[np.int64]
    response: Values


class Gathered(NamedTuple):
    """Frames (T, pixels) before a pixel responds to them; of its neighbours (T, 4, pixels); what
    these count, in sum, and what they would if they all responded alike.
    """

    own: Frames
    others: Frames
    flow: Frames
    even: Frames


class SampledScene:
    """As `nscc_runtime.effects.field.Sampled` has it; arrays are (buckets, pixels of the sample).

    `errors_cut` and `left_out` are for the planner's own account of its short cuts. Exposures are
    linear in light: every field is made of sums over the slots of a pixel's own light and of that
    of its neighbours.
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
        self.slots = program.tables.weights(program.full).slots
        self._used, self._local = _used(self.lanes)

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
        dark, beside = self.device.fixed(self.all.the(CountedDark).per_s), self._beside
        return np.asarray(
            self.exchanged * (beside.there * (dark[beside.place] - self.dark)).sum(axis=0)
        )

    @cached_property
    def _beside(self) -> Beside:
        rows, cols = self.shape
        row, col = np.divmod(self.places, cols)
        inside = np.stack([row > 0, row < rows - 1, col > 0, col < cols - 1])
        steps = np.array([-cols, cols, -1, 1])[:, None]
        place = np.where(inside, self.places + steps, 0)
        response = self.device.fixed(self.all.the(Response).factor)[place]
        return Beside(inside.astype(np.float64), place, response)

    @cached_property
    def _frames(self) -> Gathered:
        beside, shape = self._beside, (len(self.scene.frames), len(self.places))
        own, flow, even = (np.empty(shape, np.float32) for _ in range(3))
        others = np.empty((shape[0], SIDES, shape[1]), np.float32)
        frames = np.require(self.scene.frames, np.float32, ["C", "A"]).reshape(shape[0], -1)
        gather(
            gathering=Gathering(
                count=shape[0], pixels=frames.shape[1], places=shape[1], most=_MOST_LIGHT
            ),
            frames=frames, chosen=self.places, beside=beside.place, there=beside.there,
            response=beside.response, own=own, others=others, flow=flow, even=even,
        )  # fmt: skip
        return Gathered(own, others, flow, even)

    @cached_property
    def _own_part(self) -> Values:
        """The part (pixels,) of a pixel's light that its neighbours do not take."""
        return np.asarray(1.0 - self.exchanged * self._beside.there.sum(axis=0))

    def _by_bucket(self, slots: Values) -> list[Values]:
        """Weights (N, lanes that occur) of each bucket."""
        some = slots if len(self._used) == slots.shape[1] else slots[:, self._used]
        return [np.ascontiguousarray(some[:, :, bucket]) for bucket in self.buckets]

    def _sums(self, light: Light, frames: Frames, weights: Sequence[Values]) -> Values:
        """Sums (.., buckets, pixels) of a light whose frames are replaced by others."""
        found = sums_by_slot(light, frames, self._local, weights)
        return found.reshape(-1, len(self.buckets), len(self.places))

    @cached_property
    def _full(self) -> list[Values]:
        return self._by_bucket(self.slots)

    @cached_property
    def _known(self) -> list[Model]:
        """Every model of the words that an effect may ask for, each once, the full one first."""
        models = [self.program.full, self._faster, *self.program.less.values()]
        return list(dict.fromkeys(self.program.tables.same(model) for model in models))

    @cached_property
    def _light(self) -> tuple[Values, Values]:
        """Sums (models and one, buckets, pixels) of the light before the pixels respond to it and
        of what their neighbours count, by every model of the words and last by squared weights."""
        tables = self.program.tables
        weights = [w for m in self._known[1:] for w in self._by_bucket(tables.weights(m).slots)]
        weights = [*self._full, *weights, *(each**2 for each in self._full)]
        own, _, flow, _ = self._frames
        return self._sums(self.moving, own, weights), self._sums(self.moving, flow, weights)

    @cached_property
    def _seen(self) -> Values:
        """What falls on the pixels with their neighbours' light."""
        own, flow = self._light
        return np.asarray(self._own_part * self.response * own + self.exchanged * flow)

    def lit(self, model: Model) -> Values:
        """`light` as the words weigh it under a model."""
        return np.asarray(self._seen[self._known.index(self.program.tables.same(model))])

    @property
    def _faster(self) -> Model:
        full = self.program.full
        return replace(full, leak_per_s=full.leak_per_s * (1 + _LEAK_STEP))

    @property
    def light(self) -> Values:
        return self.lit(self.program.full)

    def without(self, name: str) -> Values:
        return self.lit(self.program.less[name])

    def by_words(self, name: str) -> Values:
        slow = (each.name for each in self.all.effects if isinstance(each.words, CannotHave))
        every = self.all.without(*slow)
        kept, lost = (self.program.words(each) for each in (every, every.without(name)))
        if kept is lost:
            return np.zeros((len(self.buckets), len(self.places)))
        chip = whole_chip(self.program, self.device.device_seed)
        with_it, without = (
            Running(chip.wired(each), self.scene, self.places, 1).expose(0, 0)[0]
            for each in (every, every.without(name))
        )
        return with_it - without

    @cached_property
    def base(self) -> Values:
        return self.light * self.echo

    @cached_property
    def alone(self) -> Values:
        return np.asarray(self._light[0][0] * self.response * self.echo)

    @cached_property
    def alike(self) -> Values:
        own, even = self._light[0][0], self._sums(self.moving, self._frames.even, self._full)[0]
        return np.asarray((self._own_part * own + self.exchanged * even) * self.echo)

    @cached_property
    def still(self) -> Values | None:
        if self.scene.motion is None:
            return None
        own, flow = (
            self._sums(self.scene, each, self._full)[0]
            for each in (self._frames.own, self._frames.flow)
        )
        return np.asarray(
            (self._own_part * self.response * own + self.exchanged * flow) * self.echo
        )

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
        (*_, own), (*_, flow) = self._light
        own = own * self.response
        if moved:
            return np.asarray((self._beside.there.sum(axis=0) ** 2 * own + flow) * self.echo)
        return np.asarray((self._own_part**2 * own + self.exchanged**2 * flow) * self.echo)

    def counted_alone(self) -> Values:
        return np.asarray(self._light[0][-1] * self.response * self.echo)

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
        program, counted = self.program, self.program.group_ids > 0
        rates, one, two = self._moments
        means = program.mean_weights(program.full)
        mean = np.stack([means[group][self.lanes].T for group in program.group_ids.tolist()])
        spread = np.maximum(two - 2 * mean * one + mean**2 * rates, 0.0)
        lit, overlap = self._exchanged
        within = np.clip(overlap, 0.0, 1.0)
        uneven = lit * within * (1.0 - within)
        every = np.ones_like(counted)
        thinning, neighbours = (
            {
                closed: np.where(known[:, None, None], rest, lost).sum(axis=0)
                for closed, known in ((False, counted), (True, every))
            }
            for rest, lost in (
                (spread, two), (uneven.sum(axis=1), (lit * within).sum(axis=1)),
            )
        )  # fmt: skip
        return thinning, neighbours

    @property
    def _moments(self) -> tuple[Values, Values, Values]:
        """Of the charge that is counted in each group of slots (groups, .., pixels): how much it
        is, and its sums by weights and by squared weights of the buckets."""
        program, full = self.program, self._full
        weights = []
        for group in program.group_ids.tolist():
            members = program.members(group, self._used)
            weighed = [each * members for each in full]
            # Of all groups and buckets at once: every sum reads the light again.
            weights += [members, *weighed, *(each**2 for each in weighed)]
        found = sums_by_slot(self.moving, self._frames.own, self._local, weights)
        found *= self.echo * self.response
        seconds = np.stack([program.slot_s @ each for each in weights])
        found += seconds[:, self._local] * self.dark
        shape = len(program.group_ids), 1 + 2 * len(full), len(self.places)
        rates, one, two = np.split(found.reshape(shape), [1, 1 + len(full)], axis=1)
        return rates, one, two

    @property
    def _exchanged(self) -> tuple[Values, Values]:
        """The variance (groups, 4, 1, pixels) of what neighbours' counts in each group of slots
        send over, and the mean weight (groups, 4, buckets, pixels) of the pixel over the time of
        these slots."""
        program, beside = self.program, self._beside
        used, others = _used(program.lanes[beside.place.reshape(-1)])
        members = [program.members(group, used) for group in program.group_ids.tolist()]
        frames = self._frames.others
        lit = sums_by_slot(self.moving, frames.reshape(len(frames), -1), others, members)
        lit = lit.reshape(len(members), *beside.there.shape) * beside.there * beside.response
        seconds = [each * program.slot_s[:, None] for each in self._full]
        lanes = np.broadcast_to(self._local, beside.place.shape).reshape(-1)
        overlap = np.empty((len(members), len(seconds), len(others)))
        for found, each in zip(overlap, members, strict=True):
            time = program.slot_s @ each
            parts = np.divide(each, time, out=each, where=time > 0)
            for bucket, own in enumerate(seconds):
                found[bucket] = _overlap(own, lanes, parts, others)
        overlap = overlap.reshape(*overlap.shape[:2], *beside.place.shape).transpose(0, 2, 1, 3)
        return np.asarray(self.exchanged**2 * self.echo * lit[:, :, None]), overlap


def _used(lanes: Lanes) -> tuple[NDArray[np.int64], Lanes]:
    """The lanes that occur, and where each is among them: a sample has few of many."""
    occurs = np.bincount(lanes) > 0
    place = np.cumsum(occurs, dtype=np.int32) - 1
    return np.flatnonzero(occurs), np.asarray(place[lanes], np.int32)


def _overlap(seen: Values, lanes: Lanes, parts: Values, others: Lanes) -> Values:
    """The sum over slots of weights (N, lanes) of pixels and of their neighbours."""
    if seen.shape[1] * parts.shape[1] <= len(lanes) * len(seen):
        return np.asarray((seen.T @ parts)[lanes, others])
    return np.asarray(np.einsum("np,np->p", seen[:, lanes], parts[:, others]))
