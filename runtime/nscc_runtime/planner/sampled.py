"""A sample of a scene under a program with every effect on: what effects make their fields of."""

from __future__ import annotations

from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import everything
from nscc_runtime.effects.field import OnDevice
from nscc_runtime.effects.parts import CountedDark, Echo, Exchange, Leak, Response, WordGain
from nscc_runtime.light import Light
from nscc_runtime.planner.by_lane import LEAK_STEP
from nscc_runtime.planner.chip import all_by_words, whole_chip
from nscc_runtime.planner.group_loop import Grouping, of_groups, of_groups_beside
from nscc_runtime.planner.pixels import Running
from nscc_runtime.planner.program import Program
from nscc_runtime.planner.sample import Sample
from nscc_runtime.planner.sample_loop import SIDES, Gathering, gather
from nscc_runtime.planner.sums import sums_by_slot, weighted_sums
from nscc_runtime.planner.tables import Model

Values = NDArray[np.float64]
Frames = NDArray[np.float32]
Lanes = NDArray[np.int32]

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
    """Of frames (T, 2, pixels) the light before a pixel responds to it, and what its neighbours
    count, in sum; the light of these (T, 4, pixels); what they would count (T, pixels) if they all
    responded alike.
    """

    lit: Frames
    others: Frames
    even: Frames

    @property
    def own(self) -> Frames:
        """The first of `lit`."""
        return np.ascontiguousarray(self.lit[:, 0])


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
        self.by_lane = program.by_lane
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
        even = np.empty(shape, np.float32)
        lit, others = (np.empty((shape[0], n, shape[1]), np.float32) for n in (2, SIDES))
        frames = np.require(self.scene.frames, np.float32, ["C", "A"]).reshape(shape[0], -1)
        gather(
            gathering=Gathering(
                count=shape[0], pixels=frames.shape[1], places=shape[1], most=_MOST_LIGHT
            ),
            frames=frames, chosen=self.places, beside=beside.place, there=beside.there,
            response=beside.response, lit=lit, others=others, even=even,
        )  # fmt: skip
        return Gathered(lit, others, even)

    @cached_property
    def _own_part(self) -> Values:
        """The part (pixels,) of a pixel's light that its neighbours do not take."""
        return np.asarray(1.0 - self.exchanged * self._beside.there.sum(axis=0))

    @property
    def _weights(self) -> list[Values]:
        """Those of `ByLane`, of the lanes that occur."""
        every = len(self._used) == self.by_lane.seconds.shape[2]
        made = self.by_lane.weights(None if every else self._used)
        return [each for some in made for each in some]

    def _sums(
        self, light: Light, frames: Frames, sides: int = 1, rows: slice = slice(None)
    ) -> Values:
        """Sums (rows, `sides` times pixels) over the slots of a light, by rows of `ByLane.weights`,
        of its frames (T, `sides` times pixels)."""
        tables = self.by_lane.on_frames(light)
        if tables is None:
            lanes = np.tile(self._local, sides)
            return sums_by_slot(light, frames, lanes, self._weights[rows])
        return weighted_sums(frames, np.tile(self.lanes, sides), tables[rows])

    @property
    def _full(self) -> slice:
        """The rows that have the weights of the full model."""
        return slice(len(self.buckets))

    @cached_property
    def _light(self) -> Values:
        """Sums (rows, 2, buckets, pixels) of the light before the pixels respond to it and of what
        their neighbours count, by all that `ByLane.weights` has.
        """
        return self._both(self.moving)

    def _both(self, light: Light, rows: slice = slice(None)) -> Values:
        lit = self._frames.lit
        found = self._sums(light, lit.reshape(len(lit), -1), 2, rows)
        return found.reshape(-1, len(self.buckets), 2, len(self.places)).swapaxes(1, 2)

    def _seen(self, own: Values, flow: Values) -> Values:
        """What falls on the pixels with their neighbours' light."""
        return np.asarray(self._own_part * own + self.exchanged * flow)

    @cached_property
    def _lit(self) -> Values:
        """The light (rows, buckets, pixels) as the words weigh it."""
        return self._seen(self.response * self._light[:, 0], self._light[:, 1])

    @property
    def light(self) -> Values:
        return np.asarray(self._lit[0])

    def without(self, name: str) -> Values:
        return self._charge(self.by_lane.row[name])

    def _charge(self, row: int) -> Values:
        """What falls, light and dark, by weights of a row."""
        dark = self.by_lane.seconds[row][:, self.lanes] * (self.dark + self.spilt)
        return np.asarray(self._lit[row] * self.echo + dark)

    @cached_property
    def charge(self) -> Values:
        return self._charge(0)

    def moved(self, name: str) -> Values:
        return self._charge(self.by_lane.moved_row(name))

    def by_words(self, name: str) -> Values:
        every = all_by_words()
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
        return np.asarray(self._light[0, 0] * self.response * self.echo)

    @cached_property
    def alike(self) -> Values:
        even = self._sums(self.moving, self._frames.even, rows=self._full)
        return self._seen(self._light[0, 0], even) * self.echo

    @cached_property
    def still(self) -> Values | None:
        if self.scene.motion is None:
            return None
        [(own, flow)] = self._both(self.scene, self._full)
        return self._seen(self.response * own, flow) * self.echo

    @cached_property
    def pattern(self) -> Values:
        return self._errors(self.program.full)

    def _errors(self, model: Model) -> Values:
        error = self.on_device(self.all.the(WordGain).error_e)
        return self.program.tables.pattern(model).T[:, self.lanes] * error

    def by_rate(self, pattern: bool = False) -> Values:
        if pattern:
            return np.asarray(self._off * (self._errors(self.by_lane.faster) - self.pattern))
        return np.asarray(self._off * (self._charge(self.by_lane.faster_row) - self.charge))

    @cached_property
    def _off(self) -> Values:
        """By how much the pixels' leakage is off its mean, in steps of `LEAK_STEP` of that."""
        per_s = self.on_device(self.all.the(Leak).per_s)
        return np.asarray((per_s / self.program.full.leak_per_s - 1.0) / LEAK_STEP)

    @cached_property
    def dark_s(self) -> Values:
        return np.asarray(self.by_lane.seconds[0][:, self.lanes])

    @property
    def count_e(self) -> Values:
        """What one count makes of an exposure (buckets, pixels)."""
        return self.by_lane.count_e[:, self.lanes]

    @property
    def dark_e(self) -> Values:
        return self.dark_s * (self.dark + self.spilt)

    @cached_property
    def dark_2_s(self) -> Values:
        return np.asarray(self.by_lane.seconds[self.by_lane.squared_row][:, self.lanes])

    @cached_property
    def held_near(self) -> Values:
        """The charge (kinds, pixels near saturation) that PIX holds, nothing saturated, when it is
        read last before each reset."""
        some = self.sample.near
        lit = self._frames.lit[:, :, some]
        count, _, pixels = lit.shape
        own, flow = (
            self.moving.on_slots(lit.reshape(count, -1)).reshape(-1, 2, pixels).swapaxes(0, 1)
        )
        seen = self._own_part[some] * self.response[some] * own + self.exchanged * flow
        upto = np.zeros((len(own) + 1, pixels))
        slot_s = self.program.slot_s[:, None]
        np.cumsum(seen * self.echo + slot_s * (self.dark + self.spilt)[some], axis=0, out=upto[1:])
        first, stop = (each[:, self.lanes[some]] for each in self.program.tables.held_slots)
        each = np.arange(pixels)
        return np.asarray(upto[stop, each] - upto[first, each])

    def counted(self, moved: bool = False) -> Values:
        return self._moved if moved else self._counted

    def counted_alone(self) -> Values:
        return self._by_squares[0]

    @cached_property
    def _by_squares(self) -> tuple[Values, Values]:
        """The light by squared weights, and what neighbours count of theirs."""
        own, flow = self._light[self.by_lane.squared_row] * self.echo
        return np.asarray(own * self.response), np.asarray(flow)

    @cached_property
    def _counted(self) -> Values:
        own, flow = self._by_squares
        return np.asarray(self._own_part**2 * own + self.exchanged**2 * flow)

    @cached_property
    def _moved(self) -> Values:
        own, flow = self._by_squares
        return np.asarray(self._beside.there.sum(axis=0) ** 2 * own + flow)

    def errors(self, at: str, sigma_e: float) -> Values:
        parts = (sigma_e**2 * each[:, self.lanes] for each in self.by_lane.errors(at))
        return self._at_own_rate(*parts)

    def _at_own_rate(self, mean: Values, product: Values, square: Values) -> Values:
        """Of a variance at the mean leakage, and of what leakage changes, that of each pixel."""
        return np.maximum(mean + self._off * product + self._off**2 * square, 0.0)

    def errors_cut(self, at: str, sigma_e: float) -> Values:
        """The variance that is left out where they are drawn as at the mean leakage."""
        parts = (sigma_e**2 * each[:, self.lanes] for each in self.by_lane.errors_cut(at))
        return self._at_own_rate(*parts)

    def pattern_without(self, name: str) -> Values:
        """By how much the words' fixed errors are larger with an effect, at the mean leakage."""
        return self.pattern - self._errors(self.by_lane.less[name])

    def reweighed(self, name: str, at: str, sigma_e: float) -> tuple[Values, Values]:
        """The variance of what errors change by without an effect, and by how much their own is
        larger with it."""
        parts = self.by_lane.reweighed(at, name)
        mean, product, square, more = (sigma_e**2 * each[:, self.lanes] for each in parts)
        return self._at_own_rate(mean, product, square), np.asarray(more)

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
    def levels(self) -> Values:
        """The variance (pixels,) of what neighbours count in slots that PIX sees although they are
        closed, as if their light fell evenly."""
        beside = self.moving.frame_weight @ self._frames.lit[:, 1]
        return np.asarray(
            self.exchanged**2 * self.echo * self.program.level_part[self.lanes] * beside
        )

    @property
    def _moments(self) -> tuple[Values, Values, Values]:
        """Of the charge that is counted in each group of slots (groups, .., pixels): how much it
        is, and its sums by weights and by squared weights of the buckets."""
        size, arrays = self._grouping
        shape = size.groups, size.buckets, size.pixels
        rates, one, two = np.empty((shape[0], shape[2])), np.empty(shape), np.empty(shape)
        of_groups(
            grouping=size, frames=self._frames.own, light=rates, one=one, two=two, **arrays
        )  # fmt: skip
        seconds = self.program.group_s[:, :, self.lanes]
        for found in (rates[:, None], one, two):
            found *= self.echo * self.response
        one += seconds[:, 1 : 1 + size.buckets] * self.dark
        two += seconds[:, 1 + size.buckets :] * self.dark
        return rates[:, None] + seconds[:, :1] * self.dark, one, two

    @property
    def _exchanged(self) -> tuple[Values, Values]:
        """The variance (groups, 4, 1, pixels) of what neighbours' counts in each group of slots
        send over, and the mean weight (groups, 4, buckets, pixels) of the pixel over the time of
        these slots."""
        beside, lanes = self._beside, self.program.lanes[self._beside.place]
        few = len(self.program.group_s[0, 0]) ** 2 <= lanes.size
        lit, open_s = (self._by_lanes if few else self._by_pixels)(lanes)
        lit *= beside.there * beside.response
        time = self.program.group_s[:, 0][:, lanes][:, :, None]
        overlap = np.divide(open_s, time, out=open_s, where=time > 0)
        return np.asarray(self.exchanged**2 * self.echo * lit[:, :, None]), overlap

    def _by_pixels(self, beside: Lanes) -> tuple[Values, Values]:
        """Of neighbours with the lanes `beside` (4, pixels): the light (groups, 4, pixels) in each
        group of their slots, and the seconds (groups, 4, buckets, pixels) of these by the weights
        of the pixel."""
        size, arrays = self._grouping
        lit = np.empty((size.groups, *beside.shape))
        open_s = np.empty((size.groups, SIDES, size.buckets, size.pixels))
        of_groups_beside(
            grouping=size, frames=self._frames.others, beside=beside, slot_s=self.program.slot_s,
            light=lit, open_s=open_s, **arrays,
        )  # fmt: skip
        return lit, open_s

    def _by_lanes(self, beside: Lanes) -> tuple[Values, Values]:
        """The same by way of all pairs of lanes: faster where these are few."""
        program, frames = self.program, self._frames.others
        members = [program.members(group) for group in program.group_ids.tolist()]
        lit = sums_by_slot(self.moving, frames.reshape(len(frames), -1), beside.ravel(), members)
        seconds = self.by_lane.full_weights.swapaxes(1, 2) * program.slot_s
        pairs = np.array([seconds @ each for each in members])
        open_s = pairs[:, :, self.lanes, beside].swapaxes(1, 2)
        return lit.reshape(-1, *beside.shape), np.ascontiguousarray(open_s)

    @cached_property
    def _grouping(self) -> tuple[Grouping, dict[str, Any]]:
        """What the loops over groups of slots have in common."""
        program, light = self.program, self.moving
        of_slot = program.pixels.groups
        size = Grouping(
            pixels=len(self.places), slots=of_slot.shape[1], lanes=len(of_slot),
            groups=len(program.group_ids), buckets=len(self.buckets), frames=len(light.frames),
            entries=len(light.weight),
        )  # fmt: skip
        return size, {
            "row_start": np.require(light.row_start, np.int64, ["C", "A"]),
            "frame_index": np.require(light.frame_index, np.int32, ["C", "A"]),
            "frame_part": np.require(light.weight, np.float64, ["C", "A"]),
            "lane": self.lanes, "of_slot": of_slot, "weights": self.by_lane.full_weights,
        }  # fmt: skip


def _used(lanes: Lanes) -> tuple[NDArray[np.int64], Lanes]:
    """The lanes that occur, and where each is among them: a sample has few of many."""
    occurs = np.bincount(lanes) > 0
    place = np.cumsum(occurs, dtype=np.int32) - 1
    return np.flatnonzero(occurs), np.asarray(place[lanes], np.int32)
